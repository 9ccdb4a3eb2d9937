// Binary glTF (Khronos, glTF 2.0 specification): vertices and indices of each group in each level, the head, bones,
// then the images.
#include "model/exporting/cards/card_glb.h"

#include "model/exporting/cards/bone_glb.h"
#include "model/exporting/cards/card_head.h"
#include "model/exporting/cards/card_mesh.h"
#include "model/exporting/glb_buffer.h"
#include "model/files/glb.h"
#include "model/srgb.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr QLatin1StringView kLevelExtension("MSFT_lod");
constexpr QLatin1StringView kSpringExtension("VRMC_springBone");

/// Of the picture's height, by level: what is smaller shows the next.
constexpr std::array<double, CardSettings::kMostLevels> kLeastOnScreen = {0.5, 0.2, 0.0};

/// Puts meshes and images into the binary chunk and describes them.
class CardGlbWriter
{
public:
    /// Nodes of the scene show only the first level; they name those of the others, which lie beside the scene so that
    /// programs which know nothing of levels draw one of them.
    void addCards(const QString& name, const std::vector<CardMesh>& levels)
    {
        const auto first = static_cast<int>(m_nodes.size());
        QJsonArray coarser;
        QJsonArray leastOnScreen{kLeastOnScreen.front()};
        for (std::size_t level = 0; level < levels.size(); ++level) {
            const CardMesh& mesh = levels[level];
            if (level > 0) {
                coarser.append(static_cast<int>(m_nodes.size()));
                leastOnScreen.append(kLeastOnScreen.at(level));
            }
            addMesh(levels.size() > 1 ? QStringLiteral("%1_LOD%2").arg(name).arg(level) : name, mesh);
        }
        m_sceneNodes.append(first);
        if (coarser.isEmpty())
            return;
        leastOnScreen.replace(leastOnScreen.size() - 1, 0.0);
        QJsonObject node = m_nodes[first].toObject();
        node.insert(QStringLiteral("extensions"),
                    QJsonObject{{kLevelExtension, QJsonObject{{QStringLiteral("ids"), coarser}}}});
        node.insert(QStringLiteral("extras"), QJsonObject{{QStringLiteral("MSFT_screencoverage"), leastOnScreen}});
        m_nodes.replace(first, node);
        m_extensions.insert(kLevelExtension, QJsonValue());
    }

    /// `hasBones`: it is held by the joint of the head.
    void addHead(const PlacedHead& head, QRgb colour, bool hasBones)
    {
        const int view = m_buffer.addView(head.vertices.data(), head.vertices.size() * sizeof(HeadVertexOut),
                                          GlbBuffer::kVertices, static_cast<int>(sizeof(HeadVertexOut)));
        const auto attribute = [&](std::size_t offset, const char* type) {
            return GlbBuffer::accessor(view, offset, GlbBuffer::kFloats, head.vertices.size(), type);
        };
        QJsonObject attributes{
            {QStringLiteral("POSITION"),
             m_buffer.addAccessor(withBounds(attribute(offsetof(HeadVertexOut, position), "VEC3"), head.vertices))},
            {QStringLiteral("NORMAL"), m_buffer.addAccessor(attribute(offsetof(HeadVertexOut, normal), "VEC3"))},
            {QStringLiteral("TEXCOORD_0"), m_buffer.addAccessor(attribute(offsetof(HeadVertexOut, uv), "VEC2"))}};
        addWeights(std::vector<BoneWeights>(hasBones ? head.vertices.size() : 0), attributes);
        m_materials.append(skinMaterial(colour));
        m_sceneNodes.append(static_cast<int>(m_nodes.size()));
        addNode(QStringLiteral("Head mesh"), attributes, head.indices, static_cast<int>(m_materials.size()) - 1);
    }

    void addBones(const CurveSet& curves, const CardBones& bones, std::span<const sim::Ellipsoid> colliders)
    {
        const auto head = static_cast<int>(m_nodes.size());
        const BoneGlb made = boneGlb(curves, bones, colliders, head);
        m_sceneNodes.append(head);
        for (const auto& node : made.nodes)
            m_nodes.append(node);
        const std::size_t count = made.inverseBind.size();
        const int view = m_buffer.addView(made.inverseBind.data(), count * sizeof(glm::mat4));
        m_skins.append(
            QJsonObject{{QStringLiteral("name"), QStringLiteral("Hair")},
                        {QStringLiteral("joints"), made.joints},
                        {QStringLiteral("skeleton"), head},
                        {QStringLiteral("inverseBindMatrices"),
                         m_buffer.addAccessor(GlbBuffer::accessor(view, 0, GlbBuffer::kFloats, count, "MAT4"))}});
        m_extensions.insert(kSpringExtension, made.springBone);
    }

