// The 3D area.
#include "view/head_view.h"

#include "view/editor_state.h"

namespace hairpaint::view {

struct HeadView::State
{
    EditorState* editor = nullptr;
    rendering::Camera camera;
};

HeadView::HeadView(EditorState& state, const Theme&, PresenterChoice, QWidget* parent)
    : QWidget(parent), m_state(std::make_unique<State>(State{&state, {}}))
{}
HeadView::~HeadView() = default;
void HeadView::setTheme(const Theme&) {}
void HeadView::setFrame(std::shared_ptr<const sim::StrandFrame>) {}
const rendering::Camera& HeadView::camera() const
{
    return m_state->camera;
}
void HeadView::setCamera(const rendering::Camera& camera)
{
    m_state->camera = camera;
}
void HeadView::setView(StandardView) {}
QImage HeadView::grabPicture(QSize)
{
    return {};
}
std::optional<sim::SurfacePoint> HeadView::skinAt(QPointF) const
{
    return std::nullopt;
}
QPointF HeadView::positionOf(glm::vec3) const
{
    return {};
}
QString HeadView::rendererDescription() const
{
    return {};
}
bool HeadView::weatherShown() const
{
    return false;
}
void HeadView::resetCamera() {}
void HeadView::fit() {}
void HeadView::zoomIn() {}
void HeadView::zoomOut() {}
void HeadView::setWeatherShown(bool) {}

} // namespace hairpaint::view
