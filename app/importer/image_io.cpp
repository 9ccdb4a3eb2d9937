// Reading and writing images through OpenImageIO, without association of alpha in either direction.
#include "app/importer/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace hairpaint::importer {

namespace {

constexpr const char* kUnassociated = "oiio:UnassociatedAlpha";
constexpr int kMostImageMegabytes = 1024;

void setGlobals()
{
    // Everything runs on one thread, and no image may claim more than the limit.
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", 1);
    OIIO::attribute("limits:imagesize_MB", kMostImageMegabytes);
    OIIO::attribute("limits:channels", 64);
}

/// Turns the image upright: `orientation` 1..8 as EXIF and TIFF have it, saying where row 0 and column 0 stand.
void makeUpright(wire::Image& image, int orientation)
{
    if (orientation < 2 || orientation > 8)
        return;
    const bool isTurned = orientation >= 5; // Rows are columns.
    const bool fromRight = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool fromBelow = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    const wire::Image stored = std::move(image);
    image = {.width = isTurned ? stored.height : stored.width,
             .height = isTurned ? stored.width : stored.height,
             .channels = stored.channels,
             .samples = std::vector<std::uint16_t>(stored.samples.size())};
    auto out = image.samples.begin();
    for (std::uint32_t y = 0; y < image.height; ++y)
        for (std::uint32_t x = 0; x < image.width; ++x) {
            std::uint32_t storedX = isTurned ? y : x;
            std::uint32_t storedY = isTurned ? x : y;
            storedX = fromRight ? stored.width - 1 - storedX : storedX;
            storedY = fromBelow ? stored.height - 1 - storedY : storedY;
            const std::size_t at = (std::size_t{storedY} * stored.width + storedX) * stored.channels;
            out = std::copy_n(stored.samples.begin() + static_cast<std::ptrdiff_t>(at), stored.channels, out);
        }
}

/// Why a file that is there can't be opened, by what the library says of it.
wire::Reason reasonOf(const std::string& message)
{
    if (message.find("limits:") != std::string::npos)
        return wire::Reason::TooLarge;
    if (message.find("ompression") != std::string::npos)
        return wire::Reason::UnknownCompression;
    return wire::Reason::UnknownFormat;
}

/// All pixels with 16 bits a channel. The library converts from 8 bits through floats, to the same values.
bool readSamples(OIIO::ImageInput& input, int channels, std::vector<std::uint16_t>& samples)
{
    if (input.spec().format != OIIO::TypeDesc::UINT8)
        return input.read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT16, samples.data());
    std::vector<std::uint8_t> bytes(samples.size());
    if (!input.read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, bytes.data()))
        return false;
    constexpr unsigned kSpread = 0xFFFFU / 0xFFU;
    std::ranges::transform(bytes, samples.begin(),
                           [](std::uint8_t byte) { return static_cast<std::uint16_t>(kSpread * byte); });
    return true;
}

/// Channels as grey, grey and alpha, RGB or RGBA. An alpha that stands elsewhere than second or fourth is left out.
int keptChannels(const OIIO::ImageSpec& spec)
{
    if (spec.nchannels == 2)
        return spec.alpha_channel == 1 ? 2 : 1;
    return std::min(spec.nchannels, 4);
}

/// The library takes what follows a question mark for options; whoever reads one format does not.
std::unique_ptr<OIIO::ImageInput> openPlainly(const std::string& path, const OIIO::ImageSpec& config)
{
    const std::string list = OIIO::get_string_attribute("format_list");
    for (const OIIO::string_view& format : OIIO::Strutil::splitsv(list, ",")) {
        if (format == "null") // Which reads whatever it is given.
            continue;
        auto input = OIIO::ImageInput::create(format);
        OIIO::ImageSpec spec;
        if (input && input->open(path, spec, config))
            return input;
    }
    return nullptr;
}

std::unique_ptr<OIIO::ImageInput> openImage(const std::string& path)
{
    OIIO::ImageSpec config;
    config.attribute(kUnassociated, 1);
    return path.find('?') == std::string::npos ? OIIO::ImageInput::open(path, &config) : openPlainly(path, config);
}

} // namespace

tl::expected<wire::Image, wire::Reason> readImage(const std::string& path)
{
    setGlobals();
    const auto input = openImage(path);
    if (!input) {
        std::error_code unreadable;
        const bool there =
            std::filesystem::exists(std::filesystem::path(std::u8string(path.begin(), path.end())), unreadable);
        return tl::unexpected(there ? reasonOf(OIIO::geterror()) : wire::Reason::CannotOpen);
    }
    const OIIO::ImageSpec& spec = input->spec();
    const int channels = keptChannels(spec);
    if (spec.width <= 0 || spec.height <= 0 || spec.depth > 1 || channels < 1)
        return tl::unexpected(wire::Reason::Damaged);
    wire::Image image{.width = static_cast<std::uint32_t>(spec.width),
                      .height = static_cast<std::uint32_t>(spec.height),
                      .channels = static_cast<std::uint32_t>(channels),
                      .samples = {}};
    if (!wire::imageFits(image.width, image.height, image.channels))
        return tl::unexpected(wire::Reason::TooLarge);
    image.samples.resize(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                         static_cast<std::size_t>(channels));
    if (!readSamples(*input, channels, image.samples))
        return tl::unexpected(input->geterror().find("ompression") != std::string::npos
                                  ? wire::Reason::UnknownCompression
                                  : wire::Reason::Damaged);
    makeUpright(image, spec.get_int_attribute("Orientation", 1));
    return image;
}

tl::expected<wire::Bytes, wire::Reason> encodeImage(const wire::EncodeRequest& request)
{
    setGlobals();
    const auto output = OIIO::ImageOutput::create(request.ending);
    if (!output || output->supports("ioproxy") == 0)
        return tl::unexpected(wire::Reason::CannotWriteEnding);
    const wire::Image& image = request.image;
    // Half floats would lose the last bits of a 16-bit channel, so EXR gets floats.
    OIIO::TypeDesc type = request.bits == 8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16;
    if (request.ending == "exr")
        type = OIIO::TypeDesc::FLOAT;
    OIIO::ImageSpec spec(static_cast<int>(image.width), static_cast<int>(image.height),
                         static_cast<int>(image.channels), type);
    spec.attribute(kUnassociated, 1);
    if (image.channels == 2) {
        spec.channelnames = {"Y", "A"};
        spec.alpha_channel = 1;
    }
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput proxy(bytes);
    if (!output->set_ioproxy(&proxy) || !output->open("map." + request.ending, spec) ||
        !output->write_image(OIIO::TypeDesc::UINT16, image.samples.data()) || !output->close() || bytes.empty())
        return tl::unexpected(wire::Reason::CannotWriteEnding);
    return wire::encodeFile(std::as_bytes(std::span(bytes)));
}

} // namespace hairpaint::importer
