// A mesh seen from the front, shaded by its faces' slope.
#include "view/dialogs/mesh_silhouette.h"

#include "view/theme.h"
#include "view/widgets/colour_math.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace hairpaint::view {

namespace {

glm::vec3 turned(glm::vec3 position, model::UpAxis axis)
{
    return axis == model::UpAxis::Y ? position : glm::vec3(position.x, position.z, -position.y);
}

/// Fills the pixels whose middles lie in the triangle (pixels, depth toward the eye), where it is nearest.
void fill(QImage& image, std::vector<float>& depths, const std::array<glm::vec3, 3>& corners, QRgb colour)
{
    const auto edge = [](glm::vec3 a, glm::vec3 b, glm::vec2 p) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    };
    const auto& [a, b, c] = corners;
    const float area = edge(a, b, glm::vec2(c));
    if (area == 0.0F)
        return;
    const glm::vec3 low = glm::min(a, glm::min(b, c));
    const glm::vec3 high = glm::max(a, glm::max(b, c));
    const int x1 = std::min(static_cast<int>(high.x), image.width() - 1);
    const int y1 = std::min(static_cast<int>(high.y), image.height() - 1);
    for (int y = std::max(static_cast<int>(low.y), 0); y <= y1; ++y) {
        for (int x = std::max(static_cast<int>(low.x), 0); x <= x1; ++x) {
            const glm::vec2 middle(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            const float wa = edge(b, c, middle) / area;
            const float wb = edge(c, a, middle) / area;
            const float wc = 1.0F - wa - wb;
            if (wa < 0.0F || wb < 0.0F || wc < 0.0F)
                continue;
            const float depth = wa * a.z + wb * b.z + wc * c.z;
            float& nearest = depths[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width()) +
                                    static_cast<std::size_t>(x)];
            if (depth <= nearest)
                continue;
            nearest = depth;
            image.setPixel(x, y, colour);
        }
    }
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

QImage MeshSilhouette::picture(QSize pixels) const
{
    const Theme theme = Theme::current();
    const bool dark = theme.kind == ThemeKind::Dark;
    const QColor shadow = dark ? theme.line : theme.dimText;
    const QColor lit = dark ? theme.text : QColor(Qt::white);
    QImage image(pixels, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    if (m_mesh.positionsHd.empty())
        return image;
    glm::vec3 low = turned(m_mesh.positionsHd.front(), m_axis);
    glm::vec3 high = low;
    for (const glm::vec3& position : m_mesh.positionsHd) {
        low = glm::min(low, turned(position, m_axis));
        high = glm::max(high, turned(position, m_axis));
    }
    const glm::vec3 size = glm::max(high - low, glm::vec3(1e-6F));
    const glm::vec2 room(static_cast<float>(pixels.width()), static_cast<float>(pixels.height()));
    const float scale = 0.88F * std::min(room.x / size.x, room.y / size.y);
    const glm::vec3 middle = (low + high) * 0.5F;
    std::vector<float> depths(static_cast<std::size_t>(pixels.width()) * static_cast<std::size_t>(pixels.height()),
                              std::numeric_limits<float>::lowest());
    for (const glm::uvec3& triangle : m_mesh.triangles) {
        std::array<glm::vec3, 3> corners{};
        for (int i = 0; i < 3; ++i) {
            const glm::vec3 position = turned(m_mesh.positionsHd[triangle[i]], m_axis) - middle;
            corners[static_cast<std::size_t>(i)] = {room.x * 0.5F + position.x * scale,
                                                    room.y * 0.5F - position.y * scale, position.z * scale};
        }
        glm::vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const float length = glm::length(normal);
        if (length <= 0.0F)
            continue;
        normal = normal.z < 0.0F ? normal / -length : normal / length;
        const auto light = static_cast<double>(glm::dot(normal, glm::vec3(0.35F, -0.45F, 0.82F)));
        fill(image, depths, corners, mixed(shadow, lit, 0.1 + 0.75 * std::clamp(light, 0.0, 1.0)).rgb());
    }
    return image;
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
        m_picture = picture(pixels);
    painter.drawImage(QRectF(rect()), m_picture);
}

} // namespace hairpaint::view
