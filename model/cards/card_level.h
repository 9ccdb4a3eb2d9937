// The strips and caps of one level of detail.
#pragma once

#include "model/cards/card_strip.h"
#include "model/cards/scalp_cap.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hairpaint::model {

/// By group: indices into SampledHair.
using HairsByGroup = std::vector<std::vector<std::uint32_t>>;

struct CardLevel
{
    std::vector<CardStrip>
        strips; ///< Those of a group together; in a group from the skin to the surface, flyaways last.
    std::vector<std::size_t> groups;           ///< By strip: index into CurveSet::groups().
    std::vector<std::size_t> patchOf;          ///< By strip: index into HairCards::patches.
    std::vector<std::size_t> chainOf;          ///< By strip: index into CardBones::chains, where there are bones.
    std::vector<std::optional<ScalpCap>> caps; ///< By group: its cap; none where it has none.
    [[nodiscard]] int triangles() const;
};

/// How much each hair matters to the look, above 0; by hair of `hair`.
[[nodiscard]] std::vector<float> hairWeights(const SampledHair& hair, const HairField& field);

/// The finest level, with at most `triangles`. Hair that is too short for strips lies on caps, and is removed from
/// `byGroup`. Each strip has a patch of its own, with the strip's number. Runs on several threads.
[[nodiscard]] CardLevel finestLevel(const CurveSet& set, const SampledHair& hair, const HairField& field,
                                    std::span<const float> weights, HairsByGroup& byGroup, int triangles);

/// A coarser level, with fewer and wider strips, and some of the flyaways. Each strip shows the patch of that strip of
/// the finest level that has most of its hairs. `byGroup`: as finestLevel() left it.
[[nodiscard]] CardLevel coarserLevel(const CurveSet& set, const SampledHair& hair, const HairField& field,
                                     std::span<const float> weights, const HairsByGroup& byGroup,
                                     const CardLevel& finest, int triangles);

} // namespace hairpaint::model
