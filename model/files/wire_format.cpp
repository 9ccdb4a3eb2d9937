// Encoding and checked decoding of the helper's messages.
#include "model/files/wire_format.h"

#include "sim/skin/head_limits.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace hairpaint::wire {

namespace {

constexpr std::array<char, 8> kMagic = {'H', 'P', 'W', 'I', 'R', 'E', '0', '1'};
static_assert(std::endian::native == std::endian::little, "arrays are copied as they lie in memory");
/// Bytes of a joint without its name.
constexpr std::uint64_t kJointBytes = 36;
/// Bytes of a part without its names.
constexpr std::uint64_t kPartBytes = 52;
static_assert(sizeof(glm::vec3) == 12 && sizeof(glm::vec2) == 8 && sizeof(glm::uvec3) == 12);

class Writer
{
public:
    Writer(Kind kind, std::uint64_t bodyBytes) : m_bytes(kHeaderBytes + bodyBytes)
    {
        array(std::span(kMagic));
        value(static_cast<std::uint32_t>(kind));
        value(bodyBytes);
    }
    template<typename T>
    void value(T number)
    {
        array(std::span(&number, 1));
    }
    template<typename T, std::size_t N>
    void array(std::span<T, N> values)
    {
        if (values.empty())
            return;
        std::memcpy(m_bytes.data() + m_at, values.data(), values.size_bytes());
        m_at += values.size_bytes();
    }
    [[nodiscard]] Bytes take() { return std::move(m_bytes); }

private:
    Bytes m_bytes;
    std::size_t m_at = 0;
};

class Reader
{
public:
    explicit Reader(std::span<const std::byte> bytes) : m_rest(bytes) {}

