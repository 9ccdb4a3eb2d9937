// A mesh seen from the front.
#include "view/dialogs/mesh_silhouette.h"

#include "view/dialogs/mesh_picture.h"
#include "view/look/theme.h"

#include <QPainter>

namespace hairpaint::view {

namespace {

/// Seen from the front; +y or +z is up.
glm::mat3 frontAxes(model::UpAxis axis)
{
    return axis == model::UpAxis::Y ? glm::mat3(1.0F)
                                    : glm::mat3({1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F}, {0.0F, -1.0F, 0.0F});
}

} // namespace

MeshSilhouette::MeshSilhouette(const sim::HeadMesh& mesh, QWidget* parent) : QWidget(parent), m_mesh(mesh)
{
    setAccessibleName(tr("The mesh from the front"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void MeshSilhouette::setUpAxis(model::UpAxis axis)
{
    if (axis == m_axis)
        return;
    m_axis = axis;
    m_picture = {};
    update();
}

void MeshSilhouette::paintEvent(QPaintEvent* /*event*/)
{
    const Theme theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme.line, 1.0));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), metrics::kRadius, metrics::kRadius);
    const QSize pixels = size() * devicePixelRatioF();
    if (m_picture.size() != pixels)
        m_picture = meshPicture(m_mesh, MeshFraming::around(m_mesh, frontAxes(m_axis), pixels), pixels);
    painter.drawImage(QRectF(rect()), m_picture);
}

} // namespace hairpaint::view
