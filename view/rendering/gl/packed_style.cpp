// Packing strands for the GPU.
#include "view/rendering/gl/packed_style.h"

#include "sim/groom/strand_look.h"

#include <cmath>

namespace hairpaint::rendering {
namespace {

std::uint32_t packDirection(glm::vec3 v)
{
    v /= std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
    glm::vec2 e(v);
    if (v.z < 0.0F)
        e = (1.0F - glm::abs(glm::vec2(v.y, v.x))) * glm::vec2(v.x >= 0.0F ? 1.0F : -1.0F, v.y >= 0.0F ? 1.0F : -1.0F);
    const auto bits = [](float f) {
        return static_cast<std::uint32_t>(static_cast<std::uint16_t>(std::lround(f * 32767.0F)));
    };
    return bits(e.x) | (bits(e.y) << 16U);
}

} // namespace

PackedStyle packedStyle(const sim::StrandStyle& style, glm::vec3 rootTangentHd)
{
    const sim::Gloss gloss = sim::glossOf(style.gloss);
    return {.turns = style.turns,
            .curlRadiusM = style.curlRadiusM,
            .phase = style.phase,
            .rootColour = style.rootColour,
            .tipColour = style.tipColour,
            .width = style.width,
            .braid = static_cast<std::uint32_t>(style.braid) | (std::uint32_t{style.wisp} << 8U) |
                     (std::uint32_t{style.braidTaper} << 16U) | (std::uint32_t{style.braidTied} << 24U),
            .braidRadiusM = style.braidRadiusM,
            .braidStart = style.braidStart,
            .braidTurns = style.braidTurns,
            .wispOffsetX = style.wispOffset.x,
            .wispOffsetY = style.wispOffset.y,
            .variation = style.variation,
            .order = style.detail,
            .lengthM = style.lengthM,
            .frizzM = style.frizzM,
            .shine = gloss.shine,
            .sharpness = gloss.sharpness,
            .tipStart = style.tipStart,
            .tangentHd = packDirection(rootTangentHd)};
}

} // namespace hairpaint::rendering
