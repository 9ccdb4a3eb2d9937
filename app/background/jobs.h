// Work in the background: the one way in which the window has something done that may take long.
#pragma once

#include "model/files/project_file.h"
#include "model/guarded.h"
#include "sim/base/parallel.h"

#include <QObject>
#include <QPointer>

#include <condition_variable>
#include <deque>
#include <functional>
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

/// Lives on the GUI thread. Whatever a job throws becomes its error, which names `doing`: what is done, the file named,
/// as in "Reading head.glb".
class Jobs : public QObject
{
    Q_OBJECT
public:
    explicit Jobs(QWidget& window);
    ~Jobs() override; ///< Tells what is under way to stop and waits for it; nobody hears of it any more.

    /// The result, waited for: the window stays alive but takes no input, and what is clicked or typed meanwhile is
    /// lost. After half a second a window shows how far the work is; its Cancel is all that can be pressed. None where
    /// the work was cancelled.
    template<typename T>
    [[nodiscard]] std::optional<model::Result<T>> await(const QString& doing, const Work<T>& work);
    /// Waits in the same way until `ready` (asked again and again, on the GUI thread); false where cancelled.
    [[nodiscard]] bool awaitUntil(const QString& doing, const std::function<bool()>& ready);

    /// Nobody waits: `done` gets the result, on the GUI thread, unless `receiver` is gone by then.
    template<typename T>
    void start(const QString& doing, Work<T> work, QObject* receiver, std::function<void(model::Result<T>)> done);

protected:
    void customEvent(QEvent* event) override; ///< Something is done that nobody waited for.

private:
    /// Makes what is told of the work, on the GUI thread.
    using Unwatched = std::function<std::function<void()>(const model::Progress&)>;

    bool runWatched(const QString& doing, const std::function<void(const model::Progress&)>& work);
    void runUnwatched(Unwatched work);
    void workUnwatched(const std::stop_token& stop);

    QWidget& m_window;
    std::mutex m_mutex; ///< Of the work and of what is told of it.
    std::condition_variable_any m_wanted;
    std::deque<Unwatched> m_unwatched;
    std::vector<std::function<void()>> m_told;
    std::vector<std::jthread> m_threads;
};

template<typename T>
std::optional<model::Result<T>> Jobs::await(const QString& doing, const Work<T>& work)
{
    std::optional<model::Result<T>> result;
    const bool cancelled = runWatched(doing, [&](const model::Progress& progress) {
        result.emplace(model::guarded(doing, [&] { return work(progress); }));
    });
    // What was written in spite of it is there; what was only read or made is not used.
    if (cancelled && (!std::is_void_v<T> || !*result))
        return std::nullopt;
    return result;
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
