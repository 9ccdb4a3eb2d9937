// Binary glTF (Khronos, glTF 2.0 specification): vertices and indices of each group in each level, the head, bones,
// then the images.
#include "model/cards/card_glb.h"

#include "model/cards/avatar_glb.h"
#include "model/cards/bone_glb.h"
#include "model/cards/card_mesh.h"
#include "model/cards/worn_springs.h"
#include "model/exporting/glb_buffer.h"
#include "model/exporting/worn_body.h"
#include "model/files/glb_writing.h"
#include "model/values/srgb.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr QLatin1StringView kLevelExtension("MSFT_lod");
constexpr QLatin1StringView kSpringExtension("VRMC_springBone");
constexpr QLatin1StringView kAvatarExtension("VRMC_vrm");

/// By level: the least fraction of the picture's height at which the level is shown; below it the next one is.
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

    /// `bones`: one a vertex, or none where nothing holds it. `skin`: whose joints these are.
    void addHead(const PosedMesh& head, QRgb colour, const std::shared_ptr<const sim::MeshTexture>& shown,
                 const std::vector<BoneWeights>& bones, int skin)
    {
        constexpr double kRoughness = 0.6;
        const HeadPart own{.name = "Skin", .colour = glm::vec3(1.0F), .texture = shown, .mesh = {}};
        addBody(QStringLiteral("Head mesh"), head,
                shown ? partMaterial(own) : material(QStringLiteral("Skin"), colour, kRoughness), bones, skin);
    }

    /// With the head; as addHead() has them.
    void addPart(const PosedMesh& mesh, const HeadPart& part, const std::vector<BoneWeights>& bones, int skin)
    {
        addBody(QString::fromStdString(part.name), mesh, partMaterial(part), bones, skin);
    }
    /// How many images are added before those of parts and of what is worn.
    void reserveImages(int count) { m_firstPartTexture = count; }
    /// After all others.
    void addPartImages()
    {
        for (std::size_t i = 0; i < m_partTextures.size(); ++i) {
            addImage(QStringLiteral("Part %1").arg(i + 1), pngOfTexture(*m_partTextures[i]));
            QJsonObject texture = m_textures.last().toObject();
            texture[QStringLiteral("sampler")] = 1; // It repeats.
            m_textures.replace(m_textures.size() - 1, texture);
        }
    }

    /// With the head; as addHead() has them.
    void addWorn(const WornBody& body, const std::vector<BoneWeights>& bones, int skin)
    {
        QJsonObject own = material(body.name, body.colour, body.roughness);
        if (body.isOpen)
            own.insert(QStringLiteral("doubleSided"), true);
        if (body.texture) {
            QJsonObject surface = own[QLatin1StringView("pbrMetallicRoughness")].toObject();
            surface.insert(QStringLiteral("baseColorTexture"), partTexture(body.texture));
            own.insert(QStringLiteral("pbrMetallicRoughness"), surface);
        }
        insertAlpha(body.alpha, own);
        addBody(body.name, body.mesh, own, bones, skin);
    }

    /// A thing whose parts that hang swing: its chains are added to `springs`. With the first skin, whose joints are
    /// the head and then theirs.
    void addSwinging(const WornBody& body, std::vector<SpringChain>& springs)
    {
        std::size_t joint = 1;
        for (const SpringChain& spring : springs)
            joint += spring.joints.size();
        const std::vector<SpringChain> own = springsOf(body);
        addWorn(body, springWeights(body, own, joint), 0);
        springs.insert(springs.end(), own.begin(), own.end());
    }

    /// The chains hang from a joint that is made for them.
    void addBones(const CurveSet& curves, std::span<const SpringChain> springs,
                  std::span<const sim::Ellipsoid> colliders)
    {
        const BoneRoot root{.node = static_cast<int>(m_nodes.size()),
                            .pose = {.position = curves.groups().front().middleWo}};
        const JointPose head{.position = curves.pose().positionWo, .rotation = curves.pose().rotation};
        m_sceneNodes.append(root.node);
        m_nodes.append(QJsonObject{{QStringLiteral("name"), QStringLiteral("Head")},
                                   {QStringLiteral("translation"), jsonNumbers(root.pose.position)}});
        addChains(boneGlb(springs, colliders, head, root, root.node + 1), root.node);
    }

    /// The skeleton with what VRM says of it, as the second skin where there is something that swings. The chains hang
    /// from its head.
    void addAvatar(std::span<const SpringChain> springs, const ExportSettings& settings, const AvatarBody& body)
    {
        const auto first = static_cast<int>(m_nodes.size());
        const AvatarGlb made = avatarGlb(*settings.avatar, body, first);
        m_sceneNodes.append(first);
        for (const auto& node : made.nodes)
            m_nodes.append(node);
        if (!springs.empty()) {
            const BoneRoot root{.node = made.headNode,
                                .pose = body.poses[static_cast<std::size_t>(made.headNode - first)]};
            addChains(boneGlb(springs, contactShapes(settings.worn), {.rotation = body.turn}, root,
                              static_cast<int>(m_nodes.size())),
                      made.headNode);
        }
        addSkin(QStringLiteral("Body"), made.joints, made.inverseBind);
        m_extensions.insert(kAvatarExtension, made.vrm);
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

    /// Adds the one material of all cards, before any card is added. The first two images are base colour and normals.
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
        if (!m_textures.isEmpty()) { // Linear, with levels; no repetition, but for parts and what is worn.
            QJsonArray samplers{QJsonObject{{QStringLiteral("magFilter"), 9729},
                                            {QStringLiteral("minFilter"), 9987},
                                            {QStringLiteral("wrapS"), 33071},
                                            {QStringLiteral("wrapT"), 33071}}};
            if (!m_partTextures.empty())
                samplers.append(QJsonObject{{QStringLiteral("magFilter"), 9729}, {QStringLiteral("minFilter"), 9987}});
            root.insert(QStringLiteral("samplers"), samplers);
        }
        insert(QStringLiteral("extensionsUsed"), QJsonArray::fromStringList(m_extensions.keys()));
        QJsonObject whole;
        for (const QLatin1StringView name : {kSpringExtension, kAvatarExtension})
            if (m_extensions.contains(name))
                whole.insert(name, m_extensions[name]);
        if (!whole.isEmpty())
            root.insert(QStringLiteral("extensions"), whole);
        root.insert(QStringLiteral("scenes"), QJsonArray{scene});
        if (m_nodes.isEmpty())
            return glbHead(root, 0);
        const QByteArray& bin = m_buffer.describedIn(root);
        return glbHead(root, static_cast<quint32>(bin.size())) + bin;
    }

