// Codes of characters and of bytes.
#include "app/importer/gltf_uri.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace hairpaint::importer {

namespace {

constexpr std::string_view kData = "data:";

/// -1 where it is no digit.
int hexDigit(char c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    if (c >= 'A' && c <= 'F')
        return c - 'A' + 10;
    return -1;
}

/// -1 where it is no digit of base 64, in the common alphabet or that for URLs.
int base64Digit(char c)
{
    if (c >= 'A' && c <= 'Z')
        return c - 'A';
    if (c >= 'a' && c <= 'z')
        return c - 'a' + 26;
    if (c >= '0' && c <= '9')
        return c - '0' + 52;
    if (c == '+' || c == '-')
        return 62;
    if (c == '/' || c == '_')
        return 63;
    return -1;
}

bool startsWith(std::string_view text, std::string_view lowerCase)
{
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return text.size() >= lowerCase.size() &&
           std::equal(lowerCase.begin(), lowerCase.end(), text.begin(), [&](char a, char b) { return a == lower(b); });
}

} // namespace

bool isDataUri(std::string_view uri)
{
    return startsWith(uri, kData);
}

std::optional<std::vector<std::byte>> dataOfUri(std::string_view uri)
{
    const std::size_t comma = uri.find(',');
    if (!isDataUri(uri) || comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64"))
        return std::nullopt;
    std::string_view coded = uri.substr(comma + 1);
    while (coded.ends_with('='))
        coded.remove_suffix(1);
    std::vector<std::byte> bytes;
    bytes.reserve(coded.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    unsigned count = 0;
    for (const char c : coded) {
        const int digit = base64Digit(c);
        if (digit < 0)
            return std::nullopt;
        bits = (bits << 6U) | static_cast<std::uint32_t>(digit);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(static_cast<std::byte>((bits >> count) & 0xFFU));
        }
    }
    return bytes;
}

std::string percentDecoded(std::string_view uri)
{
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const int high = uri[i] == '%' && i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
        const int low = high >= 0 ? hexDigit(uri[i + 2]) : -1;
        if (low >= 0) {
            text += static_cast<char>(high * 16 + low);
            i += 2;
        } else {
            text += uri[i];
        }
    }
    return text;
}

std::optional<std::string> pathOfUri(std::string_view uri)
{
    constexpr std::string_view kFile = "file://";
    if (startsWith(uri, kFile))
        return std::string(uri.substr(kFile.size()));
    if (uri.find("://") != std::string_view::npos)
        return std::nullopt;
    return std::string(uri);
}

} // namespace hairpaint::importer
