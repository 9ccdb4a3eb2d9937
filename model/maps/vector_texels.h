// The row of TexelOps for vectors: two channels of direction (sim/groom/direction_texel.h).
// Any thread. Errors: none; the functions over runs neither allocate nor throw.
#pragma once

#include "model/maps/texel_ops.h"

namespace hairpaint::model {

/// Layers' texels have a third channel, coverage.
void layVectors(std::uint16_t* layer, const std::uint16_t* mask, const TilePaint& paint);
void blendVectors(BlendMode /*mode*/, const std::uint16_t* layer, std::size_t layerStep, std::uint16_t opacity,
                  std::uint16_t* map, std::size_t count);
void vectorsToColours(const MapSpec& /*spec*/, bool /*nightPaper*/, const std::uint16_t* values, std::size_t step,
                      std::size_t count, std::uint16_t* colours);
void vectorsFromColours(const MapSpec& /*spec*/, std::span<sim::Texel> texels);
void vectorsFromGreys(const MapSpec& /*spec*/, std::span<sim::Texel> texels);
[[nodiscard]] PaintValue vectorOf(const sim::Texel& texel);
[[nodiscard]] sim::Texel texelOfVector(const PaintValue& value);
[[nodiscard]] QString vectorText(const sim::GroupSettings& /*settings*/, const MapSpec& /*spec*/,
                                 const PaintValue& value);

} // namespace hairpaint::model
