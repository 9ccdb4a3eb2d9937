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

/// Divides the lock with the greatest spread again and again, as long as the strips along all locks have at most
/// `triangles` together; a lock a few hairs wide stays whole. `sets`: hairs of different sets are never in one lock; an
/// empty set gives no lock, any other at least one, however few triangles there are. `weights`: by hair of SampledHair,
/// how much it matters, above 0. The same hairs give the same locks.
[[nodiscard]] std::vector<HairLock> dividedIntoLocks(const SampledHair& hair,
                                                     std::vector<std::vector<std::uint32_t>> sets,
                                                     std::span<const float> weights, int triangles);

} // namespace hairpaint::model
