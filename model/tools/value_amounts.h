// The amounts that scalar maps are painted with: what the user set (15 cm, 3 turns), whatever fraction of a group's
// range that is.
#pragma once

#include "model/tools/tool_settings.h"

#include <QString>

#include <array>
#include <vector>

namespace hairpaint::model {

/// Amounts of the values and second values of tool settings, whose scalars are fractions of the active group's range.
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
    struct Amount
    {
        double number = 0.0; ///< In the map's common unit, or in `unit` where it has none.
        QString unit; ///< Unit of `number`; amounts of different units, as turns and per cent, are never compared.
    };
    struct Pair
    {
        Amount first, second;
    };
    [[nodiscard]] static Amount amountOf(const MapSpec& spec, const sim::GroupSettings& group, const PaintValue& value);
    /// Moves the scalar to the amount; whether the range has it. In another unit it stays the fraction that it is.
    static bool follow(const MapSpec& spec, const sim::GroupSettings& group, const Amount& amount, float& scalar);
    std::array<Pair, kMapKindCount> m_pairs{}; ///< Only those of scalar maps mean something.
};

} // namespace hairpaint::model
