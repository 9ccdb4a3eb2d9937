// Smaller levels of a texture, and what corners know of the hair around them.
#include "view/rendering/card_set.h"

#include "view/rendering/light/encoded_colour.h"

#include <algorithm>
#include <utility>

namespace hairpaint::rendering {

namespace {

constexpr int kColourSide =
    128; ///< Texels across the level that colours come from: each is the mean of a lock's width.

/// The derivative of the position by v, times a positive number; 0 where the texture has no area.
glm::vec3 alongV(const CardCorner& a, const CardCorner& b, const CardCorner& c)
{
    const glm::vec2 first = b.uv - a.uv;
    const glm::vec2 second = c.uv - a.uv;
    const float area = first.x * second.y - first.y * second.x;
    const glm::vec3 along = (c.positionHd - a.positionHd) * first.x - (b.positionHd - a.positionHd) * second.x;
    return area < 0.0F ? -along : area > 0.0F ? along : glm::vec3(0.0F);
}

} // namespace

void tellHairOfCorners(CardSet& cards)
{
    std::vector<glm::vec3> along(cards.corners.size(), glm::vec3(0.0F));
    for (const glm::uvec3& triangle : cards.triangles) {
        const glm::vec3 one = alongV(cards.corners[triangle.x], cards.corners[triangle.y], cards.corners[triangle.z]);
        if (const float length = glm::length(one); length > 0.0F)
            for (int i = 0; i < 3; ++i)
                along[triangle[i]] += one / length;
    }
    const auto level =
        std::ranges::find_if(cards.levels, [](const CardTexture& one) { return one.side <= kColourSide; });
    for (std::size_t i = 0; i < cards.corners.size(); ++i) {
        CardCorner& corner = cards.corners[i];
        if (const float length = glm::length(along[i]); length > 1e-6F)
            corner.tangentHd = along[i] / length;
        if (level == cards.levels.end())
            continue;
        const glm::ivec2 at = glm::clamp(glm::ivec2(corner.uv * static_cast<float>(level->side)), 0, level->side - 1);
        const glm::u8vec4 texel = level->texels[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(level->side) +
                                                static_cast<std::size_t>(at.x)];
        for (int channel = 0; channel < 3; ++channel)
            corner.colour[channel] = linearOfEncoded(static_cast<float>(texel[channel]) / 255.0F);
    }
}

std::vector<CardTexture> withSmallerLevels(CardTexture texture)
{
    std::vector<CardTexture> levels;
    levels.push_back(std::move(texture));
    while (levels.back().side > 1) {
        const CardTexture& fine = levels.back();
        const auto across = static_cast<std::size_t>(fine.side);
        CardTexture half{.side = fine.side / 2, .texels = {}};
        half.texels.reserve(fine.texels.size() / 4);
        for (std::size_t y = 0; y < across; y += 2)
            for (std::size_t x = 0; x < across; x += 2) {
                glm::uvec4 sum(2); // Rounds.
                for (const std::size_t i :
                     {y * across + x, y * across + x + 1, (y + 1) * across + x, (y + 1) * across + x + 1})
                    sum += glm::uvec4(fine.texels[i]);
                half.texels.emplace_back(sum / 4U);
            }
        levels.push_back(std::move(half));
    }
    return levels;
}

} // namespace hairpaint::rendering
