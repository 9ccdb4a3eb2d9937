// In what unit and axes a foreign head stands.
#pragma once

#include "model/heads/rigged_mesh.h"
#include "model/project/project.h"

#include <optional>
#include <vector>

namespace hairpaint::model {

/// Scale and axis that a mesh of unknown origin most likely has: what its file tells; else the unit under which it is
/// about as tall as a head, or as a body where its joints or its slenderness say that it is one, and the axis along
/// which it is taller, or away from its opening.
struct HeadGuess
{
    float unitScale = 1.0F;
    UpAxis upAxis = UpAxis::Y;
};
[[nodiscard]] HeadGuess guessHead(const RiggedMesh& source);

/// What a user says of a head's file; what is not said is guessed.
struct HeadChoice
{
    std::optional<float> metresPerUnit{};
    std::optional<UpAxis> upAxis{};
    /// Where the face looks, an axis of the file's space.
    std::optional<glm::ivec3> facing{};
    std::vector<QString> comingIn{}; ///< Names of parts or of their materials; all where there are none.
    std::vector<QString> growing{};  ///< Names of the parts that hair grows on; where empty, the likely ones.
    bool ownLayout = false;          ///< Instead of the file's, one is made in which no two points share a texel.
};
/// `guess` but for what the user says.
[[nodiscard]] HeadGuess chosen(HeadGuess guess, const HeadChoice& choice);

/// From an axis of the file's space to a front that looks toward +z, or -y where z is up: turned about the axis that is
/// up, with its skeleton. False where the face would look along that axis; the mesh is as it was then.
[[nodiscard]] bool turnToFront(RiggedMesh& source, UpAxis upAxis, const glm::ivec3& facing);

/// Whether its uvs differ: where all are one there is nothing to paint on.
[[nodiscard]] bool hasLayout(const sim::HeadMesh& mesh);

} // namespace hairpaint::model
