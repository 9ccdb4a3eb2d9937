// Tiles of frames, and what lies between them.
#include "model/tools/strokes/skin_frames.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hairpaint::model {

SkinFrames::SkinFrames(std::shared_ptr<const sim::Skin> skin) : m_skin(std::move(skin)) {}

const std::optional<FramedPoint>& SkinFrames::point(int x, int y)
{
    const int left = x / kTileSide * kTileSide;
    const int top = y / kTileSide * kTileSide;
    Tile& tile = m_tiles.at(static_cast<std::size_t>(top / kTileSide) * kTilesAcross +
                            static_cast<std::size_t>(left / kTileSide));
    if (tile.empty()) {
        tile.resize(std::size_t{kTileSide} * kTileSide);
        auto entry = tile.begin();
        for (int row = top; row < top + kTileSide; ++row)
            for (int column = left; column < left + kTileSide; ++column, ++entry) {
                const glm::vec2 centre(static_cast<float>(column) + 0.5F, static_cast<float>(row) + 0.5F);
                const glm::vec2 uv = centre / static_cast<float>(kSize);
                if (const std::optional<sim::SurfacePoint> point = m_skin->atUv({uv.x, 1.0F - uv.y}))
                    *entry = FramedPoint{.frame = sim::SkinFrame::at(*point), .positionHd = point->positionHd};
            }
    }
    return tile[static_cast<std::size_t>(y - top) * kTileSide + static_cast<std::size_t>(x - left)];
}

std::optional<sim::SkinFrame> SkinFrames::at(glm::vec2 uv)
{
    const glm::vec2 onTable =
        glm::clamp(glm::vec2(uv.x, 1.0F - uv.y) * static_cast<float>(kSize) - 0.5F, 0.0F, kSize - 1.0F);
    const glm::ivec2 corner(glm::floor(onTable));
    const glm::vec2 fraction = onTable - glm::vec2(corner);
    // The nearest sample that has skin says which island it is.
    const sim::SkinFrame* nearest = nullptr;
    float nearestWeight = 0.0F;
    std::array<std::pair<const sim::SkinFrame*, float>, 4> around{};
    for (int k = 0; k < 4; ++k) {
        const glm::ivec2 at = glm::min(corner + glm::ivec2(k % 2, k / 2), kSize - 1);
        const std::optional<FramedPoint>& there = point(at.x, at.y);
        const float weight =
            (k % 2 == 0 ? 1.0F - fraction.x : fraction.x) * (k / 2 == 0 ? 1.0F - fraction.y : fraction.y);
        around[static_cast<std::size_t>(k)] = {there ? &there->frame : nullptr, weight};
        if (there && weight >= nearestWeight) {
            nearest = &there->frame;
            nearestWeight = weight;
        }
    }
    if (nearest == nullptr)
        return std::nullopt;
    glm::vec3 x(0.0F);
    glm::vec3 normal(0.0F);
    for (const auto& [frame, weight] : around)
        if (frame != nullptr && glm::dot(frame->x, nearest->x) > kAlike &&
            glm::dot(frame->normal, nearest->normal) > kAlike) {
            x += frame->x * weight;
            normal += frame->normal * weight;
        }
    const float length = glm::length(normal);
    if (length < 1e-6F)
        return *nearest;
    normal /= length;
    x -= normal * glm::dot(x, normal);
    const float along = glm::length(x);
    if (along < 1e-6F)
        return *nearest;
    x /= along;
    const glm::vec3 side = glm::cross(normal, x);
    return sim::SkinFrame{.x = x, .y = glm::dot(side, nearest->y) < 0.0F ? -side : side, .normal = normal};
}

} // namespace hairpaint::model
