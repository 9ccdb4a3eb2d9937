// URIs of a glTF's buffers (Berners-Lee, Fielding, Masinter 2005, RFC 3986; Masinter 1998, RFC 2397).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hairpaint::importer {

[[nodiscard]] bool isDataUri(std::string_view uri);
/// What a data URI holds; none where it is not base64.
[[nodiscard]] std::optional<std::vector<std::byte>> dataOfUri(std::string_view uri);
/// With the characters that are written as %20 and the like; what is no such code stays.
[[nodiscard]] std::string percentDecoded(std::string_view uri);
/// A path of this machine that is named whole; none where a URI names another kind of source, as http.
[[nodiscard]] std::optional<std::string> pathOfUri(std::string_view uri);

} // namespace hairpaint::importer
