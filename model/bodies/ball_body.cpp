// The unit ball out of triangles.
#include "model/bodies/ball_body.h"

#include <cmath>

namespace hairpaint::model {

namespace {

/// An octahedron whose faces are divided and blown up: square roots alone, so that pictures are the same everywhere.
std::shared_ptr<const sim::HeadMesh> madeBall()
{
    constexpr int kSteps = 16; // Along an edge of the octahedron.
    auto mesh = std::make_shared<sim::HeadMesh>();
    for (unsigned octant = 0; octant < 8; ++octant) {
        const glm::vec3 side((octant & 1U) != 0 ? -1 : 1, (octant & 2U) != 0 ? -1 : 1, (octant & 4U) != 0 ? -1 : 1);
        const bool isMirrored = side.x * side.y * side.z < 0.0F;
        const auto first = static_cast<int>(mesh->positionsHd.size());
        for (int row = 0; row <= kSteps; ++row)
            for (int i = 0; i <= kSteps - row; ++i) {
                const glm::vec3 flat = side * glm::vec3(kSteps - row - i, i, row);
                mesh->positionsHd.push_back(flat / std::sqrt(glm::dot(flat, flat)));
                mesh->uvs.push_back(glm::vec2(i, row) / static_cast<float>(kSteps));
            }
        const auto add = [&](glm::ivec2 a, glm::ivec2 b, glm::ivec2 c) {
            const auto at = [first](glm::ivec2 corner) { // Row and number in it.
                const int row = corner.x;
                return static_cast<unsigned>(first + row * (kSteps + 1) - row * (row - 1) / 2 + corner.y);
            };
            mesh->triangles.emplace_back(at(a), at(isMirrored ? c : b), at(isMirrored ? b : c));
        };
        for (int row = 0; row < kSteps; ++row)
            for (int i = 0; i < kSteps - row; ++i) {
                add({row, i}, {row, i + 1}, {row + 1, i});
                if (i + 1 < kSteps - row)
                    add({row, i + 1}, {row + 1, i + 1}, {row + 1, i});
            }
    }
    mesh->normalsHd = mesh->positionsHd;
    return mesh;
}

} // namespace

std::shared_ptr<const sim::HeadMesh> ballBody()
{
    static const std::shared_ptr<const sim::HeadMesh> ball = madeBall();
    return ball;
}

} // namespace hairpaint::model
