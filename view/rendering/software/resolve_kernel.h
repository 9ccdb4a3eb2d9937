// The end of a tile: what lies behind the hair put into it, and its pixels encoded.
#pragma once

#include "view/rendering/software/tile_kernel.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace hairpaint::rendering {

/// What turns a tile's samples into pixels.
struct ResolveTask
{
    int samplesX = 1; ///< A pixel.
    int samplesY = 1;
    int firstPixelX = 0;
    int firstPixelY = 0; ///< From the bottom.
    int pictureWidth = 0;
    int pictureHeight = 0;
    glm::vec3 background{0.0F};     ///< sRGB as encoded, in the middle of the picture;
    glm::vec3 backgroundRise{0.0F}; ///< and from there to the top.
    bool transparent = false;       ///< No background.
    float* linear = nullptr;        ///< The picture in linear light, RGBA, colours times alpha; null: not wanted.
    const float* shade = nullptr;   ///< What is left of the skin's light, in cells from the lowest; null: all.
    const float* hidden = nullptr;  ///< Likewise: how surely nothing is seen through hair.
    int shadeAcross = 0;
    int shadeUp = 0;
    int shadeCell = 1;        ///< Pixels.
    float shadeSpread = 0.0F; ///< SkinShading::scatter: light spreads under the skin into the shade, red furthest.
};
/// Writes RGBA8 into `pixels`, the picture's, whose row 0 is on top; where transparent, colours are not times alpha.
void resolveTile(const TileTask& task, const ResolveTask& resolve, const TileSamples& samples, std::uint8_t* pixels);

} // namespace hairpaint::rendering
