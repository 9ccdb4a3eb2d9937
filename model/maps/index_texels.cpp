// Numbers of a palette's entries, which are chosen and never mixed.
#include "model/maps/index_texels.h"

#include "model/maps/map_colours.h"
#include "model/values/texel_math.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr std::uint16_t kOtherShade = 47000; ///< Of 65535.
constexpr sim::Texel kNight{0, 0, 0, 0};
constexpr sim::Texel kPaper{65535, 65535, 65535, 0};
/// How far a number is from its entry's own lies in the lowest bits of the colour's channels, so that an image of 16
/// bits keeps it, and nobody sees it.
constexpr unsigned kTellingBits = 4;
constexpr std::uint16_t kTelling = (1U << kTellingBits) - 1;

/// Of an entry's number that is so many after its own. Every other one has another shade, so that two rows that touch
/// are seen as two.
sim::Texel entryColour(const PaletteEntry& entry, std::size_t after)
{
    sim::Texel rgb{widened(qRed(entry.colour)), widened(qGreen(entry.colour)), widened(qBlue(entry.colour)), 0};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        if (after % 2 != 0)
            rgb[channel] = mul16(rgb[channel], kOtherShade);
        rgb[channel] ^= static_cast<std::uint16_t>((after >> (kTellingBits * channel)) & kTelling);
    }
    return rgb;
}

/// The number of the last entry that just this colour shows; 0 where it is no such.
std::uint16_t numberOfColour(const MapSpec& spec, const sim::Texel& rgb)
{
    const std::size_t entry = spec.palette.size() - 1;
    for (const std::size_t shade : {std::size_t{0}, std::size_t{1}}) {
        const sim::Texel own = entryColour(spec.palette[entry], shade);
        std::size_t after = shade;
        bool isOwn = true;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const auto differs = static_cast<std::uint16_t>(own[channel] ^ rgb[channel]);
            isOwn = isOwn && differs <= kTelling;
            after ^= std::size_t{differs} << (kTellingBits * channel);
        }
        if (isOwn && after % 2 == shade && entry + after <= lastIndex(spec))
            return static_cast<std::uint16_t>(entry + after);
    }
    return 0;
}

} // namespace

void layIndices(std::uint16_t* layer, const std::uint16_t* mask, const TilePaint& paint)
{
    for (std::size_t texel = 0; texel < sim::kTileTexels; ++texel) {
        if (mask[texel] < kHalfCoverage)
            continue;
        layer[texel * 2] = paint.values != nullptr ? paint.values[texel] : paint.value[0];
        layer[texel * 2 + 1] = 65535;
    }
}

void eraseIndices(const MapSpec& spec, std::uint16_t* layer, const std::uint16_t* mask, std::uint16_t /*opacity*/)
{
    for (std::size_t texel = 0; texel < sim::kTileTexels; ++texel) {
        if (mask[texel] < kHalfCoverage)
            continue;
        layer[texel * 2] = spec.defaultValue[0];
        layer[texel * 2 + 1] = 0;
    }
}

void blendIndices(BlendMode /*mode*/, const std::uint16_t* layer, std::size_t layerStep, std::uint16_t opacity,
                  std::uint16_t* map, std::size_t count)
{
    for (std::size_t texel = 0; texel < count; ++texel) {
        const std::uint16_t* source = layer + texel * layerStep;
        map[texel] = mul16(source[1], opacity) >= kHalfCoverage ? source[0] : map[texel];
    }
}

void chooseIndices(const sim::Texel& first, const sim::Texel& second, std::span<const std::uint16_t> fractions,
                   std::uint16_t* values)
{
    for (const std::uint16_t fraction : fractions)
        *values++ = (fraction < kHalfCoverage ? first : second)[0];
}

/// A number of 0, or of no entry, is the paper.
void indicesToColours(const MapSpec& spec, bool nightPaper, const std::uint16_t* values, std::size_t step,
                      std::size_t count, std::uint16_t* colours)
{
    for (std::size_t texel = 0; texel < count; ++texel) {
        const std::uint16_t number = values[texel * step];
        const std::size_t entry = spec.entryOf(number);
        sim::Texel rgb = nightPaper ? kNight : kPaper;
        if (entry > 0)
            rgb = entryColour(spec.palette[entry], number - entry);
        colours = std::copy_n(rgb.begin(), 3, colours);
    }
}

void indicesFromColours(const MapSpec& spec, std::span<sim::Texel> texels)
{
    for (sim::Texel& texel : texels) {
        std::uint16_t number = numberOfColour(spec, texel);
        if (number == 0)
            number = colourToIndex(spec, static_cast<float>(texel[0]) / kFull16, static_cast<float>(texel[1]) / kFull16,
                                   static_cast<float>(texel[2]) / kFull16);
        texel = {number, texel[3], 0, 0};
    }
}

/// A grey of 0..1 spread over the palette's entries.
void indicesToGreys(const MapSpec& spec, const std::uint16_t* values, std::size_t step, std::size_t count,
                    std::uint16_t* greys)
{
    const auto last = static_cast<std::uint32_t>(spec.palette.size() - 1);
    for (std::size_t texel = 0; texel < count; ++texel)
        greys[texel] = static_cast<std::uint16_t>(std::min<std::uint32_t>(values[texel * step], last) * 65535U / last);
}

void indicesFromGreys(const MapSpec& spec, std::span<sim::Texel> texels)
{
    const auto last = static_cast<float>(spec.palette.size() - 1);
    for (sim::Texel& texel : texels)
        texel = {static_cast<std::uint16_t>(std::lround(static_cast<float>(greyOf(texel)) / kFull16 * last)), texel[3],
                 0, 0};
}

PaintValue indexOfTexel(const sim::Texel& texel)
{
    return {.index = texel[0]};
}

sim::Texel texelOfIndex(const PaintValue& value)
{
    return {static_cast<std::uint16_t>(value.index), 0, 0, 0};
}

QString indexText(const sim::GroupSettings& /*settings*/, const MapSpec& spec, const PaintValue& value)
{
    const std::size_t entry = spec.entryOf(value.index);
    return entry > 0 || value.index == 0 ? spec.palette[entry].titleText() : QString::number(value.index);
}

std::uint16_t lastIndex(const MapSpec& spec)
{
    return std::max(static_cast<std::uint16_t>(spec.palette.size() - 1), spec.lastNumber);
}

} // namespace hairpaint::model
