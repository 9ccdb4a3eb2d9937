// Reading our subset of binary glTF (Khronos, glTF 2.0 specification, sections 3 to 5).
#include "model/files/glb.h"

#include "model/files/glb_container.h"
#include "model/files/joint_nodes.h"
#include "model/files/png_codec.h"
#include "model/files/png_reader.h"
#include "sim/skin/head_limits.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <utility>

namespace hairpaint::model {

namespace {

tl::unexpected<Clause> broken()
{
    return refuse(say(QT_TRANSLATE_NOOP("Files", "its head's mesh is broken")));
}

/// Leaves unit normals bit for bit; a normal that is none points up.
void mendNormals(std::vector<glm::vec3>& normals)
{
    for (glm::vec3& normal : normals) {
        const float square = glm::dot(normal, normal);
        if (std::abs(square - 1.0F) < 0.001F)
            continue;
        normal = square > 1e-12F && std::isfinite(square) ? normal / std::sqrt(square) : glm::vec3(0.0F, 1.0F, 0.0F);
    }
}

/// The primitive of a mesh that has just one, of triangles; none for other meshes.
std::optional<QJsonObject> primitiveOf(const QJsonObject& mesh)
{
    const QJsonArray primitives = mesh.value(QLatin1String("primitives")).toArray();
    const QJsonObject primitive = primitives.at(0).toObject();
    if (primitives.size() != 1 || primitive.value(QLatin1String("mode")).toInt(4) != 4)
        return std::nullopt;
    return primitive;
}

std::optional<QJsonObject> headPrimitive(const GlbContainer& container)
{
    return primitiveOf(container.list(QLatin1StringView("meshes")).at(0).toObject());
}

std::optional<sim::HeadMesh> meshOf(const GlbContainer& container, const QJsonObject& primitive)
{
    const QJsonObject attributes = primitive.value(QLatin1String("attributes")).toObject();
    const bool hasOwnUvs = attributes.contains(QLatin1String("_UV"));
    const auto vectors = [&](const char* name) {
        return readAccessor<glm::vec3>(container, attributes.value(QLatin1String(name)), QStringLiteral("VEC3"), kFloat,
                                       sim::kMostVertices);
    };
    auto positions = vectors("POSITION");
    auto normals = vectors("NORMAL");
    auto uvs = readAccessor<glm::vec2>(container, attributes.value(QLatin1String(hasOwnUvs ? "_UV" : "TEXCOORD_0")),
                                       QStringLiteral("VEC2"), kFloat, sim::kMostVertices);
    auto indices = readAccessor<std::uint32_t>(container, primitive.value(QLatin1String("indices")),
                                               QStringLiteral("SCALAR"), kUnsignedInt, 3LL * sim::kMostTriangles);
    if (!positions || !normals || !uvs || !indices || indices->size() % 3 != 0)
        return std::nullopt;
    if (!hasOwnUvs)
        for (glm::vec2& uv : *uvs)
            uv.y = 1.0F - uv.y;
    sim::HeadMesh mesh{.positionsHd = std::move(*positions),
                       .normalsHd = std::move(*normals),
                       .uvs = std::move(*uvs),
                       .triangles = std::vector<glm::uvec3>(indices->size() / 3)};
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        mesh.triangles[i] = {(*indices)[3 * i], (*indices)[3 * i + 1], (*indices)[3 * i + 2]};
    if (!sim::withinLimits(mesh))
        return std::nullopt;
    mendNormals(mesh.normalsHd);
    return mesh;
}

/// Empty where it has none; none where they are broken.
std::optional<std::vector<BoneWeights>> weightsOf(const GlbContainer& container, const QJsonObject& primitive,
                                                  std::size_t vertices)
{
    const QJsonObject attributes = primitive.value(QLatin1String("attributes")).toObject();
    if (!attributes.contains(QLatin1String("JOINTS_0")) && !attributes.contains(QLatin1String("WEIGHTS_0")))
        return std::vector<BoneWeights>();
    using Indices = decltype(BoneWeights::joints);
    const auto indices = readAccessor<Indices>(container, attributes.value(QLatin1String("JOINTS_0")),
                                               QStringLiteral("VEC4"), kUnsignedShort, sim::kMostVertices);
    const auto weights = readAccessor<glm::vec4>(container, attributes.value(QLatin1String("WEIGHTS_0")),
                                                 QStringLiteral("VEC4"), kFloat, sim::kMostVertices);
    if (!indices || !weights || indices->size() != weights->size() || weights->size() != vertices)
        return std::nullopt;
    std::vector<BoneWeights> read;
    read.reserve(weights->size());
    for (std::size_t i = 0; i < weights->size(); ++i)
        read.push_back({.joints = (*indices)[i], .weights = (*weights)[i]});
    return read;
}

/// Without weights; none where they are broken.
std::optional<HeadSkeleton> jointsOf(const GlbContainer& container)
{
    const QJsonArray skins = container.list(QLatin1StringView("skins"));
    if (skins.isEmpty())
        return HeadSkeleton{};
    std::optional<std::vector<HeadJoint>> joints = jointsFromNodes(
        container.list(QLatin1StringView("nodes")), skins.at(0).toObject().value(QLatin1String("joints")).toArray());
    if (skins.size() != 1 || !joints || joints->empty())
        return std::nullopt;
    return HeadSkeleton{.joints = std::move(*joints), .weights = {}};
}

/// Materials of our own and the pictures that they show, each read once.
class Materials
{
public:
    explicit Materials(const GlbContainer& container) : m_container(container) {}

