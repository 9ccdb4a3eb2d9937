// Reading and writing our subset of binary glTF (Khronos, glTF 2.0 specification, sections 4 and 5).
#include "model/files/glb.h"

#include "model/files/joint_nodes.h"
#include "model/files/json_fields.h"
#include "sim/skin/head_limits.h"
#include "sim/skin/mesh_bounds.h"

#include <QJsonDocument>
#include <QtEndian>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

namespace hairpaint::model {

namespace {

constexpr quint32 kMagic = 0x46546C67;     // "glTF"
constexpr quint32 kJsonChunk = 0x4E4F534A; // "JSON"
constexpr quint32 kBinChunk = 0x004E4942;  // "BIN\0"
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kUnsignedShort = 5123;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr int kNoTarget = 0;
constexpr quint32 kMostJsonChunkBytes = 1U << 20U;
static_assert(std::endian::native == std::endian::little, "arrays are copied as they lie in memory");

tl::unexpected<Clause> broken()
{
    return refuse(say(QT_TRANSLATE_NOOP("Files", "its head's mesh is broken")));
}

quint32 wordAt(const QByteArray& bytes, qsizetype at)
{
    return qFromLittleEndian<quint32>(bytes.constData() + at);
}

/// The two chunks of a checked container.
struct Container
{
    QJsonObject json;
    QByteArrayView bin;
};

std::optional<Container> openContainer(const QByteArray& glb)
{
    if (glb.size() < 28 || wordAt(glb, 0) != kMagic || wordAt(glb, 4) != 2 || wordAt(glb, 8) != glb.size())
        return std::nullopt;
    const quint32 jsonBytes = wordAt(glb, 12);
    if (wordAt(glb, 16) != kJsonChunk || jsonBytes > kMostJsonChunkBytes || jsonBytes % 4 != 0 ||
        glb.size() - 28 < jsonBytes)
        return std::nullopt;
    const qsizetype binAt = 20 + static_cast<qsizetype>(jsonBytes);
    const quint32 binBytes = wordAt(glb, binAt);
    if (wordAt(glb, binAt + 4) != kBinChunk || glb.size() - binAt - 8 < binBytes)
        return std::nullopt;
    const QJsonDocument document = QJsonDocument::fromJson(glb.sliced(20, jsonBytes));
    if (!document.isObject())
        return std::nullopt;
    return Container{.json = document.object(), .bin = QByteArrayView(glb).sliced(binAt + 8, binBytes)};
}

qint64 wholeNumber(const QJsonValue& value, qint64 absent)
{
    return value.isUndefined() ? absent : value.toInteger(-1);
}

/// Copies an accessor's elements; none where anything about it is not as our subset has it.
template<typename Element>
std::optional<std::vector<Element>> readAccessor(const Container& container, const QJsonValue& index,
                                                 const QString& type, int componentType, qint64 most)
{
    const QJsonArray accessors = container.json.value(QLatin1String("accessors")).toArray();
    const QJsonArray views = container.json.value(QLatin1String("bufferViews")).toArray();
    const qint64 number = wholeNumber(index, -1);
    if (number < 0 || number >= accessors.size())
        return std::nullopt;
    const QJsonObject accessor = accessors.at(number).toObject();
    const qint64 viewNumber = wholeNumber(accessor.value(QLatin1String("bufferView")), -1);
    const qint64 count = wholeNumber(accessor.value(QLatin1String("count")), -1);
    if (accessor.value(QLatin1String("type")).toString() != type ||
        accessor.value(QLatin1String("componentType")).toInt() != componentType || viewNumber < 0 ||
        viewNumber >= views.size() || count < 1 || count > most ||
        wholeNumber(accessor.value(QLatin1String("byteOffset")), 0) != 0 || accessor.contains(QLatin1String("sparse")))
        return std::nullopt;
    const QJsonObject view = views.at(viewNumber).toObject();
    const qint64 offset = wholeNumber(view.value(QLatin1String("byteOffset")), 0);
    const qint64 length = wholeNumber(view.value(QLatin1String("byteLength")), -1);
    constexpr auto kElementBytes = static_cast<qint64>(sizeof(Element));
    if (wholeNumber(view.value(QLatin1String("buffer")), 0) != 0 || view.contains(QLatin1String("byteStride")) ||
        offset < 0 || offset > container.bin.size() || length != count * kElementBytes ||
        length > container.bin.size() - offset)
        return std::nullopt;
    std::vector<Element> elements(static_cast<std::size_t>(count));
    std::memcpy(elements.data(), container.bin.data() + offset, static_cast<std::size_t>(length));
    return elements;
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

QJsonArray floatArray(const glm::vec3& v)
{
    return {shortestDouble(v.x), shortestDouble(v.y), shortestDouble(v.z)};
}

void appendWord(QByteArray& bytes, quint32 word)
{
    const quint32 little = qToLittleEndian(word);
    bytes.append(reinterpret_cast<const char*>(&little), 4);
}

/// Lays arrays one after another into the binary chunk and describes them.
class GlbWriter
{
public:
    template<typename Element>
    int add(const std::vector<Element>& elements, const char* type, int componentType, qsizetype perElement, int target)
    {
        const std::size_t bytes = elements.size() * sizeof(Element);
        const auto length = static_cast<qsizetype>(bytes);
        QJsonObject view{{QStringLiteral("buffer"), 0},
                         {QStringLiteral("byteOffset"), m_bin.size()},
                         {QStringLiteral("byteLength"), length}};
        if (target != kNoTarget)
            view.insert(QStringLiteral("target"), target);
        m_views.append(view);
        m_accessors.append(QJsonObject{{QStringLiteral("bufferView"), static_cast<int>(m_views.size()) - 1},
                                       {QStringLiteral("componentType"), componentType},
                                       {QStringLiteral("count"), static_cast<qsizetype>(elements.size()) * perElement},
                                       {QStringLiteral("type"), QLatin1String(type)}});
        m_bin.append(reinterpret_cast<const char*>(elements.data()), length);
        return static_cast<int>(m_accessors.size()) - 1;
    }

    void setBounds(int accessor, const glm::vec3& least, const glm::vec3& greatest)
    {
        QJsonObject object = m_accessors.at(accessor).toObject();
        object.insert(QStringLiteral("min"), floatArray(least));
        object.insert(QStringLiteral("max"), floatArray(greatest));
        m_accessors.replace(accessor, object);
    }

    /// `skin`: empty where there are no `joints`, nodes that follow the mesh's own.
    QByteArray finish(const QJsonObject& primitive, const QJsonArray& joints, const QJsonObject& skin)
    {
        QJsonArray shown{0};
        QJsonArray nodes{QJsonObject{{QStringLiteral("mesh"), 0}}};
        if (!joints.isEmpty()) {
            nodes[0] = QJsonObject{{QStringLiteral("mesh"), 0}, {QStringLiteral("skin"), 0}};
            shown.append(1);
            for (const auto& joint : joints)
                nodes.append(joint);
        }
        QJsonObject root;
        root.insert(QStringLiteral("asset"), QJsonObject{{QStringLiteral("version"), QStringLiteral("2.0")}});
        root.insert(QStringLiteral("scene"), 0);
        root.insert(QStringLiteral("scenes"), QJsonArray{QJsonObject{{QStringLiteral("nodes"), shown}}});
        root.insert(QStringLiteral("nodes"), nodes);
        if (!joints.isEmpty())
            root.insert(QStringLiteral("skins"), QJsonArray{skin});
        root.insert(QStringLiteral("meshes"),
                    QJsonArray{QJsonObject{{QStringLiteral("primitives"), QJsonArray{primitive}}}});
        root.insert(QStringLiteral("accessors"), m_accessors);
        root.insert(QStringLiteral("bufferViews"), m_views);
        root.insert(QStringLiteral("buffers"), QJsonArray{QJsonObject{{QStringLiteral("byteLength"), m_bin.size()}}});
        QByteArray glb = glbHead(root, static_cast<quint32>(m_bin.size()));
        glb.append(m_bin);
        return glb;
    }

private:
    QByteArray m_bin;
    QJsonArray m_views;
    QJsonArray m_accessors;
};

/// The one primitive's; none where there is not just one.
std::optional<QJsonObject> primitiveOf(const Container& container)
{
    const QJsonArray meshes = container.json.value(QLatin1String("meshes")).toArray();
    const QJsonArray primitives = meshes.at(0).toObject().value(QLatin1String("primitives")).toArray();
    const QJsonObject primitive = primitives.at(0).toObject();
    if (meshes.size() != 1 || primitives.size() != 1 || primitive.value(QLatin1String("mode")).toInt(4) != 4)
        return std::nullopt;
    return primitive;
}

} // namespace

Checked<sim::HeadMesh> meshFromGlb(const QByteArray& glb)
{
    const std::optional<Container> container = openContainer(glb);
    if (!container)
        return broken();
    const std::optional<QJsonObject> primitive = primitiveOf(*container);
    if (!primitive)
        return broken();
    const QJsonObject attributes = primitive->value(QLatin1String("attributes")).toObject();
    const bool hasOwnUvs = attributes.contains(QLatin1String("_UV"));

    const auto vectors = [&](const char* name) {
        return readAccessor<glm::vec3>(*container, attributes.value(QLatin1String(name)), QStringLiteral("VEC3"),
                                       kFloat, sim::kMostVertices);
    };
    auto positions = vectors("POSITION");
    auto normals = vectors("NORMAL");
    auto uvs = readAccessor<glm::vec2>(*container, attributes.value(QLatin1String(hasOwnUvs ? "_UV" : "TEXCOORD_0")),
                                       QStringLiteral("VEC2"), kFloat, sim::kMostVertices);
    auto indices = readAccessor<std::uint32_t>(*container, primitive->value(QLatin1String("indices")),
                                               QStringLiteral("SCALAR"), kUnsignedInt, 3LL * sim::kMostTriangles);
    if (!positions || !normals || !uvs || !indices || indices->size() % 3 != 0)
        return broken();
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
        return broken();
    mendNormals(mesh.normalsHd);
    return mesh;
}

Checked<HeadSkeleton> skeletonFromGlb(const QByteArray& glb)
{
    const std::optional<Container> container = openContainer(glb);
    const std::optional<QJsonObject> primitive = container ? primitiveOf(*container) : std::nullopt;
    if (!primitive)
        return broken();
    const QJsonArray skins = container->json.value(QLatin1String("skins")).toArray();
    if (skins.isEmpty())
        return HeadSkeleton{};
    std::optional<std::vector<HeadJoint>> joints =
        jointsFromNodes(container->json.value(QLatin1String("nodes")).toArray(),
                        skins.at(0).toObject().value(QLatin1String("joints")).toArray());
    const QJsonObject attributes = primitive->value(QLatin1String("attributes")).toObject();
    using Indices = decltype(BoneWeights::joints);
    const auto indices = readAccessor<Indices>(*container, attributes.value(QLatin1String("JOINTS_0")),
                                               QStringLiteral("VEC4"), kUnsignedShort, sim::kMostVertices);
    const auto weights = readAccessor<glm::vec4>(*container, attributes.value(QLatin1String("WEIGHTS_0")),
                                                 QStringLiteral("VEC4"), kFloat, sim::kMostVertices);
    const auto positions = readAccessor<glm::vec3>(*container, attributes.value(QLatin1String("POSITION")),
                                                   QStringLiteral("VEC3"), kFloat, sim::kMostVertices);
    if (skins.size() != 1 || !joints || !indices || !weights || !positions || indices->size() != weights->size())
        return broken();
    HeadSkeleton skeleton{.joints = std::move(*joints), .weights = {}};
    skeleton.weights.reserve(weights->size());
    for (std::size_t i = 0; i < weights->size(); ++i)
        skeleton.weights.push_back({.joints = (*indices)[i], .weights = (*weights)[i]});
    if (skeleton.empty() || !withinLimits(skeleton, positions->size()))
        return broken();
    return skeleton;
}

QByteArray glbHead(const QJsonObject& json, quint32 binBytes)
{
    QByteArray text = QJsonDocument(json).toJson(QJsonDocument::Compact);
    while (text.size() % 4 != 0)
        text.append(' ');
    constexpr quint32 kHeadBytes = 28;
    QByteArray glb;
    appendWord(glb, kMagic);
    appendWord(glb, 2);
    appendWord(glb, kHeadBytes + static_cast<quint32>(text.size()) + binBytes);
    appendWord(glb, static_cast<quint32>(text.size()));
    appendWord(glb, kJsonChunk);
    glb.append(text);
    appendWord(glb, binBytes);
    appendWord(glb, kBinChunk);
    return glb;
}

QByteArray glbFromMesh(const RiggedMesh& mesh)
{
    const HeadSkeleton& skeleton = mesh.skeleton;
    std::vector<glm::vec2> turned = mesh.uvs;
    for (glm::vec2& uv : turned)
        uv.y = 1.0F - uv.y;
    GlbWriter writer;
    const int indices = writer.add(mesh.triangles, "SCALAR", kUnsignedInt, 3, kElementArrayBuffer);
    const int positions = writer.add(mesh.positionsHd, "VEC3", kFloat, 1, kArrayBuffer);
    const int normals = writer.add(mesh.normalsHd, "VEC3", kFloat, 1, kArrayBuffer);
    const int texcoords = writer.add(turned, "VEC2", kFloat, 1, kArrayBuffer);
    const int own = writer.add(mesh.uvs, "VEC2", kFloat, 1, kArrayBuffer);
    if (!mesh.positionsHd.empty()) {
        const sim::MeshBounds bounds = sim::boundsOf(mesh);
        writer.setBounds(positions, bounds.least, bounds.greatest);
    }
    QJsonObject attributes{{QStringLiteral("POSITION"), positions},
                           {QStringLiteral("NORMAL"), normals},
                           {QStringLiteral("TEXCOORD_0"), texcoords},
                           {QStringLiteral("_UV"), own}};
    QJsonArray joints;
    QJsonObject skin;
    if (!skeleton.empty()) {
        constexpr int kFirstNode = 1;
        std::vector<decltype(BoneWeights::joints)> indices4;
        std::vector<glm::vec4> weights;
        for (const BoneWeights& bones : skeleton.weights) {
            indices4.push_back(bones.joints);
            weights.push_back(bones.weights);
        }
        attributes.insert(QStringLiteral("JOINTS_0"), writer.add(indices4, "VEC4", kUnsignedShort, 1, kArrayBuffer));
        attributes.insert(QStringLiteral("WEIGHTS_0"), writer.add(weights, "VEC4", kFloat, 1, kArrayBuffer));
        std::vector<glm::mat4> inverse;
        for (const JointPose& pose : posesOf(skeleton))
            inverse.push_back(inverseBind(pose));
        joints = nodesOf(skeleton, kFirstNode);
        skin = {{QStringLiteral("inverseBindMatrices"), writer.add(inverse, "MAT4", kFloat, 1, kNoTarget)},
                {QStringLiteral("joints"), jointNumbers(skeleton, kFirstNode)}};
    }
    return writer.finish(
        {{QStringLiteral("attributes"), attributes}, {QStringLiteral("indices"), indices}, {QStringLiteral("mode"), 4}},
        joints, skin);
}

} // namespace hairpaint::model
