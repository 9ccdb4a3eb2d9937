// A mesh seen from the front, and a person.
#include "view/dialogs/mesh_silhouette.h"

#include "sim/skin/mesh_bounds.h"
#include "view/dialogs/mesh_picture.h"
#include "view/look/theme.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace hairpaint::view {

namespace {

/// Seen from the front; +y or +z is up.
glm::mat3 frontAxes(model::UpAxis axis)
{
    return axis == model::UpAxis::Y ? glm::mat3(1.0F)
                                    : glm::mat3({1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F}, {0.0F, -1.0F, 0.0F});
}

/// The figure of a person of 1.75 m from the front; metres, the crown at the origin, y down.
QPainterPath personFigure()
{
    QPainterPath person;
    person.setFillRule(Qt::WindingFill);
    const auto limb = [&person](double x, double y, double width, double height) {
        person.addRoundedRect(QRectF(x - width / 2.0, y, width, height), width / 2.0, width / 2.0);
    };
    person.addEllipse(QRectF(-0.078, 0.0, 0.156, 0.23));
    limb(0.0, 0.17, 0.10, 0.18);                                        // Neck,
    person.addRoundedRect(QRectF(-0.20, 0.29, 0.40, 0.20), 0.09, 0.09); // shoulders,
    person.addRoundedRect(QRectF(-0.15, 0.32, 0.30, 0.60), 0.09, 0.09); // trunk,
    for (const double side : {-1.0, 1.0}) {
        limb(side * 0.205, 0.31, 0.085, 0.72); // arms,
        limb(side * 0.085, 0.80, 0.135, 0.95); // and legs.
    }
    return person;
}

/// Fraction of the widget's width that the mesh has.
constexpr double kMeshPart = 0.6;

} // namespace

MeshSilhouette::MeshSilhouette(const sim::HeadMesh& mesh, QWidget* parent) : QWidget(parent), m_mesh(mesh)
{
    setAccessibleName(tr("The mesh from the front, beside a person of 1.75 m"));
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

void MeshSilhouette::setMetresPerUnit(double metres)
{
    if (metres == m_metresPerUnit)
        return;
    m_metresPerUnit = metres;
    update();
}

void MeshSilhouette::paintPerson(QPainter& painter, QPointF top, double pixelsPerMetre) const
{
    constexpr double kMostPixelsPerMetre = 1e5; // All that is in sight is skin.
    const double scale = std::min(pixelsPerMetre, kMostPixelsPerMetre);
    painter.save();
    painter.setClipRect(QRectF(rect()).adjusted(width() * kMeshPart, 1.0, -1.0, -1.0));
    painter.translate(top);
    painter.scale(scale, scale);
    painter.fillPath(personFigure(), Theme::current().line);
    painter.restore();
}

void MeshSilhouette::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    paintPicturePanel(painter, rect());
    const QSize pixels(static_cast<int>(width() * kMeshPart * devicePixelRatioF()),
                       static_cast<int>(height() * devicePixelRatioF()));
    if (m_picture.size() != pixels) {
        const MeshFraming framing = MeshFraming::around(m_mesh, frontAxes(m_axis), pixels);
        const glm::vec3 size = sim::boundsOf(m_mesh).size();
        m_picture = meshPicture(m_mesh, framing, pixels);
        m_pixelsPerUnit = static_cast<double>(framing.pixelsPerUnit) / devicePixelRatioF();
        m_meshTop =
            (height() - m_pixelsPerUnit * static_cast<double>(m_axis == model::UpAxis::Y ? size.y : size.z)) / 2.0;
    }
    painter.drawImage(QRectF(0.0, 0.0, width() * kMeshPart, height()), m_picture);
    if (m_metresPerUnit > 0.0)
        paintPerson(painter, {width() * (kMeshPart + 1.0) / 2.0, m_meshTop}, m_pixelsPerUnit / m_metresPerUnit);
}

} // namespace hairpaint::view
