// Grooms put together by hand, so that the solver is tested without maps and roots.
#pragma once

#include "sim/groom/groom.h"
#include "sim/groom/lay.h"

#include <glm/glm.hpp>

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace hairpaint::test {

/// A straight strand.
struct HandStrand
{
    glm::vec3 rootHd{0.0F};
    glm::vec3 directionHd{0.0F, 1.0F, 0.0F};
    float lengthM = 0.1F;
    float gel = 0.0F;
    float height = 0.0F;
    bool wanted = true;
    float give = 0.0F;
    float girthM = 0.0F;
};

inline std::shared_ptr<sim::BasisStyles> basisOf(const std::vector<HandStrand>& strands, int nodes)
{
    const auto nodeCount = static_cast<std::size_t>(nodes);
    auto basis = std::make_shared<sim::BasisStyles>();
    basis->resize(nodes, sim::blocksFor(strands.size()));
    for (std::size_t i = 0; i < strands.size(); ++i) {
        const HandStrand& strand = strands[i];
        const float segment = strand.lengthM / static_cast<float>(nodes - 1);
        (*basis)[sim::BasisQuantity::SegmentLength][i] = segment;
        (*basis)[sim::BasisQuantity::Gel][i] = strand.gel;
        (*basis)[sim::BasisQuantity::Give][i] = strand.give;
        (*basis)[sim::BasisQuantity::Girth][i] = strand.girthM;
        (*basis)[sim::BasisQuantity::Height][i] = strand.height;
        if (strand.wanted)
            sim::insertLane(basis->wanted, i);
        for (std::size_t node = 0; node < nodeCount; ++node) {
            const glm::vec3 p = strand.rootHd + strand.directionHd * (segment * static_cast<float>(node));
            sim::StrandBlocks(nodes).setNode(basis->restPositions, i, node, p);
        }
    }
    return basis;
}

/// Physics without anything but gravity.
inline sim::PhysicsSettings barePhysics()
{
    sim::PhysicsSettings physics;
    physics.damping = 0.0F;
    physics.stiffnessM = 0.0F;
    physics.friction = 0.0F;
    physics.volumeM = 0.0F;
    return physics;
}

/// Basis hairs alone: nothing is drawn.
inline std::shared_ptr<sim::Groom> groomOf(const std::vector<HandStrand>& strands, int nodes,
                                           const sim::PhysicsSettings& physics)
{
    auto groom = std::make_shared<sim::Groom>();
    groom->groupId = 1;
    groom->nodes = nodes;
    groom->settings.nodesPerHair = nodes;
    groom->settings.physics = physics;
    groom->basis = basisOf(strands, nodes);
    return groom;
}

/// The same with every strand drawn as a dependent of itself: one chunk for each 1024.
inline std::shared_ptr<sim::Groom> drawnGroomOf(const std::vector<HandStrand>& strands, int nodes,
                                                const sim::PhysicsSettings& physics)
{
    auto groom = groomOf(strands, nodes, physics);
    auto roots = std::make_shared<sim::RootSet>();
    const auto count = static_cast<std::uint32_t>(strands.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        roots->rankOfSlot.push_back(i);
        roots->slotOfRank.push_back(i);
        roots->basisSlot.push_back(i);
        roots->positionHd.push_back(strands[i].rootHd);
        roots->neighbours.push_back({i, i, i});
        roots->weights.push_back({1.0F, 0.0F, 0.0F});
    }
    groom->roots = std::move(roots);
    const std::size_t chunks = (strands.size() + sim::kChunkSlots - 1) / sim::kChunkSlots;
    for (std::size_t c = 0; c < chunks; ++c) {
        auto chunk = std::make_shared<sim::StrandChunk>();
        chunk->styles.resize(sim::kChunkSlots);
        chunk->braidCentre.assign(sim::kChunkSlots, sim::kNoCentre);
        chunk->clump.assign(sim::kChunkSlots, 0.0F);
        chunk->segmentLengths.assign(sim::kChunkSlots, 0.0F);
        chunk->restPositions.assign(groom->blocks().floatsFor(sim::kBlocksPerChunk), 0.0F);
        for (std::size_t slot = 0; slot < sim::kChunkSlots; ++slot) {
            const std::size_t strand = c * sim::kChunkSlots + slot;
            if (strand >= strands.size() || !strands[strand].wanted)
                continue;
            chunk->hairs[slot] = true;
            chunk->drawn[slot] = true;
            chunk->styles[slot].lengthM = strands[strand].lengthM;
            chunk->styles[slot].detail = 0.0F;
            chunk->segmentLengths[slot] = (*groom->basis)[sim::BasisQuantity::SegmentLength][strand];
            for (std::size_t node = 0; node < static_cast<std::size_t>(nodes); ++node)
                groom->blocks().setNode(chunk->restPositions, slot, node,
                                        groom->blocks().node(groom->basis->restPositions, strand, node));
        }
        groom->chunks.push_back(std::move(chunk));
        groom->packedChunk.push_back(static_cast<std::int32_t>(c));
    }
    groom->packedChunks = static_cast<std::int32_t>(chunks);
    groom->hairCount = groom->drawnCount = groom->basisCount = strands.size();
    return groom;
}

} // namespace hairpaint::test
