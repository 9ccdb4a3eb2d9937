// Chooses how frames come to the screen.
#include "view/head_area/frame_presenter.h"

#include "view/head_area/gl_presenter.h"
#include "view/head_area/gpu_probe.h"
#include "view/head_area/software_presenter.h"

#include <QGuiApplication>

#include <memory>

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
    const bool gl = choice == PresenterChoice::Gl || (choice == PresenterChoice::Automatic && !headless() && hasGpu());
    if (gl && !headless())
        return new GlPresenter(area);
    return new SoftwarePresenter(std::make_unique<RenderThread>(), area);
}

} // namespace hairpaint::view