    /// Colour, texture and how they count; false where it is broken.
    [[nodiscard]] bool read(const QJsonObject& primitive, HeadPart& part)
    {
        if (!primitive.contains(QLatin1String("material")))
            return true;
        const QJsonArray materials = m_container.list(QLatin1StringView("materials"));
        const qint64 number = wholeNumber(primitive.value(QLatin1String("material")), -1);
        if (number < 0 || number >= materials.size())
            return false;
        const QJsonObject material = materials.at(number).toObject();
        const QJsonObject surface = material.value(QLatin1String("pbrMetallicRoughness")).toObject();
        const QJsonArray factor = surface.value(QLatin1String("baseColorFactor")).toArray();
        for (int i = 0; i < 3 && i < factor.size(); ++i) {
            part.colour[i] = static_cast<float>(factor.at(i).toDouble(-1.0));
            if (!(part.colour[i] >= 0.0F && part.colour[i] <= 1.0F))
                return false;
        }
        const QString alpha = material.value(QLatin1String("alphaMode")).toString();
        part.alpha = alpha == QLatin1String("MASK")    ? PartAlpha::Mask
                     : alpha == QLatin1String("BLEND") ? PartAlpha::Blend
                                                       : PartAlpha::Opaque;
        part.doubleSided = material.value(QLatin1String("doubleSided")).toBool();
        const QJsonValue texture = surface.value(QLatin1String("baseColorTexture"));
        if (texture.isUndefined())
            return true;
        part.texture = textureOf(wholeNumber(texture.toObject().value(QLatin1String("index")), -1));
        return part.texture != nullptr;
    }

private:
    std::shared_ptr<const sim::MeshTexture> textureOf(qint64 number)
    {
        const QJsonArray textures = m_container.list(QLatin1StringView("textures"));
        const QJsonArray images = m_container.list(QLatin1StringView("images"));
        if (number < 0 || number >= textures.size())
            return nullptr;
        const qint64 source = wholeNumber(textures.at(number).toObject().value(QLatin1String("source")), -1);
        if (source < 0 || source >= images.size())
            return nullptr;
        const auto [known, isNew] = m_read.try_emplace(source, nullptr);
        if (isNew)
            known->second = picture(wholeNumber(images.at(source).toObject().value(QLatin1String("bufferView")), -1));
        return known->second;
    }
    std::shared_ptr<const sim::MeshTexture> picture(qint64 view)
    {
        const std::optional<QByteArrayView> bytes = glbView(m_container, view);
        if (!bytes)
            return nullptr;
        const auto png = QByteArray::fromRawData(bytes->data(), bytes->size());
        const std::optional<PngParts> header = readPngHeader(png);
        constexpr std::size_t kMost = sim::MeshTexture::kMostPixels;
        if (!header || header->width > sim::MeshTexture::kLargestSide ||
            header->height > sim::MeshTexture::kLargestSide)
            return nullptr;
        m_pixels += std::size_t{header->width} * header->height;
        if (m_pixels > kMost)
            return nullptr;
        const QImage image = decodePicture(png, static_cast<int>(sim::MeshTexture::kLargestSide))
                                 .convertToFormat(QImage::Format_RGBA8888);
        if (image.isNull())
            return nullptr;
        auto texture = std::make_shared<sim::MeshTexture>();
        texture->width = static_cast<std::uint32_t>(image.width());
        texture->height = static_cast<std::uint32_t>(image.height());
        texture->rgba.resize(std::size_t{4} * texture->width * texture->height);
        const std::size_t row = std::size_t{4} * texture->width;
        for (int y = 0; y < image.height(); ++y)
            std::memcpy(texture->rgba.data() + static_cast<std::size_t>(y) * row, image.constScanLine(y), row);
        return texture;
    }

