// Assimp's scene copied into ours.
#include "app/importer/assimp_scene.h"

#include "app/importer/plain_files.h"
#include "model/values/srgb.h"
#include "sim/skin/head_limits.h"

#include <assimp/GltfMaterial.h>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <unordered_map>

namespace hairpaint::importer {

namespace {

constexpr unsigned kDeepestNode = 256;

glm::vec3 toVec3(const aiVector3D& v)
{
    return {v.x, v.y, v.z};
}

glm::mat4 toMat4(const aiMatrix4x4& m)
{
    return {{m.a1, m.b1, m.c1, m.d1}, {m.a2, m.b2, m.c2, m.d2}, {m.a3, m.b3, m.c3, m.d3}, {m.a4, m.b4, m.c4, m.d4}};
}

std::string textOf(const aiString& string)
{
    return {string.C_Str(), string.length};
}

/// In lower case, with the dot.
std::string endingOf(const std::string& path)
{
    const std::size_t dot = path.find_last_of("./\\");
    std::string ending = dot == std::string::npos || path[dot] != '.' ? std::string() : path.substr(dot);
    std::ranges::transform(ending, ending.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return ending;
}

class SceneCopy
{
public:
    explicit SceneCopy(const aiScene& scene) : m_scene(scene) {}

    /// False where the limits are passed, or an index is none of a vertex.
    bool copy()
    {
        if (!addNode(*m_scene.mRootNode, -1, 0))
            return false;
        for (unsigned i = 0; i < m_scene.mNumMeshes; ++i)
            if (!addMesh(*m_scene.mMeshes[i]))
                return false;
        return true;
    }
    ForeignScene copied{};

private:
    bool addNode(const aiNode& node, int parent, unsigned depth)
    {
        if (depth > kDeepestNode)
            return false;
        const auto own = static_cast<int>(copied.nodes.size());
        copied.nodes.push_back(
            {.name = textOf(node.mName), .parent = parent, .toParent = toMat4(node.mTransformation)});
        m_byName.try_emplace(node.mName.C_Str(), own); // The first one is who Assimp's bones name.
        for (unsigned i = 0; i < node.mNumMeshes; ++i)
            if (node.mMeshes[i] < m_scene.mNumMeshes)
                copied.nodes.back().meshes.push_back(static_cast<int>(node.mMeshes[i]));
        for (unsigned i = 0; i < node.mNumChildren; ++i) {
            copied.nodes[static_cast<std::size_t>(own)].children.push_back(static_cast<int>(copied.nodes.size()));
            if (!addNode(*node.mChildren[i], own, depth + 1))
                return false;
        }
        return true;
    }
    bool addMesh(const aiMesh& mesh)
    {
        SceneMesh& own = copied.meshes.emplace_back();
        if (!mesh.HasPositions())
            return true;
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            own.positions.push_back(toVec3(mesh.mVertices[i]));
            own.normals.push_back(mesh.HasNormals() ? toVec3(mesh.mNormals[i]) : glm::vec3(0.0F));
            if (mesh.HasTextureCoords(0))
                own.uvs.emplace_back(mesh.mTextureCoords[0][i].x, mesh.mTextureCoords[0][i].y);
        }
        for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
            const aiFace& face = mesh.mFaces[i];
            if (face.mNumIndices != 3)
                continue;
            own.triangles.emplace_back(face.mIndices[0], face.mIndices[1], face.mIndices[2]);
            for (unsigned corner = 0; corner < 3; ++corner)
                if (face.mIndices[corner] >= mesh.mNumVertices)
                    return false;
        }
        own.name = textOf(mesh.mName);
        own.material = static_cast<int>(mesh.mMaterialIndex);
        m_triangles += own.triangles.size();
        addBones(mesh, own);
        return m_triangles <= sim::kMostTriangles;
    }
    void addBones(const aiMesh& mesh, SceneMesh& own) const
    {
        for (unsigned b = 0; b < mesh.mNumBones; ++b) {
            const aiBone& bone = *mesh.mBones[b];
            const auto node = m_byName.find(bone.mName.C_Str());
            if (node == m_byName.end())
                continue;
            const auto index = static_cast<std::uint32_t>(own.bones.size());
            own.bones.push_back({.node = node->second, .meshToNode = toMat4(bone.mOffsetMatrix)});
            for (unsigned i = 0; i < bone.mNumWeights; ++i)
                if (bone.mWeights[i].mVertexId < mesh.mNumVertices)
                    own.weights.push_back(
                        {.vertex = bone.mWeights[i].mVertexId, .bone = index, .weight = bone.mWeights[i].mWeight});
        }
    }

