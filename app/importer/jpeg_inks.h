// A JPEG of inks (CMYK, or YCCK), which OpenImageIO 2.4 gives as RGB alone. The only file that includes libjpeg is
// jpeg_inks.cpp.
#pragma once

#include "model/files/wire_format.h"

#include <tl/expected.hpp>

#include <string>

namespace hairpaint::importer {

/// 4 channels, 0 no ink: as Adobe's marker says, files with it hold the opposite. Not turned upright. Fails where it is
/// no JPEG of inks (CannotOpen), is damaged or too large.
[[nodiscard]] tl::expected<wire::Image, wire::Reason> readJpegInks(const std::string& path);

} // namespace hairpaint::importer
