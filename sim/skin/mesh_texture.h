// A picture that lies on a mesh by its uvs and repeats beyond 0..1.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hairpaint::sim {

/// How a texture's alpha counts.
enum class TextureAlpha : std::uint32_t
{
    Opaque = 0, ///< Alpha is ignored.
    Mask = 1,   ///< Where alpha is under a half nothing is drawn.
    Blend = 2   ///< Mixed with what is behind it; drawn as a mask here.
};

/// RGBA, 8 bits a channel, sRGB, unassociated; row 0 is v = 1. Immutable once shared between threads.
struct MeshTexture
{
    static constexpr std::uint32_t kLargestSide = 4096;
    /// Limit on the pixels of all textures of a mesh together.
    static constexpr std::size_t kMostPixels = std::size_t{1} << 24U;

    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
    friend bool operator==(const MeshTexture&, const MeshTexture&) = default;
};

} // namespace hairpaint::sim
