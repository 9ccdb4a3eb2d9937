// Foreign images, decoded and encoded by OpenImageIO, which only image_io and image_channels include.
#pragma once

#include "model/files/wire_format.h"

#include <tl/expected.hpp>

namespace hairpaint::importer {

/// `path`: UTF-8. The first image of the file as 16-bit unassociated samples: grey or RGB, with alpha where it has
/// some. `isColour`: in sRGB, whatever light or profile the file has them in; else its numbers are taken as they are.
[[nodiscard]] tl::expected<wire::Image, wire::Refusal> readImage(const std::string& path, bool isColour);

/// The file's bytes, for an ending such as "png". `isColour`: it holds sRGB, which becomes linear light in a format of
/// floats.
[[nodiscard]] tl::expected<wire::Bytes, wire::Reason> encodeImageFile(const wire::EncodeRequest& request,
                                                                      bool isColour);

} // namespace hairpaint::importer
