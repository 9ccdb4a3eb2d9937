// A head's mesh as it comes from a foreign file: with its skeleton, where it has one.
#pragma once

#include "model/heads/head_skeleton.h"
#include "model/heads/mesh_parts.h"
#include "model/heads/uv_tiles.h"
#include "sim/skin/head_mesh.h"

#include <cstdint>
#include <utility>

namespace hairpaint::model {

enum class ToldAxis : std::uint32_t
{
    None = 0,
    Y = 1,
    Z = 2
};

/// What a file tells of the space that its mesh stands in, by itself or by its format.
struct ToldSpace
{
    float metresPerUnit = 0.0F; ///< Finite; 0 where nothing tells.
    ToldAxis up = ToldAxis::None;
    friend bool operator==(const ToldSpace&, const ToldSpace&) = default;
};

struct RiggedMesh : sim::HeadMesh
{
    HeadSkeleton skeleton = {};
    ToldSpace told = {};
    std::vector<MeshPart> parts = {}; ///< All of it together; none where it is one part without a name.
    std::vector<MeshTexture> textures = {};
    UvTiles tiles = {}; ///< Of the first part, once arranged() laid it out.
    RiggedMesh() = default;
    RiggedMesh(sim::HeadMesh mesh) : sim::HeadMesh(std::move(mesh)) {}
};

/// Whether what its parts say of it can be: they cover all of it, each with vertices of its own, of colours and tiles
/// within their ranges, and name textures that are there.
[[nodiscard]] bool partsFit(const RiggedMesh& mesh);

} // namespace hairpaint::model
