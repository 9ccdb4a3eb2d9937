// What scissors cut off, as it lay in the picture.
#pragma once

#include "model/tools/cutting/cut_lengths.h"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::model {

struct CutPiece
{
    std::vector<glm::vec3> pointsWo;
    std::uint32_t colour = 0; ///< 0xAABBGGRR, sRGB as encoded.
};

/// The pieces that `cuts` take off, at most `most`, spread evenly over the cuts. `rotation`: the head's, from Hd to Wo.
[[nodiscard]] std::vector<CutPiece> cutPieces(const sim::GroupFrame& hair, const glm::quat& rotation,
                                              std::span<const StrandCut> cuts, std::size_t most);

} // namespace hairpaint::model
