// The head as it is held, and what goes with it, as meshes for files.
#pragma once

#include "model/exporting/curve_set.h"
#include "model/project/head_part.h"
#include "model/project/worn.h"

#include <cstdint>
#include <vector>

namespace hairpaint::model {

/// glTF: uv with v down.
struct HeadVertexOut
{
    glm::vec3 position{0.0F};
    glm::vec3 normal{0.0F, 0.0F, 1.0F};
    glm::vec2 uv{0.0F};
};
static_assert(sizeof(HeadVertexOut) == 32);

struct PosedMesh
{
    std::vector<HeadVertexOut> vertices;
    std::vector<std::uint32_t> indices; ///< Three a triangle, counter-clockwise from outside.
};

/// The mesh at rest, Hd.
[[nodiscard]] PosedMesh plainHead(const sim::HeadMesh& mesh);
/// The mesh that the hair stands on, Wo, as it is held and its neck turned; empty where no group has roots.
[[nodiscard]] PosedMesh posedHead(const CurveSet& set);
/// A part of the head's character, likewise.
[[nodiscard]] PosedMesh posedPart(const CurveSet& set, const HeadPart& part);
/// A mesh that is drawn of a thing (wornSurfaces), Wo, as it goes with the head.
[[nodiscard]] PosedMesh posedWorn(const CurveSet& set, const Worn& worn, const sim::HeadMesh& mesh);
/// The same on a head at rest that is turned about its origin.
[[nodiscard]] PosedMesh turnedWorn(const Worn& worn, const sim::HeadMesh& mesh, const glm::quat& turn);

} // namespace hairpaint::model
