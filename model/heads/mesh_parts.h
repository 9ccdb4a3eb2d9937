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
    static constexpr int kMostTiles = 10; ///< Across, as UDIM counts them, and up.

    std::string name;       ///< Of the object; as isJointName() has it.
    std::string material;   ///< Likewise; empty where it has none.
    bool hasLayout = true;  ///< Else all its uvs are the same.
    glm::ivec2 tile{0};     ///< Of the uv plane, where its layout lay before it was moved to 0..1; 0 .. kMostTiles - 1.
    glm::vec3 colour{0.8F}; ///< Linear, 0..1; times the texture.
    PartAlpha alpha = PartAlpha::Opaque;
    bool doubleSided = false;
    std::int32_t texture = -1;   ///< Of the mesh's; none: -1.
    std::uint32_t vertices = 0;  ///< How many of the mesh's: they lie part after part,
    std::uint32_t triangles = 0; ///< as triangles do.
    PartUse use = PartUse::Grows;
    friend bool operator==(const MeshPart&, const MeshPart&) = default;
};

} // namespace hairpaint::model
