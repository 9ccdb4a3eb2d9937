// Ranges of maps changed under what is painted: 15 cm stay 15 cm, whatever the greatest length is.
#pragma once

#include "model/project/project.h"

#include <cstddef>
#include <span>
#include <vector>

namespace hairpaint::model {

struct GroupSetting;

/// Whether that setting is the range of a map.
[[nodiscard]] bool setsRange(const GroupSetting& setting);

/// A group with another range, made by withRange(). Any thread.
struct RangeChange
{
    /// A map where amounts were painted that the new range does not have; they are its nearest end now.
    struct Clamped
    {
        MapKind map = MapKind::Density;
        bool beyond = false; ///< Above its greatest amount.
        bool below = false;  ///< Under its least one, and painted above 0: a map's 0 means the least one anyway.
    };
    Id group = 0;
    sim::GroupSettings settings;
    std::vector<SharedStack> maps; ///< A lowest layer with the id 0 is a new one.
    std::vector<Clamped> clamped;

    void applyTo(Project& project) const;
};

/// The group's maps rescaled so that they show the same amounts by `settings`, all layers, hidden ones too, in
/// every blend mode; maps whose range stays are shared. What a map shows where nothing is painted is laid under the
/// layers, so that it stays too, where hair grows at all. A map whose range is or becomes a single amount keeps its
/// texels.
[[nodiscard]] RangeChange withRange(const HairGroup& group, const sim::GroupSettings& settings);
/// Values of one scalar map, the first channel, as the same amounts of another range, at its nearest end where it does
/// not reach.
void rescaleTexels(const MapSpec& spec, const sim::GroupSettings& before, const sim::GroupSettings& after,
                   std::span<sim::Texel> texels);
/// What withRange() takes: texels of the maps whose range differs, in tiles that are not one value.
[[nodiscard]] std::size_t texelsToRescale(const HairGroup& group, const sim::GroupSettings& settings);

} // namespace hairpaint::model