    template<typename T>
    bool value(T& number)
    {
        if (m_rest.size() < sizeof(T))
            return false;
        std::memcpy(&number, m_rest.data(), sizeof(T));
        m_rest = m_rest.subspan(sizeof(T));
        return true;
    }
    /// Allocates only what the body really holds.
    template<typename T>
    bool array(std::vector<T>& values, std::uint64_t count)
    {
        if (count > m_rest.size() / sizeof(T))
            return false;
        values.resize(static_cast<std::size_t>(count));
        if (count > 0)
            std::memcpy(values.data(), m_rest.data(), values.size() * sizeof(T));
        m_rest = m_rest.subspan(values.size() * sizeof(T));
        return true;
    }
    [[nodiscard]] bool atEnd() const { return m_rest.empty(); }
    [[nodiscard]] std::span<const std::byte> rest() const { return m_rest; }

private:
    std::span<const std::byte> m_rest;
};

std::uint64_t mostBodyBytes(Kind kind)
{
    switch (kind) {
    case Kind::ReadImage:
    case Kind::ReadMesh:
    case Kind::ReadBody:
    case Kind::TellSandbox:
    case Kind::ReadColours:
        return kLongestPath;
    case Kind::EncodeImage:
    case Kind::EncodeColours:
    case Kind::Image:
        return 64 + kMostPixels * 8;
    case Kind::Mesh:
        return 20 + (32ULL + sizeof(model::BoneWeights)) * sim::kMostVertices + 12ULL * sim::kMostTriangles +
               (kJointBytes + model::HeadSkeleton::kLongestName) * model::HeadSkeleton::kMostJoints + 8 +
               (kPartBytes + 2 * model::HeadSkeleton::kLongestName + 8) * model::MeshPart::kMost +
               4 * model::MeshTexture::kMostPixels;
    case Kind::Encoded:
        return kMostEncodedBytes;
    case Kind::Sandbox:
        return sizeof(Sandbox);
    case Kind::Refusal:
        return 4 + kLongestName;
    }
    return 0;
}

void writeImage(Writer& writer, const Image& image)
{
    writer.value(image.width);
    writer.value(image.height);
    writer.value(image.channels);
    writer.array(std::span(image.samples));
}

/// False where there is less than it says; what the joints say is not looked at.
bool readJoints(Reader& reader, model::HeadSkeleton& skeleton)
{
    std::uint32_t count = 0;
    if (!reader.value(count) || count > model::HeadSkeleton::kMostJoints)
        return false;
    for (std::uint32_t i = 0; i < count; ++i) {
        model::HeadJoint joint;
        std::int32_t parent = 0;
        glm::vec4 rotation(0.0F);
        std::uint32_t length = 0;
        std::vector<char> name;
        if (!reader.value(parent) || !reader.value(joint.translation) || !reader.value(rotation) ||
            !reader.value(length) || length > model::HeadSkeleton::kLongestName || !reader.array(name, length))
            return false;
        joint.parent = parent;
        joint.rotation = {rotation.w, rotation.x, rotation.y, rotation.z};
        joint.name.assign(name.begin(), name.end());
        skeleton.joints.push_back(std::move(joint));
    }
    return true;
}

bool isLaterReason(std::uint32_t reason)
{
    return reason >= static_cast<std::uint32_t>(Reason::LayersOnly) &&
           reason <= static_cast<std::uint32_t>(Reason::UnreadFormat);
}

template<typename Text>
bool readName(Reader& reader, Text& text)
{
    std::uint32_t length = 0;
    std::vector<char> name;
    if (!reader.value(length) || length > model::HeadSkeleton::kLongestName || !reader.array(name, length))
        return false;
    text.assign(name.begin(), name.end());
    return model::isJointName(text);
}

void writeName(Writer& writer, const std::string& name)
{
    writer.value(static_cast<std::uint32_t>(name.size()));
    writer.array(std::span(name));
}

std::uint64_t partBytes(const model::RiggedMesh& mesh)
{
    std::uint64_t bytes = 8 + 8 * mesh.textures.size();
    for (const model::MeshPart& part : mesh.parts)
        bytes += kPartBytes + part.name.size() + part.material.size();
    for (const model::MeshTexture& texture : mesh.textures)
        bytes += texture.rgba.size();
    return bytes;
}

void writeParts(Writer& writer, const model::RiggedMesh& mesh)
{
    writer.value(static_cast<std::uint32_t>(mesh.parts.size()));
    for (const model::MeshPart& part : mesh.parts) {
        writeName(writer, part.name);
        writeName(writer, part.material);
        writer.value(std::uint32_t{part.hasLayout});
        writer.value(part.tile);
        writer.value(part.colour);
        writer.value(static_cast<std::uint32_t>(part.alpha));
        writer.value(std::uint32_t{part.doubleSided});
        writer.value(part.texture);
        writer.value(part.vertices);
        writer.value(part.triangles);
    }
    writer.value(static_cast<std::uint32_t>(mesh.textures.size()));
    for (const model::MeshTexture& texture : mesh.textures) {
        writer.value(texture.width);
        writer.value(texture.height);
        writer.array(std::span(texture.rgba));
    }
}

bool readPart(Reader& reader, model::MeshPart& part)
{
    std::uint32_t hasLayout = 0;
    std::uint32_t alpha = 0;
    std::uint32_t doubleSided = 0;
    if (!readName(reader, part.name) || !readName(reader, part.material) || !reader.value(hasLayout) ||
        !reader.value(part.tile) || !reader.value(part.colour) || !reader.value(alpha) || !reader.value(doubleSided) ||
        !reader.value(part.texture) || !reader.value(part.vertices) || !reader.value(part.triangles))
        return false;
    part.hasLayout = hasLayout == 1;
    part.alpha = static_cast<model::PartAlpha>(alpha);
    part.doubleSided = doubleSided == 1;
    return hasLayout <= 1 && doubleSided <= 1 && alpha <= static_cast<std::uint32_t>(model::PartAlpha::Blend);
}

/// Reads the parts and textures of a mesh whose vertices and triangles were read; false where they break a rule.
bool readParts(Reader& reader, model::RiggedMesh& mesh)
{
    std::uint32_t parts = 0;
    if (!reader.value(parts) || parts > model::MeshPart::kMost)
        return false;
    for (std::uint32_t i = 0; i < parts; ++i)
        if (!readPart(reader, mesh.parts.emplace_back()))
            return false;
    std::uint32_t textures = 0;
    std::size_t pixels = 0;
    if (!reader.value(textures) || textures > model::MeshPart::kMost)
        return false;
    for (std::uint32_t i = 0; i < textures; ++i) {
        model::MeshTexture& texture = mesh.textures.emplace_back();
        constexpr std::uint32_t kMostSide = model::MeshTexture::kLargestSide;
        if (!reader.value(texture.width) || !reader.value(texture.height) || texture.width < 1 || texture.height < 1 ||
            texture.width > kMostSide || texture.height > kMostSide)
            return false;
        pixels += std::size_t{texture.width} * texture.height;
        if (pixels > model::MeshTexture::kMostPixels ||
            !reader.array(texture.rgba, std::uint64_t{4} * texture.width * texture.height))
            return false;
    }
    return model::partsFit(mesh);
}

bool readTold(Reader& reader, model::ToldSpace& told)
{
    std::uint32_t axis = 0;
    if (!reader.value(told.metresPerUnit) || !reader.value(axis) ||
        axis > static_cast<std::uint32_t>(model::ToldAxis::Z))
        return false;
    told.up = static_cast<model::ToldAxis>(axis);
    return std::isfinite(told.metresPerUnit) && told.metresPerUnit >= 0.0F;
}

bool finite(const glm::vec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace

std::optional<Header> decodeHeader(std::span<const std::byte> bytes)
{
    if (bytes.size() < kHeaderBytes || std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) != 0)
        return std::nullopt;
    Reader reader(bytes.subspan(kMagic.size()));
    std::uint32_t kind = 0;
    Header header;
    if (!reader.value(kind) || !reader.value(header.bodyBytes))
        return std::nullopt;
    header.kind = static_cast<Kind>(kind);
    if (header.bodyBytes == 0 || header.bodyBytes > mostBodyBytes(header.kind))
        return std::nullopt;
    return header;
}

Bytes encodeText(Kind kind, const std::string& text)
{
    Writer writer(kind, text.size());
    writer.array(std::span(text));
    return writer.take();
}

Bytes encodeImage(const Image& image)
{
    Writer writer(Kind::Image, 12 + image.samples.size() * 2);
    writeImage(writer, image);
    return writer.take();
}

Bytes encodeRequest(const EncodeRequest& request, Kind kind)
{
    Writer writer(kind, 8 + request.ending.size() + 12 + request.image.samples.size() * 2);
    writer.value(request.bits);
    writer.value(static_cast<std::uint32_t>(request.ending.size()));
    writer.array(std::span(request.ending));
    writeImage(writer, request.image);
    return writer.take();
}

Bytes encodeMesh(const model::RiggedMesh& mesh)
{
    const model::HeadSkeleton& skeleton = mesh.skeleton;
    std::uint64_t jointBytes = kJointBytes * skeleton.joints.size();
    for (const model::HeadJoint& joint : skeleton.joints)
        jointBytes += joint.name.size();
    Writer writer(Kind::Mesh, 20 + mesh.positionsHd.size() * 32 + mesh.triangles.size() * 12 + jointBytes +
                                  skeleton.weights.size() * sizeof(model::BoneWeights) + partBytes(mesh));
    writer.value(static_cast<std::uint32_t>(mesh.positionsHd.size()));
    writer.value(static_cast<std::uint32_t>(mesh.triangles.size()));
    writer.array(std::span(mesh.positionsHd));
    writer.array(std::span(mesh.normalsHd));
    writer.array(std::span(mesh.uvs));
    writer.array(std::span(mesh.triangles));
    writer.value(static_cast<std::uint32_t>(skeleton.joints.size()));
    for (const model::HeadJoint& joint : skeleton.joints) {
        writer.value(static_cast<std::int32_t>(joint.parent));
        writer.value(joint.translation);
        writer.value(glm::vec4(joint.rotation.x, joint.rotation.y, joint.rotation.z, joint.rotation.w));
        writer.value(static_cast<std::uint32_t>(joint.name.size()));
        writer.array(std::span(joint.name));
    }
    writer.array(std::span(skeleton.weights));
    writer.value(mesh.told.metresPerUnit);
    writer.value(static_cast<std::uint32_t>(mesh.told.up));
    writeParts(writer, mesh);
    return writer.take();
}

Bytes encodeFile(std::span<const std::byte> file)
{
    Writer writer(Kind::Encoded, file.size());
    writer.array(file);
    return writer.take();
}

Bytes encodeSandbox(const Sandbox& sandbox)
{
    Writer writer(Kind::Sandbox, sizeof sandbox);
    writer.value(sandbox.landlockVersion);
    writer.value(sandbox.filtersCalls);
    writer.value(sandbox.mostMegabytes);
    return writer.take();
}

Bytes encodeRefusal(const Refusal& refusal)
{
    std::string detail = refusal.detail.substr(0, kLongestName);
    std::ranges::replace(detail, '\0', '?');
    Writer writer(Kind::Refusal, 4 + detail.size());
    writer.value(static_cast<std::uint32_t>(refusal.reason));
    writer.array(std::span(detail));
    return writer.take();
}

std::optional<std::string> decodePath(std::span<const std::byte> body)
{
    if (body.empty() || body.size() > kLongestPath)
        return std::nullopt;
    std::string path(body.size(), '\0');
    std::memcpy(path.data(), body.data(), body.size());
    if (path.find('\0') != std::string::npos)
        return std::nullopt;
    return path;
}

bool imageFits(std::uint64_t width, std::uint64_t height, std::uint64_t channels)
{
    return width >= 1 && width <= kLargestSide && height >= 1 && height <= kLargestSide &&
           width * height <= kMostPixels && channels >= 1 && channels <= 4;
}

std::optional<Image> decodeImage(std::span<const std::byte> body)
{
    Reader reader(body);
    Image image;
    if (!reader.value(image.width) || !reader.value(image.height) || !reader.value(image.channels) ||
        !imageFits(image.width, image.height, image.channels))
        return std::nullopt;
    const std::uint64_t samples = static_cast<std::uint64_t>(image.width) * image.height * image.channels;
    if (!reader.array(image.samples, samples) || !reader.atEnd())
        return std::nullopt;
    return image;
}

std::optional<EncodeRequest> decodeRequest(std::span<const std::byte> body)
{
    Reader reader(body);
    EncodeRequest request;
    std::uint32_t length = 0;
    if (!reader.value(request.bits) || (request.bits != 8 && request.bits != 16) || !reader.value(length) ||
        length < 1 || length > kLongestEnding)
        return std::nullopt;
    std::vector<char> ending;
    if (!reader.array(ending, length))
        return std::nullopt;
    const auto plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); };
    if (!std::ranges::all_of(ending, plain))
        return std::nullopt;
    request.ending.assign(ending.begin(), ending.end());
    std::optional<Image> image = decodeImage(reader.rest());
    if (!image)
        return std::nullopt;
    request.image = std::move(*image);
    return request;
}

