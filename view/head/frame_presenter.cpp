// Chooses how frames come to the screen.
#include "view/head/frame_presenter.h"

#include "view/head/gl_presenter.h"
#include "view/head/software_presenter.h"

#include <QGuiApplication>

#include <memory>
#include <utility>

namespace hairpaint::view {

namespace {

/// Where a QOpenGLWidget can't work at all.
bool headless()
{
    const QString platform = QGuiApplication::platformName();
    return platform == QLatin1StringView("offscreen") || platform == QLatin1StringView("minimal");
}

} // namespace

FramePresenter* FramePresenter::make(PresenterChoice choice, QWidget* area)
{
    if (choice == PresenterChoice::Gl && !headless())
        return new GlPresenter(area);
    auto thread = std::make_unique<RenderThread>();
    if (choice == PresenterChoice::Automatic && !headless()) {
        const RenderStart start = thread->waitForStart();
        if (start.works && !start.software) {
            thread.reset();
            return new GlPresenter(area);
        }
    }
    return new SoftwarePresenter(std::move(thread), area);
}

} // namespace hairpaint::view