    void addImage(const QString& name, const QByteArray& png)
    {
        const int view = m_buffer.addView(png.constData(), static_cast<std::size_t>(png.size()));
        m_images.append(QJsonObject{{QStringLiteral("name"), name},
                                    {QStringLiteral("mimeType"), QStringLiteral("image/png")},
                                    {QStringLiteral("bufferView"), view}});
        m_textures.append(QJsonObject{{QStringLiteral("source"), static_cast<int>(m_images.size()) - 1},
                                      {QStringLiteral("sampler"), 0}});
    }

    /// Of all cards, before any is added; its first two images are base colour and normals.
    void addCardMaterial(float roughness)
    {
        const auto texture = [](int index) { return QJsonObject{{QStringLiteral("index"), index}}; };
        m_materials.append(
            QJsonObject{{QStringLiteral("name"), QStringLiteral("Hair cards")},
                        {QStringLiteral("doubleSided"), true},
                        {QStringLiteral("alphaMode"), QStringLiteral("MASK")},
                        {QStringLiteral("alphaCutoff"), static_cast<double>(kCardCutoff)},
                        {QStringLiteral("normalTexture"), texture(1)},
                        {QStringLiteral("pbrMetallicRoughness"),
                         QJsonObject{{QStringLiteral("baseColorTexture"), texture(0)},
                                     {QStringLiteral("metallicFactor"), 0.0},
                                     {QStringLiteral("roughnessFactor"), static_cast<double>(roughness)}}}});
    }

    [[nodiscard]] QByteArray finish() const
    {
        QJsonObject root{
            {QStringLiteral("asset"), QJsonObject{{QStringLiteral("version"), QStringLiteral("2.0")},
                                                  {QStringLiteral("generator"), QStringLiteral("Hair Paint")}}},
            {QStringLiteral("scene"), 0}};
        QJsonObject scene{{QStringLiteral("name"), QStringLiteral("Hair")}};
        const auto insert = [&root](const QString& key, const QJsonArray& values) {
            if (!values.isEmpty()) // Arrays of glTF are never empty.
                root.insert(key, values);
        };
        if (!m_sceneNodes.isEmpty())
            scene.insert(QStringLiteral("nodes"), m_sceneNodes);
        insert(QStringLiteral("nodes"), m_nodes);
        insert(QStringLiteral("meshes"), m_meshes);
        insert(QStringLiteral("skins"), m_skins);
        insert(QStringLiteral("materials"), m_materials);
        insert(QStringLiteral("images"), m_images);
        insert(QStringLiteral("textures"), m_textures);
        if (!m_textures.isEmpty()) // Linear, with levels; no repetition.
            root.insert(QStringLiteral("samplers"), QJsonArray{QJsonObject{{QStringLiteral("magFilter"), 9729},
                                                                           {QStringLiteral("minFilter"), 9987},
                                                                           {QStringLiteral("wrapS"), 33071},
                                                                           {QStringLiteral("wrapT"), 33071}}});
        insert(QStringLiteral("extensionsUsed"), QJsonArray::fromStringList(m_extensions.keys()));
        if (m_extensions.contains(kSpringExtension))
            root.insert(QStringLiteral("extensions"), QJsonObject{{kSpringExtension, m_extensions[kSpringExtension]}});
        root.insert(QStringLiteral("scenes"), QJsonArray{scene});
        if (m_nodes.isEmpty())
            return glbHead(root, 0);
        const QByteArray& bin = m_buffer.describedIn(root);
        return glbHead(root, static_cast<quint32>(bin.size())) + bin;
    }

private:
    template<typename Vertex>
    [[nodiscard]] static QJsonObject withBounds(QJsonObject accessor, const std::vector<Vertex>& vertices)
    {
        glm::vec3 least(std::numeric_limits<float>::max());
        glm::vec3 greatest(std::numeric_limits<float>::lowest());
        for (const Vertex& vertex : vertices) {
            least = glm::min(least, vertex.position);
            greatest = glm::max(greatest, vertex.position);
        }
        accessor.insert(QStringLiteral("min"), jsonNumbers(least));
        accessor.insert(QStringLiteral("max"), jsonNumbers(greatest));
        return accessor;
    }
    void addMesh(const QString& name, const CardMesh& mesh)
    {
        const int vertices = m_buffer.addView(mesh.vertices.data(), mesh.vertices.size() * sizeof(CardVertex),
                                              GlbBuffer::kVertices, static_cast<int>(sizeof(CardVertex)));
        const auto attribute = [&](std::size_t offset, const char* type) {
            return GlbBuffer::accessor(vertices, offset, GlbBuffer::kFloats, mesh.vertices.size(), type);
        };
        QJsonObject attributes{
            {QStringLiteral("POSITION"),
             m_buffer.addAccessor(withBounds(attribute(offsetof(CardVertex, position), "VEC3"), mesh.vertices))},
            {QStringLiteral("NORMAL"), m_buffer.addAccessor(attribute(offsetof(CardVertex, normal), "VEC3"))},
            {QStringLiteral("TANGENT"), m_buffer.addAccessor(attribute(offsetof(CardVertex, tangent), "VEC4"))},
            {QStringLiteral("TEXCOORD_0"), m_buffer.addAccessor(attribute(offsetof(CardVertex, uv), "VEC2"))}};
        addWeights(mesh.bones, attributes);
        addNode(name, attributes, mesh.indices, 0);
    }
    void addWeights(const std::vector<BoneWeights>& bones, QJsonObject& attributes)
    {
        if (bones.empty())
            return;
        const int view = m_buffer.addView(bones.data(), bones.size() * sizeof(BoneWeights), GlbBuffer::kVertices,
                                          static_cast<int>(sizeof(BoneWeights)));
        const auto part = [&](std::size_t offset, int componentType) {
            return m_buffer.addAccessor(GlbBuffer::accessor(view, offset, componentType, bones.size(), "VEC4"));
        };
        attributes.insert(QStringLiteral("JOINTS_0"), part(offsetof(BoneWeights, joints), GlbBuffer::kShorts));
        attributes.insert(QStringLiteral("WEIGHTS_0"), part(offsetof(BoneWeights, weights), GlbBuffer::kFloats));
    }
    /// With a mesh of those triangles; with the only skin where it has weights.
    void addNode(const QString& name, const QJsonObject& attributes, const std::vector<std::uint32_t>& indices,
                 int material)
    {
        const QJsonObject primitive{{QStringLiteral("attributes"), attributes},
                                    {QStringLiteral("indices"), m_buffer.addIndices(indices)},
                                    {QStringLiteral("material"), material},
                                    {QStringLiteral("mode"), 4}};
        m_meshes.append(
            QJsonObject{{QStringLiteral("name"), name}, {QStringLiteral("primitives"), QJsonArray{primitive}}});
        QJsonObject node{{QStringLiteral("name"), name},
                         {QStringLiteral("mesh"), static_cast<int>(m_meshes.size()) - 1}};
        if (attributes.contains(QStringLiteral("WEIGHTS_0")))
            node.insert(QStringLiteral("skin"), 0);
        m_nodes.append(node);
    }
    [[nodiscard]] static QJsonObject skinMaterial(QRgb colour)
    {
        constexpr double kRoughness = 0.6;
        const auto linear = [](int value) { return linearFromSrgb(static_cast<float>(value) / 255.0F); };
        QJsonArray factor = jsonNumbers({linear(qRed(colour)), linear(qGreen(colour)), linear(qBlue(colour))});
        factor.append(1.0);
        return {{QStringLiteral("name"), QStringLiteral("Skin")},
                {QStringLiteral("pbrMetallicRoughness"), QJsonObject{{QStringLiteral("baseColorFactor"), factor},
                                                                     {QStringLiteral("metallicFactor"), 0.0},
                                                                     {QStringLiteral("roughnessFactor"), kRoughness}}}};
    }

