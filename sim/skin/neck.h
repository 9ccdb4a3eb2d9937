// The neck: what the head turns about, and where the bust below it begins, which stays.
#pragma once

#include "sim/skin/head_landmarks.h"
#include "sim/skin/head_mesh.h"

#include <optional>

namespace hairpaint::sim {

/// Hd, which is Wo while the head looks straight ahead; m.
struct Neck
{
    glm::vec3 pivotHd{0.0F};
    glm::vec3 acrossHd{1.0F, 0.0F, 0.0F}; ///< Unit length, level, toward the head's own left.
    /// What lies above headY turns with the head, what lies below shouldersY does not, and between them the
    /// neck twists. Where the two are equal everything turns with the head.
    float headY = 0.0F;
    float shouldersY = 0.0F;

    [[nodiscard]] bool hasShoulders() const { return headY > shouldersY; }
    friend bool operator==(const Neck&, const Neck&) = default;
};

/// The neck's base by the landmarks; without them, and then without shoulders, below the mesh's top by as much as
/// people have, or at its base where that is higher.
[[nodiscard]] Neck neckOf(const std::optional<HeadLandmarks>& landmarks, const HeadMesh& mesh);

} // namespace hairpaint::sim
