// A picture that lies on a mesh by its uvs and repeats beyond 0..1.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hairpaint::sim {

/// How a texture's alpha counts.
enum class TextureAlpha : std::uint32_t
{
    Opaque = 0, ///< Not at all.
    Mask = 1,   ///< What is under a half is not there.
    Blend = 2   ///< Mixed with what is behind it; drawn as a mask here.
};

/// RGBA, 8 bits a channel, sRGB, unassociated; row 0 is v = 1. Immutable once shared between threads.
struct MeshTexture
{
    static constexpr std::uint32_t kLargestSide = 4096;
    static constexpr std::size_t kMostPixels = std::size_t{1} << 24U; ///< Of all of a mesh together.

    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
    friend bool operator==(const MeshTexture&, const MeshTexture&) = default;
};

} // namespace hairpaint::sim
