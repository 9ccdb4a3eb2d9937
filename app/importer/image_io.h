// Foreign images, decoded and encoded by OpenImageIO. The only file that includes it is image_io.cpp.
#pragma once

#include "model/files/wire_format.h"

#include <tl/expected.hpp>

namespace hairpaint::importer {

/// `path`: UTF-8. The first image of the file, its first 4 channels, as 16-bit unassociated samples.
[[nodiscard]] tl::expected<wire::Image, wire::Reason> readImage(const std::string& path);

/// The file's bytes, for an ending such as "png".
[[nodiscard]] tl::expected<wire::Bytes, wire::Reason> encodeImage(const wire::EncodeRequest& request);

} // namespace hairpaint::importer
