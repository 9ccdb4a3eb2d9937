// What a bundle of strands is braided to.
#pragma once

#include "model/importing/foreign_curves.h"
#include "model/importing/head_strands.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace hairpaint::model {

struct FoundBraid
{
    sim::BraidKind kind = sim::BraidKind::None;
    float lengthM = 0.0F;                    ///< Length of the skeleton, from where the hairs come together to the end.
    float radiusM = 0.0F;                    ///< Radius, as in GroupSettings::braidRadiusM.
    std::vector<std::uint32_t> strands = {}; ///< Indices into HeadStrands::strands.
};

/// The braid that strands of `onHead` with their tips together make; none where they are no braid. `members`: indices
/// of at least one strand, each of two points or more.
[[nodiscard]] std::optional<FoundBraid> braidOf(const ForeignStrands& strands, const CurveTransform& transform,
                                                const HeadStrands& onHead, const std::vector<std::uint32_t>& members);

} // namespace hairpaint::model
