// See the header.
#include "model/tools/lying/restyled_hair.h"

#include "model/tools/lying/evened_hair.h"
#include "sim/base/rounded.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

constexpr float kRuffleRad = 0.9F;     ///< Noise turns by at most this,
constexpr float kRuffleLength = 0.25F; ///< and changes the length by at most this.
constexpr float kRuffleCells = 512.0F; ///< Cells of noise along the layout's side.

/// -1..1, the same for the same uv.
float noiseAt(int x, int y, std::uint32_t salt)
{
    std::uint32_t h =
        static_cast<std::uint32_t>(x) * 0x8DA6B343U ^ static_cast<std::uint32_t>(y) * 0xD8163841U ^ salt * 0xCB1AB31FU;
    h = (h ^ (h >> 15U)) * 0x2C1B3C6DU;
    h = (h ^ (h >> 12U)) * 0x297A2D39U;
    return static_cast<float>((h ^ (h >> 15U)) >> 8U) / 8388608.0F - 1.0F;
}

glm::vec2 turnedBy(glm::vec2 v, float angleRad)
{
    const float c = sim::cosRounded(angleRad);
    const float s = sim::sinRounded(angleRad);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}

} // namespace

glm::vec2 restyled(FallenHair& before, SkinFrames& frames, glm::vec2 uv, glm::vec2 reachUv,
                   const ToolSettings& settings)
{
    const glm::vec2 was = before.at(uv);
    const float length = glm::length(was);
    if (settings.comb == CombKind::Smooth)
        return evenedDirection(frames, before, uv, reachUv);
    if (settings.comb == CombKind::Noise) {
        const glm::ivec2 cell(glm::floor(uv * kRuffleCells));
        const float stretched = std::clamp(length * (1.0F + kRuffleLength * noiseAt(cell.x, cell.y, 2)), 0.0F, 1.0F);
        const glm::vec2 direction = length > 0.0F ? was / length : glm::vec2(0.0F);
        return turnedBy(direction * stretched, kRuffleRad * noiseAt(cell.x, cell.y, 1));
    }
    const float flat =
        settings.lift < 0.0F ? length + (1.0F - length) * -settings.lift : length * (1.0F - settings.lift);
    return length > 1e-4F ? was * (flat / length) : was; // Upright hair has no direction along the skin.
}

} // namespace hairpaint::model
