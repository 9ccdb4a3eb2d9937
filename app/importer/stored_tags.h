// What the header of an image file says and OpenImageIO 2.4 leaves out or reads otherwise.
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <vector>

namespace hairpaint::importer {

struct StoredTags
{
    int orientation = 0;             ///< 1..8 as EXIF has it; 0: not told here (PNG; JPEG and TIFF tell OpenImageIO).
    bool isAssociated = false;       ///< Colours are multiplied by alpha (TIFF, TGA).
    bool fourthIsNoAlpha = false;    ///< The bytes behind the colours have no meaning as alpha (BMP, TIFF).
    bool lowIsWhite = false;         ///< TIFF's photometric 0.
    bool lacksMergedPicture = false; ///< PSD saved without the picture that its layers make.
    bool hasInks = false;            ///< PSD whose colours are CMYK.
    bool lacksBitsPerSample = false; ///< TIFF without tag 258, whose default is 1.
    friend bool operator==(const StoredTags&, const StoredTags&) = default;
};

/// By the file's first bytes. Sources: TIFF 6.0 (1992), BITMAPV5HEADER (Microsoft), Truevision TGA 2.0 (1991), Adobe
/// Photoshop File Formats (2019), PNG 3 (2025). Whatever is cut short or broken is not told.
[[nodiscard]] StoredTags readStoredTags(std::istream& file);

/// The orientation of an EXIF block ("II" or "MM" first, with or without "Exif\0\0"); 0 where it tells none.
[[nodiscard]] int exifOrientation(const std::vector<std::uint8_t>& exif);

/// A TIFF's bytes with tag 258 (BitsPerSample) at its default of 1 in a copy of its first directory; none where that
/// can't be read, or has the tag.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> withBitsPerSample(std::vector<std::uint8_t> tiff);

} // namespace hairpaint::importer
