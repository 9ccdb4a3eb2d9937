// Long work on another thread, with progress and cancel once it takes over half a second.
#pragma once

#include "model/error.h"
#include "model/files/project_file.h"

#include <QEventLoop>
#include <QProgressDialog>
#include <QThreadPool>
#include <QTimer>

#include <atomic>
#include <memory>

namespace hairpaint::app {

/// Runs `work(progress)` on another thread while the window stays alive (but takes no input), and returns its result.
/// After cancelling, the work returns its own error, which `cancelled` tells apart. Everything the work uses must be
/// the caller's own copy.
template<typename T>
[[nodiscard]] model::Result<T> runInBackground(QWidget* parent, const QString& label,
                                               const std::function<model::Result<T>(const model::Progress&)>& work,
                                               bool* cancelled = nullptr)
{
    std::atomic<double> share = 0.0;
    std::atomic<bool> stop = false;
    std::optional<model::Result<T>> result;
    QEventLoop loop;
    QProgressDialog dialog(label, QProgressDialog::tr("Cancel"), 0, 100, parent);
    dialog.setWindowModality(Qt::ApplicationModal);
    dialog.setMinimumDuration(500);
    dialog.setAutoClose(false);
    dialog.setAutoReset(false);
    dialog.setValue(0);
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &dialog, [&] {
        if (!stop)
            dialog.setValue(static_cast<int>(share * 100.0));
    });
    QObject::connect(&dialog, &QProgressDialog::canceled, &dialog, [&] { stop = true; });
    timer.start(50);
    QThreadPool::globalInstance()->start([&] {
        result.emplace(work([&](double done) {
            share = done;
            return !stop;
        }));
        QMetaObject::invokeMethod(&loop, &QEventLoop::quit, Qt::QueuedConnection);
    });
    loop.exec(QEventLoop::ExcludeUserInputEvents | QEventLoop::WaitForMoreEvents);
    while (!result) // A quit from elsewhere must not leave the work with dead references.
        loop.exec();
    if (cancelled != nullptr)
        *cancelled = stop;
    return std::move(*result);
}

} // namespace hairpaint::app
