// What strands on a head sum up to at each texel of its skin.
#pragma once

#include "model/importing/head_strands.h"
#include "model/importing/skin_texels.h"
#include "sim/groom/groom.h"

#include <optional>
#include <vector>

namespace hairpaint::model {

/// What strands sum up to at a texel, each by its weight.
struct TexelSum
{
    float weight = 0.0F;
    float densityPerM2 = 0.0F;
    float lengthM = 0.0F;
    float curl = 0.0F;
    float radiusM = 0.0F;
    float coiled = 0.0F; ///< Weight of those with a coil.
    float held = 0.0F;
    glm::vec4 braided{0.0F}; ///< Weight of strands of each BraidKind, of None too.
    glm::vec3 rootColour{0.0F};
    glm::vec3 tipColour{0.0F};
};

/// How hair runs there: the mean of directions in the skin, of their lengths, and the nearest one.
struct DirectionSum
{
    float weight = 0.0F;
    float flatness = 0.0F;
    glm::vec3 meanHd{0.0F};
    float nearestWeight = 0.0F;
    glm::vec3 nearestHd{0.0F};

    void add(const SkinDirection& here, float added);
    /// In that frame; where two sides of a parting meet, that of the nearest strand.
    [[nodiscard]] glm::vec2 in(const sim::SkinFrame& frame) const;
};

struct StrandSums
{
    std::vector<TexelSum> strands; ///< By texel on the skin.
    std::vector<DirectionSum> roots;
    std::vector<DirectionSum> further;
};

/// Strands weigh on the texels around them by how far apart they stand, so that between them is no hole, and density
/// adds up to their number. None where `progress` cancels.
[[nodiscard]] std::optional<StrandSums> summed(const HeadStrands& onHead, const SkinTexels& texels,
                                               const Progress& progress = {});

} // namespace hairpaint::model
