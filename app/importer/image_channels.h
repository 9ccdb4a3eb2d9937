// Which channels of an image are its colours and its alpha, and the rectangle that it shows.
#pragma once

#include "app/importer/stored_tags.h"
#include "model/files/wire_format.h"

#include <OpenImageIO/imageio.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <vector>

namespace hairpaint::importer {

/// By their numbers in the file.
struct ImageChannels
{
    std::vector<int> colours; ///< One grey, or red, green and blue.
    int alpha = -1;           ///< -1: none.
    [[nodiscard]] std::uint32_t count() const
    {
        return static_cast<std::uint32_t>(colours.size()) + (alpha >= 0 ? 1U : 0U);
    }
};

/// By their names where they have such (R, G, B, A, Y, also in a layer: "hair.R"), else by their order. A depth or any
/// other fourth channel is no alpha; what stands beside a luminance is no colour.
[[nodiscard]] ImageChannels channelsOf(const OIIO::ImageSpec& spec, const StoredTags& tags);

/// How its samples become values.
struct SampleReading
{
    ImageChannels channels;
    bool isAssociated = false; ///< Colours are divided by alpha.
    bool isLinear = false;     ///< Colours become sRGB.
    bool isShown = false;      ///< The display window is read instead of the data; what lies outside is not covered.
};

/// 16 bits a sample, row 0 on top; none where the file is damaged, or too large. Throws std::bad_alloc.
[[nodiscard]] tl::expected<wire::Image, wire::Reason> readSamples(OIIO::ImageInput& input,
                                                                  const SampleReading& reading);

} // namespace hairpaint::importer
