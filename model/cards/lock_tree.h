// Hair divided into locks.
#pragma once

#include "model/cards/sampled_hair.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hairpaint::model {

/// Hairs that run nearly alike.
struct HairLock
{
    std::vector<std::uint32_t> hairs; ///< Indices into SampledHair.
    std::array<glm::vec3, SampledHair::kSamples> meanWo{};
    float spreadM = 0.0F; ///< Root mean square distance of the hairs from the mean.
};

/// Puts into `kept` the samples at which a strip along the lock has nodes, both ends among them.
void stripSamples(const HairLock& lock, std::vector<std::uint16_t>& kept);

/// Number of triangles of a strip along the lock: two a segment.
[[nodiscard]] int stripTriangles(const HairLock& lock);

/// Divides what runs most apart again and again, as long as the strips along all locks have at most `triangles`
/// together; a lock of less than a hair's few widths stays whole. `sets`: hairs that are never in one lock, of which
/// those without hairs give none and the others at least one, however few triangles there are. `weights`: by hair of
/// SampledHair, above 0: how much it matters. The same hairs give the same locks.
[[nodiscard]] std::vector<HairLock> dividedIntoLocks(const SampledHair& hair,
                                                     std::vector<std::vector<std::uint32_t>> sets,
                                                     std::span<const float> weights, int triangles);

} // namespace hairpaint::model