    const GlbContainer& m_container;
    std::map<qint64, std::shared_ptr<const sim::MeshTexture>> m_read{};
    std::size_t m_pixels = 0;
};

} // namespace

Checked<sim::HeadMesh> meshFromGlb(const QByteArray& glb)
{
    const std::optional<GlbContainer> container = openGlb(glb);
    const std::optional<QJsonObject> primitive = container ? headPrimitive(*container) : std::nullopt;
    std::optional<sim::HeadMesh> mesh = primitive ? meshOf(*container, *primitive) : std::nullopt;
    if (!mesh)
        return broken();
    return *std::move(mesh);
}

Checked<HeadSkeleton> skeletonFromGlb(const QByteArray& glb)
{
    const std::optional<GlbContainer> container = openGlb(glb);
    const std::optional<QJsonObject> primitive = container ? headPrimitive(*container) : std::nullopt;
    std::optional<HeadSkeleton> skeleton = primitive ? jointsOf(*container) : std::nullopt;
    if (!skeleton)
        return broken();
    if (skeleton->empty())
        return HeadSkeleton{};
    const std::optional<sim::HeadMesh> mesh = meshOf(*container, *primitive);
    if (!mesh)
        return broken();
    std::optional<std::vector<BoneWeights>> weights = weightsOf(*container, *primitive, mesh->positionsHd.size());
    if (!weights)
        return broken();
    skeleton->weights = *std::move(weights);
    if (skeleton->weights.empty() || !withinLimits(*skeleton, mesh->positionsHd.size()))
        return broken();
    return *std::move(skeleton);
}

Checked<GlbParts> partsFromGlb(const QByteArray& glb)
{
    const std::optional<GlbContainer> container = openGlb(glb);
    std::optional<HeadSkeleton> skeleton = container ? jointsOf(*container) : std::nullopt;
    if (!skeleton)
        return broken();
    Materials materials(*container);
    GlbParts read;
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    const QJsonArray meshes = container->list(QLatin1StringView("meshes"));
    if (meshes.size() > static_cast<qsizetype>(MeshPart::kMost) + 1)
        return broken();
    for (qsizetype i = 0; i < meshes.size(); ++i) {
        const QJsonObject told = meshes.at(i).toObject();
        const std::optional<QJsonObject> primitive = primitiveOf(told);
        HeadPart part{
            .name = told.value(QLatin1String("name")).toString().toStdString(), .texture = nullptr, .mesh = nullptr};
        if (i == 0)
            part.colour = glm::vec3(1.0F);
        if (!primitive || !isJointName(part.name) || !materials.read(*primitive, part))
            return broken();
        if (i == 0) {
            read.first = std::move(part);
            continue;
        }
        std::optional<sim::HeadMesh> mesh = meshOf(*container, *primitive);
        if (!mesh)
            return broken();
        vertices += mesh->positionsHd.size();
        triangles += mesh->triangles.size();
        std::optional<std::vector<BoneWeights>> weights = weightsOf(*container, *primitive, mesh->positionsHd.size());
        if (!weights || vertices > sim::kMostVertices || triangles > sim::kMostTriangles)
            return broken();
        skeleton->weights = *std::move(weights);
        if (!skeleton->weights.empty() && !withinLimits(*skeleton, mesh->positionsHd.size()))
            return broken();
        part.mesh = std::make_shared<const sim::HeadMesh>(*std::move(mesh));
        read.parts.push_back(std::move(part));
        read.weights.push_back(std::move(skeleton->weights));
    }
    return read;
}

UvTiles tilesFromGlb(const QByteArray& glb)
{
    const std::optional<GlbContainer> container = openGlb(glb);
    if (!container)
        return {};
    const QJsonObject mesh = container->list(QLatin1StringView("meshes")).at(0).toObject();
    const QJsonArray told = mesh.value(QLatin1String("extras")).toObject().value(QLatin1String("udim")).toArray();
    std::vector<int> numbers;
    if (told.size() > static_cast<qsizetype>(MeshPart::kMost))
        return {};
    numbers.reserve(static_cast<std::size_t>(told.size()));
    for (const auto& number : told) {
        numbers.push_back(number.toInt());
        if (numbers.back() < kFirstUdim || numbers.back() > kLastUdim)
            return {};
    }
    return UvTiles(std::move(numbers));
}

} // namespace hairpaint::model
