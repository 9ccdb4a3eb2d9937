// From the document's steps to the writer's thread.
#include "app/background/journal.h"

#include <QDateTime>
#include <QUndoStack>

#include <utility>

namespace hairpaint::app {

namespace {

constexpr int kLookMs = 10'000; ///< Between looks after the folder.

} // namespace

Journal::Journal(model::Document& document, const QString& root, QObject* parent)
    : QObject(parent), m_document(document), m_thread(root, [this](const QString& problem) {
          ++m_untold;
          QMetaObject::invokeMethod(
              this, [this, problem] { tell(problem); }, Qt::QueuedConnection);
      })
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(0);
    connect(&m_soon, &QTimer::timeout, this, &Journal::look);
    m_nowAndThen.setInterval(kLookMs);
    m_nowAndThen.setTimerType(Qt::VeryCoarseTimer);
    connect(&m_nowAndThen, &QTimer::timeout, this, &Journal::lookAfterFolder);
    connect(&document, &model::Document::changed, this, [this](const model::Change& change) {
        m_replaced = m_replaced || change.aspect == model::Change::Aspect::Everything;
        if (!change.preview)
            m_soon.start();
    });
    connect(&document, &model::Document::modifiedChanged, &m_soon, qOverload<>(&QTimer::start));
    // At once: the next step may come before the event loop does.
    connect(&document.undoStack(), &QUndoStack::indexChanged, this, &Journal::look);
    look();
}

Journal::~Journal()
{
    flush();
}

model::JournalState Journal::present() const
{
    const QUndoStack& steps = m_document.undoStack();
    return {.project = m_document.committed(),
            .path = m_path,
            .file = m_file ? m_file() : model::KnownFile(),
            .step = steps.undoText(),
            .index = steps.index(),
            .count = steps.count(),
            .timeMs = QDateTime::currentMSecsSinceEpoch()};
}

void Journal::look()
{
    m_soon.stop();
    if (m_isPaused)
        return;
    if (std::exchange(m_replaced, false)) {
        if (std::exchange(m_written, false))
            post({});
        m_before.reset();
    }
    if (!m_document.modified()) {
        m_nowAndThen.stop();
        if (m_written)
            post({});
        m_before = present();
        return;
    }
    const std::pair now{m_document.revision(), m_document.undoStack().index()};
    if (m_written && std::exchange(m_posted, now) == now)
        return;
    // What was there before the first step, so that this can be undone after a crash too.
    if (!std::exchange(m_written, true) && m_before)
        post({.kind = JournalThread::Task::Kind::Append, .states = {*std::exchange(m_before, std::nullopt)}});
    post({.kind = JournalThread::Task::Kind::Append, .states = {present()}});
    if (!m_nowAndThen.isActive())
        m_nowAndThen.start();
}

void Journal::lookAfterFolder()
{
    if (m_thread.isStuck()) {
        if (!std::exchange(m_isStopped, true))
            Q_EMIT stopped(tr("its disk does not answer; save the project to another disk"));
        return;
    }
    if (m_written && m_document.modified() && !m_isPaused)
        post({.kind = JournalThread::Task::Kind::LookAfter, .states = {present()}});
}

void Journal::setPaused(bool paused)
{
    m_isPaused = paused;
    if (!paused)
        m_soon.start();
}

void Journal::takeOver(const model::RecoveredWork& work)
{
    m_replaced = false;
    m_written = true;
    m_before.reset();
    JournalThread::Task task{.kind = JournalThread::Task::Kind::TakeOver};
    for (std::size_t i = 0; i < work.steps.size(); ++i) {
        model::JournalState& state = task.states.emplace_back(work.steps[i]);
        state.index = state.count = static_cast<int>(i);
    }
    task.states.push_back(present()); // Which of them it is.
    m_posted = {m_document.revision(), m_document.undoStack().index()};
    post(std::move(task));
    m_nowAndThen.start();
}

void Journal::post(JournalThread::Task task)
{
    m_thread.post(std::move(task));
}

void Journal::flush()
{
    if (m_soon.isActive() || m_replaced)
        look();
    (void)m_thread.finish();
}

bool Journal::idle() const
{
    return !m_soon.isActive() && m_untold == 0 && m_thread.isIdle();
}

void Journal::discard()
{
    m_soon.stop();
    (void)m_thread.discard();
    m_written = false;
}

void Journal::tell(const QString& problem)
{
    --m_untold;
    if (m_isStopped != !problem.isEmpty()) {
        m_isStopped = !problem.isEmpty();
        if (m_isStopped)
            Q_EMIT stopped(problem);
        else
            Q_EMIT resumed();
    }
    if (!m_isStopped && idle())
        Q_EMIT kept();
}

} // namespace hairpaint::app
