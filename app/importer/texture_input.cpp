// PNG, JPEG and what else OpenImageIO reads from memory.
#include "app/importer/texture_input.h"

#include "model/files/wire_format.h"
#include "sim/skin/texture_halving.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace hairpaint::importer {

namespace {

using model::MeshTexture;

/// By the file's first bytes.
const char* formatOf(std::span<const std::byte> bytes)
{
    constexpr std::array<std::pair<std::string_view, const char*>, 5> kMagic{
        {{"\x89PNG", "png"}, {"\xFF\xD8", "jpeg"}, {"RIFF", "webp"}, {"BM", "bmp"}, {"DDS ", "dds"}}};
    const std::string_view begin(reinterpret_cast<const char*>(bytes.data()), std::min<std::size_t>(bytes.size(), 4));
    for (const auto& [magic, format] : kMagic)
        if (begin.starts_with(magic))
            return format;
    return "targa"; // Which has none.
}

std::optional<MeshTexture> decoded(std::span<const std::byte> bytes)
{
    if (bytes.empty())
        return std::nullopt;
    const auto input = OIIO::ImageInput::create(formatOf(bytes));
    OIIO::Filesystem::IOMemReader proxy(const_cast<std::byte*>(bytes.data()), bytes.size());
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::ImageSpec spec;
    if (!input || !input->set_ioproxy(&proxy) || !input->open("texture", spec, config))
        return std::nullopt;
    constexpr std::int64_t kMost = 16'384;
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 || spec.width > kMost ||
        spec.height > kMost || std::int64_t{spec.width} * spec.height > static_cast<std::int64_t>(wire::kMostPixels))
        return std::nullopt;
    const auto channels = static_cast<std::size_t>(std::min(spec.nchannels, 4));
    MeshTexture texture{
        .width = static_cast<std::uint32_t>(spec.width), .height = static_cast<std::uint32_t>(spec.height), .rgba = {}};
    const std::size_t pixels = std::size_t{texture.width} * texture.height;
    std::vector<std::uint8_t> read(pixels * channels);
    if (!input->read_image(0, 0, 0, static_cast<int>(channels), OIIO::TypeDesc::UINT8, read.data()))
        return std::nullopt;
    texture.rgba.resize(pixels * 4);
    const bool isGrey = channels < 3;
    for (std::size_t i = 0; i < pixels; ++i) {
        const std::uint8_t* const from = read.data() + i * channels;
        std::uint8_t* const to = texture.rgba.data() + i * 4;
        for (std::size_t c = 0; c < 3; ++c)
            to[c] = from[isGrey ? 0 : c];
        to[3] = channels == 4 ? from[3] : channels == 2 ? from[1] : 255;
    }
    return texture;
}

} // namespace

void decodeTextures(model::RiggedMesh& mesh, const std::vector<std::vector<std::byte>>& images)
{
    OIIO::attribute("threads", 1);
    std::map<std::int32_t, std::int32_t> numbers;
    for (model::MeshPart& part : mesh.parts) {
        const bool isNamed = part.texture >= 0 && static_cast<std::size_t>(part.texture) < images.size();
        if (!isNamed) {
            part.texture = -1;
            continue;
        }
        const auto [known, isNew] = numbers.try_emplace(part.texture, -1);
        if (isNew) {
            std::optional<MeshTexture> texture = decoded(images[static_cast<std::size_t>(part.texture)]);
            while (texture && (std::max(texture->width, texture->height) > MeshTexture::kLargestSide ||
                               texture->rgba.size() / 4 > MeshTexture::kMostPixels))
                texture = sim::halved(*texture);
            if (texture) {
                known->second = static_cast<std::int32_t>(mesh.textures.size());
                mesh.textures.push_back(*std::move(texture));
            }
            sim::shrinkTo(mesh.textures, MeshTexture::kMostPixels);
        }
        part.texture = known->second;
    }
}

} // namespace hairpaint::importer
