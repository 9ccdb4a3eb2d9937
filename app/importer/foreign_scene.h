// A scene of another program, whichever library read it: nodes, meshes of triangles, and what bones they follow.
#pragma once

#include "model/heads/rigged_mesh.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hairpaint::importer {

struct SceneBone
{
    int node = 0;               ///< Index into ForeignScene::nodes; checked.
    glm::mat4 meshToNode{1.0F}; ///< From the mesh to the node, at the time when the mesh was bound.
};

struct VertexWeight
{
    std::uint32_t vertex = 0; ///< Index into SceneMesh::positions; checked.
    std::uint32_t bone = 0;   ///< Index into SceneMesh::bones; checked.
    float weight = 0.0F;      ///< Weight as the file has it; not normalized.
};

/// Positions and indices are checked: each index is that of a vertex.
struct SceneMesh
{
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals; ///< One a vertex, of any length.
    std::vector<glm::vec2> uvs;     ///< One a vertex, v up; none where the mesh has no layout.
    std::vector<glm::uvec3> triangles;
    std::vector<SceneBone> bones;
    std::vector<VertexWeight> weights;
    std::string name = {};
    int material = -1; ///< Index into ForeignScene::materials; -1 for none.
};

struct SceneMaterial
{
    std::string name;
    glm::vec3 colour{0.8F}; ///< Linear.
    model::PartAlpha alpha = model::PartAlpha::Opaque;
    bool doubleSided = false;
    int image = -1; ///< Index into ForeignScene::images of the base colour's image; -1 for none.
};

struct SceneNode
{
    std::string name;
    /// VRM's name of the bone, where the file gives one; else empty.
    std::string boneName = {};
    int parent = -1; ///< An earlier node; none for the first alone.
    glm::mat4 toParent{1.0F};
    std::vector<int> children = {}; ///< Later nodes.
    std::vector<int> meshes = {};   ///< Indices into ForeignScene::meshes; checked.
};

struct ForeignScene
{
    std::vector<SceneNode> nodes; ///< At least one.
    std::vector<SceneMesh> meshes;
    std::vector<SceneMaterial> materials;
    std::vector<std::vector<std::byte>> images; ///< Content of the images' files; empty where one could not be read.
    /// Skinned meshes stand where their joints put them, whatever their own nodes say (as in glTF).
    bool boundByJoints = false;
    model::ToldSpace told = {};
};

} // namespace hairpaint::importer