    GlbBuffer m_buffer;
    QJsonArray m_sceneNodes, m_nodes, m_meshes, m_skins, m_materials, m_images, m_textures;
    QJsonObject m_extensions; ///< Those that are used, with what they say of the whole file.
};

} // namespace

QByteArray cardGlb(const CurveSet& curves, const HairCards& cards, const ExportSettings& settings,
                   std::span<const QByteArray> pngs)
{
    CardGlbWriter glb;
    if (!cards.patches.empty())
        glb.addCardMaterial(curves.material(curves.curves().front()).roughness);
    for (std::size_t group = 0; group < curves.groups().size(); ++group) {
        std::vector<CardMesh> levels;
        levels.reserve(cards.levels.size());
        for (const CardLevel& level : cards.levels)
            levels.push_back(cardMesh(cards, level, group));
        std::erase_if(levels, [](const CardMesh& mesh) { return mesh.indices.empty(); });
        if (!levels.empty())
            glb.addCards(curves.groups()[group].name, levels);
    }
    if (const PlacedHead head = settings.cards.withHead ? placedHead(curves) : PlacedHead{}; !head.indices.empty())
        glb.addHead(head, settings.skinColour, cards.bones.has_value());
    if (cards.patches.empty())
        return glb.finish();
    if (cards.bones)
        glb.addBones(curves, *cards.bones, settings.colliders);
    for (std::size_t i = 0; i < pngs.size(); ++i)
        if (cardImageKinds()[i].embedded)
            glb.addImage(QString::fromLatin1(cardImageKinds()[i].name), pngs[i]);
    return glb.finish();
}

} // namespace hairpaint::model
