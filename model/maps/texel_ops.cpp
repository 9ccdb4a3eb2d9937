// Scalars and colours, and the table of all kinds.
#include "model/maps/texel_ops.h"

#include "model/maps/index_texels.h"
#include "model/maps/vector_texels.h"
#include "model/values/texel_math.h"

#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr float kRounding = 0.5F; ///< lround would not become vector code; what it is added to is never negative.

// Scalars, colours and vectors

template<int channels>
void layValues(std::uint16_t* layer, const std::uint16_t* mask, const TilePaint& paint)
{
    for (std::size_t texel = 0; texel < sim::kTileTexels; ++texel) {
        std::uint16_t* target = layer + texel * (channels + 1);
        const std::uint32_t fraction = mul16(mask[texel], paint.opacity);
        const std::uint32_t coverage = target[channels];
        const std::uint32_t after = coverage + mul16(65535U - coverage, fraction);
        const float part = static_cast<float>(fraction) / static_cast<float>(std::max(after, 1U));
        for (int i = 0; i < channels; ++i) {
            const std::uint16_t value = paint.values != nullptr
                                            ? paint.values[texel * channels + static_cast<std::size_t>(i)]
                                            : paint.value[static_cast<std::size_t>(i)];
            const auto old = static_cast<float>(target[i]);
            const int moved = static_cast<int>(old + (static_cast<float>(value) - old) * part + kRounding);
            target[i] = static_cast<std::uint16_t>(moved);
        }
        target[channels] = static_cast<std::uint16_t>(after);
    }
}

template<int channels>
void eraseValues(const MapSpec& spec, std::uint16_t* layer, const std::uint16_t* mask, std::uint16_t opacity)
{
    for (std::size_t texel = 0; texel < sim::kTileTexels; ++texel) {
        std::uint16_t* target = layer + texel * (channels + 1);
        const std::uint16_t fraction = mul16(mask[texel], opacity);
        if (fraction == 0)
            continue;
        target[channels] = mul16(target[channels], 65535U - fraction);
        if (target[channels] == 0)
            std::copy_n(spec.defaultValue.begin(), channels, target);
    }
}

template<int channels>
void mixValues(const sim::Texel& first, const sim::Texel& second, std::span<const std::uint16_t> fractions,
               std::uint16_t* values)
{
    for (const std::uint16_t fraction : fractions)
        for (std::size_t i = 0; i < channels; ++i)
            *values++ = lerp16(first[i], second[i], fraction);
}

std::uint16_t anyNumber(const MapSpec& /*spec*/)
{
    return 65535;
}

// Scalars

void blendScalars(BlendMode mode, const std::uint16_t* layer, std::size_t layerStep, std::uint16_t opacity,
                  std::uint16_t* map, std::size_t count)
{
    blendRule(mode).ofOne(layer, layerStep, opacity, map, count);
}

void scalarsToColours(const MapSpec& spec, bool nightPaper, const std::uint16_t* values, std::size_t step,
                      std::size_t count, std::uint16_t* colours)
{
    const std::int64_t paper = nightPaper ? 0 : 65535;
    const std::array<std::int64_t, 3> full{widened(qRed(spec.scaleColour)), widened(qGreen(spec.scaleColour)),
                                           widened(qBlue(spec.scaleColour))};
    for (std::size_t texel = 0; texel < count; ++texel)
        for (const std::int64_t channel : full) {
            const std::int64_t fromPaper = (channel - paper) * values[texel * step];
            *colours++ = static_cast<std::uint16_t>(paper + (fromPaper + (fromPaper < 0 ? -32767 : 32767)) / 65535);
        }
}

void scalarsFromColours(const MapSpec& spec, std::span<sim::Texel> texels)
{
    for (sim::Texel& texel : texels) {
        const float value =
            colourToScale(spec, static_cast<float>(texel[0]) / kFull16, static_cast<float>(texel[1]) / kFull16,
                          static_cast<float>(texel[2]) / kFull16);
        texel = {static_cast<std::uint16_t>(std::lround(value * kFull16)), texel[3], 0, 0};
    }
}

void scalarsToGreys(const MapSpec& /*spec*/, const std::uint16_t* values, std::size_t step, std::size_t count,
                    std::uint16_t* greys)
{
    for (std::size_t texel = 0; texel < count; ++texel)
        greys[texel] = values[texel * step];
}

void scalarsFromGreys(const MapSpec& /*spec*/, std::span<sim::Texel> texels)
{
    for (sim::Texel& texel : texels)
        texel = {greyOf(texel), texel[3], 0, 0};
}

PaintValue scalarOf(const sim::Texel& texel)
{
    return {.scalar = static_cast<float>(texel[0]) / kFull16};
}

sim::Texel texelOfScalar(const PaintValue& value)
{
    return {unit16(value.scalar), 0, 0, 0};
}