    const aiScene& m_scene;
    std::unordered_map<std::string, int> m_byName{};
    std::size_t m_triangles = 0;
};

/// The bytes of a texture inside the scene or in the model's folder, where exporters leave whole paths of their own;
/// empty where there is none.
std::vector<std::byte> textureBytes(const aiScene& scene, const ModelFolder& folder, const aiString& named)
{
    if (const aiTexture* const inside = scene.GetEmbeddedTexture(named.C_Str())) {
        if (inside->mHeight != 0 || inside->pcData == nullptr) // Texels without a file's form are rare.
            return {};
        const auto* const bytes = reinterpret_cast<const std::byte*>(inside->pcData);
        return {bytes, bytes + inside->mWidth};
    }
    std::string name = textOf(named);
    std::ranges::replace(name, '\\', '/');
    if (name.empty() || name.front() == '*' || name.find('\0') != std::string::npos)
        return {};
    for (const std::string& candidate : {name, ModelFolder::nameOf(name)}) {
        const std::string path = folder.pathOf(candidate);
        if (!folder.mayBeRead(path) || !ModelFolder::isOrdinary(path))
            continue;
        if (tl::expected<std::vector<std::byte>, wire::Refusal> bytes = bytesOfFile(path))
            return *std::move(bytes);
    }
    return {};
}

void copyMaterials(const aiScene& scene, const ModelFolder& folder, ForeignScene& copied)
{
    std::map<std::string, int> images;
    for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
        const aiMaterial& told = *scene.mMaterials[i];
        SceneMaterial& own = copied.materials.emplace_back();
        aiString text;
        if (told.Get(AI_MATKEY_NAME, text) == aiReturn_SUCCESS && text != aiString(AI_DEFAULT_MATERIAL_NAME))
            own.name = textOf(text);
        aiColor4D colour;
        if (told.Get(AI_MATKEY_BASE_COLOR, colour) == aiReturn_SUCCESS)
            own.colour = {colour.r, colour.g, colour.b};
        else if (told.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == aiReturn_SUCCESS)
            for (int c = 0; c < 3; ++c) // As exporters write what is seen.
                own.colour[c] = model::linearFromSrgb(std::clamp(colour[static_cast<unsigned>(c)], 0.0F, 1.0F));
        int isTwoSided = 0;
        own.doubleSided = told.Get(AI_MATKEY_TWOSIDED, isTwoSided) == aiReturn_SUCCESS && isTwoSided != 0;
        if (told.GetTextureCount(aiTextureType_OPACITY) > 0)
            own.alpha = model::PartAlpha::Mask;
        if (told.GetTexture(aiTextureType_BASE_COLOR, 0, &text) != aiReturn_SUCCESS &&
            told.GetTexture(aiTextureType_DIFFUSE, 0, &text) != aiReturn_SUCCESS)
            continue;
        const auto [known, isNew] = images.try_emplace(textOf(text), static_cast<int>(copied.images.size()));
        if (isNew)
            copied.images.push_back(textureBytes(scene, folder, text));
        own.image = known->second;
    }
}

/// A whole number of an FBX's settings.
int settingOf(const aiMetadata& settings, const char* name, int otherwise)
{
    std::int32_t value = 0;
    return settings.Get(name, value) ? value : otherwise;
}

/// The axis of a setting of that name, toward its sign; none where it is no axis.
glm::vec3 axisOf(const aiMetadata& settings, const std::string& name, int otherwise)
{
    glm::vec3 axis(0.0F);
    const int index = settingOf(settings, name.c_str(), otherwise);
    if (index >= 0 && index < 3)
        axis[index] = settingOf(settings, (name + "Sign").c_str(), 1) < 0 ? -1.0F : 1.0F;
    return axis;
}

/// An FBX tells its axes and how many centimetres its unit is (Autodesk, FBX SDK, FbxAxisSystem, FbxSystemUnit).
/// Axes other than the two that are known here are turned to them.
void followFbx(ForeignScene& scene, const aiMetadata& settings)
{
    constexpr float kMetresPerCm = 0.01F;
    float cm = 0.0F;
    double exactCm = 0.0;
    if (settings.Get("UnitScaleFactor", exactCm))
        cm = static_cast<float>(exactCm);
    else
        settings.Get("UnitScaleFactor", cm);
    if (std::isfinite(cm) && cm > 0.0F)
        scene.told.metresPerUnit = kMetresPerCm * cm;
    const glm::vec3 right = axisOf(settings, "CoordAxis", 0);
    const glm::vec3 up = axisOf(settings, "UpAxis", 1);
    const glm::vec3 front = axisOf(settings, "FrontAxis", 2);
    const glm::mat3 toOurs = glm::transpose(glm::mat3(right, up, front));
    if (glm::determinant(toOurs) == 0.0F)
        return;
    const bool isUsualZ = right == glm::vec3(1, 0, 0) && up == glm::vec3(0, 0, 1) && front == glm::vec3(0, -1, 0);
    scene.told.up = isUsualZ ? model::ToldAxis::Z : model::ToldAxis::Y;
    if (!isUsualZ)
        scene.nodes.front().toParent = glm::mat4(toOurs) * scene.nodes.front().toParent;
}

