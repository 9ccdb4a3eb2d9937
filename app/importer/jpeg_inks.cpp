// libjpeg's scan lines. What it can't go on from jumps back (setjmp), over no object that is to be destroyed.
#include "app/importer/jpeg_inks.h"

#include <csetjmp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

// Which want cstdio before them.
#include <jpeglib.h>

#include <jerror.h>

namespace hairpaint::importer {

namespace {

struct Decoding
{
    jpeg_decompress_struct jpeg{};
    jpeg_error_mgr errors{};
    std::jmp_buf back{};
    bool isCutShort = false; ///< libjpeg fills up with grey what is missing.
};

void jumpBack(j_common_ptr jpeg)
{
    std::longjmp(static_cast<Decoding*>(jpeg->client_data)->back, 1); // NOLINT(cert-err52-cpp)
}

void sayNothing(j_common_ptr /*jpeg*/) {}

void noteWhatIsMissing(j_common_ptr jpeg, int level)
{
    const int code = jpeg->err->msg_code;
    if (level < 0 && (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER))
        static_cast<Decoding*>(jpeg->client_data)->isCutShort = true;
}

/// False where it is damaged.
bool begin(Decoding& decoding, const std::vector<unsigned char>& bytes)
{
    jpeg_decompress_struct& jpeg = decoding.jpeg;
    jpeg.err = jpeg_std_error(&decoding.errors);
    decoding.errors.error_exit = jumpBack;
    decoding.errors.output_message = sayNothing;
    decoding.errors.emit_message = noteWhatIsMissing;
    jpeg.client_data = &decoding;
    if (setjmp(decoding.back) != 0) // NOLINT(cert-err52-cpp)
        return false;
    jpeg_create_decompress(&jpeg);
    jpeg_mem_src(&jpeg, bytes.data(), static_cast<unsigned long>(bytes.size()));
    return jpeg_read_header(&jpeg, TRUE) == JPEG_HEADER_OK;
}

/// Into as many bytes as the picture has.
bool decode(Decoding& decoding, unsigned char* samples)
{
    jpeg_decompress_struct& jpeg = decoding.jpeg;
    if (setjmp(decoding.back) != 0) // NOLINT(cert-err52-cpp)
        return false;
    jpeg.out_color_space = JCS_CMYK;
    jpeg_start_decompress(&jpeg);
    while (jpeg.output_scanline < jpeg.output_height) {
        JSAMPROW row = samples + std::size_t{jpeg.output_scanline} * jpeg.output_width * 4;
        (void)jpeg_read_scanlines(&jpeg, &row, 1);
    }
    return !decoding.isCutShort;
}

} // namespace

tl::expected<wire::Image, wire::Reason> readJpegInks(const std::string& path)
{
    std::ifstream file(std::filesystem::path(std::u8string(path.begin(), path.end())), std::ios::binary);
    const std::vector<char> read(std::istreambuf_iterator<char>(file), {});
    const std::vector<unsigned char> bytes(read.begin(), read.end());
    Decoding decoding;
    const bool isBegun = begin(decoding, bytes);
    jpeg_decompress_struct& jpeg = decoding.jpeg;
    tl::expected<wire::Image, wire::Reason> result = tl::unexpected(wire::Reason::Damaged);
    if (isBegun && jpeg.jpeg_color_space != JCS_CMYK && jpeg.jpeg_color_space != JCS_YCCK) {
        result = tl::unexpected(wire::Reason::CannotOpen);
    } else if (isBegun && !wire::imageFits(jpeg.image_width, jpeg.image_height, 4)) {
        result = tl::unexpected(wire::Reason::TooLarge);
    } else if (isBegun) {
        std::vector<unsigned char> samples(std::size_t{jpeg.image_width} * jpeg.image_height * 4);
        if (decode(decoding, samples.data())) {
            constexpr unsigned kSpread = 0xFFFFU / 0xFFU;
            const unsigned turns = jpeg.saw_Adobe_marker != FALSE ? 0xFFU : 0U;
            result = wire::Image{.width = jpeg.image_width, .height = jpeg.image_height, .channels = 4, .samples = {}};
            result->samples.reserve(samples.size());
            for (const unsigned char sample : samples)
                result->samples.push_back(static_cast<std::uint16_t>((sample ^ turns) * kSpread));
        }
    }
    jpeg_destroy_decompress(&jpeg);
    return result;
}

} // namespace hairpaint::importer
