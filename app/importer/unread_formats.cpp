// Their signatures (ISO/IEC 18181-2, KTX 2.0 by Khronos, and those that their programs write).
#include "app/importer/unread_formats.h"

#include <algorithm>
#include <array>
#include <string>

namespace hairpaint::importer {

namespace {

struct Signature
{
    std::string_view bytes;
    std::size_t at;
    std::string_view name;
};

using namespace std::string_view_literals;

constexpr std::array kSignatures{
    Signature{"\xFF\x0A"sv, 0, "JPEG XL"},
    Signature{"\0\0\0\x0CJXL \r\n\x87\n"sv, 0, "JPEG XL"},
    Signature{"\xABKTX 20\xBB"sv, 0, "KTX2"},
    Signature{"\xABKTX 11\xBB"sv, 0, "KTX"},
    Signature{"gimp xcf"sv, 0, "GIMP (.xcf)"},
    Signature{"CSFCHUNK"sv, 0, "Clip Studio Paint (.clip)"},
    Signature{"mimetypeapplication/x-krita"sv, 30, "Krita (.kra)"},
    Signature{"mimetypeimage/openraster"sv, 30, "OpenRaster (.ora)"},
    Signature{"%PDF-"sv, 0, "PDF"},
};

} // namespace

std::string_view unreadFormatOf(std::istream& file)
{
    std::string start(64, '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(file.gcount()));
    for (const Signature& signature : kSignatures)
        if (std::string_view(start).substr(std::min(signature.at, start.size())).starts_with(signature.bytes))
            return signature.name;
    return {};
}

} // namespace hairpaint::importer
