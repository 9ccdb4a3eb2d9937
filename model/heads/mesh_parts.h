// What a foreign character's mesh is made of: parts with a material each, and the textures that these show.
#pragma once

#include "sim/skin/mesh_texture.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hairpaint::model {

/// What becomes of a part.
enum class PartUse : std::uint32_t
{
    LeftOut = 0,
    Seen = 1, ///< It is drawn, hair touches it, and it leaves with avatars.
    Grows = 2 ///< Hair grows on it.
};

using PartAlpha = sim::TextureAlpha;
using sim::MeshTexture;

/// An object's triangles of one material, or those of one tile of its layout.
struct MeshPart
{
    static constexpr std::size_t kMost = 1024;
    static constexpr int kMostTiles = 10; ///< Limit on tiles across, as UDIM has it, and on tiles up.

    std::string name;       ///< Name of the object; isJointName() holds for it.
    std::string material;   ///< Name of the material, within the same limits; empty where there is none.
    bool hasLayout = true;  ///< Whether the part has uvs of its own; else all its uvs are the same.
    glm::ivec2 tile{0};     ///< Tile of the uv plane that the layout was moved to 0..1 from; 0 .. kMostTiles - 1.
    glm::vec3 colour{0.8F}; ///< Linear, 0..1; times the texture.
    PartAlpha alpha = PartAlpha::Opaque;
    bool doubleSided = false;
    std::int32_t texture = -1;   ///< Index into RiggedMesh::textures; -1 for none.
    std::uint32_t vertices = 0;  ///< Number of vertices; the mesh has them part after part.
    std::uint32_t triangles = 0; ///< Number of triangles; the mesh has them part after part.
    PartUse use = PartUse::Grows;
    friend bool operator==(const MeshPart&, const MeshPart&) = default;
};

} // namespace hairpaint::model
