// All hair of a group made longer, denser or more widely curled by a factor: the ranges change and the maps stay.
#pragma once

#include "sim/groom/group_settings.h"

#include <QString>

#include <array>
#include <span>

namespace hairpaint::model {

/// A quantity that can be scaled by itself.
struct HairScale
{
    const char* title;                 ///< To be translated in context "HairScale".
    std::array<const char*, 2> ranges; ///< Keys of the settings that are multiplied by the same factor; null for none.

    [[nodiscard]] QString titleText() const; ///< Translated.
    /// The factors that every one of its settings can take, from `least` to `greatest`; both 1 where it is 0.
    struct Limits
    {
        double least = 1.0, greatest = 1.0;
    };
    [[nodiscard]] Limits limits(const sim::GroupSettings& settings) const;
    /// `factor`: 1 changes nothing; within the limits.
    void apply(sim::GroupSettings& settings, double factor) const;
};

[[nodiscard]] std::span<const HairScale> hairScales();

} // namespace hairpaint::model
