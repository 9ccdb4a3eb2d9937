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
    float metresPerUnit = 0.0F; ///< Finite; 0 where the file does not tell.
    ToldAxis up = ToldAxis::None;
    friend bool operator==(const ToldSpace&, const ToldSpace&) = default;
};

struct RiggedMesh : sim::HeadMesh
{
    HeadSkeleton skeleton = {};
    ToldSpace told = {};
    std::vector<MeshPart> parts = {}; ///< Parts that cover the whole mesh; empty where it is one part without a name.
    std::vector<MeshTexture> textures = {};
    UvTiles tiles = {}; ///< Tiles of the first part's layout, once arranged() has run.
    RiggedMesh() = default;
    RiggedMesh(sim::HeadMesh mesh) : sim::HeadMesh(std::move(mesh)) {}
};

/// Whether the parts are valid: they cover the whole mesh, each with vertices of its own, colours and tiles are within
/// their ranges, and the textures that they name exist.
[[nodiscard]] bool partsFit(const RiggedMesh& mesh);

} // namespace hairpaint::model
