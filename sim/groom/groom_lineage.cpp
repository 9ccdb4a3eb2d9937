// Following basis hairs from groom to groom.
#include "sim/groom/groom_lineage.h"

#include <algorithm>

namespace hairpaint::sim {

namespace {

constexpr float kSameRootM = 1e-5F;
constexpr float kMovedTieM = 0.05F; ///< A tail whose ring moves further in one go is another one.

bool sameRange(const std::vector<float>& a, const std::vector<float>& b, std::size_t begin, std::size_t count)
{
    const auto from = static_cast<std::ptrdiff_t>(begin);
    return std::equal(a.begin() + from, a.begin() + from + static_cast<std::ptrdiff_t>(count), b.begin() + from);
}

} // namespace

bool sameStrands(const Groom& before, const Groom& after)
{
    return before.nodes == after.nodes && before.roots == after.roots &&
           before.basis->blockCount() == after.basis->blockCount();
}

std::vector<std::int32_t> originsOf(const Groom& before, const Groom& after)
{
    const std::size_t lanes = after.basis->blockCount() * kLanes;
    std::vector<std::int32_t> origins(lanes, kNoOrigin);
    if (before.nodes != after.nodes)
        return origins;
    if (sameStrands(before, after)) {
        for (std::size_t i = 0; i < lanes; ++i)
            origins[i] = static_cast<std::int32_t>(i);
        return origins;
    }
    if (!before.roots || !after.roots || before.roots->skin != after.roots->skin ||
        before.roots->seed != after.roots->seed)
        return origins;
    const RootSet& old = *before.roots;
    const RootSet& now = *after.roots;
    std::vector<std::int32_t> ofRank(old.basisSlot.size(), kNoOrigin);
    for (std::size_t i = 0; i < old.basisSlot.size(); ++i) {
        const std::size_t rank = old.rankOfSlot[old.basisSlot[i]];
        if (rank < ofRank.size())
            ofRank[rank] = static_cast<std::int32_t>(i);
    }
    for (std::size_t i = 0; i < std::min(lanes, now.basisSlot.size()); ++i) {
        const std::size_t rank = now.rankOfSlot[now.basisSlot[i]];
        if (rank < ofRank.size())
            origins[i] = ofRank[rank];
    }
    return origins;
}

StrandChange changeOf(const Groom& before, std::int32_t origin, const Groom& after, std::size_t index)
{
    const BasisStyles& now = *after.basis;
    if (!hasLane(now.wanted, index) || now[BasisQuantity::SegmentLength][index] <= 0.0F)
        return StrandChange::Gone;
    const BasisStyles& old = *before.basis;
    const auto was = static_cast<std::size_t>(std::max(origin, 0));
    if (origin == kNoOrigin || !hasLane(old.wanted, was) || old[BasisQuantity::SegmentLength][was] <= 0.0F)
        return StrandChange::Arrived;
    bool same = true;
    for (std::size_t k = 0; k < kBasisQuantities; ++k)
        same = same && now.numbers[k][index] == old.numbers[k][was];
    for (std::size_t node = 0; node < static_cast<std::size_t>(after.nodes); ++node) {
        const glm::vec3 a = before.blocks().node(old.restPositions, was, node);
        const glm::vec3 b = after.blocks().node(now.restPositions, index, node);
        if (node == 0 &&
            glm::any(glm::greaterThan(glm::abs(a - b), glm::vec3(after.isOfTails ? kMovedTieM : kSameRootM))))
            return StrandChange::Arrived;
        same = same && a == b;
    }
    return same ? StrandChange::None : StrandChange::Shape;
}

bool sameBlock(const BasisStyles& before, const BasisStyles& after, int nodes, std::size_t block)
{
    const std::size_t floats = StrandBlocks(nodes).blockFloats();
    for (std::size_t k = 0; k < kBasisQuantities; ++k)
        if (!sameRange(before.numbers[k], after.numbers[k], block * kLanes, kLanes))
            return false;
    return before.wanted[block] == after.wanted[block] &&
           sameRange(before.restPositions, after.restPositions, block * floats, floats);
}

} // namespace hairpaint::sim
