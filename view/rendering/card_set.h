// Hair cards, ready to be drawn instead of strands.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace hairpaint::rendering {

/// The light on a card is that on a hair which lies along it there.
struct CardCorner
{
    glm::vec3 positionHd{0.0F};
    glm::vec3 normalHd{0.0F, 0.0F, 1.0F};   ///< Unit, outward.
    glm::vec3 tangentHd{0.0F, -1.0F, 0.0F}; ///< Unit, toward the hairs' tips.
    glm::vec3 colour{0.2F};                 ///< Colour of the hair around; linear.
    glm::vec2 uv{0.0F};                     ///< 0..1, v down.
    float shine = 0.5F;                     ///< As in sim::StrandMaterial.
    float roughness = 0.35F;
};

/// Rows from v = 0 on: sRGB as encoded, and alpha.
struct CardTexture
{
    int side = 0;
    std::vector<glm::u8vec4> texels;
};

/// Immutable once shared between threads.
struct CardSet
{
    std::vector<CardCorner> corners;
    std::vector<glm::uvec3> triangles; ///< Seen from both sides.
    std::vector<CardTexture> levels;   ///< The atlas, and what is left of it at half the side, again and again.
    float cutoff = 0.5F;               ///< Alpha from which there is hair.
};

/// How much hair lies between what is seen of a card and its lights, as area over area: it stands for the outer hair of
/// a lock, and nothing shades it but the head.
inline constexpr float kCrossedByCards = 0.5F;

/// Fills in the corners' tangents and colours: hair runs along v, and the texture has its colour.
void tellHairOfCorners(CardSet& cards);

/// The texture and all smaller ones down to one texel, each texel the mean of four. The side is a power of two.
[[nodiscard]] std::vector<CardTexture> withSmallerLevels(CardTexture texture);

} // namespace hairpaint::rendering
