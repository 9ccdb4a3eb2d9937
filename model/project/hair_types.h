// The types of curled hair that hairdressers tell apart, 1A to 4C, as values of a group's settings.
#pragma once

#include "sim/groom/group_settings.h"

#include <optional>
#include <span>
#include <string_view>

namespace hairpaint::model {

struct HairType
{
    const char* name; ///< "3B", not translated.
    sim::CurlSettings curl;
    float lockSizeM;
    float sectionAxes; ///< Ratio of the axes of a fibre's cross-section; see GroupSettings.
};

/// From straight to coily. Diameters and pitches as measured (Loussouarn and others 2007), the rest judged by eye.
[[nodiscard]] std::span<const HairType> hairTypes();
/// The type of that name; there must be one.
[[nodiscard]] const HairType& hairType(std::string_view name);
/// The index in hairTypes() of the type whose course a group's settings have; none where any number of it differs.
[[nodiscard]] std::optional<std::size_t> hairTypeOf(const sim::GroupSettings& settings);
/// Sets what `type` has; the other settings stay.
void setHairType(sim::GroupSettings& settings, const HairType& type);

} // namespace hairpaint::model
