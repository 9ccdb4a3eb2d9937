// Puts taut parts and tails together.
#include "sim/motion/gathered_hair.h"

#include "sim/base/parallel.h"
#include "sim/groom/gathered_path.h"
#include "sim/motion/group_dynamics.h"
#include "sim/motion/head_motion.h"

#include <algorithm>

namespace hairpaint::sim {

namespace {

/// [3][kLanes] in the world.
struct LanesOfNode
{
    std::array<std::array<float, kLanes>, 3> at;
};

void toWorld(const RigidMotion& world, const float* from, LanesOfNode& to)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t lane = 0; lane < kLanes; ++lane)
            to.at[axis][lane] = world.identity
                                    ? from[axis * kLanes + lane]
                                    : world.rows[axis][0] * from[lane] + world.rows[axis][1] * from[kLanes + lane] +
                                          world.rows[axis][2] * from[2 * kLanes + lane] + world.offset[axis];
}

/// One block: every node of the gathered lanes. `tails` is null where none of them has one.
void writeBlock(const StrandChunk& chunk, std::size_t block, const StrandBlocks& blocks, int nodes,
                const RigidMotion& world, const float* tails, float* out)
{
    const auto ring = static_cast<std::size_t>(ringNode(nodes));
    std::array<bool, kLanes> isGathered{};
    std::array<bool, kLanes> isTailed{};
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        isGathered[lane] = chunk.gathered[block * kLanes + lane] && chunk.drawn[block * kLanes + lane];
        isTailed[lane] = tails != nullptr && isGathered[lane] && chunk.tailed[block * kLanes + lane];
    }
    const float* rest = chunk.restPositions.data() + blocks.index(block * kLanes, 0);
    LanesOfNode placed;
    for (std::size_t node = 0; node < static_cast<std::size_t>(nodes); ++node) {
        toWorld(world, rest + node * StrandBlocks::kNodeStride, placed);
        float* const to = out + node * StrandBlocks::kNodeStride;
        const float* const tail =
            node >= ring && tails != nullptr ? tails + (node - ring) * StrandBlocks::kNodeStride : nullptr;
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                const std::size_t i = axis * kLanes + lane;
                if (tail != nullptr && isTailed[lane])
                    to[i] = tail[i];
                else if (isGathered[lane])
                    to[i] = placed.at[axis][lane];
            }
    }
}

} // namespace

GatheredHair::GatheredHair() = default;
GatheredHair::~GatheredHair() = default;
GatheredHair::GatheredHair(GatheredHair&&) noexcept = default;
GatheredHair& GatheredHair::operator=(GatheredHair&&) noexcept = default;

void GatheredHair::setGroom(const Groom& groom, const ColliderSet& colliders, const StepForces& calm, const Neck& neck)
{
    if (!groom.tails) {
        m_tails.reset();
        m_frame = {};
        return;
    }
    if (!m_tails)
        m_tails = std::make_unique<GroupDynamics>();
    m_tails->setGroom(groom.tails, colliders, calm, neck);
}

void GatheredHair::write(GroupFrame& frame, float fraction, const HeadPose& pose, const Neck& neck) const
{
    const Groom& groom = *frame.groom;
    const auto isGathered = [](const auto& chunk) { return chunk && chunk->gathered.any(); };
    if (std::ranges::none_of(groom.chunks, isGathered))
        return;
    if (m_tails) {
        m_frame.detail = frame.detail;
        m_tails->write(m_frame, fraction, pose, neck);
    }
    const RigidMotion world = worldOfHead(pose);
    const std::size_t blockFloats = groom.blocks().blockFloats();
    const std::size_t tailFloats = m_tails ? groom.tails->blocks().blockFloats() : 0;
    parallelFor(groom.chunks.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index) {
            const StrandChunk* chunk = groom.chunks[index].get();
            if (groom.packedChunk[index] < 0 || !isGathered(groom.chunks[index]))
                continue;
            const auto first = static_cast<std::size_t>(groom.packedChunk[index]) * kBlocksPerChunk;
            const std::int32_t packed = m_tails ? groom.tails->packedChunk[index] : -1;
            const float* const ofTails =
                packed < 0 ? nullptr
                           : m_frame.positions.data() + static_cast<std::size_t>(packed) * kBlocksPerChunk * tailFloats;
            for (std::size_t block = 0; block < kBlocksPerChunk; ++block)
                if (frame.detail >= 1.0F || chunk->leastDetail[block] < frame.detail)
                    writeBlock(*chunk, block, groom.blocks(), groom.nodes, world,
                               ofTails == nullptr ? nullptr : ofTails + block * tailFloats,
                               frame.positions.data() + (first + block) * blockFloats);
        }
    });
}

} // namespace hairpaint::sim
