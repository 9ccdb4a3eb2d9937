// Formats of pictures that are known and not read, so that a sentence can name them.
#pragma once

#include <istream>
#include <string_view>

namespace hairpaint::importer {

/// "JPEG XL", by the file's first bytes; empty where it is none of them.
[[nodiscard]] std::string_view unreadFormatOf(std::istream& file);

} // namespace hairpaint::importer
