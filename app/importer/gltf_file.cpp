// tinygltf reads the description alone: buffers and images, which it would open or look into unchecked, are taken out
// before, and so is what it reads by recursion.
#define TINYGLTF_IMPLEMENTATION
#include <fstream> // Its writer names it, with or without files.

#include "app/importer/gltf_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace hairpaint::importer {

namespace {

using Json = nlohmann::json;

static_assert(std::endian::native == std::endian::little);

constexpr std::size_t kGlbHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

tl::unexpected<wire::Refusal> malformed(const std::string& what)
{
    return tl::unexpected(wire::Refusal(wire::Reason::Malformed, what));
}

std::uint32_t wordAt(std::span<const std::byte> bytes, std::size_t at)
{
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

struct Container
{
    std::span<const std::byte> json;
    std::span<const std::byte> binary;
};

tl::expected<Container, wire::Refusal> opened(std::span<const std::byte> bytes)
{
    constexpr std::string_view kMagic = "glTF";
    if (bytes.size() < kMagic.size() || std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) != 0)
        return Container{.json = bytes, .binary = {}};
    if (bytes.size() < kGlbHeaderBytes)
        return malformed("it ends within its header");
    if (wordAt(bytes, 4) != 2)
        return tl::unexpected(wire::Reason::UnknownFormat);
    Container container;
    std::size_t at = kGlbHeaderBytes;
    while (bytes.size() - at >= kChunkHeaderBytes) {
        const std::size_t length = wordAt(bytes, at);
        const std::uint32_t type = wordAt(bytes, at + 4);
        at += kChunkHeaderBytes;
        if (length > bytes.size() - at)
            return malformed("it is cut short: a part of " + std::to_string(length) + " bytes has only " +
                             std::to_string(bytes.size() - at));
        const std::span<const std::byte> content = bytes.subspan(at, length);
        at += length;
        if (type == kJsonChunk && container.json.empty())
            container.json = content;
        else if (type == kBinaryChunk && container.binary.empty())
            container.binary = content;
    }
    if (container.json.empty())
        return malformed("it has no description of a scene");
    return container;
}

/// Deeper values are left out.
Json parsed(std::span<const std::byte> text)
{
    constexpr int kDeepest = 24;
    constexpr bool kThrows = false;
    const auto* begin = reinterpret_cast<const char*>(text.data());
    return Json::parse(
        begin, begin + text.size(), [](int depth, Json::parse_event_t, const Json&) { return depth <= kDeepest; },
        kThrows);
}

/// A null where it is no object or has no such member.
const Json& memberOf(const Json& object, const char* name)
{
    static const Json none;
    const auto found = object.find(name);
    return found == object.end() ? none : *found;
}

std::vector<GltfFile::Buffer> buffersIn(const Json& root)
{
    std::vector<GltfFile::Buffer> buffers;
    for (const Json& own : memberOf(root, "buffers")) {
        GltfFile::Buffer& buffer = buffers.emplace_back();
        if (const Json& uri = memberOf(own, "uri"); uri.is_string())
            buffer.uri = uri.get<std::string>();
        if (const Json& length = memberOf(own, "byteLength"); length.is_number_unsigned())
            buffer.byteLength = length.get<std::size_t>();
    }
    return buffers;
}

std::vector<GltfFile::Image> imagesIn(const Json& root)
{
    std::vector<GltfFile::Image> images;
    for (const Json& own : memberOf(root, "images")) {
        GltfFile::Image& image = images.emplace_back();
        if (const Json& uri = memberOf(own, "uri"); uri.is_string())
            image.uri = uri.get<std::string>();
        if (const Json& view = memberOf(own, "bufferView"); view.is_number_unsigned())
            image.view = view.get<int>();
    }
    return images;
}

/// tinygltf refuses compressed meshes whose indices have no bytes of their own.
void takeOutIndices(Json& root)
{
    if (!root.contains("meshes") || !root["meshes"].is_array())
        return;
    for (Json& mesh : root["meshes"]) {
        if (!mesh.is_object() || !mesh.contains("primitives") || !mesh["primitives"].is_array())
            continue;
        for (Json& primitive : mesh["primitives"])
            if (memberOf(memberOf(primitive, "extensions"), "KHR_draco_mesh_compression").is_object())
                primitive.erase("indices");
    }
}

/// The members of the file's JSON that describe meshes; they are moved out of `root`.
Json description(Json& root)
{
    constexpr std::array kNeeded = {
        "asset",  "extensionsRequired", "bufferViews", "accessors", "meshes", "nodes", "scene",
        "scenes", "materials",          "skins",       "textures"};
    Json needed = Json::object();
    for (const char* name : kNeeded)
        if (const auto found = root.find(name); found != root.end())
            needed[name] = std::move(*found);
    return needed;
}

/// What tinygltf says, as part of a sentence.
std::string clauseOf(std::string said)
{
    std::ranges::replace_if(
        said, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    while (!said.empty() && (said.back() == ' ' || said.back() == '.'))
        said.pop_back();
    return said.empty() ? "its description makes no sense" : said;
}

} // namespace

tl::expected<GltfFile, wire::Refusal> parsedGltf(std::vector<std::byte> bytes)
{
    GltfFile file;
    file.bytes = std::move(bytes);
    const tl::expected<Container, wire::Refusal> container = opened(file.bytes);
    if (!container)
        return tl::unexpected(container.error());
    file.chunk = container->binary;
    Json root = parsed(container->json);
    if (!root.is_object())
        return malformed("its description is no JSON");
    const Json& version = memberOf(memberOf(root, "asset"), "version");
    const bool isOld = version.is_string() ? version.get_ref<const std::string&>().starts_with("1.")
                                           : memberOf(root, "meshes").is_object(); // Lists came with version 2.
    if (isOld)
        return tl::unexpected(wire::Reason::UnknownFormat);
    file.bones = vrmBones(root);
    file.facesBack = facesBack(root);
    file.buffers = buffersIn(root);
    file.images = imagesIn(root);
    takeOutIndices(root);
    const std::string text = description(root).dump(-1, ' ', false, Json::error_handler_t::replace);
    root = Json();
    constexpr std::size_t kMostText = 1U << 30U;
    if (text.size() > kMostText)
        return tl::unexpected(wire::Reason::TooLarge);
    tinygltf::TinyGLTF reader;
    std::string error;
    std::string warning;
    if (!reader.LoadASCIIFromString(&file.model, &error, &warning, text.data(), static_cast<unsigned>(text.size()), ""))
        return malformed(clauseOf(error));
    return file;
}

} // namespace hairpaint::importer
