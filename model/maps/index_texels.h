// The row of TexelOps for indices of a palette.
// Any thread. Errors: none; the functions over runs neither allocate nor throw.
#pragma once

#include "model/maps/texel_ops.h"

namespace hairpaint::model {

/// An index is replaced where coverage is at least half (kHalfCoverage).
void layIndices(std::uint16_t* layer, const std::uint16_t* mask, const TilePaint& paint);
void eraseIndices(const MapSpec& spec, std::uint16_t* layer, const std::uint16_t* mask, std::uint16_t /*opacity*/);
void blendIndices(BlendMode /*mode*/, const std::uint16_t* layer, std::size_t layerStep, std::uint16_t opacity,
                  std::uint16_t* map, std::size_t count);
void chooseIndices(const sim::Texel& first, const sim::Texel& second, std::span<const std::uint16_t> fractions,
                   std::uint16_t* values);
void indicesToColours(const MapSpec& spec, bool nightPaper, const std::uint16_t* values, std::size_t step,
                      std::size_t count, std::uint16_t* colours);
void indicesFromColours(const MapSpec& spec, std::span<sim::Texel> texels);
void indicesToGreys(const MapSpec& spec, const std::uint16_t* values, std::size_t step, std::size_t count,
                    std::uint16_t* greys);
void indicesFromGreys(const MapSpec& spec, std::span<sim::Texel> texels);
[[nodiscard]] PaintValue indexOfTexel(const sim::Texel& texel);
[[nodiscard]] sim::Texel texelOfIndex(const PaintValue& value);
[[nodiscard]] QString indexText(const sim::GroupSettings& /*settings*/, const MapSpec& spec, const PaintValue& value);
[[nodiscard]] std::uint16_t lastIndex(const MapSpec& spec);

} // namespace hairpaint::model
