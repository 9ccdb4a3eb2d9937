// Evaluates the hairs of one chunk.
#pragma once

#include "sim/groom/braid_layout.h"
#include "sim/groom/groom.h"
#include "sim/groom/hairline.h"
#include "sim/groom/lay.h"
#include "sim/groom/lock_partition.h"
#include "sim/groom/map_changes.h"
#include "sim/groom/map_sampler.h"
#include "sim/groom/passed_cells.h"
#include "sim/groom/slot_set.h"

#include <memory>
#include <span>

namespace hairpaint::sim {

class Gathering;

/// What evaluating a hair reads. Immutable while chunks are built, on any number of threads.
struct ChunkInputs
{
    const GroupSettings& settings;
    const RootSet& roots;
    const MapSamplers& maps;
    const LayInputs& lay;
    const BasisStyles& basis;
    const BraidLayout& braids;
    std::span<const std::uint8_t> kinds; ///< [slots] The braid map's.
    const LockPartition& locks;
    const Hairline& hairline;
    const Gathering& gathering;
};

/// Density at a root: it is a hair where that is above its threshold.
[[nodiscard]] float hairDensity(const VariationSettings& variation, const Hairline& hairline, const MapSamplers& maps,
                                const RootSet& roots, std::uint32_t slot);

/// The chunk with the hairs of `dirty` evaluated anew and those of its look coloured anew: `before` itself where none
/// of them was a hair or is one, null where no hair is left. Adds to `rebuilt` those that were or are hairs; puts into
/// `passed`, which has strands by slots, over what they lie.
[[nodiscard]] std::shared_ptr<const StrandChunk> rebuildChunk(const ChunkInputs& inputs,
                                                              const std::shared_ptr<const StrandChunk>& before,
                                                              std::size_t chunkIndex, const ChangedSlots& dirty,
                                                              PassedCells& passed, SlotSet& rebuilt);

} // namespace hairpaint::sim
