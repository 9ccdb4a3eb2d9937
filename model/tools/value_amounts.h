// The amounts that scalar maps are painted with: what the user set (15 cm, 3 turns), whatever fraction of a group's
// range that is.
#pragma once

#include "model/tools/tool_settings.h"

#include <array>
#include <vector>

namespace hairpaint::model {

/// Of the values and second values of tool settings, whose scalars are fractions of the active group's range.
class ValueAmounts
{
public:
    /// The amounts of all values.
    void take(const sim::GroupSettings& group, const ToolSettings& settings);
    /// The amounts of those values that differ; the others keep theirs, also where it lies beyond the group's range.
    void takeChanges(const sim::GroupSettings& group, const ToolSettings& before, const ToolSettings& settings);
    /// Makes the scalars the fractions that give the amounts; at an end of the range where it lies beyond. Returns the
    /// maps whose value does.
    std::vector<MapKind> putOn(const sim::GroupSettings& group, ToolSettings& settings) const;

private:
    struct Pair
    {
        double first = 0.0, second = 0.0; ///< In the map's common unit.
    };
    std::array<Pair, kMapKindCount> m_pairs{}; ///< Only those of scalar maps mean something.
};

} // namespace hairpaint::model
