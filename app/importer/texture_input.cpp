// PNG, JPEG and what else OpenImageIO reads from memory.
#include "app/importer/texture_input.h"

#include "model/files/wire_format.h"

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

/// Means of two by two.
MeshTexture halved(const MeshTexture& whole)
{
    MeshTexture half{.width = std::max(whole.width / 2, 1U), .height = std::max(whole.height / 2, 1U), .rgba = {}};
    half.rgba.resize(std::size_t{half.width} * half.height * 4);
    for (std::uint32_t y = 0; y < half.height; ++y)
        for (std::uint32_t x = 0; x < half.width; ++x)
            for (std::size_t c = 0; c < 4; ++c) {
                unsigned sum = 2;
                for (std::uint32_t i = 0; i < 4; ++i) {
                    const std::size_t row = std::min(2 * y + i / 2, whole.height - 1);
                    const std::size_t column = std::min(2 * x + i % 2, whole.width - 1);
                    sum += whole.rgba[(row * whole.width + column) * 4 + c];
                }
                half.rgba[(std::size_t{y} * half.width + x) * 4 + c] = static_cast<std::uint8_t>(sum / 4);
            }
    return half;
}

std::size_t pixelsOf(const std::vector<MeshTexture>& textures)
{
    std::size_t pixels = 0;
    for (const MeshTexture& texture : textures)
        pixels += texture.rgba.size() / 4;
    return pixels;
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
                texture = halved(*texture);
            if (texture) {
                known->second = static_cast<std::int32_t>(mesh.textures.size());
                mesh.textures.push_back(*std::move(texture));
            }
            while (pixelsOf(mesh.textures) > MeshTexture::kMostPixels) {
                MeshTexture& largest = *std::ranges::max_element(
                    mesh.textures, {}, [](const MeshTexture& one) { return one.rgba.size(); });
                largest = halved(largest);
            }
        }
        part.texture = known->second;
    }
}

} // namespace hairpaint::importer
