// A head's mesh as it comes from a foreign file: with its skeleton, where it has one.
#pragma once

#include "model/heads/head_skeleton.h"
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
    RiggedMesh() = default;
    RiggedMesh(sim::HeadMesh mesh) : sim::HeadMesh(std::move(mesh)) {}
};

} // namespace hairpaint::model