bool meshFits(const sim::HeadMesh& mesh)
{
    const auto unit = [](const glm::vec3& n) { return finite(n) && std::abs(glm::dot(n, n) - 1.0F) < 0.01F; };
    const auto inUnitSquare = [](const glm::vec2& uv) {
        return uv.x >= 0.0F && uv.x <= 1.0F && uv.y >= 0.0F && uv.y <= 1.0F;
    };
    return sim::withinLimits(mesh) && std::ranges::all_of(mesh.normalsHd, unit) &&
           std::ranges::all_of(mesh.uvs, inUnitSquare);
}

std::optional<model::RiggedMesh> decodeMesh(std::span<const std::byte> body)
{
    Reader reader(body);
    std::uint32_t vertices = 0;
    std::uint32_t triangles = 0;
    model::RiggedMesh mesh;
    if (!reader.value(vertices) || !reader.value(triangles) || vertices > sim::kMostVertices ||
        triangles > sim::kMostTriangles || !reader.array(mesh.positionsHd, vertices) ||
        !reader.array(mesh.normalsHd, vertices) || !reader.array(mesh.uvs, vertices) ||
        !reader.array(mesh.triangles, triangles) || !meshFits(mesh) || !readJoints(reader, mesh.skeleton))
        return std::nullopt;
    if (!reader.array(mesh.skeleton.weights, mesh.skeleton.empty() ? 0 : vertices) ||
        !model::withinLimits(mesh.skeleton, vertices) || !readTold(reader, mesh.told) || !readParts(reader, mesh) ||
        !reader.atEnd())
        return std::nullopt;
    return mesh;
}

std::optional<Sandbox> decodeSandbox(std::span<const std::byte> body)
{
    Reader reader(body);
    Sandbox sandbox;
    if (!reader.value(sandbox.landlockVersion) || !reader.value(sandbox.filtersCalls) || sandbox.filtersCalls > 1 ||
        !reader.value(sandbox.mostMegabytes) || !reader.atEnd())
        return std::nullopt;
    return sandbox;
}

std::optional<Refusal> decodeRefusal(std::span<const std::byte> body)
{
    Reader reader(body);
    std::uint32_t reason = 0;
    if (!reader.value(reason) || reason < 1 ||
        (reason > static_cast<std::uint32_t>(Reason::Malformed) && !isLaterReason(reason)))
        return std::nullopt;
    Refusal refusal(static_cast<Reason>(reason));
    if ((refusal.reason >= Reason::MissingFile && refusal.reason <= Reason::Malformed) ||
        refusal.reason == Reason::UnreadFormat) {
        std::optional<std::string> name = decodePath(reader.rest());
        if (!name || name->size() > kLongestName)
            return std::nullopt;
        refusal.detail = *std::move(name);
    } else if (!reader.atEnd()) {
        return std::nullopt;
    }
    return refusal;
}

} // namespace hairpaint::wire
