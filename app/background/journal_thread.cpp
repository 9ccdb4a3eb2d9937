// From tasks to the journal's writer.
#include "app/background/journal_thread.h"

#include "app/background/counted_thread.h"
#include "app/background/journal_folder.h"
#include "app/background/thread_time.h"
#include "model/journal/journal_writer.h"
#include "model/values/guarded.h"

#include <QCoreApplication>

#include <algorithm>
#include <deque>
#include <iterator>
#include <optional>
#include <utility>

namespace hairpaint::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostWaiting = 16; ///< Tasks.
constexpr std::chrono::milliseconds kBetweenLooks{20};
constexpr double kComputesMs = 3.0; ///< Between two looks: less is the waiting itself.

/// A step between others of its history: those after it hold what it holds, but for what undoes it.
bool isPassedOver(const JournalThread::Task& task)
{
    return task.kind == JournalThread::Task::Kind::Append && task.states.front().count > 0;
}

/// What is written, and how to go on where it can't be.
class Desk
{
    Q_DECLARE_TR_FUNCTIONS(Journal)
public:
    explicit Desk(const QString& root) : m_root(root) {}

    /// A clause where the task can't be done.
    [[nodiscard]] QString work(const JournalThread::Task& task)
    {
        QString problem = model::whereMemoryLasts(
            [&] {
                const model::Checked<void> written = handle(task);
                return written ? QString() : written.error().text;
            },
            [] { return model::notEnoughMemory().text; });
        m_isLacking = !problem.isEmpty();
        if (m_isLacking && m_writer) {
            m_states = m_writer->takeStates();
            m_writer.reset(); // The next step begins anew, with all of the content.
        }
        return problem;
    }

    void discard()
    {
        m_writer.reset();
        m_states.clear();
        if (m_folder)
            m_folder->remove();
        m_folder.reset();
        m_isLacking = false;
    }

private:
    using Kind = JournalThread::Task::Kind;

    model::Checked<void> begin()
    {
        // Somebody tidied up: what is written there now has no name, or another one.
        if (m_writer && !m_writer->isAtPath()) {
            m_states = m_writer->takeStates();
            m_writer.reset();
        }
        if (m_folder && !m_folder->own()->isAtPath())
            m_folder.reset();
        if (!m_folder)
            m_folder = JournalFolder::create(m_root);
        if (!m_folder)
            return model::refuse(tr("its folder can't be written to; check that you may write there"));
        if (!m_writer)
            m_writer = std::make_unique<model::JournalWriter>(m_folder->own(), JournalFolder::fileName(),
                                                              std::exchange(m_states, {}));
        return {};
    }

    void markClean()
    {
        if (m_writer && m_writer->markClean())
            return;
        // What can't be marked on a full disk can be removed.
        if (m_writer)
            m_states = m_writer->takeStates();
        m_writer.reset();
        if (m_folder)
            m_folder->own()->remove(JournalFolder::fileName());
    }

    model::Checked<void> handle(const JournalThread::Task& task)
    {
        if (task.kind == Kind::MarkClean) {
            markClean();
            return {};
        }
        // What could not be written is not there, whatever stands in the folder.
        if (task.kind == Kind::LookAfter && !m_isLacking && (!m_writer || m_writer->isClean() || m_writer->isAtPath()))
            return {};
        if (task.kind == Kind::TakeOver) {
            m_writer.reset();
            m_states.assign(task.states.begin(), task.states.end());
            const model::Checked<void> begun = begin();
            return begun ? m_writer->writeAnew() : begun;
        }
        if (model::Checked<void> begun = begin(); !begun) {
            for (const model::JournalState& state : task.states)
                model::JournalWriter::keep(m_states, state);
            return begun;
        }
        for (const model::JournalState& state : task.states)
            if (model::Checked<void> written = m_writer->append(state); !written)
                return written;
        return {};
    }

    QString m_root;
    std::unique_ptr<JournalFolder> m_folder;
    std::unique_ptr<model::JournalWriter> m_writer;
    std::deque<model::JournalState> m_states; ///< The states of a writer that failed; the next writer begins with them.
    bool m_isLacking = false;                 ///< Whether the last task failed.
};

} // namespace

/// Owned by both threads, since either may be gone first.
struct JournalThread::Shared
{
    Shared(const QString& root, std::function<void(const QString&)> whatToTell)
        : desk(root), told(std::move(whatToTell))
    {}

