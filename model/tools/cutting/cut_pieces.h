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

/// Of hair that was cut, of a head that is turned so: at most `most`, spread evenly over them.
[[nodiscard]] std::vector<CutPiece> cutPieces(const sim::GroupFrame& hair, const glm::quat& rotation,
                                              std::span<const StrandCut> cuts, std::size_t most);

} // namespace hairpaint::model