/// Assimp puts a COLLADA's unit and axis into its root, which bears nothing else.
void followCollada(ForeignScene& scene)
{
    glm::mat4& root = scene.nodes.front().toParent;
    const float metres = glm::length(glm::vec3(root[0]));
    if (!std::isfinite(metres) || !(metres > 0.0F))
        return;
    const glm::mat3 turn = glm::mat3(root) / metres;
    const auto turnsTo = [&turn](const glm::mat3& wanted) {
        constexpr float kClose = 1e-4F;
        for (int i = 0; i < 3; ++i)
            if (glm::distance(turn[i], wanted[i]) > kClose)
                return false;
        return true;
    };
    if (glm::vec3(root[3]) != glm::vec3(0.0F))
        return;
    const bool isZ = turnsTo({{1, 0, 0}, {0, 0, -1}, {0, 1, 0}});
    scene.told = {.metresPerUnit = metres, .up = isZ ? model::ToldAxis::Z : model::ToldAxis::Y};
    root = isZ ? glm::mat4(1.0F) : glm::mat4(turn);
}

/// What an importer of Assimp's says, as part of a sentence.
std::string clauseOf(std::string said)
{
    constexpr std::size_t kLongest = 160;
    std::ranges::replace_if(
        said, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    while (!said.empty() && std::string_view(" .!:").find(said.back()) != std::string_view::npos)
        said.pop_back();
    if (said.size() > kLongest) {
        said.resize(said.find_last_of(' ', kLongest) == std::string::npos ? kLongest
                                                                          : said.find_last_of(' ', kLongest));
        said += " ...";
    }
    return said;
}

} // namespace

tl::expected<ForeignScene, wire::Refusal> readByAssimp(const std::string& path)
{
    Assimp::Importer importer;
    auto* const files = new PlainFiles(path);
    importer.SetIOHandler(files); // It takes it over.
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, 175.0F);
    const std::string ending = endingOf(path);
    const bool isVrm = ending == ".vrm"; // A binary glTF by another name, which Assimp goes by.
    const aiScene* scene = importer.ReadFile(isVrm ? path + PlainFiles::kOtherEnding : path,
                                             static_cast<unsigned>(aiProcess_Triangulate) | aiProcess_GenSmoothNormals |
                                                 aiProcess_JoinIdenticalVertices | aiProcess_ValidateDataStructure);
    if (scene == nullptr) {
        // It catches what is thrown, and keeps the words.
        const std::string said = importer.GetErrorString();
        if (said.find("bad_alloc") != std::string::npos)
            return tl::unexpected(wire::Reason::OutOfMemory);
        if (!files->outside().empty())
            return tl::unexpected(wire::Refusal(wire::Reason::OutsideFolder, files->outside()));
        if (!files->missing().empty())
            return tl::unexpected(wire::Refusal(wire::Reason::MissingFile, files->missing()));
        const bool known = isVrm || (ending.size() > 1 && importer.IsExtensionSupported(ending));
        if (!known)
            return tl::unexpected(wire::Reason::UnknownFormat);
        const std::string clause = clauseOf(said);
        return tl::unexpected(clause.empty() ? wire::Refusal(wire::Reason::Damaged)
                                             : wire::Refusal(wire::Reason::Malformed, clause));
    }
    if (scene->mRootNode == nullptr || scene->mNumMeshes == 0)
        return tl::unexpected(wire::Reason::NoTriangles);
    SceneCopy copy(*scene);
    if (!copy.copy())
        return tl::unexpected(wire::Reason::TooLarge);
    ForeignScene& copied = copy.copied;
    copyMaterials(*scene, ModelFolder(path), copied);
    if (ending == ".fbx" && scene->mMetaData != nullptr)
        followFbx(copied, *scene->mMetaData);
    else if (ending == ".dae" || ending == ".zae")
        followCollada(copied);
    else if (ending == ".gltf" || ending == ".glb" || isVrm) { // Version 1.
        copied.boundByJoints = true;
        copied.told = {.metresPerUnit = 1.0F, .up = model::ToldAxis::Y};
    }
    return std::move(copied);
}

} // namespace hairpaint::importer
