// Alpha that keeps covering as much when a texture is made smaller.
#pragma once

#include "model/cards/atlas_layout.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::model {

/// What part of a patch is hair, 0..1, in level `level` of the mipmap, each of whose texels is the mean of four of the
/// level before; level 0 is the image itself. `alpha`: sizePx rows of sizePx.
[[nodiscard]] float alphaCoverage(const std::vector<std::uint8_t>& alpha, int sizePx, const AtlasPatch& patch,
                                  int level);

/// Moves each patch's alpha nearer to the cutoff, from both sides and never across it, so that as much of it as can be
/// is hair in the first levels of its mipmap as in the image itself, which keeps its own. (After Castano 2010, who
/// scales each level, which a file without levels can't.) Runs on several threads.
void keepAlphaCoverage(std::vector<std::uint8_t>& alpha, int sizePx, std::span<const AtlasPatch> patches);

} // namespace hairpaint::model
