// Shows frames that another thread draws without OpenGL.
#pragma once

#include "view/head_area/frame_presenter.h"
#include "view/head_area/render_thread.h"

#include <memory>
#include <optional>

namespace hairpaint::view {

/// Where there is no GPU: a QOpenGLWidget would make every repaint of the whole window slow; here the rest of the
/// window never waits. Renders at one pixel per point whatever the screen's scale.
class SoftwarePresenter : public FramePresenter
{
    Q_OBJECT
public:
    SoftwarePresenter(std::unique_ptr<RenderThread> thread, QWidget* parent);
    ~SoftwarePresenter() override;

    [[nodiscard]] QWidget& widget() override;
    void present(const Shot& shot) override;
    [[nodiscard]] bool resting() const override { return m_thread->resting(); }
    [[nodiscard]] QImage grab(const rendering::Scene& scene, QSize size) override;
    [[nodiscard]] QString description() const override;

private:
    class Canvas;
    void onFrameReady();

    std::unique_ptr<RenderThread> m_thread;
    Canvas* m_canvas; ///< Owned by its parent widget.
};

} // namespace hairpaint::view
