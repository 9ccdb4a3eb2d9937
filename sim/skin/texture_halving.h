// Textures made smaller until they fit. In a header, since the helper program reads textures without the library.
#pragma once

#include "sim/skin/mesh_texture.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hairpaint::sim {

/// Half as wide and high, 1 at least: means of two by two. A last odd row or column is left out.
[[nodiscard]] inline MeshTexture halved(const MeshTexture& whole)
{
    MeshTexture half{.width = std::max(whole.width / 2, 1U), .height = std::max(whole.height / 2, 1U), .rgba = {}};
    half.rgba.resize(std::size_t{half.width} * half.height * 4);
    for (std::uint32_t y = 0; y < half.height; ++y)
        for (std::uint32_t x = 0; x < half.width; ++x)
            for (std::size_t c = 0; c < 4; ++c) {
                unsigned sum = 2;
                for (std::uint32_t i = 0; i < 4; ++i) {
                    const std::size_t row = std::min(2 * y + i / 2, whole.height - 1);
                    const std::size_t column = std::min(2 * x + i % 2, whole.width - 1);
                    sum += whole.rgba[(row * whole.width + column) * 4 + c];
                }
                half.rgba[(std::size_t{y} * half.width + x) * 4 + c] = static_cast<std::uint8_t>(sum / 4);
            }
    return half;
}

[[nodiscard]] inline std::size_t pixelsOf(const std::vector<MeshTexture>& textures)
{
    std::size_t pixels = 0;
    for (const MeshTexture& texture : textures)
        pixels += texture.rgba.size() / 4;
    return pixels;
}

/// Halves the largest until all together have at most that many pixels, which are no fewer than the textures.
inline void shrinkTo(std::vector<MeshTexture>& textures, std::size_t mostPixels)
{
    while (pixelsOf(textures) > mostPixels) {
        MeshTexture& largest =
            *std::ranges::max_element(textures, {}, [](const MeshTexture& one) { return one.rgba.size(); });
        largest = halved(largest);
    }
}

} // namespace hairpaint::sim
