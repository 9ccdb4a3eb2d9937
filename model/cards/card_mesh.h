// The triangles of cards as they lie in a file.
#pragma once

#include "model/cards/hair_cards.h"

#include <cstdint>
#include <vector>

namespace hairpaint::model {

/// glTF: uv with v down; the tangent points along u, its w is the bitangent's sign.
struct CardVertex
{
    glm::vec3 position{0.0F};
    glm::vec3 normal{0.0F, 0.0F, 1.0F};
    glm::vec4 tangent{1.0F, 0.0F, 0.0F, 1.0F};
    glm::vec2 uv{0.0F};
};
static_assert(sizeof(CardVertex) == 48);

struct CardMesh
{
    std::vector<CardVertex> vertices;
    std::vector<BoneWeights> bones;     ///< One a vertex, where there are bones.
    std::vector<std::uint32_t> indices; ///< Three a triangle, counter-clockwise from outside.
};

/// The mesh of the cap and the strips of one group in a level. Normals lean to the strip's sides, so that it is lit
/// like a round lock.
[[nodiscard]] CardMesh cardMesh(const HairCards& cards, const CardLevel& level, std::size_t group);
/// The mesh in the coordinates of `frame`.
[[nodiscard]] CardMesh movedMesh(CardMesh mesh, const JointPose& frame);

} // namespace hairpaint::model
