// Shows frames in a QOpenGLWidget, for GPUs.
#pragma once

#include "view/head_area/frame_presenter.h"

namespace hairpaint::view {

/// A shot is drawn at once, at the detail that keeps motion fluent; repaints show that picture again. A still one is
/// then refined on the GUI thread in steps of a few milliseconds, between which events are handled, and each finer
/// picture is shown when it is whole; a shot that differs ends that. The renderer is made anew whenever Qt makes the
/// context anew: after its loss, or when a dock floats.
class GlPresenter : public FramePresenter
{
    Q_OBJECT
public:
    explicit GlPresenter(QWidget* parent);

    [[nodiscard]] QWidget& widget() override;
    void present(const Shot& shot) override;
    [[nodiscard]] bool resting() const override { return true; } // The widget draws with its next repaint.
    [[nodiscard]] QImage grab(const rendering::Scene& scene, QSize size) override;
    [[nodiscard]] QString description() const override;

private:
    class Canvas;
    Canvas* m_canvas; ///< Owned by its parent widget.
};

} // namespace hairpaint::view
