// Directions over the skin, mixed by turning.
#include "model/maps/vector_texels.h"

#include "model/values/texel_math.h"
#include "sim/groom/direction_texel.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hairpaint::model {

namespace {

class TexelWords
{
    Q_DECLARE_TR_FUNCTIONS(TexelWords)
};

sim::Texel turnedTexel(const sim::Texel& from, const sim::Texel& to, float fraction)
{
    return sim::texelOfDirection(sim::turnedBetween(sim::directionOf(from), sim::directionOf(to), fraction));
}

} // namespace

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
            mixed = turnedTexel({map[0], map[1], 0, 0}, mixed, static_cast<float>(fraction) / kFull16);
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
        texel = sim::texelOfDirection({0.0F, -static_cast<float>(greyOf(texel)) / kFull16});
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

} // namespace hairpaint::model