private:
    void addBody(const QString& name, const PosedMesh& mesh, const QJsonObject& material,
                 const std::vector<BoneWeights>& bones, int skin)
    {
        const int view = m_buffer.addView(mesh.vertices.data(), mesh.vertices.size() * sizeof(HeadVertexOut),
                                          GlbBuffer::kVertices, static_cast<int>(sizeof(HeadVertexOut)));
        const auto attribute = [&](std::size_t offset, const char* type) {
            return GlbBuffer::accessor(view, offset, GlbBuffer::kFloats, mesh.vertices.size(), type);
        };
        QJsonObject attributes{
            {QStringLiteral("POSITION"),
             m_buffer.addAccessor(withBounds(attribute(offsetof(HeadVertexOut, position), "VEC3"), mesh.vertices))},
            {QStringLiteral("NORMAL"), m_buffer.addAccessor(attribute(offsetof(HeadVertexOut, normal), "VEC3"))},
            {QStringLiteral("TEXCOORD_0"), m_buffer.addAccessor(attribute(offsetof(HeadVertexOut, uv), "VEC2"))}};
        addWeights(bones, attributes);
        m_materials.append(material);
        m_sceneNodes.append(static_cast<int>(m_nodes.size()));
        addNode(name, attributes, mesh.indices, static_cast<int>(m_materials.size()) - 1, skin);
    }
    void addSkin(const QString& name, const QJsonArray& joints, const std::vector<glm::mat4>& inverseBind)
    {
        const int view = m_buffer.addView(inverseBind.data(), inverseBind.size() * sizeof(glm::mat4));
        m_skins.append(QJsonObject{
            {QStringLiteral("name"), name},
            {QStringLiteral("joints"), joints},
            {QStringLiteral("skeleton"), joints.first()},
            {QStringLiteral("inverseBindMatrices"),
             m_buffer.addAccessor(GlbBuffer::accessor(view, 0, GlbBuffer::kFloats, inverseBind.size(), "MAT4"))}});
    }
    /// As the first skin. `root`: the number of the node that they hang from.
    void addChains(const BoneGlb& made, int root)
    {
        QJsonObject node = m_nodes[root].toObject();
        QJsonArray children = node.value(QStringLiteral("children")).toArray();
        for (const auto& child : made.below)
            children.append(child);
        node.insert(QStringLiteral("children"), children);
        m_nodes.replace(root, node);
        for (const auto& joint : made.nodes)
            m_nodes.append(joint);
        addSkin(QStringLiteral("Hair"), made.joints, made.inverseBind);
        m_extensions.insert(kSpringExtension, made.springBone);
    }
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
        addNode(name, attributes, mesh.indices, 0, 0);
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
    /// With a mesh of those triangles; with that skin where it has weights.
    void addNode(const QString& name, const QJsonObject& attributes, const std::vector<std::uint32_t>& indices,
                 int material, int skin)
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
            node.insert(QStringLiteral("skin"), skin);
        m_nodes.append(node);
    }
    /// The image goes out behind all others.
    [[nodiscard]] QJsonObject partTexture(const std::shared_ptr<const sim::MeshTexture>& texture)
    {
        auto known = std::ranges::find(m_partTextures, texture);
        if (known == m_partTextures.end())
            known = m_partTextures.insert(known, texture);
        const auto number = m_firstPartTexture + static_cast<int>(known - m_partTextures.begin());
        return {{QStringLiteral("index"), number}};
    }
    [[nodiscard]] QJsonObject partMaterial(const HeadPart& part)
    {
        constexpr double kRoughness = 0.7;
        QJsonArray factor = jsonNumbers(part.colour);
        factor.append(1.0);
        QJsonObject surface{{QStringLiteral("baseColorFactor"), factor},
                            {QStringLiteral("metallicFactor"), 0.0},
                            {QStringLiteral("roughnessFactor"), kRoughness}};
        if (part.texture)
            surface.insert(QStringLiteral("baseColorTexture"), partTexture(part.texture));
        QJsonObject made{{QStringLiteral("name"), QString::fromStdString(part.name)},
                         {QStringLiteral("pbrMetallicRoughness"), surface}};
        insertAlpha(part.alpha, made);
        if (part.doubleSided)
            made.insert(QStringLiteral("doubleSided"), true);
        return made;
    }
    [[nodiscard]] static QJsonObject material(const QString& name, QRgb colour, double roughness)
    {
        const auto linear = [](int value) { return linearFromSrgb(static_cast<float>(value) / 255.0F); };
        QJsonArray factor = jsonNumbers({linear(qRed(colour)), linear(qGreen(colour)), linear(qBlue(colour))});
        factor.append(1.0);
        return {{QStringLiteral("name"), name},
                {QStringLiteral("pbrMetallicRoughness"), QJsonObject{{QStringLiteral("baseColorFactor"), factor},
                                                                     {QStringLiteral("metallicFactor"), 0.0},
                                                                     {QStringLiteral("roughnessFactor"), roughness}}}};
    }

    GlbBuffer m_buffer;
    int m_firstPartTexture = 0;
    std::vector<std::shared_ptr<const sim::MeshTexture>> m_partTextures;
    QJsonArray m_sceneNodes, m_nodes, m_meshes, m_skins, m_materials, m_images, m_textures;
    QJsonObject m_extensions; ///< Those that are used, with what they say of the whole file.
};

} // namespace

