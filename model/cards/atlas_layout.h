// The layout of the cards' pictures in the atlas.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::model {

/// Texels of the atlas, row 0 on top; the border around it belongs to no other.
struct AtlasPatch
{
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// What a patch is to show.
struct PatchWish
{
    float widthM = 0.0F;
    float heightM = 0.0F;
};

/// One patch for each wish, in the same order, in shelves of patches of about one height that are stretched to fill a
/// square of `sizePx`: patches are disjoint, `borderPx` of nothing is around each. Texels are about twice as long as
/// wide, since hair varies least along itself; longer where patches would be too narrow. At most 40,000 wishes.
[[nodiscard]] std::vector<AtlasPatch> packedAtlas(std::span<const PatchWish> wishes, int sizePx);

/// The fraction of the atlas that patches cover, 0..1.
[[nodiscard]] float filledPart(std::span<const AtlasPatch> patches, int sizePx);

} // namespace hairpaint::model
