// Joints along locks of cards, for programs that let hair swing.
#pragma once

#include "model/cards/card_strip.h"
#include "model/heads/head_skeleton.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::model {

/// Weights of a vertex that follows joints one after another, of which the first has the number `firstJoint`; at the
/// first it follows joint 0, the head.
[[nodiscard]] BoneWeights weightsAlong(std::span<const glm::vec3> joints, std::size_t firstJoint,
                                       const glm::vec3& position);

/// Some joints one after another, each the parent of the next; the last only tells where the hair ends.
struct BoneChain
{
    static constexpr std::size_t kJoints = 5;
    std::array<glm::vec3, kJoints> jointsWo{}; ///< The first where the hair grows.
    std::size_t group = 0;                     ///< Index into CurveSet::groups().
};

/// BoneWeights of cards: joint 0 is the head, 1 + kJoints * chain + j the chain's joint j.
struct CardBones
{
    std::vector<BoneChain> chains;
    std::vector<std::size_t> chainOfHair; ///< By hair of SampledHair; for those that are in a set.
    [[nodiscard]] std::size_t jointCount() const { return 1 + BoneChain::kJoints * chains.size(); }
    /// The chain that most of a strip's hairs belong to.
    [[nodiscard]] std::size_t chainFor(const CardStrip& strip) const;
    /// Weights of a vertex that follows a chain; at its root it follows the head.
    [[nodiscard]] BoneWeights weightsAt(std::size_t chain, const glm::vec3& positionWo) const;
};

/// Some two dozen chains or fewer for all hair. `sets`: hairs by group.
[[nodiscard]] CardBones bonesFor(const SampledHair& hair, std::vector<std::vector<std::uint32_t>> sets);

} // namespace hairpaint::model