QString scalarText(const sim::GroupSettings& settings, const MapSpec& spec, const PaintValue& value)
{
    const int decimals = spec.scale->decimals(settings);
    QString number = QLocale().toString(spec.scale->shown(settings, static_cast<double>(value.scalar)), 'f', decimals);
    const QString zeros = QLocale().decimalPoint() + QLocale().zeroDigit();
    if (decimals == 1 && number.endsWith(zeros))
        number.chop(zeros.size());
    return number + QChar(0x2009) + spec.scale->unit(settings);
}

// Colours

void blendColours(BlendMode mode, const std::uint16_t* layer, std::size_t layerStep, std::uint16_t opacity,
                  std::uint16_t* map, std::size_t count)
{
    blendRule(mode).ofThree(layer, layerStep, opacity, map, count);
}

void coloursAsTheyAre(const MapSpec& /*spec*/, bool /*nightPaper*/, const std::uint16_t* values, std::size_t step,
                      std::size_t count, std::uint16_t* colours)
{
    // One by one: six bytes are no work for a call.
    for (std::size_t texel = 0; texel < count; ++texel, values += step, colours += 3) {
        colours[0] = values[0];
        colours[1] = values[1];
        colours[2] = values[2];
    }
}

void coloursFromColours(const MapSpec& /*spec*/, std::span<sim::Texel> /*texels*/) {}

void coloursFromGreys(const MapSpec& /*spec*/, std::span<sim::Texel> texels)
{
    for (sim::Texel& texel : texels) {
        const std::uint16_t grey = greyOf(texel);
        texel = {grey, grey, grey, texel[3]};
    }
}

PaintValue colourOf(const sim::Texel& texel)
{
    return {.colour = QColor::fromRgba64(texel[0], texel[1], texel[2])};
}

sim::Texel texelOfColour(const PaintValue& value)
{
    const QRgba64 exact = value.colour.rgba64();
    return {exact.red(), exact.green(), exact.blue(), 0};
}

QString colourText(const sim::GroupSettings& /*settings*/, const MapSpec& /*spec*/, const PaintValue& value)
{
    return value.colour.name();
}

constexpr std::array kOps{
    TexelOps{.kind = TexelKind::Scalar,
             .continuous = true,
             .lay = layValues<1>,
             .erase = eraseValues<1>,
             .blend = blendScalars,
             .mix = mixValues<1>,
             .toColours = scalarsToColours,
             .toGreys = scalarsToGreys,
             .fromColours = scalarsFromColours,
             .fromGreys = scalarsFromGreys,
             .paintValue = scalarOf,
             .texel = texelOfScalar,
             .text = scalarText,
             .greatest = anyNumber},
    TexelOps{.kind = TexelKind::Index,
             .continuous = false,
             .lay = layIndices,
             .erase = eraseIndices,
             .blend = blendIndices,
             .mix = chooseIndices,
             .toColours = indicesToColours,
             .toGreys = indicesToGreys,
             .fromColours = indicesFromColours,
             .fromGreys = indicesFromGreys,
             .paintValue = indexOfTexel,
             .texel = texelOfIndex,
             .text = indexText,
             .greatest = lastIndex},
    TexelOps{.kind = TexelKind::Colour,
             .continuous = true,
             .lay = layValues<3>,
             .erase = eraseValues<3>,
             .blend = blendColours,
             .mix = mixValues<3>,
             .toColours = coloursAsTheyAre,
             .toGreys = nullptr,
             .fromColours = coloursFromColours,
             .fromGreys = coloursFromGreys,
             .paintValue = colourOf,
             .texel = texelOfColour,
             .text = colourText,
             .greatest = anyNumber},
    TexelOps{.kind = TexelKind::Vector,
             .continuous = true,
             .lay = layVectors,
             .erase = eraseValues<2>,
             .blend = blendVectors,
             .mix = mixValues<2>,
             .toColours = vectorsToColours,
             .toGreys = nullptr,
             .fromColours = vectorsFromColours,
             .fromGreys = vectorsFromGreys,
             .paintValue = vectorOf,
             .texel = texelOfVector,
             .text = vectorText,
             .greatest = anyNumber},
};

static_assert(
    [] {
        for (std::size_t i = 0; i < kOps.size(); ++i)
            if (static_cast<std::size_t>(kOps[i].kind) != i)
                return false;
        return true;
    }(),
    "rows stand in the order of TexelKind");

} // namespace

const TexelOps& texelOps(TexelKind kind)
{
    return kOps[static_cast<std::size_t>(kind)];
}

sim::Texel texelOf(const MapSpec& spec, const PaintValue& value)
{
    return texelOps(spec).texel(value);
}

QRgb colourOfTexel(const MapSpec& spec, const sim::Texel& texel, bool nightPaper)
{
    std::array<std::uint16_t, 3> colour{};
    texelOps(spec).toColours(spec, nightPaper, texel.data(), 0, 1, colour.data());
    return qRgb(narrowed(colour[0]), narrowed(colour[1]), narrowed(colour[2]));
}

} // namespace hairpaint::model
