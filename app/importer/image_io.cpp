// Reading and writing images through OpenImageIO, without association of alpha in either direction.
#include "app/importer/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <filesystem>

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

/// Channels as grey, grey and alpha, RGB or RGBA. An alpha that stands elsewhere than second or fourth is left out.
int keptChannels(const OIIO::ImageSpec& spec)
{
    if (spec.nchannels == 2)
        return spec.alpha_channel == 1 ? 2 : 1;
    return std::min(spec.nchannels, 4);
}

} // namespace

tl::expected<wire::Image, wire::Reason> readImage(const std::string& path)
{
    setGlobals();
    OIIO::ImageSpec config;
    config.attribute(kUnassociated, 1);
    const auto input = OIIO::ImageInput::open(path, &config);
    if (!input) {
        std::error_code unreadable;
        const bool there =
            std::filesystem::exists(std::filesystem::path(std::u8string(path.begin(), path.end())), unreadable);
        const bool mentionsLimit = OIIO::geterror().find("limits:") != std::string::npos;
        if (mentionsLimit)
            return tl::unexpected(wire::Reason::TooLarge);
        return tl::unexpected(there ? wire::Reason::UnknownFormat : wire::Reason::CannotOpen);
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
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT16, image.samples.data()))
        return tl::unexpected(wire::Reason::Damaged);
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
