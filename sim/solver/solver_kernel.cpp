// The solver's inner loop: blocks of strands, a few steps at a time. The step itself is strand_step_inl.h.
#include "sim/solver/solver_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/solver/solver_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "sim/solver/strand_step_inl.h"
#include <algorithm>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

void StepBlocks(const SolverBlocks& blocks, const GroupGains& gains, const ColliderSet& colliders,
                std::span<const StepForces> steps, int from, std::size_t begin, std::size_t end)
{
    const std::size_t width = hn::Lanes(Tag());
    const std::size_t blockFloats = static_cast<std::size_t>(gains.nodes) * StrandBlocks::kNodeStride;
    HWY_ALIGN float scratch[std::size_t{kMostNodes} * StrandBlocks::kNodeStride];
    std::fill(blocks.awake + begin, blocks.awake + end, std::uint8_t{0});
    for (std::size_t block = begin; block < end; ++block) {
        for (std::size_t lane = 0; lane < kLanes; lane += width) {
            const std::size_t at = block * blockFloats + lane;
            float* const lanes = blocks.lanes + block * blocks.laneRows * kLanes + lane;
            const float* const contact =
                blocks.contact != nullptr && blocks.dense[block] != 0 ? blocks.contact + at : nullptr;
            const std::int32_t row = blocks.braids.rowOfBlock != nullptr ? blocks.braids.rowOfBlock[block] : -1;
            BraidRows braids;
            if (row >= 0) {
                const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(gains.nodes);
                braids = {.rows = blocks.braids.rows + first * kBraidRows * kLanes + lane,
                          .counts = blocks.braids.counts + first,
                          .stepsOn = blocks.braids.stepsDone};
            }
            // All steps while the strands are in the cache.
            auto read = static_cast<std::size_t>(from);
            for (const StepForces& step : steps) {
                ++braids.stepsOn;
                // Asleep for two steps: both positions are the same, and nothing needs to be written.
                if (!asleep(lanes, step.windy ? kUnwanted : kStillSteps + 2.0F))
                    stepStrands(gains, colliders, step,
                                {blocks.rest + at, blocks.positions[read] + at, blocks.positions[1 - read] + at,
                                 blocks.previous + at, lanes, scratch, contact, blocks.contact != nullptr,
                                 any(loaded(lanes + kRecoil * kLanes) > 0.0F), braids});
                read = 1 - read;
            }
            if (!asleep(lanes, kStillSteps + 2.0F))
                blocks.awake[block] = 1;
        }
    }
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::sim {

HWY_EXPORT(StepBlocks);

void stepBlocks(const SolverBlocks& blocks, const GroupGains& gains, const ColliderSet& colliders,
                std::span<const StepForces> steps, int from, std::size_t begin, std::size_t end)
{
    HWY_DYNAMIC_DISPATCH(StepBlocks)(blocks, gains, colliders, steps, from, begin, end);
}

} // namespace hairpaint::sim
#endif
