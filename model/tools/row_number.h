// Which number a stroke of cornrow paints.
#pragma once

#include "model/tools/tool.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace hairpaint::model {

/// The texel that a stroke begun there paints on the target's map. A stroke of cornrow begun on a row has that row's
/// number and goes on with it; one begun elsewhere has a number that no row of the group has, so that it stays a row of
/// its own where it touches others. Numbers ascend in the order in which rows were painted, until they are used up
/// (sim::kLastRowNumber). Any other value is itself.
[[nodiscard]] sim::Texel strokeTexel(const ToolContext& context, const ToolEvent& begin);

/// Whether the map's number is a row's.
[[nodiscard]] bool isRow(std::uint16_t number);
/// Numbers of so many new rows in a stack of the braid map: those after the last, else the least that are free. Where
/// none is left, the first row's.
[[nodiscard]] std::vector<std::uint16_t> newRowNumbers(const MapStack& braids, std::size_t count);

/// Braid texels that are to be laid into a stack: rows whose numbers it has get new ones, each its own.
/// `isLaidOver(i)`: whether the i-th lies where its own number lies; a row all of which does keeps its number.
void renumberRows(const MapStack& braids, std::vector<sim::Texel>& texels,
                  const std::function<bool(std::size_t)>& isLaidOver);

} // namespace hairpaint::model
