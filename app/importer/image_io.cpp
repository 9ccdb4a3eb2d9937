// Reading and writing images through OpenImageIO, which leaves alpha as the file has it.
#include "app/importer/image_io.h"

#include "app/importer/image_channels.h"
#include "app/importer/image_light.h"
#include "app/importer/jpeg_inks.h"
#include "app/importer/png_chunks.h"
#include "app/importer/stored_tags.h"
#include "app/importer/unread_formats.h"
#include "app/importer/webp_input.h"
#include "model/values/srgb.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

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

std::unique_ptr<OIIO::ImageInput> openImage(const std::string& path, bool isRaw)
{
    OIIO::ImageSpec config;
    config.attribute(kUnassociated, 1);
    if (isRaw)
        config.attribute("oiio:RawColor", 1);
    return path.find('?') == std::string::npos ? OIIO::ImageInput::open(path, &config) : openPlainly(path, config);
}

std::filesystem::path asPath(const std::string& path)
{
    return std::u8string(path.begin(), path.end());
}

std::vector<std::uint8_t> profileOf(const OIIO::ImageSpec& spec)
{
    const OIIO::ParamValue* value = spec.find_attribute("ICCProfile");
    if (value == nullptr || value->type().basetype != OIIO::TypeDesc::UINT8)
        return {};
    const auto* bytes = static_cast<const std::uint8_t*>(value->data());
    return {bytes, bytes + value->type().size()};
}

bool isFloating(const OIIO::TypeDesc& format)
{
    const int type = format.basetype;
    return type == OIIO::TypeDesc::HALF || type == OIIO::TypeDesc::FLOAT || type == OIIO::TypeDesc::DOUBLE;
}

/// Whether its colours are of linear light: as the file says, else where its numbers are floats.
bool isLinear(const OIIO::ImageSpec& spec)
{
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    return space.empty() ? isFloating(spec.format) : OIIO::Strutil::iequals(space, "linear") || space == "scene_linear";
}

/// Greys of a TIFF whose 0 is white. The library turns 8 bits alone, and their alpha with them.
void turnWhite(wire::Image& image, bool isTurned)
{
    for (std::size_t i = 0; i < image.samples.size(); ++i) {
        const bool isAlpha = i % image.channels != 0;
        if (isAlpha == isTurned)
            image.samples[i] = static_cast<std::uint16_t>(65535U - image.samples[i]);
    }
}

/// The first image of a file that the library has opened.
tl::expected<wire::Image, wire::Reason> readOpened(OIIO::ImageInput& input, const StoredTags& tags, bool isColour)
{
    const OIIO::ImageSpec spec = input.spec();
    if (spec.width <= 0 || spec.height <= 0 || spec.depth > 1 || spec.nchannels < 1)
        return tl::unexpected(wire::Reason::Damaged);
    const std::string format = input.format_name();
    const bool isExr = format == "openexr";
    const SampleReading reading{.channels = channelsOf(spec, tags),
                                // By OpenEXR's definition, whatever the library makes of the others.
                                .isAssociated = isExr || tags.isAssociated,
                                .isLinear = isColour && isLinear(spec),
                                .isShown = isExr && (spec.x != spec.full_x || spec.y != spec.full_y ||
                                                     spec.width != spec.full_width || spec.height != spec.full_height)};
    auto image = readSamples(input, reading);
    if (!image)
        return image.error() == wire::Reason::Damaged && input.geterror().find("ompression") != std::string::npos
                   ? tl::unexpected(wire::Reason::UnknownCompression)
                   : image;
    if (tags.lowIsWhite)
        turnWhite(*image, spec.format == OIIO::TypeDesc::UINT8);
    if (isColour && !reading.isLinear)
        toSrgb(*image, profileOf(spec));
    makeUpright(*image, tags.orientation != 0 ? tags.orientation : spec.get_int_attribute("Orientation", 1));
    return image;
}

/// A picture of inks as colours; none where it is none, or the library's own colours are right, as there is no profile.
std::optional<tl::expected<wire::Image, wire::Reason>> readInks(const std::string& path, const OIIO::ImageSpec& spec)
{
    if (const std::string space = spec.get_string_attribute("jpeg:ColorSpace"); space == "CMYK" || space == "YCbCrK") {
        auto jpeg = readJpegInks(path);
        if (jpeg) {
            toSrgb(*jpeg, profileOf(spec), true);
            makeUpright(*jpeg, spec.get_int_attribute("Orientation", 1));
        }
        return jpeg;
    }
    if (!OIIO::Strutil::iequals(spec.get_string_attribute("tiff:ColorSpace"), "CMYK") || profileOf(spec).empty())
        return std::nullopt;
    const auto input = openImage(path, true);
    if (!input || input->spec().nchannels < 4)
        return std::nullopt;
    auto image = readSamples(*input, {.channels = {.colours = {0, 1, 2, 3}}});
    if (image) {
        toSrgb(*image, profileOf(spec), true);
        makeUpright(*image, spec.get_int_attribute("Orientation", 1));
    }
    return image;
}

