// Pixels counted by what they could be.
#include "model/maps/image_reading.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr float kOne = 65535.0F;
constexpr float kGreyTolerance = 6.0F / 255.0F;   ///< Greatest difference of the channels of a grey, for JPEG's errors.
constexpr float kScaleTolerance = 24.0F / 255.0F; ///< Greatest distance from a scale, for soft edges and JPEG's errors.
constexpr float kWhite = 1.0F - kGreyTolerance;

using Rgb = std::array<float, 3>;

Rgb channelsOfColour(QRgb colour)
{
    return {static_cast<float>(qRed(colour)) / 255.0F, static_cast<float>(qGreen(colour)) / 255.0F,
            static_cast<float>(qBlue(colour)) / 255.0F};
}

/// How far a colour lies off the straight line from white to `full`, in its worst channel.
float offScale(const Rgb& read, const Rgb& full)
{
    float along = 0.0F;
    float length = 0.0F;
    for (std::size_t i = 0; i < 3; ++i) {
        along += (1.0F - read[i]) * (1.0F - full[i]);
        length += (1.0F - full[i]) * (1.0F - full[i]);
    }
    const float part = length > 0.0F ? std::clamp(along / length, 0.0F, 1.0F) : 0.0F;
    float worst = 0.0F;
    for (std::size_t i = 0; i < 3; ++i)
        worst = std::max(worst, std::abs(read[i] - (1.0F - part * (1.0F - full[i]))));
    return worst;
}

bool isOnScale(const Rgb& read, const MapSpec& spec)
{
    if (spec.texel == TexelKind::Vector) {
        const float x = 2.0F * read[0] - 1.0F;
        const float y = 2.0F * read[1] - 1.0F;
        const float z = 2.0F * read[2] - 1.0F;
        return std::abs(std::sqrt(x * x + y * y + z * z) - 1.0F) < 4.0F * kScaleTolerance;
    }
    if (spec.palette.empty())
        return offScale(read, channelsOfColour(spec.scaleColour)) < kScaleTolerance;
    return std::ranges::any_of(spec.palette, [&read](const PaletteEntry& entry) {
        return offScale(read, channelsOfColour(entry.colour)) < kScaleTolerance;
    });
}

} // namespace

ImageReading readingOf(std::span<const std::uint16_t> samples, int channels, const MapSpec& spec)
{
    if (spec.texel == TexelKind::Colour)
        return ImageReading::Scale;
    if (channels <= 2)
        return ImageReading::Value;
    std::size_t white = 0;
    std::size_t grey = 0;
    std::size_t onScale = 0;
    std::size_t strange = 0;
    const auto each = static_cast<std::size_t>(channels);
    for (std::size_t at = 0; at + each <= samples.size(); at += each) {
        if (channels == 4 && samples[at + 3] == 0)
            continue;
        const Rgb read{static_cast<float>(samples[at]) / kOne, static_cast<float>(samples[at + 1]) / kOne,
                       static_cast<float>(samples[at + 2]) / kOne};
        const auto [least, most] = std::ranges::minmax(read);
        if (most - least <= kGreyTolerance)
            ++(least >= kWhite ? white : grey);
        else
            ++(isOnScale(read, spec) ? onScale : strange);
    }
    const std::size_t coloured = onScale + strange;
    if (coloured == 0)
        return grey > 0 ? ImageReading::Value : ImageReading::Scale;
    // Some strays are soft edges and a picture's noise.
    constexpr std::size_t kFew = 20; ///< One in so many.
    const bool isOfScale = strange * kFew <= coloured && grey * kFew <= coloured + white + grey;
    return isOfScale ? ImageReading::Scale : ImageReading::Either;
}

} // namespace hairpaint::model
