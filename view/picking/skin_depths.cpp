// Draws the skin's triangles by 1/depth, which is linear over the picture.
#include "view/picking/skin_depths.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

constexpr int kMostSamples = 384; ///< Along the longer side.

} // namespace

SkinDepths::SkinDepths(const sim::Skin* skin, const sim::HeadPose& pose, const Lens& lens, QSize size)
{
    const int longer = std::max({size.width(), size.height(), 1});
    m_scale = std::min(1.0F, static_cast<float>(kMostSamples) / static_cast<float>(longer));
    m_width = static_cast<int>(std::ceil(static_cast<float>(size.width()) * m_scale)) + 1;
    m_height = static_cast<int>(std::ceil(static_cast<float>(size.height()) * m_scale)) + 1;
    m_depths.assign(static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height), 0.0F);
    if (skin == nullptr)
        return;
    const sim::HeadMesh& mesh = skin->mesh();
    std::vector<glm::vec3> seen;
    seen.reserve(mesh.positionsHd.size());
    for (const glm::vec3& positionHd : mesh.positionsHd) {
        glm::vec3 one = lens.seen(pose.rotation * positionHd + pose.positionWo);
        one.z = one.z > 0.0F ? 1.0F / one.z : 0.0F;
        seen.emplace_back(one.x * m_scale, one.y * m_scale, one.z);
    }
    for (const glm::uvec3& face : mesh.triangles)
        draw(seen[face.x], seen[face.y], seen[face.z]);
}

/// x, y in samples, z: 1/depth. Samples lie at whole numbers.
void SkinDepths::draw(glm::vec3 a, glm::vec3 b, glm::vec3 c)
{
    if (a.z <= 0.0F || b.z <= 0.0F || c.z <= 0.0F)
        return; // Reaches behind the eye.
    const float area = crossed(glm::vec2(b) - glm::vec2(a), glm::vec2(c) - glm::vec2(a));
    if (std::abs(area) < 1e-9F)
        return;
    const auto from = [](float least) { return std::max(0, static_cast<int>(std::ceil(std::max(least, 0.0F)))); };
    const auto to = [](float most, int count) {
        return static_cast<int>(std::floor(std::clamp(most, -1.0F, static_cast<float>(count - 1))));
    };
    const int left = from(std::min({a.x, b.x, c.x}));
    const int right = to(std::max({a.x, b.x, c.x}), m_width);
    const int bottom = to(std::max({a.y, b.y, c.y}), m_height);
    for (int y = from(std::min({a.y, b.y, c.y})); y <= bottom; ++y) {
        for (int x = left; x <= right; ++x) {
            const glm::vec2 point(static_cast<float>(x), static_cast<float>(y));
            const float ofB = crossed(point - glm::vec2(a), glm::vec2(c) - glm::vec2(a)) / area;
            const float ofC = crossed(glm::vec2(b) - glm::vec2(a), point - glm::vec2(a)) / area;
            if (ofB < 0.0F || ofC < 0.0F || ofB + ofC > 1.0F)
                continue;
            float& nearest = at(x, y);
            nearest = std::max(nearest, a.z + (b.z - a.z) * ofB + (c.z - a.z) * ofC);
        }
    }
}

/// Skin counts where all samples around the point show it, and as far away as the furthest of them: at the outline of
/// the head nothing is hidden that is seen.
bool SkinDepths::hides(glm::vec3 seen) const
{
    const float x = seen.x * m_scale;
    const float y = seen.y * m_scale;
    if (!(x >= 0.0F) || !(y >= 0.0F) || x >= static_cast<float>(m_width - 1) || y >= static_cast<float>(m_height - 1))
        return false;
    const std::size_t first =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
    const std::size_t below = first + static_cast<std::size_t>(m_width);
    const float furthest = std::min({m_depths[first], m_depths[first + 1], m_depths[below], m_depths[below + 1]});
    return furthest > 0.0F && seen.z > 1.0F / furthest + kOnSkinM;
}

} // namespace hairpaint::view
