// Work in the background: the one way in which the window has something done that may take long.
#pragma once

#include "model/files/project_file.h"
#include "model/guarded.h"
#include "sim/base/parallel.h"

#include <QObject>
#include <QPointer>
#include <QThreadPool>

#include <atomic>
#include <functional>
#include <optional>

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

private:
    bool runWatched(const QString& doing, const std::function<void(const model::Progress&)>& work);
    void runUnwatched(std::function<void()> work);

    QWidget& m_window;
    std::atomic<bool> m_stop = false;
    QThreadPool m_watched;
    QThreadPool m_unwatched;
};

template<typename T>
std::optional<model::Result<T>> Jobs::await(const QString& doing, const Work<T>& work)
{
    std::optional<model::Result<T>> result;
    const bool cancelled = runWatched(doing, [&](const model::Progress& progress) {
        result.emplace(model::guarded(doing, [&] { return work(progress); }));
    });
    // Work that was done in spite of it counts.
    if (cancelled && !*result)
        return std::nullopt;
    return result;
}

template<typename T>
void Jobs::start(const QString& doing, Work<T> work, QObject* receiver, std::function<void(model::Result<T>)> done)
{
    runUnwatched([this, doing, work = std::move(work), receiver = QPointer<QObject>(receiver), done = std::move(done)] {
        auto result = std::make_shared<model::Result<T>>(
            model::guarded(doing, [&] { return work([this](double) { return !m_stop; }); }));
        QMetaObject::invokeMethod(
            this,
            [receiver, done, result] {
                if (receiver)
                    done(std::move(*result));
            },
            Qt::QueuedConnection);
    });
}

} // namespace hairpaint::app
