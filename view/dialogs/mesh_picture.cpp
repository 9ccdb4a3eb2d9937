// Filled triangles with a buffer of depths.
#include "view/dialogs/mesh_picture.h"

#include "view/look/theme.h"
#include "view/widgets/colour_math.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace hairpaint::view {

namespace {

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
    const auto right = static_cast<float>(image.width() - 1);
    const auto bottom = static_cast<float>(image.height() - 1);
    if (high.x < 0.0F || high.y < 0.0F || low.x > right || low.y > bottom)
        return;
    const int x1 = static_cast<int>(std::min(high.x, right));
    const int y1 = static_cast<int>(std::min(high.y, bottom));
    for (int y = static_cast<int>(std::max(low.y, 0.0F)); y <= y1; ++y) {
        for (int x = static_cast<int>(std::max(low.x, 0.0F)); x <= x1; ++x) {
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

MeshFraming MeshFraming::around(const sim::HeadMesh& mesh, const glm::mat3& axes, QSize pixels)
{
    constexpr float kFilled = 0.88F;
    MeshFraming framing{
        .axes = axes,
        .middlePx = {0.5F * static_cast<float>(pixels.width()), 0.5F * static_cast<float>(pixels.height())}};
    if (mesh.positionsHd.empty())
        return framing;
    glm::vec3 low(std::numeric_limits<float>::max());
    glm::vec3 high(std::numeric_limits<float>::lowest());
    for (const glm::vec3& position : mesh.positionsHd) {
        const glm::vec3 seen = position * axes;
        low = glm::min(low, seen);
        high = glm::max(high, seen);
    }
    const glm::vec2 size = glm::max(glm::vec2(high - low), glm::vec2(1e-6F));
    framing.middle = axes * (0.5F * (low + high));
    framing.pixelsPerUnit = kFilled * std::min(2.0F * framing.middlePx.x / size.x, 2.0F * framing.middlePx.y / size.y);
    return framing;
}

glm::vec3 MeshFraming::toPicture(const glm::vec3& position) const
{
    const glm::vec3 seen = (position - middle) * axes * pixelsPerUnit;
    return {middlePx.x + seen.x, middlePx.y - seen.y, seen.z};
}

sim::RayHd MeshFraming::rayThrough(QPointF px) const
{
    constexpr float kFarPx = 1e4F;
    const glm::vec3 seen(static_cast<float>(px.x()) - middlePx.x, middlePx.y - static_cast<float>(px.y()), kFarPx);
    return {.originHd = middle + axes * seen / pixelsPerUnit, .directionHd = -axes[2]};
}

QImage meshPicture(const sim::HeadMesh& mesh, const MeshFraming& framing, QSize pixels)
{
    const Theme theme = Theme::current();
    const bool dark = theme.kind == ThemeKind::Dark;
    const QColor shadow = dark ? theme.line : theme.dimText;
    const QColor lit = dark ? theme.text : QColor(Qt::white);
    QImage image(pixels, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    std::vector<float> depths(static_cast<std::size_t>(pixels.width()) * static_cast<std::size_t>(pixels.height()),
                              std::numeric_limits<float>::lowest());
    for (const glm::uvec3& triangle : mesh.triangles) {
        std::array<glm::vec3, 3> corners{};
        for (int i = 0; i < 3; ++i)
            corners[static_cast<std::size_t>(i)] = framing.toPicture(mesh.positionsHd[triangle[i]]);
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

void paintPicturePanel(QPainter& painter, const QRect& area)
{
    const Theme theme = Theme::current();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme.line, 1.0));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(QRectF(area).adjusted(0.5, 0.5, -0.5, -0.5), metrics::kRadius, metrics::kRadius);
}

} // namespace hairpaint::view
