// How a hair looks beside its colour, and how that changes from root to tip. Renderers and exports have the same law.
#pragma once

#include "sim/groom/group_settings.h"
#include "sim/groom/map_slot.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>

namespace hairpaint::sim {

/// A hair's length over the length of its taper, at least 1; 1 without a taper.
[[nodiscard]] inline float perTaperOf(const StrandMaterial& material, float lengthM)
{
    return material.taperM > 0.0F ? std::max(lengthM / material.taperM, 1.0F) : 1.0F;
}

/// Fraction of the diameter that is left at fraction s of the hair. Used as opacity instead where the hair is drawn at
/// its whole width.
[[nodiscard]] inline float thinnedAt(const StrandMaterial& material, float perTaper, float s)
{
    const float t = std::max(s * perTaper + (1.0F - perTaper), 0.0F);
    return glm::mix(material.rootAlpha, material.tipAlpha, t * t);
}

/// Factors on the group's shine and on the sharpness of its highlights: exactly 1 where nothing is painted.
struct Gloss
{
    float shine = 1.0F;
    float sharpness = 1.0F;
};

/// `value` as the map has it: at 0 a hair is matte, at 65535 it mirrors.
[[nodiscard]] constexpr Gloss glossOf(std::uint16_t value)
{
    constexpr float kMostShine = 2.0F;
    constexpr float kMostSharpness = 2.5F;
    constexpr float kLeastSharpness = 0.4F;
    constexpr float kNeutral = ruleOf(MapSlot::Gloss).defaultValue[0];
    const auto given = static_cast<float>(value);
    if (given <= kNeutral) {
        const float part = given / kNeutral - 1.0F;
        return {.shine = 1.0F + part, .sharpness = 1.0F + (1.0F - kLeastSharpness) * part};
    }
    const float part = (given - kNeutral) / (65535.0F - kNeutral);
    return {.shine = 1.0F + (kMostShine - 1.0F) * part, .sharpness = 1.0F + (kMostSharpness - 1.0F) * part};
}

/// The group's roughness where a hair's highlights are as sharp as its gloss says.
[[nodiscard]] inline float roughnessOf(const StrandMaterial& material, std::uint16_t gloss)
{
    constexpr float kLeast =
        0.02F; // Widths of highlights are that + kGrowth roughness: view/rendering/light/fibre_shape.h
    constexpr float kGrowth = 0.18F;
    const float sharpness = glossOf(gloss).sharpness;
    if (sharpness == 1.0F)
        return material.roughness;
    return std::clamp(((kLeast + kGrowth * material.roughness) / sharpness - kLeast) / kGrowth, 0.0F, 1.0F);
}

/// Weight of the tip colour at fraction s of the hair: s scale + offset, clamped to 0..1.
struct TipMix
{
    float scale = 1.0F;
    float offset = 0.0F;
    [[nodiscard]] float at(float s) const { return std::clamp(s * scale + offset, 0.0F, 1.0F); }
    /// Whether the weight is not linear between two fractions.
    [[nodiscard]] bool bendsWithin(float from, float to) const
    {
        const auto isWithin = [&](float s) { return s > from + 1e-3F && s < to - 1e-3F; };
        return isWithin(-offset / scale) || isWithin((1.0F - offset) / scale);
    }
};
/// `tipStart` as the map has it: from 0, where the group says, to 1, at the very tip.
[[nodiscard]] inline TipMix tipMixOf(const StrandMaterial& material, float tipStart = 0.0F)
{
    constexpr float kSharpest = 1e-3F; ///< Least fraction of the length over which the colour changes: a line.
    const float from = material.tipFrom + (1.0F - material.tipFrom) * tipStart;
    const float scale = 1.0F / std::max(material.tipOver * (1.0F - from), kSharpest);
    return {.scale = scale, .offset = from * -scale};
}
/// The tip start map's value of hair whose tip colour begins at a fraction of its length; 0 where the group's begins
/// further on.
[[nodiscard]] inline float tipStartOf(const StrandMaterial& material, float from)
{
    constexpr float kLeastRest = 1e-3F;
    const float rest = std::max(1.0F - material.tipFrom, kLeastRest);
    return std::clamp((from - material.tipFrom) / rest, 0.0F, 1.0F);
}

} // namespace hairpaint::sim
