// Views, accessors, meshes and materials by the glTF 2.0 specification (Khronos).
#include "model/exporting/ribbon_json.h"

#include "model/exporting/glb_buffer.h"
#include "model/files/glb_writing.h"
#include "model/values/srgb.h"

#include <algorithm>
#include <cstddef>

namespace hairpaint::model {

void RibbonJson::add(const CurveSet& set, const RibbonGroup& group)
{
    const QString name = group.curves->name;
    const int vertices = addView(group.vertexBytes(), GlbBuffer::kVertices, sizeof(RibbonVertex));
    QJsonObject position =
        GlbBuffer::accessor(vertices, offsetof(RibbonVertex, position), GlbBuffer::kFloats, group.vertices(), "VEC3");
    position.insert(QStringLiteral("min"), jsonNumbers(group.least));
    position.insert(QStringLiteral("max"), jsonNumbers(group.greatest));
    const auto normalised = [](QJsonObject object) {
        object.insert(QStringLiteral("normalized"), true);
        return object;
    };
    const QJsonObject attributes{
        {QStringLiteral("POSITION"), addAccessor(position)},
        {QStringLiteral("NORMAL"), addAccessor(GlbBuffer::accessor(vertices, offsetof(RibbonVertex, normal),
                                                                   GlbBuffer::kFloats, group.vertices(), "VEC3"))},
        {QStringLiteral("TEXCOORD_0"),
         addAccessor(normalised(
             GlbBuffer::accessor(vertices, offsetof(RibbonVertex, uv), GlbBuffer::kShorts, group.vertices(), "VEC2")))},
        {QStringLiteral("COLOR_0"),
         addAccessor(normalised(GlbBuffer::accessor(vertices, offsetof(RibbonVertex, colour), GlbBuffer::kShorts,
                                                    group.vertices(), "VEC4")))}};
    const int indexView = addView(group.indexBytes(), GlbBuffer::kIndices, 0);
    const int indices = addAccessor(GlbBuffer::accessor(indexView, 0, GlbBuffer::kInts, group.indices(), "SCALAR"));
    const auto roughness = static_cast<double>(set.material(group.curves->curves.front()).roughness);
    addNode(name, attributes, indices,
            {{QStringLiteral("name"), name},
             {QStringLiteral("doubleSided"), true},
             {QStringLiteral("pbrMetallicRoughness"),
              QJsonObject{{QStringLiteral("metallicFactor"), 0.0}, {QStringLiteral("roughnessFactor"), roughness}}}});
}

void RibbonJson::add(const WornBody& body)
{
    const std::vector<HeadVertexOut>& vertices = body.mesh.vertices;
    const int view = addView(vertices.size() * sizeof(HeadVertexOut), GlbBuffer::kVertices, sizeof(HeadVertexOut));
    glm::vec3 least = vertices.front().position;
    glm::vec3 greatest = least;
    for (const HeadVertexOut& vertex : vertices) {
        least = glm::min(least, vertex.position);
        greatest = glm::max(greatest, vertex.position);
    }
    QJsonObject position =
        GlbBuffer::accessor(view, offsetof(HeadVertexOut, position), GlbBuffer::kFloats, vertices.size(), "VEC3");
    position.insert(QStringLiteral("min"), jsonNumbers(least));
    position.insert(QStringLiteral("max"), jsonNumbers(greatest));
    const QJsonObject attributes{
        {QStringLiteral("POSITION"), addAccessor(position)},
        {QStringLiteral("NORMAL"), addAccessor(GlbBuffer::accessor(view, offsetof(HeadVertexOut, normal),
                                                                   GlbBuffer::kFloats, vertices.size(), "VEC3"))},
        {QStringLiteral("TEXCOORD_0"), addAccessor(GlbBuffer::accessor(view, offsetof(HeadVertexOut, uv),
                                                                       GlbBuffer::kFloats, vertices.size(), "VEC2"))}};
    const int indexView = addView(body.mesh.indices.size() * sizeof(quint32), GlbBuffer::kIndices, 0);
    const int indices =
        addAccessor(GlbBuffer::accessor(indexView, 0, GlbBuffer::kInts, body.mesh.indices.size(), "SCALAR"));
    const auto linear = [](int channel) { return linearFromSrgb(static_cast<float>(channel) / 255.0F); };
    QJsonArray factor =
        jsonNumbers({linear(qRed(body.colour)), linear(qGreen(body.colour)), linear(qBlue(body.colour))});
    factor.append(1.0);
    QJsonObject surface{{QStringLiteral("baseColorFactor"), factor},
                        {QStringLiteral("metallicFactor"), 0.0},
                        {QStringLiteral("roughnessFactor"), body.roughness}};
    if (body.texture) {
        auto known = std::ranges::find(m_textures, body.texture);
        if (known == m_textures.end())
            known = m_textures.insert(known, body.texture);
        const auto number = static_cast<int>(known - m_textures.begin());
        surface.insert(QStringLiteral("baseColorTexture"), QJsonObject{{QStringLiteral("index"), number}});
    }
    QJsonObject material{{QStringLiteral("name"), body.name}, {QStringLiteral("pbrMetallicRoughness"), surface}};
    if (body.isOpen)
        material.insert(QStringLiteral("doubleSided"), true);
    insertAlpha(body.alpha, material);
    addNode(body.name, attributes, indices, material);
}

std::vector<QByteArray> RibbonJson::addImages()
{
    std::vector<QByteArray> images;
    for (const std::shared_ptr<const sim::MeshTexture>& texture : m_textures) {
        QByteArray& png = images.emplace_back(pngOfTexture(*texture));
        const int view = addView(static_cast<quint64>(png.size()), GlbBuffer::kOther, 0);
        m_images.append(QJsonObject{{QStringLiteral("mimeType"), QStringLiteral("image/png")},
                                    {QStringLiteral("bufferView"), view}});
        while (png.size() % 4 != 0) { // What follows begins at a multiple of 4.
            png.append('\0');
            ++m_bytes;
        }
    }
    return images;
}

QJsonObject RibbonJson::finish() const
{
    QJsonObject root{
        {QStringLiteral("asset"), QJsonObject{{QStringLiteral("version"), QStringLiteral("2.0")},
                                              {QStringLiteral("generator"), QStringLiteral("Hair Paint")}}},
        {QStringLiteral("scene"), 0}};
    QJsonObject scene{{QStringLiteral("name"), QStringLiteral("Hair")}};
    if (!m_nodes.isEmpty()) { // Arrays of glTF are never empty.
        QJsonArray nodes;
        for (int i = 0; i < static_cast<int>(m_nodes.size()); ++i)
            nodes.append(i);
        scene.insert(QStringLiteral("nodes"), nodes);
        root.insert(QStringLiteral("nodes"), m_nodes);
        root.insert(QStringLiteral("meshes"), m_meshes);
        root.insert(QStringLiteral("materials"), m_materials);
        if (!m_images.isEmpty()) {
            QJsonArray textures;
            for (int i = 0; i < static_cast<int>(m_images.size()); ++i)
                textures.append(QJsonObject{{QStringLiteral("source"), i}});
            root.insert(QStringLiteral("images"), m_images);
            root.insert(QStringLiteral("textures"), textures);
        }
        root.insert(QStringLiteral("accessors"), m_accessors);
        root.insert(QStringLiteral("bufferViews"), m_views);
        root.insert(QStringLiteral("buffers"),
                    QJsonArray{QJsonObject{{QStringLiteral("byteLength"), static_cast<qint64>(m_bytes)}}});
    }
    root.insert(QStringLiteral("scenes"), QJsonArray{scene});
    return root;
}

void RibbonJson::addNode(const QString& name, const QJsonObject& attributes, int indices, const QJsonObject& material)
{
    m_materials.append(material);
    const QJsonObject primitive{{QStringLiteral("attributes"), attributes},
                                {QStringLiteral("indices"), indices},
                                {QStringLiteral("material"), static_cast<int>(m_materials.size()) - 1},
                                {QStringLiteral("mode"), 4}};
    m_meshes.append(QJsonObject{{QStringLiteral("name"), name}, {QStringLiteral("primitives"), QJsonArray{primitive}}});
    m_nodes.append(
        QJsonObject{{QStringLiteral("name"), name}, {QStringLiteral("mesh"), static_cast<int>(m_meshes.size()) - 1}});
}

int RibbonJson::addView(quint64 bytes, int target, std::size_t stride)
{
    QJsonObject view{{QStringLiteral("buffer"), 0},
                     {QStringLiteral("byteOffset"), static_cast<qint64>(m_bytes)},
                     {QStringLiteral("byteLength"), static_cast<qint64>(bytes)}};
    if (target != GlbBuffer::kOther)
        view.insert(QStringLiteral("target"), target);
    if (stride > 0)
        view.insert(QStringLiteral("byteStride"), static_cast<int>(stride));
    m_views.append(view);
    m_bytes += bytes;
    return static_cast<int>(m_views.size()) - 1;
}

int RibbonJson::addAccessor(const QJsonObject& accessor)
{
    m_accessors.append(accessor);
    return static_cast<int>(m_accessors.size()) - 1;
}

} // namespace hairpaint::model
