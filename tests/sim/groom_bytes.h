// Whether two grooms are the same, byte by byte.
#pragma once

#include "sim/groom/groom.h"

#include <cstring>
#include <vector>

namespace hairpaint::test {

template<typename T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Null, or what differs first.
inline const char* differenceOf(const sim::Groom& a, const sim::Groom& b)
{
    if (a.hairCount != b.hairCount || a.drawnCount != b.drawnCount || a.basisCount != b.basisCount)
        return "counts";
    if (a.groupId != b.groupId || a.visible != b.visible || a.limit != b.limit || a.nodes != b.nodes ||
        a.settings != b.settings)
        return "settings";
    if (!sameBytes(a.roots->rankOfSlot, b.roots->rankOfSlot) || !sameBytes(a.roots->positionHd, b.roots->positionHd))
        return "roots";
    if (!sameBytes(a.packedChunk, b.packedChunk) || a.packedChunks != b.packedChunks)
        return "indices of chunks";
    if (!sameBytes(a.basis->wanted, b.basis->wanted))
        return "wanted basis hairs";
    if (!sameBytes(a.basis->restPositions, b.basis->restPositions))
        return "basis hairs";
    for (std::size_t k = 0; k < sim::kBasisQuantities; ++k)
        if (!sameBytes(a.basis->numbers[k], b.basis->numbers[k]))
            return "quantities of basis hairs";
    for (std::size_t i = 0; i < a.chunks.size(); ++i) {
        if (!a.chunks[i] && !b.chunks[i])
            continue;
        if (!a.chunks[i] || !b.chunks[i])
            return "chunks";
        const sim::StrandChunk& x = *a.chunks[i];
        const sim::StrandChunk& y = *b.chunks[i];
        if (x.hairs != y.hairs || x.drawn != y.drawn)
            return "hairs";
        if (!sameBytes(x.styles, y.styles))
            return "styles";
        if (!sameBytes(x.restPositions, y.restPositions) || !sameBytes(x.segmentLengths, y.segmentLengths))
            return "rest shapes";
        if (!sameBytes(x.braidCentre, y.braidCentre))
            return "braid centres";
        if (!sameBytes(x.cornrows, y.cornrows))
            return "cornrows";
        if (!sameBytes(x.lockLeader, y.lockLeader) || !sameBytes(x.clump, y.clump))
            return "locks";
        if (x.gathered != y.gathered || x.tailed != y.tailed || !sameBytes(x.followed, y.followed))
            return "gathered hairs";
    }
    if ((a.tails == nullptr) != (b.tails == nullptr))
        return "whether there are tails";
    if (a.tails)
        return differenceOf(*a.tails, *b.tails) != nullptr ? "tails" : nullptr;
    return nullptr;
}

} // namespace hairpaint::test
