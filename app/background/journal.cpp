// From the document's steps to the writer's thread.
#include "app/background/journal.h"

#include "model/journal/journal_writer.h"
#include "model/values/guarded.h"

#include <QDateTime>
#include <QUndoStack>

#include <utility>

namespace hairpaint::app {

namespace {

constexpr std::size_t kMostWaiting = 16; ///< Steps that are made faster than the disk takes them are left out.
constexpr int kLookMs = 10'000;          ///< Between looks after the folder.

} // namespace

Journal::Journal(model::Document& document, QString root, QObject* parent)
    : QObject(parent), m_document(document), m_root(std::move(root)),
      m_thread([this](const std::stop_token& stop) { work(stop); })
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
        post({.kind = Task::Kind::Append, .states = {*std::exchange(m_before, std::nullopt)}});
    post({.kind = Task::Kind::Append, .states = {present()}});
    if (!m_nowAndThen.isActive())
        m_nowAndThen.start();
}

void Journal::lookAfterFolder()
{
    if (m_written && m_document.modified() && !m_isStopped)
        post({.kind = Task::Kind::LookAfter});
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
    Task task{.kind = Task::Kind::TakeOver};
    for (std::size_t i = 0; i < work.steps.size(); ++i) {
        model::JournalState& state = task.states.emplace_back(work.steps[i]);
        state.index = state.count = static_cast<int>(i);
    }
    task.states.push_back(present()); // Which of them it is.
    m_posted = {m_document.revision(), m_document.undoStack().index()};
    post(std::move(task));
    m_nowAndThen.start();
}

void Journal::post(Task task)
{
    {
        const std::scoped_lock lock(m_mutex);
        m_tasks.push_back(std::move(task));
        if (m_tasks.size() > kMostWaiting)
            m_tasks.erase(m_tasks.begin() + static_cast<std::ptrdiff_t>(kMostWaiting / 2));
    }
    m_changed.notify_all();
}

void Journal::flush()
{
    if (m_soon.isActive() || m_replaced)
        look();
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return m_tasks.empty() && !m_busy; });
}

bool Journal::idle()
{
    if (m_soon.isActive())
        return false;
    const std::scoped_lock lock(m_mutex);
    return m_tasks.empty() && !m_busy && m_told;
}

void Journal::discard()
{
    m_soon.stop();
    {
        const std::scoped_lock lock(m_mutex);
        m_tasks.clear();
        m_discarding = true;
    }
    m_changed.notify_all();
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return !m_discarding; });
    m_written = false;
}

void Journal::tell(const QString& problem)
{
    {
        const std::scoped_lock lock(m_mutex);
        m_told = true;
    }
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

void Journal::work(const std::stop_token& stop)
{
    std::unique_ptr<JournalFolder> folder;
    std::unique_ptr<model::JournalWriter> writer;
    std::deque<model::JournalState> states; // Of a writer that has failed: the next one begins with them.
    const auto begin = [&]() -> model::Checked<void> {
        // Somebody tidied up: what is written there now has no name, or another one.
        if (writer && !writer->isInPlace()) {
            states = writer->takeStates();
            writer.reset();
        }
        if (folder && !folder->place()->isInPlace())
            folder.reset();
        if (!folder)
            folder = JournalFolder::create(m_root);
        if (!folder)
            return model::refuse(tr("its folder can't be written to; check that you may write there"));
        if (!writer)
            writer = std::make_unique<model::JournalWriter>(folder->place(), JournalFolder::fileName(),
                                                            std::exchange(states, {}));
        return {};
    };
    const auto handle = [&](const Task& task) -> model::Checked<void> {
        if (task.kind == Task::Kind::MarkClean) {
            if (writer && writer->markClean())
                return {};
            // What can't be marked on a full disk can be removed.
            if (writer)
                states = writer->takeStates();
            writer.reset();
            if (folder)
                folder->place()->remove(JournalFolder::fileName());
            return {};
        }
        if (task.kind == Task::Kind::LookAfter && (!writer || writer->isClean() || writer->isInPlace()))
            return {};
        if (task.kind == Task::Kind::TakeOver) {
            writer.reset();
            states.assign(task.states.begin(), task.states.end());
            const model::Checked<void> begun = begin();
            return begun ? writer->writeAnew() : begun;
        }
        if (model::Checked<void> begun = begin(); !begun) {
            for (const model::JournalState& state : task.states)
                model::JournalWriter::keep(states, state);
            return begun;
        }
        if (task.kind == Task::Kind::LookAfter)
            return writer->writeAnew();
        for (const model::JournalState& state : task.states)
            if (model::Checked<void> written = writer->append(state); !written)
                return written;
        return {};
    };
    for (;;) {
        Task task;
        {
            std::unique_lock lock(m_mutex);
            m_changed.notify_all();
            if (!m_changed.wait(lock, stop, [this] { return !m_tasks.empty() || m_discarding; }))
                return;
            if (m_discarding) {
                writer.reset();
                states.clear();
                if (folder)
                    folder->remove();
                folder.reset();
                m_discarding = false;
                continue;
            }
            task = std::move(m_tasks.front());
            m_tasks.pop_front();
            m_busy = true;
        }
        const QString problem = model::whereMemoryLasts(
            [&] {
                const model::Checked<void> written = handle(task);
                return written ? QString() : written.error().text;
            },
            [] { return model::notEnoughMemory().text; });
        if (!problem.isEmpty() && writer) {
            states = writer->takeStates();
            writer.reset(); // The next step begins anew, with all of the content.
        }
        {
            const std::scoped_lock lock(m_mutex);
            m_told = false;
            m_busy = false;
        }
        QMetaObject::invokeMethod(this, [this, problem] { tell(problem); });
    }
}

} // namespace hairpaint::app
