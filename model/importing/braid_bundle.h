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
    float lengthM = 0.0F;                    ///< Of its skeleton, from where its hairs come together to its end.
    float radiusM = 0.0F;                    ///< As GroupSettings::braidRadiusM has it.
    std::vector<std::uint32_t> strands = {}; ///< Of HeadStrands.
};

/// What strands of `onHead` whose tips are together are; none where that is no braid. `members`: at least one, of
/// two points or more each.
[[nodiscard]] std::optional<FoundBraid> braidOf(const ForeignStrands& strands, const CurveTransform& transform,
                                                const HeadStrands& onHead, const std::vector<std::uint32_t>& members);

} // namespace hairpaint::model
