// Nodes in the order of the scene, meshes where they hang, skins, and files beside the model.
#include "app/importer/gltf_scene.h"

#include "app/importer/gltf_primitive.h"
#include "app/importer/gltf_uri.h"
#include "app/importer/model_folder.h"
#include "sim/skin/head_limits.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace hairpaint::importer {

namespace {

template<typename T>
using Read = tl::expected<T, wire::Refusal>;

/// Those that leave the mesh as it is, or are followed.
bool isKnownExtension(std::string_view name)
{
    constexpr std::array kKnown = {"KHR_mesh_quantization",
                                   "KHR_texture_transform",
                                   "KHR_draco_mesh_compression",
                                   "EXT_meshopt_compression",
                                   "KHR_texture_basisu",
                                   "KHR_meshopt_compression",
                                   "EXT_texture_webp",
                                   "EXT_texture_avif",
                                   "MSFT_texture_dds",
                                   "KHR_lights_punctual",
                                   "EXT_lights_image_based",
                                   "KHR_animation_pointer",
                                   "KHR_node_visibility",
                                   "MSFT_lod",
                                   "VRM",
                                   "KHR_xmp",
                                   "KHR_xmp_json_ld"};
    constexpr std::array kFamilies = {"KHR_materials_", "KHR_technique", "EXT_materials_", "VRMC_", "KHR_audio"};
    return std::ranges::find(kKnown, name) != kKnown.end() ||
           std::ranges::any_of(kFamilies, [name](std::string_view family) { return name.starts_with(family); });
}

glm::mat4 transformOf(const tinygltf::Node& node)
{
    glm::mat4 matrix(1.0F);
    if (node.matrix.size() == 16) {
        for (int i = 0; i < 16; ++i)
            matrix[i / 4][i % 4] = static_cast<float>(node.matrix[static_cast<std::size_t>(i)]);
        return matrix;
    }
    const auto number = [](const std::vector<double>& numbers, std::size_t i) {
        return static_cast<float>(numbers[i]);
    };
    if (node.translation.size() == 3)
        matrix = glm::translate(
            matrix, {number(node.translation, 0), number(node.translation, 1), number(node.translation, 2)});
    if (node.rotation.size() == 4)
        matrix *= glm::mat4_cast(glm::quat(number(node.rotation, 3), number(node.rotation, 0), number(node.rotation, 1),
                                           number(node.rotation, 2)));
    if (node.scale.size() == 3)
        matrix = glm::scale(matrix, {number(node.scale, 0), number(node.scale, 1), number(node.scale, 2)});
    return matrix;
}

class SceneMaker
{
public:
    SceneMaker(const GltfFile& file, const BufferReader& reader)
        : m_file(file), m_data(file, reader), m_own(file.model.nodes.size(), -1), m_parents(file.model.nodes.size(), -1)
    {}
    [[nodiscard]] Read<ForeignScene> make();

private:
    [[nodiscard]] bool exists(int node) const
    {
        return node >= 0 && static_cast<std::size_t>(node) < m_file.model.nodes.size();
    }
    [[nodiscard]] const tinygltf::Node& at(int node) const
    {
        return m_file.model.nodes[static_cast<std::size_t>(node)];
    }
    [[nodiscard]] std::vector<int> rootsOfScene() const;
    void findParents();
    /// The node and all below it that are not there yet.
    void addTree(int root, int parent);
    /// Joints may stand outside of the scene that holds their mesh.
    void addJointsElsewhere();
    [[nodiscard]] Read<void> addMeshes();
    [[nodiscard]] Read<void> addMesh(int node);
    [[nodiscard]] Read<const GltfSkin*> skin(int index);
    /// What can't be had is left out: a character without its textures is better than none.
    void addMaterials();
    void addImages();

