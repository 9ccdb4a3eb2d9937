// The arithmetic of laying paint, for one tile.
#include "model/tools/tile_paint.h"

#include "model/compositor.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

constexpr std::size_t kTexels = StrokeBuffer::kTileTexels;

template<int channels>
void layPixels(std::uint16_t* pixels, const std::uint16_t* mask, const TilePaint& paint)
{
    for (std::size_t texel = 0; texel < kTexels; ++texel) {
        std::uint16_t* target = pixels + texel * (channels + 1);
        const std::uint32_t share = mul16(mask[texel], paint.opacity);
        const std::uint32_t coverage = target[channels];
        const std::uint32_t after = coverage + mul16(65535U - coverage, share);
        const float part = static_cast<float>(share) / static_cast<float>(std::max(after, 1U));
        for (int i = 0; i < channels; ++i) {
            const std::uint16_t value = paint.values != nullptr
                                            ? paint.values[texel * channels + static_cast<std::size_t>(i)]
                                            : paint.value[static_cast<std::size_t>(i)];
            const auto old = static_cast<float>(target[i]);
            // lround would not become vector code; values are never negative.
            // NOLINTNEXTLINE(bugprone-incorrect-roundings)
            const int moved = static_cast<int>(old + (static_cast<float>(value) - old) * part + 0.5F);
            target[i] = static_cast<std::uint16_t>(moved);
        }
        target[channels] = static_cast<std::uint16_t>(after);
    }
}

template<int channels>
void erasePixels(const MapSpec& spec, std::uint16_t* pixels, const std::uint16_t* mask, std::uint16_t opacity)
{
    for (std::size_t texel = 0; texel < kTexels; ++texel) {
        std::uint16_t* target = pixels + texel * (channels + 1);
        const std::uint16_t share = mul16(mask[texel], opacity);
        if (share == 0)
            continue;
        target[channels] = mul16(target[channels], 65535U - share);
        if (target[channels] == 0)
            std::copy_n(spec.defaultValue.begin(), channels, target);
    }
}

void paintIndices(const MapSpec& spec, std::uint16_t* pixels, const std::uint16_t* mask, const TilePaint& paint)
{
    for (std::size_t texel = 0; texel < kTexels; ++texel) {
        if (mask[texel] < kHalfCoverage)
            continue;
        const std::uint16_t value = paint.values != nullptr ? paint.values[texel] : paint.value[0];
        pixels[texel * 2] = paint.erase ? spec.defaultValue[0] : value;
        pixels[texel * 2 + 1] = paint.erase ? 0 : 65535;
    }
}

void expand(sim::RasterTile& tile, const sim::RasterTile& from, std::size_t channels)
{
    if (!from.isUniform()) {
        tile.pixels = from.pixels;
        return;
    }
    tile.pixels.resize(kTexels * channels);
    for (std::size_t i = 0; i < tile.pixels.size(); ++i)
        tile.pixels[i] = from.uniform[i % channels];
}

} // namespace

sim::RasterTilePtr paintTile(const MapSpec& spec, const sim::RasterTilePtr& before, const StrokeBuffer::MaskTile& mask,
                             const TilePaint& paint)
{
    const auto channels = static_cast<std::size_t>(spec.layerChannels());
    auto tile = std::make_shared<sim::RasterTile>();
    expand(*tile, *before, channels);
    std::uint16_t* pixels = tile->pixels.data();
    const bool colour = spec.valueChannels == 3;
    if (spec.texel == TexelKind::Index)
        paintIndices(spec, pixels, mask.data(), paint);
    else if (paint.erase)
        colour ? erasePixels<3>(spec, pixels, mask.data(), paint.opacity)
               : erasePixels<1>(spec, pixels, mask.data(), paint.opacity);
    else
        colour ? layPixels<3>(pixels, mask.data(), paint) : layPixels<1>(pixels, mask.data(), paint);

    const auto stride = static_cast<std::ptrdiff_t>(channels);
    if (std::equal(tile->pixels.begin() + stride, tile->pixels.end(), tile->pixels.begin())) {
        std::copy_n(tile->pixels.begin(), channels, tile->uniform.begin());
        tile->pixels = {};
    }
    const bool same =
        tile->isUniform() == before->isUniform() && tile->uniform == before->uniform && tile->pixels == before->pixels;
    return same ? before : tile;
}

} // namespace hairpaint::model
