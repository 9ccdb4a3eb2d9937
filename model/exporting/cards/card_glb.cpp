// Binary glTF (Khronos, glTF 2.0 specification): vertices and indices of each group, bones, then the images;
// VRMC_springBone 1.0 (VRM Consortium).
#include "model/exporting/cards/card_glb.h"

#include "model/exporting/cards/card_mesh.h"
#include "model/files/glb.h"

#include <glm/gtc/matrix_transform.hpp>

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr int kFloats = 5126;
constexpr int kInts = 5125;
constexpr int kShorts = 5123;
constexpr int kVertices = 34962;
constexpr int kIndices = 34963;

QJsonArray numbers(const glm::vec3& v)
{
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// Puts meshes and images into the binary chunk and describes them.
class CardGlbWriter
{
public:
    void addMesh(const QString& name, const CardMesh& mesh)
    {
        glm::vec3 least(std::numeric_limits<float>::max());
        glm::vec3 greatest(std::numeric_limits<float>::lowest());
        for (const CardVertex& vertex : mesh.vertices) {
            least = glm::min(least, vertex.position);
            greatest = glm::max(greatest, vertex.position);
        }
        const int vertices = addView(mesh.vertices.data(), mesh.vertices.size() * sizeof(CardVertex), kVertices,
                                     static_cast<int>(sizeof(CardVertex)));
        const auto attribute = [&](std::size_t offset, const char* type) {
            return accessor(vertices, offset, kFloats, mesh.vertices.size(), type);
        };
        QJsonObject position = attribute(offsetof(CardVertex, position), "VEC3");
        position.insert(QStringLiteral("min"), numbers(least));
        position.insert(QStringLiteral("max"), numbers(greatest));
        QJsonObject attributes{
            {QStringLiteral("POSITION"), addAccessor(position)},
            {QStringLiteral("NORMAL"), addAccessor(attribute(offsetof(CardVertex, normal), "VEC3"))},
            {QStringLiteral("TANGENT"), addAccessor(attribute(offsetof(CardVertex, tangent), "VEC4"))},
            {QStringLiteral("TEXCOORD_0"), addAccessor(attribute(offsetof(CardVertex, uv), "VEC2"))}};
        if (!mesh.bones.empty()) {
            const int bones = addView(mesh.bones.data(), mesh.bones.size() * sizeof(BoneWeights), kVertices,
                                      static_cast<int>(sizeof(BoneWeights)));
            const auto part = [&](std::size_t offset, int componentType) {
                return addAccessor(accessor(bones, offset, componentType, mesh.bones.size(), "VEC4"));
            };
            attributes.insert(QStringLiteral("JOINTS_0"), part(offsetof(BoneWeights, joints), kShorts));
            attributes.insert(QStringLiteral("WEIGHTS_0"), part(offsetof(BoneWeights, weights), kFloats));
        }
        const int indices = addView(mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t), kIndices, 0);
        const QJsonObject primitive{
            {QStringLiteral("attributes"), attributes},
            {QStringLiteral("indices"), addAccessor(accessor(indices, 0, kInts, mesh.indices.size(), "SCALAR"))},
            {QStringLiteral("material"), 0},
            {QStringLiteral("mode"), 4}};
        m_meshes.append(
            QJsonObject{{QStringLiteral("name"), name}, {QStringLiteral("primitives"), QJsonArray{primitive}}});
        QJsonObject node{{QStringLiteral("name"), name},
                         {QStringLiteral("mesh"), static_cast<int>(m_meshes.size()) - 1}};
        if (!mesh.bones.empty())
            node.insert(QStringLiteral("skin"), 0);
        m_sceneNodes.append(static_cast<int>(m_nodes.size()));
        m_nodes.append(node);
    }

    /// A joint for the head and those of the chains below it; the skin of all meshes.
    void addBones(const CurveSet& curves, const CardBones& bones, std::span<const sim::Ellipsoid> colliders)
    {
        const auto head = static_cast<int>(m_nodes.size());
        const glm::vec3 headWo = curves.groups().front().middleWo;
        std::vector<glm::mat4> inverse{glm::translate(glm::mat4(1.0F), -headWo)};
        QJsonArray joints{head};
        QJsonArray chains;
        QJsonArray springs;
        QJsonArray below;
        for (std::size_t chain = 0; chain < bones.chains.size(); ++chain) {
            const BoneChain& own = bones.chains[chain];
            const QString name = QStringLiteral("%1 %2").arg(curves.groups()[own.group].name).arg(chain + 1);
            QJsonArray links;
            for (std::size_t j = 0; j < BoneChain::kJoints; ++j) {
                const int node = head + 1 + static_cast<int>(BoneChain::kJoints * chain + j);
                const glm::vec3 parentWo = j > 0 ? own.jointsWo.at(j - 1) : headWo;
                QJsonObject joint{{QStringLiteral("name"), QStringLiteral("%1.%2").arg(name).arg(j + 1)},
                                  {QStringLiteral("translation"), numbers(own.jointsWo.at(j) - parentWo)}};
                if (j + 1 < BoneChain::kJoints)
                    joint.insert(QStringLiteral("children"), QJsonArray{node + 1});
                chains.append(joint);
                joints.append(node);
                links.append(springJoint(node, curves.physics(own.group)));
                inverse.push_back(glm::translate(glm::mat4(1.0F), -own.jointsWo.at(j)));
                if (j == 0)
                    below.append(node);
            }
            QJsonObject spring{{QStringLiteral("name"), name}, {QStringLiteral("joints"), links}};
            if (!colliders.empty())
                spring.insert(QStringLiteral("colliderGroups"), QJsonArray{0});
            springs.append(spring);
        }
        m_sceneNodes.append(head);
        m_nodes.append(QJsonObject{{QStringLiteral("name"), QStringLiteral("Head")},
                                   {QStringLiteral("translation"), numbers(headWo)},
                                   {QStringLiteral("children"), below}});
        for (const auto& joint : std::as_const(chains))
            m_nodes.append(joint);
        const int view = addView(inverse.data(), inverse.size() * sizeof(glm::mat4), 0, 0);
        m_skins.append(QJsonObject{
            {QStringLiteral("name"), QStringLiteral("Hair")},
            {QStringLiteral("joints"), joints},
            {QStringLiteral("skeleton"), head},
            {QStringLiteral("inverseBindMatrices"), addAccessor(accessor(view, 0, kFloats, inverse.size(), "MAT4"))}});
        m_springBone = {{QStringLiteral("specVersion"), QStringLiteral("1.0")}, {QStringLiteral("springs"), springs}};
        if (!colliders.empty())
            addColliders(head, headWo, curves.pose(), colliders);
    }

    void addImage(const QString& name, const QByteArray& png)
    {
        const int view = addView(png.constData(), static_cast<std::size_t>(png.size()), 0, 0);
        m_images.append(QJsonObject{{QStringLiteral("name"), name},
                                    {QStringLiteral("mimeType"), QStringLiteral("image/png")},
                                    {QStringLiteral("bufferView"), view}});
        m_textures.append(QJsonObject{{QStringLiteral("source"), static_cast<int>(m_images.size()) - 1},
                                      {QStringLiteral("sampler"), 0}});
    }

    /// The first two images are base colour and normals.
    [[nodiscard]] QByteArray finish(float roughness) const
    {
        QJsonObject root{
            {QStringLiteral("asset"), QJsonObject{{QStringLiteral("version"), QStringLiteral("2.0")},
                                                  {QStringLiteral("generator"), QStringLiteral("Hair Paint")}}},
            {QStringLiteral("scene"), 0}};
        QJsonObject scene{{QStringLiteral("name"), QStringLiteral("Hair")}};
        if (!m_nodes.isEmpty()) { // Arrays of glTF are never empty.
            scene.insert(QStringLiteral("nodes"), m_sceneNodes);
            root.insert(QStringLiteral("nodes"), m_nodes);
            root.insert(QStringLiteral("meshes"), m_meshes);
            if (!m_skins.isEmpty()) {
                const QString extension = QStringLiteral("VRMC_springBone");
                root.insert(QStringLiteral("skins"), m_skins);
                root.insert(QStringLiteral("extensionsUsed"), QJsonArray{extension});
                root.insert(QStringLiteral("extensions"), QJsonObject{{extension, m_springBone}});
            }
            root.insert(QStringLiteral("materials"), QJsonArray{material(roughness)});
            root.insert(QStringLiteral("images"), m_images);
            root.insert(QStringLiteral("textures"), m_textures);
            // Linear, with levels; no repetition.
            root.insert(QStringLiteral("samplers"), QJsonArray{QJsonObject{{QStringLiteral("magFilter"), 9729},
                                                                           {QStringLiteral("minFilter"), 9987},
                                                                           {QStringLiteral("wrapS"), 33071},
                                                                           {QStringLiteral("wrapT"), 33071}}});
            root.insert(QStringLiteral("accessors"), m_accessors);
            root.insert(QStringLiteral("bufferViews"), m_views);
            root.insert(QStringLiteral("buffers"),
                        QJsonArray{QJsonObject{{QStringLiteral("byteLength"), m_bin.size()}}});
        }
        root.insert(QStringLiteral("scenes"), QJsonArray{scene});
        return glbHead(root, static_cast<quint32>(m_bin.size())) + m_bin;
    }

private:
    /// Units of VRMC_springBone 1.0: 1 is a usual stiffness, 0.4 a usual drag.
    [[nodiscard]] static QJsonObject springJoint(int node, const sim::PhysicsSettings& physics)
    {
        constexpr float kHitRadiusM = 0.01F;
        constexpr float kStiffnessPerM = 20.0F;
        constexpr float kGravity = 0.3F;
        constexpr float kDragSeconds = 0.2F;
        const auto number = [](float value) { return static_cast<double>(value); };
        return {{QStringLiteral("node"), node},
                {QStringLiteral("hitRadius"), number(kHitRadiusM)},
                {QStringLiteral("stiffness"), number(kStiffnessPerM * physics.stiffnessM)},
                {QStringLiteral("gravityPower"), number(kGravity * physics.gravityScale)},
                {QStringLiteral("gravityDir"), QJsonArray{0.0, -1.0, 0.0}},
                {QStringLiteral("dragForce"), number(std::clamp(kDragSeconds * physics.damping, 0.0F, 1.0F))}};
    }
    /// An ellipsoid becomes the capsule along its longest axis.
    void addColliders(int head, const glm::vec3& headWo, const sim::HeadPose& pose,
                      std::span<const sim::Ellipsoid> colliders)
    {
        QJsonArray shapes;
        QJsonArray all;
        for (const sim::Ellipsoid& ellipsoid : colliders) {
            const glm::vec3& axes = ellipsoid.semiAxesM;
            const int longest = axes.x > axes.y ? (axes.x > axes.z ? 0 : 2) : (axes.y > axes.z ? 1 : 2);
            const float radius = 0.5F * (axes[(longest + 1) % 3] + axes[(longest + 2) % 3]);
            glm::vec3 half(0.0F);
            half[longest] = std::max(axes[longest] - radius, 0.0F);
            half = pose.rotation * (ellipsoid.rotation * half);
            const glm::vec3 centre = pose.rotation * ellipsoid.centreHd + pose.positionWo - headWo;
            const QJsonObject capsule{{QStringLiteral("offset"), numbers(centre - half)},
                                      {QStringLiteral("radius"), static_cast<double>(radius)},
                                      {QStringLiteral("tail"), numbers(centre + half)}};
            all.append(static_cast<int>(shapes.size()));
            shapes.append(QJsonObject{{QStringLiteral("node"), head},
                                      {QStringLiteral("shape"), QJsonObject{{QStringLiteral("capsule"), capsule}}}});
        }
        m_springBone.insert(QStringLiteral("colliders"), shapes);
        m_springBone.insert(QStringLiteral("colliderGroups"),
                            QJsonArray{QJsonObject{{QStringLiteral("name"), QStringLiteral("Head")},
                                                   {QStringLiteral("colliders"), all}}});
    }
    [[nodiscard]] static QJsonObject material(float roughness)
    {
        const auto texture = [](int index) { return QJsonObject{{QStringLiteral("index"), index}}; };
        return {{QStringLiteral("name"), QStringLiteral("Hair cards")},
                {QStringLiteral("doubleSided"), true},
                {QStringLiteral("alphaMode"), QStringLiteral("MASK")},
                {QStringLiteral("alphaCutoff"), static_cast<double>(kCardCutoff)},
                {QStringLiteral("normalTexture"), texture(1)},
                {QStringLiteral("pbrMetallicRoughness"),
                 QJsonObject{{QStringLiteral("baseColorTexture"), texture(0)},
                             {QStringLiteral("metallicFactor"), 0.0},
                             {QStringLiteral("roughnessFactor"), static_cast<double>(roughness)}}}};
    }
    int addView(const void* data, std::size_t bytes, int target, int stride)
    {
        QJsonObject view{{QStringLiteral("buffer"), 0},
                         {QStringLiteral("byteOffset"), m_bin.size()},
                         {QStringLiteral("byteLength"), static_cast<qsizetype>(bytes)}};
        if (target > 0)
            view.insert(QStringLiteral("target"), target);
        if (stride > 0)
            view.insert(QStringLiteral("byteStride"), stride);
        m_bin.append(static_cast<const char*>(data), static_cast<qsizetype>(bytes));
        while (m_bin.size() % 4 != 0)
            m_bin.append('\0');
        m_views.append(view);
        return static_cast<int>(m_views.size()) - 1;
    }
    [[nodiscard]] static QJsonObject accessor(int view, std::size_t offset, int componentType, std::size_t count,
                                              const char* type)
    {
        return {{QStringLiteral("bufferView"), view},
                {QStringLiteral("byteOffset"), static_cast<int>(offset)},
                {QStringLiteral("componentType"), componentType},
                {QStringLiteral("count"), static_cast<qsizetype>(count)},
                {QStringLiteral("type"), QLatin1String(type)}};
    }
    int addAccessor(const QJsonObject& accessor)
    {
        m_accessors.append(accessor);
        return static_cast<int>(m_accessors.size()) - 1;
    }

    QJsonArray m_sceneNodes, m_nodes, m_meshes, m_skins, m_images, m_textures, m_accessors, m_views;
    QJsonObject m_springBone;
    QByteArray m_bin;
};

} // namespace

QByteArray cardGlb(const CurveSet& curves, const HairCards& cards, std::span<const sim::Ellipsoid> colliders,
                   std::span<const QByteArray> pngs)
{
    CardGlbWriter glb;
    for (std::size_t group = 0; group < curves.groups().size(); ++group)
        if (const CardMesh mesh = cardMesh(cards, group); !mesh.indices.empty())
            glb.addMesh(curves.groups()[group].name, mesh);
    if (cards.patches.empty())
        return glb.finish(1.0F);
    if (cards.bones)
        glb.addBones(curves, *cards.bones, colliders);
    for (std::size_t i = 0; i < pngs.size(); ++i)
        if (cardImageKinds()[i].embedded)
            glb.addImage(QString::fromLatin1(cardImageKinds()[i].name), pngs[i]);
    return glb.finish(curves.material(curves.curves().front()).roughness);
}

} // namespace hairpaint::model
