// Large locks, and which of them each strip's hairs belong to.
#include "model/cards/card_bones.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr int kTriangles = 240; ///< That strips along the large locks would have: makes some two dozen of them.

BoneChain chainAlong(const HairLock& lock, std::size_t group)
{
    BoneChain chain{.jointsWo = {}, .group = group};
    for (std::size_t j = 0; j < BoneChain::kJoints; ++j)
        chain.jointsWo.at(j) = lock.meanWo.at(j * (SampledHair::kSamples - 1) / (BoneChain::kJoints - 1));
    return chain;
}

/// How many of the joints lie before the point, with a fraction.
float jointsBefore(std::span<const glm::vec3> joints, const glm::vec3& position)
{
    float least = 0.0F;
    float found = 0.0F;
    for (std::size_t j = 0; j + 1 < joints.size(); ++j) {
        const glm::vec3& from = joints[j];
        const glm::vec3 along = joints[j + 1] - from;
        const float square = glm::dot(along, along);
        const float part = square > 0.0F ? glm::clamp(glm::dot(position - from, along) / square, 0.0F, 1.0F) : 0.0F;
        const float away = glm::distance(position, from + part * along);
        if (j == 0 || away < least) {
            least = away;
            found = static_cast<float>(j) + part;
        }
    }
    return found;
}

} // namespace

std::size_t CardBones::chainFor(const CardStrip& strip) const
{
    std::vector<std::size_t> votes;
    votes.reserve(strip.hairs.size());
    for (const std::uint32_t i : strip.hairs)
        votes.push_back(chainOfHair[i]);
    const auto middle = votes.begin() + static_cast<std::ptrdiff_t>(votes.size() / 2);
    std::ranges::nth_element(votes, middle); // The chain of the most, where most have one.
    return *middle;
}

BoneWeights CardBones::weightsAt(std::size_t chain, const glm::vec3& positionWo) const
{
    return weightsAlong(chains[chain].jointsWo, 1 + BoneChain::kJoints * chain, positionWo);
}

BoneWeights weightsAlong(std::span<const glm::vec3> joints, std::size_t firstJoint, const glm::vec3& position)
{
    const float before = jointsBefore(joints, position);
    const auto whole = static_cast<std::size_t>(before);
    const float part = before - static_cast<float>(whole);
    // A joint turns what comes after it, wholly from the next joint on.
    const auto jointAt = [&](std::size_t number) {
        return static_cast<std::uint16_t>(number == 0 ? 0 : firstJoint + number - 1);
    };
    const std::uint16_t next = part > 0.0F ? jointAt(whole + 1) : std::uint16_t{0};
    return {.joints = {jointAt(whole), next, 0, 0}, .weights = {1.0F - part, part, 0.0F, 0.0F}};
}

CardBones bonesFor(const SampledHair& hair, std::vector<std::vector<std::uint32_t>> sets)
{
    constexpr auto kNone = static_cast<std::size_t>(-1);
    std::vector<std::size_t> groupOf(hair.count(), kNone);
    for (std::size_t group = 0; group < sets.size(); ++group)
        for (const std::uint32_t i : sets[group])
            groupOf[i] = group;
    const std::vector<float> alike(hair.count(), 1.0F);
    CardBones bones{.chains = {}, .chainOfHair = std::vector<std::size_t>(hair.count(), kNone)};
    for (const HairLock& lock : dividedIntoLocks(hair, std::move(sets), alike, kTriangles)) {
        for (const std::uint32_t i : lock.hairs)
            bones.chainOfHair[i] = bones.chains.size();
        bones.chains.push_back(chainAlong(lock, groupOf[lock.hairs.front()]));
    }
    return bones;
}

} // namespace hairpaint::model