/// A TIFF without tag 258, with it.
tl::expected<wire::Image, wire::Reason> readBilevel(const std::string& path, const StoredTags& tags, bool isColour)
{
    std::ifstream file(asPath(path), std::ios::binary);
    const std::vector<char> read(std::istreambuf_iterator<char>(file), {});
    std::optional<std::vector<std::uint8_t>> whole =
        withBitsPerSample(std::vector<std::uint8_t>(read.begin(), read.end()));
    if (!whole)
        return tl::unexpected(wire::Reason::Damaged);
    OIIO::Filesystem::IOMemReader proxy(whole->data(), whole->size());
    const auto input = OIIO::ImageInput::create("tiff");
    OIIO::ImageSpec spec;
    OIIO::ImageSpec config;
    config.attribute(kUnassociated, 1);
    if (!input || !input->set_ioproxy(&proxy) || !input->open("bilevel.tif", spec, config))
        return tl::unexpected(wire::Reason::Damaged);
    return readOpened(*input, tags, isColour);
}

tl::expected<wire::Image, wire::Refusal> asAnswer(tl::expected<wire::Image, wire::Reason> image)
{
    return std::move(image).map_error([](wire::Reason reason) { return wire::Refusal(reason); });
}

/// As OpenEXR has it: colours of linear light, multiplied by alpha.
bool writeFloats(OIIO::ImageOutput& output, const wire::Image& image, bool isColour)
{
    const bool hasAlpha = image.channels % 2 == 0;
    const std::size_t colours = image.channels - (hasAlpha ? 1 : 0);
    std::vector<float> row(std::size_t{image.width} * image.channels);
    for (std::uint32_t y = 0; y < image.height; ++y) {
        const std::uint16_t* sample = image.samples.data() + std::size_t{y} * row.size();
        for (std::size_t at = 0; at < row.size(); at += image.channels) {
            const float alpha = hasAlpha ? static_cast<float>(sample[at + colours]) / 65535.0F : 1.0F;
            for (std::size_t i = 0; i < colours; ++i) {
                const float value = static_cast<float>(sample[at + i]) / 65535.0F;
                row[at + i] = (isColour ? model::linearFromSrgb(value) : value) * alpha;
            }
            if (hasAlpha)
                row[at + colours] = alpha;
        }
        if (!output.write_scanline(static_cast<int>(y), 0, OIIO::TypeDesc::FLOAT, row.data()))
            return false;
    }
    return true;
}

} // namespace

tl::expected<wire::Image, wire::Refusal> readImage(const std::string& path, bool isColour)
{
    setGlobals();
    std::ifstream file(asPath(path), std::ios::binary);
    const StoredTags tags = readStoredTags(file);
    file.clear();
    file.seekg(0);
    const std::string_view unread = unreadFormatOf(file);
    file.close();
    const auto refuse = [](wire::Reason reason, std::string_view detail = {}) {
        return tl::unexpected(wire::Refusal(reason, std::string(detail)));
    };
    if (!unread.empty())
        return refuse(wire::Reason::UnreadFormat, unread);
    if (tags.lacksMergedPicture)
        return refuse(wire::Reason::LayersOnly);
    if (tags.hasInks && isColour)
        return refuse(wire::Reason::InkColours);
    if (auto webp = readWebp(path)) {
        if (!*webp)
            return refuse(webp->error());
        wire::Image image = std::move((*webp)->image);
        if (isColour)
            toSrgb(image, (*webp)->profile);
        makeUpright(image, (*webp)->orientation);
        return image;
    }
    if (tags.lacksBitsPerSample)
        return asAnswer(readBilevel(path, tags, isColour));
    const auto input = openImage(path, false);
    if (!input) {
        std::error_code unreadable;
        const bool there = std::filesystem::exists(asPath(path), unreadable);
        return refuse(there ? reasonOf(OIIO::geterror()) : wire::Reason::CannotOpen);
    }
    if (isColour)
        if (auto image = readInks(path, input->spec()))
            return asAnswer(*std::move(image));
    return asAnswer(readOpened(*input, tags, isColour));
}

tl::expected<wire::Bytes, wire::Reason> encodeImageFile(const wire::EncodeRequest& request, bool isColour)
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
    if (!output->set_ioproxy(&proxy) || !output->open("map." + request.ending, spec))
        return tl::unexpected(wire::Reason::CannotWriteEnding);
    const bool isWritten = type == OIIO::TypeDesc::FLOAT
                               ? writeFloats(*output, image, isColour)
                               : output->write_image(OIIO::TypeDesc::UINT16, image.samples.data());
    if (!isWritten || !output->close() || bytes.empty())
        return tl::unexpected(wire::Reason::CannotWriteEnding);
    if (request.ending == "png")
        dropExif(bytes);
    return wire::encodeFile(std::as_bytes(std::span(bytes)));
}

} // namespace hairpaint::importer
