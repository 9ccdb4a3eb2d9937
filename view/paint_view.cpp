// The paint area.
#include "view/paint_view.h"

#include "view/editor_state.h"

namespace hairpaint::view {

struct PaintView::State
{
    EditorState* editor = nullptr;
};

PaintView::PaintView(EditorState& state, const Theme&, QWidget* parent)
    : QWidget(parent), m_state(std::make_unique<State>(State{&state}))
{}
PaintView::~PaintView() = default;
void PaintView::setTheme(const Theme&) {}
glm::vec2 PaintView::uvAt(QPointF position) const
{
    return {static_cast<float>(position.x()) / 512.0F, 1.0F - static_cast<float>(position.y()) / 512.0F};
}
QPointF PaintView::positionOf(glm::vec2 uv) const
{
    return {512.0 * uv.x, 512.0 * (1.0F - uv.y)};
}
double PaintView::zoom() const
{
    return 1.0;
}
bool PaintView::mirrored() const
{
    return false;
}
void PaintView::zoomIn() {}
void PaintView::zoomOut() {}
void PaintView::zoomAt(QPointF, double) {}
void PaintView::panBy(QPointF) {}
void PaintView::rotateBy(double) {}
void PaintView::fit() {}
void PaintView::resetView() {}
void PaintView::mirrorView() {}

} // namespace hairpaint::view
