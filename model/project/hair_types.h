// The types of curled hair that hairdressers tell apart, 1A to 4C, as values of a group's settings.
#pragma once

#include "sim/groom/group_settings.h"

#include <optional>
#include <span>
#include <string_view>

namespace hairpaint::model {

struct HairType
{
    const char* name; ///< The same in all languages.
    sim::CurlSettings curl;
    float lockSizeM;
    float sectionAxes; ///< Of a fibre's section.
};

/// From straight to coily. Diameters and pitches as measured (Loussouarn and others 2007), the rest judged by eye.
[[nodiscard]] std::span<const HairType> hairTypes();
/// The one of that name; there must be one.
[[nodiscard]] const HairType& hairType(std::string_view name);
/// Which of hairTypes() a group's settings are, as far as its course goes; nothing where any number of that is another.
[[nodiscard]] std::optional<std::size_t> hairTypeOf(const sim::GroupSettings& settings);
/// Nothing else of the settings changes.
void setHairType(sim::GroupSettings& settings, const HairType& type);

} // namespace hairpaint::model
