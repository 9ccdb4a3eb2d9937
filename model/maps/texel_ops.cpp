// Scalars, indices, colours and vectors.
#include "model/maps/texel_ops.h"

#include "model/values/texel_math.h"
#include "sim/groom/direction_texel.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hairpaint::model {

namespace {

constexpr float kGreatest = 65535.0F;
constexpr float kRounding = 0.5F; ///< lround would not become vector code; what it is added to is never negative.
constexpr sim::Texel kBlack{0, 0, 0, 0};
constexpr sim::Texel kWhite{65535, 65535, 65535, 0};

class TexelWords
{
    Q_DECLARE_TR_FUNCTIONS(TexelWords)
};

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

std::uint16_t greyOf(const sim::Texel& rgba)
{
    return static_cast<std::uint16_t>((rgba[0] + rgba[1] + rgba[2] + 1) / 3);
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
            colourToScale(spec, static_cast<float>(texel[0]) / kGreatest, static_cast<float>(texel[1]) / kGreatest,
                          static_cast<float>(texel[2]) / kGreatest);
        texel = {static_cast<std::uint16_t>(std::lround(value * kGreatest)), texel[3], 0, 0};
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
    return {.scalar = static_cast<float>(texel[0]) / kGreatest};
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

// Indices

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

/// An index of 0, or of no entry, is the paper.
void indicesToColours(const MapSpec& spec, bool nightPaper, const std::uint16_t* values, std::size_t step,
                      std::size_t count, std::uint16_t* colours)
{
    for (std::size_t texel = 0; texel < count; ++texel) {
        const std::size_t index = values[texel * step];
        sim::Texel rgb = nightPaper ? kBlack : kWhite;
        if (index > 0 && index < spec.palette.size()) {
            const QRgb colour = spec.palette[index].colour;
            rgb = {widened(qRed(colour)), widened(qGreen(colour)), widened(qBlue(colour)), 0};
        }
        colours = std::copy_n(rgb.begin(), 3, colours);
    }
}

void indicesFromColours(const MapSpec& spec, std::span<sim::Texel> texels)
{
    for (sim::Texel& texel : texels)
        texel = {colourToIndex(spec, static_cast<float>(texel[0]) / kGreatest, static_cast<float>(texel[1]) / kGreatest,
                               static_cast<float>(texel[2]) / kGreatest),
                 texel[3], 0, 0};
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
        texel = {static_cast<std::uint16_t>(std::lround(static_cast<float>(greyOf(texel)) / kGreatest * last)),
                 texel[3], 0, 0};
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
    const auto index = static_cast<std::size_t>(std::max(value.index, 0));
    return index < spec.palette.size() ? spec.palette[index].titleText() : QString::number(value.index);
}

std::uint16_t lastOfPalette(const MapSpec& spec)
{
    return static_cast<std::uint16_t>(spec.palette.size() - 1);
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

// Vectors

sim::Texel turnedTexel(const sim::Texel& from, const sim::Texel& to, float fraction)
{
    return sim::texelOfDirection(sim::turnedBetween(sim::directionOf(from), sim::directionOf(to), fraction));
}

void layVectors(std::uint16_t* layer, const std::uint16_t* mask, const TilePaint& paint)
{
    for (std::size_t texel = 0; texel < sim::kTileTexels; ++texel, layer += 3) {
        const std::uint32_t fraction = mul16(mask[texel], paint.opacity);
        if (fraction == 0)
            continue;
        const std::uint32_t after = layer[2] + mul16(65535U - layer[2], fraction);
        sim::Texel value = paint.value;
        if (paint.values != nullptr)
            value = {paint.values[2 * texel], paint.values[2 * texel + 1], 0, 0};
        if (fraction != after)
            value = turnedTexel({layer[0], layer[1], 0, 0}, value,
                                static_cast<float>(fraction) / static_cast<float>(std::max(after, 1U)));
        layer[0] = value[0];
        layer[1] = value[1];
        layer[2] = static_cast<std::uint16_t>(after);
    }
}

void blendVectors(BlendMode /*mode*/, const std::uint16_t* layer, std::size_t layerStep, std::uint16_t opacity,
                  std::uint16_t* map, std::size_t count)
{
    for (std::size_t texel = 0; texel < count; ++texel, layer += layerStep, map += 2) {
        const std::uint16_t fraction = mul16(layer[2], opacity);
        if (fraction == 0)
            continue;
        sim::Texel mixed{layer[0], layer[1], 0, 0};
        if (fraction != 65535)
            mixed = turnedTexel({map[0], map[1], 0, 0}, mixed, static_cast<float>(fraction) / kGreatest);
        map[0] = mixed[0];
        map[1] = mixed[1];
    }
}

/// A tangent-space normal map. Its (x + 1) / 2 is what is stored, to half a step.
void vectorsToColours(const MapSpec& /*spec*/, bool /*nightPaper*/, const std::uint16_t* values, std::size_t step,
                      std::size_t count, std::uint16_t* colours)
{
    for (std::size_t texel = 0; texel < count; ++texel, values += step, colours += 3) {
        const glm::vec2 vector = sim::directionOf({values[0], values[1], 0, 0});
        const float z = std::sqrt(std::max(1.0F - glm::dot(vector, vector), 0.0F));
        colours[0] = values[0];
        colours[1] = values[1];
        colours[2] = unit16(0.5F * z + 0.5F);
    }
}

/// Blue only says what red and green have said. Vectors too long, as of pictures that are no normal maps, lie flat.
void vectorsFromColours(const MapSpec& /*spec*/, std::span<sim::Texel> texels)
{
    for (sim::Texel& texel : texels) {
        const glm::vec2 read = (glm::vec2(texel[0], texel[1]) - sim::kDirectionZero) / sim::kDirectionOne;
        const std::uint16_t coverage = texel[3];
        if (glm::dot(read, read) > 1.0F)
            texel = sim::texelOfDirection(read);
        texel[2] = coverage;
        texel[3] = 0;
    }
}

/// How flat hair lies, down the map.
void vectorsFromGreys(const MapSpec& /*spec*/, std::span<sim::Texel> texels)
{
    for (sim::Texel& texel : texels) {
        const std::uint16_t coverage = texel[3];
        texel = sim::texelOfDirection({0.0F, -static_cast<float>(greyOf(texel)) / kGreatest});
        texel[2] = coverage;
    }
}

PaintValue vectorOf(const sim::Texel& texel)
{
    return {.direction = sim::directionOf(texel)};
}

sim::Texel texelOfVector(const PaintValue& value)
{
    return sim::texelOfDirection(value.direction);
}

/// The angle is counted from the map's right, against the clock.
QString vectorText(const sim::GroupSettings& /*settings*/, const MapSpec& /*spec*/, const PaintValue& value)
{
    const float flatness = glm::length(value.direction);
    const int percent = static_cast<int>(std::lround(flatness * 100.0F));
    if (percent == 0)
        return TexelWords::tr("upright");
    const double turns = std::atan2(static_cast<double>(value.direction.y), static_cast<double>(value.direction.x)) /
                         (2.0 * std::numbers::pi);
    const int degrees = static_cast<int>(std::lround((turns - std::floor(turns)) * 360.0)) % 360;
    //: An angle in degrees, and how flat hair lies, in per cent.
    return TexelWords::tr("%1°, %2 % flat").arg(degrees).arg(percent);
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
             .greatest = lastOfPalette},
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

sim::Texel PaintValue::texel(const MapSpec& spec) const
{
    return texelOps(spec).texel(*this);
}

QRgb colourOfTexel(const MapSpec& spec, const sim::Texel& texel, bool nightPaper)
{
    std::array<std::uint16_t, 3> colour{};
    texelOps(spec).toColours(spec, nightPaper, texel.data(), 0, 1, colour.data());
    return qRgb(narrowed(colour[0]), narrowed(colour[1]), narrowed(colour[2]));
}

} // namespace hairpaint::model
