// A mesh seen from the front, shaded by its faces' slope.
#include "view/dialogs/mesh_silhouette.h"

#include "view/theme.h"
#include "view/widgets/colour_math.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <vector>

namespace hairpaint::view {

namespace {

constexpr std::size_t kMostFaces = 20'000; ///< Of larger meshes every so many-th face is drawn.

glm::vec3 turned(glm::vec3 position, model::UpAxis axis)
{
    return axis == model::UpAxis::Y ? position : glm::vec3(position.x, position.z, -position.y);
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
    if (m_mesh.positionsHd.empty())
        return;
    glm::vec3 low = turned(m_mesh.positionsHd.front(), m_axis);
    glm::vec3 high = low;
    for (const glm::vec3& position : m_mesh.positionsHd) {
        low = glm::min(low, turned(position, m_axis));
        high = glm::max(high, turned(position, m_axis));
    }
    const glm::vec3 size = glm::max(high - low, glm::vec3(1e-6F));
    const double scale =
        std::min((width() - 24.0) / static_cast<double>(size.x), (height() - 24.0) / static_cast<double>(size.y));
    const glm::vec3 middle = (low + high) * 0.5F;
    const auto place = [&](glm::vec3 position) {
        return QPointF(width() / 2.0 + static_cast<double>(position.x - middle.x) * scale,
                       height() / 2.0 - static_cast<double>(position.y - middle.y) * scale);
    };
    struct Face
    {
        std::array<QPointF, 3> corners;
        float depth;
        double light;
    };
    std::vector<Face> faces;
    const std::size_t step = m_mesh.triangles.size() / kMostFaces + 1;
    for (std::size_t i = 0; i < m_mesh.triangles.size(); i += step) {
        const glm::uvec3 triangle = m_mesh.triangles[i];
        const glm::vec3 a = turned(m_mesh.positionsHd[triangle.x], m_axis);
        const glm::vec3 b = turned(m_mesh.positionsHd[triangle.y], m_axis);
        const glm::vec3 c = turned(m_mesh.positionsHd[triangle.z], m_axis);
        const glm::vec3 normal = glm::cross(b - a, c - a);
        const float length = glm::length(normal);
        if (length <= 0.0F || normal.z <= 0.0F)
            continue;
        const double light = static_cast<double>(glm::dot(normal / length, glm::vec3(0.35F, 0.45F, 0.82F)));
        faces.push_back({{place(a), place(b), place(c)}, a.z + b.z + c.z, std::clamp(light, 0.0, 1.0)});
    }
    std::ranges::sort(faces, {}, &Face::depth);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(Qt::NoPen);
    for (const Face& face : faces) {
        painter.setBrush(mixed(theme.line, theme.text, 0.15 + 0.75 * face.light));
        painter.drawConvexPolygon(face.corners.data(), 3);
    }
}

} // namespace hairpaint::view
