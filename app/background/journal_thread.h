// The thread that writes the journal. Waiting for it ends when its disk does not answer.
#pragma once

#include "model/document/journal_state.h"

#include <QString>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace hairpaint::app {

/// All functions are called on the GUI thread.
class JournalThread
{
public:
    struct Task
    {
        enum class Kind
        {
            Append,
            TakeOver,  ///< Instead of all that was appended.
            MarkClean, ///< What was appended last is saved.
            LookAfter  ///< Appends where the folder is gone or the task before could not be done, else does nothing.
        };
        Kind kind = Kind::MarkClean;
        std::vector<model::JournalState> states = {}; ///< To be appended; of LookAfter the present one.
    };

    /// `root`: where the journal's folder is made with the first task. `told`: called on the thread after each task,
    /// with a clause where the journal lacks something now; not after the destructor has begun.
    JournalThread(const QString& root, std::function<void(const QString& problem)> told);
    /// Waits as finish() does, and leaves the thread where that fails: it ends when the disk answers.
    ~JournalThread();
    JournalThread(const JournalThread&) = delete;
    JournalThread& operator=(const JournalThread&) = delete;
    JournalThread(JournalThread&&) = delete;
    JournalThread& operator=(JournalThread&&) = delete;

    /// If steps come faster than the disk writes them, some are skipped, but never the newest or the first of a
    /// history.
    void post(Task task);
    /// Waits until nothing is left to do. False where the disk does not answer: for a while the thread has neither
    /// ended a task nor computed. Then it returns at once until a task ends.
    bool finish();
    /// The same, but first drops waiting tasks; then the thread removes the journal's folder.
    bool discard();
    [[nodiscard]] bool isIdle() const;
    /// Whether one task has taken longer than the time limit for the disk.
    [[nodiscard]] bool isStuck() const;
    /// How long the disk is waited for; 5 s unless set.
    void setPatience(std::chrono::milliseconds patience) { m_patience = patience; }

private:
    struct Shared;

    static void work(Shared& shared);
    bool await(std::unique_lock<std::mutex>& lock, const std::function<bool()>& isReady);

    std::shared_ptr<Shared> m_shared;
    std::chrono::milliseconds m_patience{5000};
    std::thread m_thread;
};

} // namespace hairpaint::app
