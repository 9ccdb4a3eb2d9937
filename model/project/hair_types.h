// The types of curled hair that hairdressers tell apart, 1A to 4C, as values of a group's settings.
#pragma once

#include "sim/groom/group_settings.h"

#include <optional>
#include <span>

namespace hairpaint::model {

struct HairType
{
    const char* name; ///< The same in all languages.
    sim::CurlSettings curl;
};

/// From straight to coily. Diameters and pitches as measured (Loussouarn and others 2007), the rest judged by eye.
[[nodiscard]] std::span<const HairType> hairTypes();
/// Which of hairTypes() a group's settings are; nothing where any number is another.
[[nodiscard]] std::optional<std::size_t> hairTypeOf(const sim::GroupSettings& settings);
/// Nothing else of the settings changes.
void setHairType(sim::GroupSettings& settings, const HairType& type);

} // namespace hairpaint::model
