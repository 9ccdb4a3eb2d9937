// Writing our subset of binary glTF (Khronos, glTF 2.0 specification, sections 3 to 5).
#include "model/files/glb_writing.h"

#include "model/files/glb_container.h"
#include "model/files/joint_nodes.h"
#include "model/files/json_fields.h"
#include "sim/skin/mesh_bounds.h"

#include <QBuffer>
#include <QImage>
#include <QJsonDocument>

#include <algorithm>
#include <span>

namespace hairpaint::model {

namespace {

void appendWord(QByteArray& bytes, quint32 word)
{
    const quint32 little = qToLittleEndian(word);
    bytes.append(reinterpret_cast<const char*>(&little), 4);
}

QJsonArray floatArray(const glm::vec3& v)
{
    return {shortestDouble(v.x), shortestDouble(v.y), shortestDouble(v.z)};
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

    /// The number of the view.
    int addBytes(const QByteArray& bytes)
    {
        m_views.append(QJsonObject{{QStringLiteral("buffer"), 0},
                                   {QStringLiteral("byteOffset"), m_bin.size()},
                                   {QStringLiteral("byteLength"), bytes.size()}});
        m_bin.append(bytes);
        while (m_bin.size() % 4 != 0)
            m_bin.append('\0');
        return static_cast<int>(m_views.size()) - 1;
    }

    /// A mesh each; `joints`: nodes that follow that of the first mesh, and `skin` of them, which is empty where there
    /// are none. The nodes of the other meshes come after these.
    QByteArray finish(const QJsonArray& meshes, const QJsonArray& joints, const QJsonObject& skin, QJsonObject root)
    {
        QJsonArray shown{0};
        QJsonArray nodes;
        const auto addNode = [&](qsizetype mesh) {
            QJsonObject node{{QStringLiteral("mesh"), mesh}};
            const QJsonObject primitive =
                meshes.at(mesh).toObject().value(QLatin1String("primitives")).toArray().at(0).toObject();
            if (primitive.value(QLatin1String("attributes")).toObject().contains(QLatin1String("JOINTS_0")))
                node.insert(QStringLiteral("skin"), 0);
            nodes.append(node);
        };
        addNode(0);
        if (!joints.isEmpty()) {
            shown.append(1);
            for (const auto& joint : joints)
                nodes.append(joint);
        }
        for (qsizetype mesh = 1; mesh < meshes.size(); ++mesh) {
            shown.append(nodes.size());
            addNode(mesh);
        }
        root.insert(QStringLiteral("asset"), QJsonObject{{QStringLiteral("version"), QStringLiteral("2.0")}});
        root.insert(QStringLiteral("scene"), 0);
        root.insert(QStringLiteral("scenes"), QJsonArray{QJsonObject{{QStringLiteral("nodes"), shown}}});
        root.insert(QStringLiteral("nodes"), nodes);
        if (!joints.isEmpty())
            root.insert(QStringLiteral("skins"), QJsonArray{skin});
        root.insert(QStringLiteral("meshes"), meshes);
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

/// Some of a mesh's vertices and triangles, which name no others.
struct MeshRange
{
    std::size_t firstVertex = 0, vertices = 0, firstTriangle = 0, triangles = 0;
};

template<typename Element>
std::vector<Element> taken(const std::vector<Element>& all, std::size_t first, std::size_t count)
{
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
    return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

QJsonObject attributesOf(GlbWriter& writer, const RiggedMesh& mesh, const MeshRange& range, int& indices)
{
    sim::HeadMesh own{.positionsHd = taken(mesh.positionsHd, range.firstVertex, range.vertices),
                      .normalsHd = taken(mesh.normalsHd, range.firstVertex, range.vertices),
                      .uvs = taken(mesh.uvs, range.firstVertex, range.vertices),
                      .triangles = taken(mesh.triangles, range.firstTriangle, range.triangles)};
    for (glm::uvec3& triangle : own.triangles)
        triangle -= static_cast<std::uint32_t>(range.firstVertex);
    std::vector<glm::vec2> turned = own.uvs;
    for (glm::vec2& uv : turned)
        uv.y = 1.0F - uv.y;
    indices = writer.add(own.triangles, "SCALAR", kUnsignedInt, 3, kElementArrayBuffer);
    const int positions = writer.add(own.positionsHd, "VEC3", kFloat, 1, kArrayBuffer);
    const int normals = writer.add(own.normalsHd, "VEC3", kFloat, 1, kArrayBuffer);
    const int texcoords = writer.add(turned, "VEC2", kFloat, 1, kArrayBuffer);
    const int ownUvs = writer.add(own.uvs, "VEC2", kFloat, 1, kArrayBuffer);
    if (!own.positionsHd.empty()) {
        const sim::MeshBounds bounds = sim::boundsOf(own);
        writer.setBounds(positions, bounds.least, bounds.greatest);
    }
    QJsonObject attributes{{QStringLiteral("POSITION"), positions},
                           {QStringLiteral("NORMAL"), normals},
                           {QStringLiteral("TEXCOORD_0"), texcoords},
                           {QStringLiteral("_UV"), ownUvs}};
    if (mesh.skeleton.empty())
        return attributes;
    std::vector<decltype(BoneWeights::joints)> joints;
    std::vector<glm::vec4> weights;
    const std::vector<BoneWeights>& all = mesh.skeleton.weights; // Too few are written as they are.
    const std::size_t first = std::min(range.firstVertex, all.size());
    for (const BoneWeights& bones : std::span(all).subspan(first, std::min(range.vertices, all.size() - first))) {
        joints.push_back(bones.joints);
        weights.push_back(bones.weights);
    }
    attributes.insert(QStringLiteral("JOINTS_0"), writer.add(joints, "VEC4", kUnsignedShort, 1, kArrayBuffer));
    attributes.insert(QStringLiteral("WEIGHTS_0"), writer.add(weights, "VEC4", kFloat, 1, kArrayBuffer));
    return attributes;
}

QJsonObject materialOf(const MeshPart& part)
{
    QJsonObject surface{
        {QStringLiteral("baseColorFactor"),
         QJsonArray{shortestDouble(part.colour.x), shortestDouble(part.colour.y), shortestDouble(part.colour.z), 1.0}},
        {QStringLiteral("metallicFactor"), 0.0}};
    if (part.texture >= 0)
        surface.insert(QStringLiteral("baseColorTexture"), QJsonObject{{QStringLiteral("index"), part.texture}});
    QJsonObject material{{QStringLiteral("pbrMetallicRoughness"), surface}};
    if (!part.material.empty())
        material.insert(QStringLiteral("name"), QString::fromStdString(part.material));
    if (part.alpha != PartAlpha::Opaque)
        material.insert(QStringLiteral("alphaMode"),
                        part.alpha == PartAlpha::Mask ? QStringLiteral("MASK") : QStringLiteral("BLEND"));
    if (part.doubleSided)
        material.insert(QStringLiteral("doubleSided"), true);
    return material;
}

} // namespace

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

QByteArray pngOfTexture(const sim::MeshTexture& texture)
{
    const QImage image(texture.rgba.data(), static_cast<int>(texture.width), static_cast<int>(texture.height),
                       static_cast<int>(texture.width) * 4, QImage::Format_RGBA8888);
    bool isOpaque = true;
    for (std::size_t i = 3; i < texture.rgba.size() && isOpaque; i += 4)
        isOpaque = texture.rgba[i] == 255;
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    constexpr int kQuick = 80; // Qt's quality of a PNG: the higher, the less and the quicker it is packed.
    (isOpaque ? image.convertToFormat(QImage::Format_RGB888) : image).save(&buffer, "PNG", kQuick);
    return png;
}

QByteArray glbFromMesh(const RiggedMesh& mesh)
{
    GlbWriter writer;
    const bool isPlain = mesh.parts.size() <= 1 && mesh.textures.empty();
    QJsonArray meshes;
    QJsonArray materials;
    MeshRange range{.firstVertex = 0,
                    .vertices = isPlain ? mesh.positionsHd.size() : 0,
                    .firstTriangle = 0,
                    .triangles = isPlain ? mesh.triangles.size() : 0};
    const auto addMesh = [&](const MeshPart* part) {
        int indices = 0;
        const QJsonObject attributes = attributesOf(writer, mesh, range, indices);
        QJsonObject primitive{{QStringLiteral("attributes"), attributes},
                              {QStringLiteral("indices"), indices},
                              {QStringLiteral("mode"), 4}};
        QJsonObject own;
        if (part != nullptr) {
            primitive.insert(QStringLiteral("material"), materials.size());
            materials.append(materialOf(*part));
            own.insert(QStringLiteral("name"), QString::fromStdString(part->name));
        }
        if (meshes.isEmpty() && !mesh.tiles.isOneMap()) {
            QJsonArray tiles;
            for (const int number : mesh.tiles.numbers())
                tiles.append(number);
            own.insert(QStringLiteral("extras"), QJsonObject{{QStringLiteral("udim"), tiles}});
        }
        own.insert(QStringLiteral("primitives"), QJsonArray{primitive});
        meshes.append(own);
    };
    if (isPlain)
        addMesh(nullptr);
    else
        for (const MeshPart& part : mesh.parts) {
            range = {.firstVertex = range.firstVertex + range.vertices,
                     .vertices = part.vertices,
                     .firstTriangle = range.firstTriangle + range.triangles,
                     .triangles = part.triangles};
            addMesh(&part);
        }
    QJsonObject root;
    if (!materials.isEmpty())
        root.insert(QStringLiteral("materials"), materials);
    QJsonArray joints;
    QJsonObject skin;
    if (const HeadSkeleton& skeleton = mesh.skeleton; !skeleton.empty()) {
        constexpr int kFirstNode = 1;
        std::vector<glm::mat4> inverse;
        for (const JointPose& pose : posesOf(skeleton))
            inverse.push_back(inverseBind(pose));
        joints = nodesOf(skeleton, kFirstNode);
        skin = {{QStringLiteral("inverseBindMatrices"), writer.add(inverse, "MAT4", kFloat, 1, kNoTarget)},
                {QStringLiteral("joints"), jointNumbers(skeleton, kFirstNode)}};
    }
    QJsonArray images;
    QJsonArray textures;
    for (const sim::MeshTexture& texture : mesh.textures) {
        textures.append(QJsonObject{{QStringLiteral("source"), images.size()}});
        images.append(QJsonObject{{QStringLiteral("bufferView"), writer.addBytes(pngOfTexture(texture))},
                                  {QStringLiteral("mimeType"), QStringLiteral("image/png")}});
    }
    if (!images.isEmpty()) {
        root.insert(QStringLiteral("images"), images);
        root.insert(QStringLiteral("textures"), textures);
    }
    return writer.finish(meshes, joints, skin, root);
}

} // namespace hairpaint::model