    const GltfFile& m_file;
    GltfData m_data;
    ForeignScene m_scene{};
    std::vector<int> m_own;     ///< By the file's node, the scene's; -1 where it is not there.
    std::vector<int> m_parents; ///< By the file's node.
    std::map<int, GltfSkin> m_skins{};
    std::map<std::pair<int, int>, std::vector<int>> m_meshes{}; ///< By mesh and skin, the scene's.
    std::size_t m_triangles = 0;
};

std::vector<int> SceneMaker::rootsOfScene() const
{
    const std::vector<tinygltf::Scene>& scenes = m_file.model.scenes;
    const auto shown = static_cast<std::size_t>(std::max(m_file.model.defaultScene, 0));
    std::vector<int> roots;
    if (!scenes.empty())
        roots = scenes[shown < scenes.size() ? shown : 0].nodes;
    else
        for (std::size_t i = 0; i < m_parents.size(); ++i)
            if (m_parents[i] < 0)
                roots.push_back(static_cast<int>(i));
    std::erase_if(roots, [this](int node) { return !exists(node); });
    return roots;
}

void SceneMaker::findParents()
{
    for (std::size_t i = 0; i < m_parents.size(); ++i)
        for (const int child : m_file.model.nodes[i].children)
            if (exists(child) && m_parents[static_cast<std::size_t>(child)] < 0)
                m_parents[static_cast<std::size_t>(child)] = static_cast<int>(i);
}

void SceneMaker::addTree(int root, int parent)
{
    std::vector<std::pair<int, int>> open{{root, parent}};
    while (!open.empty()) {
        const auto [node, above] = open.back();
        open.pop_back();
        if (!exists(node) || m_own[static_cast<std::size_t>(node)] >= 0)
            continue;
        const auto own = static_cast<int>(m_scene.nodes.size());
        m_own[static_cast<std::size_t>(node)] = own;
        const auto bone = m_file.bones.find(node);
        m_scene.nodes.push_back({.name = at(node).name,
                                 .boneName = bone == m_file.bones.end() ? std::string() : bone->second,
                                 .parent = above,
                                 .toParent = transformOf(at(node))});
        if (above >= 0)
            m_scene.nodes[static_cast<std::size_t>(above)].children.push_back(own);
        std::vector<int> children = at(node).children;
        std::ranges::reverse(children);
        for (const int child : children)
            open.emplace_back(child, own);
    }
}

void SceneMaker::addJointsElsewhere()
{
    for (const tinygltf::Skin& skin : m_file.model.skins)
        for (int joint : skin.joints) {
            if (!exists(joint) || m_own[static_cast<std::size_t>(joint)] >= 0)
                continue;
            for (std::size_t steps = 0; steps < m_parents.size(); ++steps) {
                const int parent = m_parents[static_cast<std::size_t>(joint)];
                if (parent < 0 || m_own[static_cast<std::size_t>(parent)] >= 0)
                    break;
                joint = parent;
            }
            addTree(joint, 0);
        }
}

Read<const GltfSkin*> SceneMaker::skin(int index)
{
    if (index < 0 || static_cast<std::size_t>(index) >= m_file.model.skins.size())
        return nullptr;
    const auto [known, isNew] = m_skins.try_emplace(index);
    GltfSkin& own = known->second;
    if (!isNew)
        return &own;
    const tinygltf::Skin& told = m_file.model.skins[static_cast<std::size_t>(index)];
    std::vector<float> matrices;
    if (told.inverseBindMatrices >= 0) {
        Read<std::vector<float>> read = m_data.floats(told.inverseBindMatrices, 16, sim::kMostVertices);
        if (!read)
            return tl::unexpected(read.error());
        matrices = std::move(*read);
    }
    std::map<int, std::int32_t> bones; // By node: a list may name one twice.
    for (std::size_t slot = 0; slot < told.joints.size(); ++slot) {
        const int node = exists(told.joints[slot]) ? m_own[static_cast<std::size_t>(told.joints[slot])] : -1;
        if (node < 0) {
            own.slots.push_back(-1);
            continue;
        }
        const auto [bone, isFirst] = bones.try_emplace(node, static_cast<std::int32_t>(own.bones.size()));
        own.slots.push_back(bone->second);
        if (!isFirst)
            continue;
        SceneBone& added = own.bones.emplace_back();
        added.node = node;
        for (std::size_t i = 0; 16 * slot + 15 < matrices.size() && i < 16; ++i)
            added.meshToNode[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = matrices[16 * slot + i];
    }
    return &own;
}

Read<void> SceneMaker::addMesh(int node)
{
    const tinygltf::Node& told = at(node);
    std::vector<int>& there = m_scene.nodes[static_cast<std::size_t>(m_own[static_cast<std::size_t>(node)])].meshes;
    if (told.mesh < 0 || static_cast<std::size_t>(told.mesh) >= m_file.model.meshes.size())
        return {};
    // A mesh of several nodes is one, but for what it is morphed by.
    const bool isShared = told.weights.empty();
    const std::pair key(told.mesh, told.skin);
    if (const auto known = m_meshes.find(key); isShared && known != m_meshes.end()) {
        there = known->second;
        return {};
    }
    const Read<const GltfSkin*> skin = this->skin(told.skin);
    if (!skin)
        return tl::unexpected(skin.error());
    const tinygltf::Mesh& mesh = m_file.model.meshes[static_cast<std::size_t>(told.mesh)];
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
        Read<SceneMesh> read = gltfPrimitive(m_data, m_file, primitive, *skin, isShared ? mesh.weights : told.weights);
        if (!read)
            return tl::unexpected(read.error());
        m_triangles += read->triangles.size();
        if (m_triangles > sim::kMostTriangles)
            return tl::unexpected(wire::Reason::TooLarge);
        if (read->triangles.empty())
            continue;
        read->name = mesh.name;
        there.push_back(static_cast<int>(m_scene.meshes.size()));
        m_scene.meshes.push_back(std::move(*read));
    }
    if (isShared)
        m_meshes.emplace(key, there);
    return {};
}

Read<void> SceneMaker::addMeshes()
{
    const std::vector<int> own = m_own; // What joints elsewhere bring along is no part of the scene.
    addJointsElsewhere();
    for (std::size_t node = 0; node < own.size(); ++node)
        if (own[node] >= 0)
            if (const Read<void> added = addMesh(static_cast<int>(node)); !added)
                return added;
    return {};
}

void SceneMaker::addMaterials()
{
    const tinygltf::Model& model = m_file.model;
    for (const tinygltf::Material& told : model.materials) {
        SceneMaterial& own = m_scene.materials.emplace_back();
        own.name = told.name;
        own.doubleSided = told.doubleSided;
        own.alpha = told.alphaMode == "MASK"    ? model::PartAlpha::Mask
                    : told.alphaMode == "BLEND" ? model::PartAlpha::Blend
                                                : model::PartAlpha::Opaque;
        const std::vector<double>& factor = told.pbrMetallicRoughness.baseColorFactor;
        for (std::size_t i = 0; i < 3 && i < factor.size(); ++i)
            own.colour[static_cast<int>(i)] = static_cast<float>(factor[i]);
        const int texture = told.pbrMetallicRoughness.baseColorTexture.index;
        if (texture < 0 || static_cast<std::size_t>(texture) >= model.textures.size())
            continue;
        const tinygltf::Texture& named = model.textures[static_cast<std::size_t>(texture)];
        own.image = named.source;
        if (const auto webp = named.extensions.find("EXT_texture_webp"); webp != named.extensions.end())
            if (const tinygltf::Value& source = webp->second.Get("source"); own.image < 0 && source.IsInt())
                own.image = source.GetNumberAsInt();
        if (own.image < 0 || static_cast<std::size_t>(own.image) >= m_file.images.size())
            own.image = -1;
    }
}

void SceneMaker::addImages()
{
    std::vector<bool> isShown(m_file.images.size());
    for (const SceneMesh& mesh : m_scene.meshes)
        if (mesh.material >= 0 && static_cast<std::size_t>(mesh.material) < m_scene.materials.size())
            if (const int image = m_scene.materials[static_cast<std::size_t>(mesh.material)].image; image >= 0)
                isShown[static_cast<std::size_t>(image)] = true;
    m_scene.images.resize(m_file.images.size());
    for (std::size_t i = 0; i < isShown.size(); ++i) {
        const GltfFile::Image& told = m_file.images[i];
        if (!isShown[i])
            continue;
        if (!told.uri.empty()) {
            if (Read<std::vector<std::byte>> bytes = m_data.uri(told.uri))
                m_scene.images[i] = std::move(*bytes);
        } else if (const Read<GltfData::Bytes> bytes = m_data.view(told.view)) {
            m_scene.images[i].assign(bytes->begin(), bytes->end());
        }
    }
}

Read<ForeignScene> SceneMaker::make()
{
    for (const std::string& name : m_file.model.extensionsRequired)
        if (!name.empty() && !isKnownExtension(name))
            return tl::unexpected(wire::Refusal(wire::Reason::UnknownExtension, name));
    m_scene.boundByJoints = true;
    m_scene.told = {.metresPerUnit = 1.0F, .up = model::ToldAxis::Y};
    findParents();
    const std::vector<int> roots = rootsOfScene();
    if (roots.size() != 1)
        m_scene.nodes.push_back({.name = {}}); // One stands above all.
    for (const int root : roots)
        addTree(root, roots.size() != 1 ? 0 : -1);
    if (const Read<void> added = addMeshes(); !added)
        return tl::unexpected(added.error());
    addMaterials();
    addImages();
    if (m_file.facesBack)
        m_scene.nodes.front().toParent =
            glm::mat4({-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, 0}, {0, 0, 0, 1}) * m_scene.nodes.front().toParent;
    return std::move(m_scene);
}

/// As the standard has it, and as writers have it that do not encode what they name.
Read<std::vector<std::byte>> bytesOfUri(const ModelFolder& folder, const std::string& uri)
{
    const std::string decoded = percentDecoded(uri);
    const auto refused = [&decoded](wire::Reason reason) {
        return tl::unexpected(wire::Refusal(reason, ModelFolder::nameOf(decoded)));
    };
    if (decoded.find('\0') != std::string::npos)
        return tl::unexpected(wire::Refusal(wire::Reason::Malformed, "the name of a buffer is none"));
    for (const std::string& name : {decoded, uri}) {
        const std::optional<std::string> relative = pathOfUri(name);
        if (!relative)
            return refused(wire::Reason::OutsideFolder);
        const std::string path = folder.pathOf(*relative);
        if (!folder.mayBeRead(path))
            return refused(wire::Reason::OutsideFolder);
        if (ModelFolder::isOrdinary(path))
            return bytesOfFile(path);
    }
    return refused(wire::Reason::MissingFile);
}

} // namespace

Read<ForeignScene> gltfScene(const GltfFile& file, const BufferReader& reader)
{
    return SceneMaker(file, reader).make();
}

Read<ForeignScene> readGltf(const std::string& path)
{
    Read<std::vector<std::byte>> bytes = bytesOfFile(path);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const Read<GltfFile> file = parsedGltf(std::move(*bytes));
    if (!file)
        return tl::unexpected(file.error());
    const ModelFolder folder(path);
    return gltfScene(*file, [&folder](const std::string& uri) { return bytesOfUri(folder, uri); });
}

} // namespace hairpaint::importer
