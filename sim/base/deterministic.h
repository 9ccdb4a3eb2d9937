// Numbers that are the same on every machine: our own random integers and our own transcendentals.
#pragma once

#include <cstdint>

namespace hairpaint::sim {

/// A well-mixed 64-bit hash of two numbers.
[[nodiscard]] std::uint64_t hash64(std::uint64_t key, std::uint64_t counter);
/// Uniform in [0, 1), 24 bits, from a hash.
[[nodiscard]] float unitFloat(std::uint64_t hash);

/// Sine, cosine and exponential from multiplications and additions alone; absolute error under 2e-6 for |x| < 1e4
/// (sine, cosine), relative error under 1e-6 for x in [-80, 80] (exponential).
[[nodiscard]] float sinDet(float radians);
[[nodiscard]] float cosDet(float radians);
[[nodiscard]] float expDet(float x);

} // namespace hairpaint::sim
