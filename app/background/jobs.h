// Work in the background: whatever may take long and belongs to the window is done here.
#pragma once

#include "model/files/project_file.h"
#include "model/values/guarded.h"
#include "sim/base/parallel.h"

#include <QObject>
#include <QPointer>

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>
#include <vector>

class QWidget;

namespace hairpaint::app {

/// What a job does. It runs on a thread of the service, with loops in the background's arena, tells how far it is
/// (0..1) and stops, with an error, soon after it is told to by `false`. Everything it uses is its own copy, or stays
/// as it is until the job is done.
template<typename T>
using Work = std::function<model::Result<T>(const model::Progress&)>;

/// The texts of a job: what it does, and what is shown when it is cancelled.
struct Doing
{
    QString text;          ///< As in "Reading head.glb".
    QString whenCancelled; ///< A sentence that names what was not done: "'head.glb' was not read: cancelled".
};

/// How work ended that was waited for.
enum class WorkEnd
{
    Done, ///< Also where Cancel came too late for what was written, or whose result is used all the same.
    Cancelled,
    Left ///< It was cancelled, and still has not stopped.
};

template<typename T>
struct Awaited
{
    WorkEnd end = WorkEnd::Done;
    /// None if it was left running. If it was cancelled: the result that it still produced.
    std::optional<model::Result<T>> result;
};

/// What to do with a result that arrives after Cancel.
enum class Late
{
    Used,
    Dropped
};

/// Lives on the GUI thread. Whatever a job throws becomes its error, which names `doing`: what is done, the file named.
class Jobs : public QObject
{
    Q_OBJECT
public:
    explicit Jobs(QWidget& window);
    ~Jobs() override; ///< Stops running jobs and waits for them; their results are dropped.

    /// A clock in milliseconds, from any start, that measures how long work takes. Real time unless set.
    using Clock = std::function<qint64()>;
    void setClock(Clock clock) { m_clock = std::move(clock); }

    /// Waits for the result: the window stays alive but takes no input, and what is clicked or typed meanwhile is
    /// lost. After half a second a window shows how far the work is. Its Cancel is all that can be pressed, by mouse or
    /// with Esc: Enter and Space, which may still have been meant for the dialog before, do nothing. None if the
    /// work was cancelled, which has been reported.
    template<typename T>
    [[nodiscard]] std::optional<model::Result<T>> await(const Doing& doing, const Work<T>& work);
    /// Waits likewise until `ready` (asked again and again, on the GUI thread); false where cancelled.
    [[nodiscard]] bool awaitUntil(const Doing& doing, const std::function<bool()>& ready);

    /// The same for work on a disk that may not answer: what has not stopped a while after Cancel, and computes nothing
    /// meanwhile, is left to itself, so it owns all that it uses.
    template<typename T>
    [[nodiscard]] Awaited<T> awaitOrLeave(const Doing& doing, Work<T> work,
                                          Late late = std::is_void_v<T> ? Late::Used : Late::Dropped);

    /// Does not wait: `done` gets the result, on the GUI thread, unless `receiver` is gone by then.
    template<typename T>
    void start(const QString& doing, Work<T> work, QObject* receiver, std::function<void(model::Result<T>)> done);
    /// Asks a disk that may not answer. Nothing waits for it, not even the end of the program. The question owns all
    /// that it uses; where it throws, the answer is T().
    template<typename T>
    void ask(std::function<T()> question, QObject* receiver, std::function<void(T)> done);
    /// Work that was left to itself, a question, or another counted thread (counted_thread.h) is running: the program
    /// ends without waiting for it.
    [[nodiscard]] static bool anyLeft();

Q_SIGNALS:
    /// A job was cancelled by the user: a sentence that names it.
    void cancelled(const QString& sentence);

protected:
    void customEvent(QEvent* event) override; ///< A job that was not waited for has ended.

private:
    /// Work on a thread of the service; the function that it returns is called on the GUI thread.
    using Unwatched = std::function<std::function<void()>(const model::Progress&)>;

    WorkEnd runWatched(const QString& doing, std::function<void(const model::Progress&)> work, bool mayBeLeft);
    void runUnwatched(Unwatched work);
    void runLeft(std::function<std::function<void()>()> work);
    void tellLater(std::function<void()> told);
    void workUnwatched(const std::stop_token& stop);

    /// The way from threads that may outlive the service to the service.
    struct Ear
    {
        std::mutex mutex;
        Jobs* jobs = nullptr; ///< Null once the service is gone.
    };

    QWidget& m_window;
    Clock m_clock;
    std::shared_ptr<Ear> m_ear;
    std::mutex m_mutex; ///< Guards m_unwatched and m_told.
    std::condition_variable_any m_wanted;
    std::deque<Unwatched> m_unwatched;
    std::vector<std::function<void()>> m_told;
    std::vector<std::jthread> m_threads;
};

template<typename T>
std::optional<model::Result<T>> Jobs::await(const Doing& doing, const Work<T>& work)
{
    std::optional<model::Result<T>> result;
    const WorkEnd end = runWatched(
        doing.text,
        [&](const model::Progress& progress) {
            result.emplace(model::guarded(doing.text, [&] { return work(progress); }));
        },
        false);
    // What was written in spite of it is there; what was only read or made is not used.
    if (end == WorkEnd::Cancelled && (!std::is_void_v<T> || !*result)) {
        Q_EMIT cancelled(doing.whenCancelled);
        return std::nullopt;
    }
    return result;
}

template<typename T>
Awaited<T> Jobs::awaitOrLeave(const Doing& doing, Work<T> work, Late late)
{
    const auto result = std::make_shared<std::optional<model::Result<T>>>();
    WorkEnd end = runWatched(
        doing.text,
        [text = doing.text, work = std::move(work), result](const model::Progress& progress) {
            result->emplace(model::guarded(text, [&] { return work(progress); }));
        },
        true);
    if (end == WorkEnd::Cancelled && late == Late::Used && **result)
        end = WorkEnd::Done;
    if (end == WorkEnd::Cancelled)
        Q_EMIT cancelled(doing.whenCancelled);
    // What is left may be writing it.
    return {.end = end, .result = end == WorkEnd::Left ? std::nullopt : std::move(*result)};
}

template<typename T>
void Jobs::ask(std::function<T()> question, QObject* receiver, std::function<void(T)> done)
{
    runLeft([question = std::move(question), receiver = QPointer<QObject>(receiver),
             done = std::move(done)]() -> std::function<void()> {
        auto answer = std::make_shared<T>();
        try {
            *answer = question();
        } catch (const std::exception&) { // It says nothing, then.
        }
        return [receiver, done, answer] {
            if (receiver)
                done(std::move(*answer));
        };
    });
}

template<typename T>
void Jobs::start(const QString& doing, Work<T> work, QObject* receiver, std::function<void(model::Result<T>)> done)
{
    runUnwatched([doing, work = std::move(work), receiver = QPointer<QObject>(receiver),
                  done = std::move(done)](const model::Progress& progress) -> std::function<void()> {
        auto result = std::make_shared<model::Result<T>>(model::guarded(doing, [&] { return work(progress); }));
        return [receiver, done, result] {
            if (receiver)
                done(std::move(*result));
        };
    });
}

} // namespace hairpaint::app
