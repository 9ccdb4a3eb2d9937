// The colour that a hair has along its length.
#pragma once

#include "model/values/srgb.h"
#include "sim/groom/groom.h"
#include "sim/groom/strand_look.h"

#include <cstdint>

namespace hairpaint::test {

/// So far from its root: its green, linear, 0..1.
inline float greenAt(const sim::Groom& groom, std::uint32_t slot, float alongM)
{
    const sim::StrandStyle& style = groom.style(slot);
    const float part = sim::tipMixOf(groom.settings.material, style.tipStart).at(alongM / style.lengthM);
    const auto lightOf = [](std::uint32_t colour) {
        return model::linearFromSrgb(static_cast<float>(colour >> 8U & 0xFFU) / 255.0F);
    };
    return glm::mix(lightOf(style.rootColour), lightOf(style.tipColour), part);
}

} // namespace hairpaint::test
