// Reading a scene through Assimp and flattening it into one mesh.
#include "app/importer/mesh_import.h"

#include "app/importer/mesh_builder.h"
#include "app/importer/plain_files.h"
#include "app/importer/scene_skeleton.h"
#include "sim/skin/head_limits.h"

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>

namespace hairpaint::importer {

namespace {

constexpr unsigned kDeepestNode = 256;

glm::vec3 toVec3(const aiVector3D& v)
{
    return {v.x, v.y, v.z};
}

/// In lower case, with the dot.
std::string endingOf(const std::string& path)
{
    std::string ending = std::filesystem::path(path).extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return ending;
}

/// A binary glTF by another name, which Assimp goes by.
bool isVrm(const std::string& ending)
{
    return ending == ".vrm";
}

bool isGltf(const std::string& ending)
{
    return ending == ".glb" || ending == ".gltf" || isVrm(ending);
}

/// What the scene holds, for the reason of a refusal.
struct Found
{
    bool triangles = false;
    bool uvs = false;
};

class SceneFlattener
{
public:
    SceneFlattener(const aiScene& scene, SceneSkeleton& skeleton) : m_scene(scene), m_skeleton(skeleton) {}

    /// False where the limits are passed.
    bool addNode(const aiNode& node, const aiMatrix4x4& parent, unsigned depth)
    {
        if (depth > kDeepestNode)
            return false;
        const aiMatrix4x4 toWorld = parent * node.mTransformation;
        for (unsigned i = 0; i < node.mNumMeshes; ++i)
            if (node.mMeshes[i] < m_scene.mNumMeshes && !addMesh(*m_scene.mMeshes[node.mMeshes[i]], node, toWorld))
                return false;
        for (unsigned i = 0; i < node.mNumChildren; ++i)
            if (!addNode(*node.mChildren[i], toWorld, depth + 1))
                return false;
        return true;
    }
    [[nodiscard]] const Found& found() const { return m_found; }
    MeshBuilder& builder() { return m_builder; }

private:
    bool addMesh(const aiMesh& mesh, const aiNode& node, const aiMatrix4x4& nodeToWorld)
    {
        const bool hasTriangles = (mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) != 0;
        m_found.triangles = m_found.triangles || hasTriangles;
        if (!hasTriangles || !mesh.HasTextureCoords(0) || !mesh.HasPositions())
            return true;
        m_found.uvs = true;
        const aiMatrix4x4 toWorld = m_skeleton.meshToWorld(mesh, nodeToWorld);
        const std::vector<model::BoneWeights> bones = m_skeleton.weightsOf(mesh, node, toWorld);
        aiMatrix3x3 forNormals(toWorld);
        // A mirrored node turns triangles inside out.
        const bool mirrored = forNormals.Determinant() < 0.0F;
        forNormals.Inverse().Transpose();
        for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
            const aiFace& face = mesh.mFaces[i];
            if (face.mNumIndices != 3)
                continue;
            std::array<Corner, 3> triangle;
            for (unsigned corner = 0; corner < 3; ++corner) {
                const unsigned index = face.mIndices[mirrored ? 2 - corner : corner];
                if (index >= mesh.mNumVertices)
                    return false;
                triangle[corner].position = toVec3(toWorld * mesh.mVertices[index]);
                if (mesh.HasNormals())
                    triangle[corner].normal = toVec3(forNormals * mesh.mNormals[index]);
                triangle[corner].uv = {mesh.mTextureCoords[0][index].x, mesh.mTextureCoords[0][index].y};
                if (!bones.empty())
                    triangle[corner].bones = bones[index];
            }
            m_builder.add(triangle);
            if (m_builder.vertexCount() > sim::kMostVertices || m_builder.triangleCount() > sim::kMostTriangles)
                return false;
        }
        return true;
    }

    const aiScene& m_scene;
    SceneSkeleton& m_skeleton;
    MeshBuilder m_builder;
    Found m_found;
};

} // namespace

tl::expected<model::RiggedMesh, wire::Refusal> readMesh(const std::string& path)
{
    Assimp::Importer importer;
    auto* const files = new PlainFiles(path);
    importer.SetIOHandler(files); // It takes it over.
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, 175.0F);
    const std::string ending = endingOf(path);
    const aiScene* scene = importer.ReadFile(isVrm(ending) ? path + PlainFiles::kOtherEnding : path,
                                             static_cast<unsigned>(aiProcess_Triangulate) | aiProcess_GenSmoothNormals |
                                                 aiProcess_JoinIdenticalVertices | aiProcess_ValidateDataStructure);
    if (scene == nullptr) {
        // It catches what is thrown, and keeps the words.
        if (std::string_view(importer.GetErrorString()).find("bad_alloc") != std::string_view::npos)
            return tl::unexpected(wire::Reason::OutOfMemory);
        if (!files->outside().empty())
            return tl::unexpected(wire::Refusal(wire::Reason::OutsideFolder, files->outside()));
        if (!files->missing().empty())
            return tl::unexpected(wire::Refusal(wire::Reason::MissingFile, files->missing()));
        const bool known = isVrm(ending) || (ending.size() > 1 && importer.IsExtensionSupported(ending));
        return tl::unexpected(known ? wire::Reason::Damaged : wire::Reason::UnknownFormat);
    }
    if (scene->mRootNode == nullptr || scene->mNumMeshes == 0)
        return tl::unexpected(wire::Reason::NoTriangles);
    SceneSkeleton skeleton(*scene, isGltf(ending));
    SceneFlattener flattener(*scene, skeleton);
    if (!flattener.addNode(*scene->mRootNode, aiMatrix4x4(), 0))
        return tl::unexpected(wire::Reason::TooLarge);
    if (!flattener.found().triangles)
        return tl::unexpected(wire::Reason::NoTriangles);
    if (!flattener.found().uvs)
        return tl::unexpected(wire::Reason::NoUvs);
    model::RiggedMesh mesh = flattener.builder().take();
    if (mesh.triangles.empty())
        return tl::unexpected(wire::Reason::NoTriangles);
    if (!wire::meshFits(mesh))
        return tl::unexpected(wire::Reason::Damaged);
    mesh.skeleton.joints = skeleton.joints(isGltf(ending) ? vrmBones(path) : BoneNames()).joints;
    // A head without its skeleton is better than none.
    if (mesh.skeleton.empty() || !model::withinLimits(mesh.skeleton, mesh.positionsHd.size()))
        mesh.skeleton = {};
    return mesh;
}

} // namespace hairpaint::importer
