// Whether an image tells a map's values by its brightness or by the colours of the map's scale.
#pragma once

#include "model/project/map_spec.h"

#include <cstdint>
#include <span>

namespace hairpaint::model {

enum class ImageReading
{
    Scale, ///< By the map's scale, as the program writes it; of colour maps, the colours themselves.
    Value, ///< Brightness is the value.
    Either ///< Its pixels allow both.
};

/// `samples`: 16 bits, of 1 to 4 `channels` (grey, grey and alpha, RGB, RGBA). By its pixels, those that nothing covers
/// left out. An image of one channel has no colours. One of three or four tells the value where all its pixels are grey
/// and some are not white, the scale where its coloured pixels lie along that, and is the scale's where it is white all
/// over, which is how an empty map is written. Cheap beside decoding.
[[nodiscard]] ImageReading readingOf(std::span<const std::uint16_t> samples, int channels, const MapSpec& spec);

} // namespace hairpaint::model
