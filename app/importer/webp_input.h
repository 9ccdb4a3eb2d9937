// WebP through its own library: OpenImageIO 2.4 multiplies its colours by alpha, and does not read how it is turned.
// The only file that includes libwebp is webp_input.cpp.
#pragma once

#include "model/files/wire_format.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hairpaint::importer {

struct WebpImage
{
    wire::Image image; ///< RGB or RGBA, as it is stored.
    std::vector<std::uint8_t> profile;
    int orientation = 1;
};

/// None where it is no WebP, or one that moves. `path`: UTF-8.
[[nodiscard]] std::optional<tl::expected<WebpImage, wire::Reason>> readWebp(const std::string& path);

} // namespace hairpaint::importer
