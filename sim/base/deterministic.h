// Numbers that are the same on every machine: our own random integers and our own transcendentals.
#pragma once

#include <cstdint>

namespace hairpaint::sim {

/// The finaliser of SplitMix64 (Steele, Lea and Flood 2014).
[[nodiscard]] constexpr std::uint64_t splitMix64(std::uint64_t z)
{
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
}

/// A well-mixed 64-bit hash of two numbers. Of many numbers with one key, the key is mixed once.
[[nodiscard]] constexpr std::uint64_t hash64(std::uint64_t key, std::uint64_t counter)
{
    constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15U;
    return splitMix64(splitMix64(key + kGolden) + (counter + 1) * kGolden);
}

/// Uniform in [0, 1), 24 bits, from a hash.
[[nodiscard]] constexpr float unitFloat(std::uint64_t hash)
{
    return static_cast<float>(hash >> 40U) * (1.0F / 16777216.0F);
}

/// Sine, cosine and exponential from multiplications and additions alone; absolute error under 2e-6 for |x| < 1e4
/// (sine, cosine), relative error under 1e-6 for x in [-80, 80] (exponential).
[[nodiscard]] float sinDet(float radians);
[[nodiscard]] float cosDet(float radians);
[[nodiscard]] float expDet(float x);
/// Both of an angle, the same bits as one by one, for little more than one.
struct SineCosine
{
    float sine;
    float cosine;
};
[[nodiscard]] SineCosine sinCosDet(float radians);

} // namespace hairpaint::sim