QByteArray cardGlb(const CurveSet& curves, const HairCards& cards, const ExportSettings& settings,
                   std::span<const QByteArray> pngs)
{
    CardGlbWriter glb;
    int images = 0;
    for (std::size_t i = 0; i < pngs.size() && !cards.patches.empty(); ++i)
        images += cardImageKinds()[i].embedded ? 1 : 0;
    glb.reserveImages(images);
    const Avatar* const avatar = settings.avatar.get();
    const AvatarBody body = avatar != nullptr ? avatarBody(*avatar) : AvatarBody{};
    JointPose frame; // The frame of the hair's space (Wo) in the space of the file.
    if (avatar != nullptr) {
        frame.rotation = body.turn * glm::conjugate(curves.pose().rotation);
        frame.position = frame.rotation * -curves.pose().positionWo;
    }
    if (!cards.patches.empty())
        glb.addCardMaterial(curves.material(curves.curves().front()).roughness);
    for (std::size_t group = 0; group < curves.groups().size(); ++group) {
        std::vector<CardMesh> levels;
        levels.reserve(cards.levels.size());
        for (const CardLevel& level : cards.levels)
            levels.push_back(avatar != nullptr ? movedMesh(cardMesh(cards, level, group), frame)
                                               : cardMesh(cards, level, group));
        std::erase_if(levels, [](const CardMesh& mesh) { return mesh.indices.empty(); });
        if (!levels.empty())
            glb.addCards(curves.groups()[group].name, levels);
    }
    std::vector<SpringChain> springs =
        cards.bones ? springsOf(curves, cards.bones->chains, frame) : std::vector<SpringChain>();
    if (avatar != nullptr) {
        const int skin = springs.empty() ? 0 : 1;
        glb.addHead(body.mesh, settings.skinColour, settings.headTexture, avatar->skeleton.weights, skin);
        for (std::size_t i = 0; i < body.parts.size(); ++i)
            glb.addPart(body.parts[i], avatar->parts[i], avatar->partWeights[i], skin);
        const BoneWeights headBone{.joints = {static_cast<std::uint16_t>(avatar->bones[HumanBone::Head])}};
        for (const Worn& worn : settings.worn) {
            for (const WornBody& thing : turnedBodies(curves, worn, body.turn))
                if (springs.empty() || thing.hanging.empty())
                    glb.addWorn(thing, std::vector<BoneWeights>(thing.mesh.vertices.size(), headBone), skin);
                else
                    glb.addSwinging(thing, springs);
        }
        glb.addAvatar(springs, settings, body);
    } else {
        const bool swings = !springs.empty();
        const auto held = [swings](const PosedMesh& mesh) {
            return std::vector<BoneWeights>(swings ? mesh.vertices.size() : 0);
        };
        const PosedMesh head = settings.cards.withHead ? posedHead(curves) : PosedMesh{};
        if (!head.indices.empty()) {
            glb.addHead(head, settings.skinColour, settings.headTexture, held(head), 0);
            for (const HeadPart& part : settings.parts) {
                const PosedMesh own = posedPart(curves, part);
                glb.addPart(own, part, held(own), 0);
            }
        }
        for (const WornBody& thing : wornBodies(curves, settings.worn))
            swings ? glb.addSwinging(thing, springs) : glb.addWorn(thing, {}, 0);
    }
    if (cards.patches.empty()) {
        glb.addPartImages();
        return glb.finish();
    }
    if (!springs.empty() && avatar == nullptr)
        glb.addBones(curves, springs, contactShapes(settings.worn));
    for (std::size_t i = 0; i < pngs.size(); ++i)
        if (cardImageKinds()[i].embedded)
            glb.addImage(QString::fromLatin1(cardImageKinds()[i].name), pngs[i]);
    glb.addPartImages();
    return glb.finish();
}

} // namespace hairpaint::model