    std::optional<ThreadCount> count; ///< Set once the thread is left to itself; destroyed after all other members.
    Desk desk;                        ///< Used by the thread alone.

    std::mutex mutex; ///< Guards the members below.
    std::condition_variable changed;
    std::deque<Task> tasks;
    std::optional<Clock::time_point> busySince;
    std::size_t ended = 0;  ///< Number of tasks that have ended.
    bool isGivenUp = false; ///< Whether waiting for the present task was given up.
    bool isDiscarding = false;
    bool isToStop = false;
    std::function<void(const QString& problem)> told; ///< Null once nobody listens.
};

JournalThread::JournalThread(const QString& root, std::function<void(const QString& problem)> told)
    : m_shared(std::make_shared<Shared>(root, std::move(told))), m_thread([shared = m_shared] { work(*shared); })
{}

JournalThread::~JournalThread()
{
    const bool isDone = finish();
    {
        const std::scoped_lock lock(m_shared->mutex);
        m_shared->told = nullptr;
        m_shared->isToStop = true;
        if (!isDone)
            m_shared->count.emplace();
    }
    m_shared->changed.notify_all();
    if (isDone)
        m_thread.join();
    else
        m_thread.detach();
}

void JournalThread::post(Task task)
{
    {
        const std::scoped_lock lock(m_shared->mutex);
        std::deque<Task>& tasks = m_shared->tasks;
        tasks.push_back(std::move(task));
        if (tasks.size() > kMostWaiting) {
            const auto newest = std::prev(tasks.end());
            const auto one =
                std::find_if(tasks.begin() + static_cast<std::ptrdiff_t>(kMostWaiting / 2), newest, isPassedOver);
            if (one != newest)
                tasks.erase(one);
        }
    }
    m_shared->changed.notify_all();
}

bool JournalThread::await(std::unique_lock<std::mutex>& lock, const std::function<bool()>& isReady)
{
    double computedMs = processorMs(m_thread);
    std::size_t ended = m_shared->ended;
    Clock::time_point lived = Clock::now();
    while (!m_shared->isGivenUp && !m_shared->changed.wait_for(lock, kBetweenLooks, isReady)) {
        const double nowMs = processorMs(m_thread);
        if (nowMs - std::exchange(computedMs, nowMs) > kComputesMs || std::exchange(ended, m_shared->ended) != ended)
            lived = Clock::now();
        m_shared->isGivenUp = Clock::now() - lived > m_patience;
    }
    return isReady();
}

bool JournalThread::finish()
{
    std::unique_lock lock(m_shared->mutex);
    return await(lock, [this] { return m_shared->tasks.empty() && !m_shared->busySince; });
}

bool JournalThread::discard()
{
    std::unique_lock lock(m_shared->mutex);
    m_shared->tasks.clear();
    m_shared->isDiscarding = true;
    m_shared->changed.notify_all();
    return await(lock, [this] { return !m_shared->isDiscarding; });
}

bool JournalThread::isIdle() const
{
    const std::scoped_lock lock(m_shared->mutex);
    return m_shared->tasks.empty() && !m_shared->busySince;
}

bool JournalThread::isStuck() const
{
    const std::scoped_lock lock(m_shared->mutex);
    return m_shared->busySince && Clock::now() - *m_shared->busySince > m_patience;
}

void JournalThread::work(Shared& shared)
{
    std::unique_lock lock(shared.mutex);
    for (;;) {
        shared.changed.notify_all();
        shared.changed.wait(lock,
                            [&shared] { return !shared.tasks.empty() || shared.isDiscarding || shared.isToStop; });
        if (shared.isDiscarding) {
            shared.busySince = Clock::now();
            lock.unlock();
            shared.desk.discard();
            lock.lock();
            shared.isDiscarding = false;
        } else if (!shared.tasks.empty()) {
            const Task task = std::move(shared.tasks.front());
            shared.tasks.pop_front();
            shared.busySince = Clock::now();
            lock.unlock();
            const QString problem = shared.desk.work(task);
            lock.lock();
            if (shared.told)
                shared.told(problem);
        } else {
            return;
        }
        shared.busySince.reset();
        shared.isGivenUp = false;
        ++shared.ended;
    }
}

} // namespace hairpaint::app
