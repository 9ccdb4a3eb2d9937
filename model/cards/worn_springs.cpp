// Sections of ribbons become joints.
#include "model/cards/worn_springs.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

constexpr std::uint32_t kRibbonJoints = 4; ///< Of a part that hangs, at most.
/// How ribbon swings: as soft hair does.
constexpr float kRibbonStiffnessM = 0.02F;

glm::vec3 middleOf(const PosedMesh& mesh, const HangingPart& part, std::uint32_t section)
{
    glm::vec3 sum(0.0F);
    for (std::uint32_t corner = 0; corner < part.corners; ++corner)
        sum += mesh.vertices[part.first + section * part.corners + corner].position;
    return sum / static_cast<float>(part.corners);
}

} // namespace

std::vector<SpringChain> springsOf(const WornBody& body)
{
    std::vector<SpringChain> springs;
    for (const HangingPart& part : body.hanging) {
        SpringChain& spring = springs.emplace_back(
            SpringChain{.name = QStringLiteral("%1 tail %2").arg(body.name).arg(springs.size() + 1), .joints = {}});
        spring.physics.stiffnessM = kRibbonStiffnessM;
        const std::uint32_t last = part.sections - 1;
        const std::uint32_t joints = std::min(kRibbonJoints, part.sections);
        for (std::uint32_t j = 0; j < joints; ++j)
            spring.joints.push_back(middleOf(body.mesh, part, j * last / (joints - 1)));
    }
    return springs;
}

std::vector<BoneWeights> springWeights(const WornBody& body, std::span<const SpringChain> springs,
                                       std::size_t firstJoint)
{
    std::vector<BoneWeights> weights(body.mesh.vertices.size());
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const HangingPart& part = body.hanging[i];
        for (std::uint32_t vertex = part.first; vertex < part.first + part.vertices(); ++vertex)
            weights[vertex] = weightsAlong(springs[i].joints, firstJoint, body.mesh.vertices[vertex].position);
        firstJoint += springs[i].joints.size();
    }
    return weights;
}

} // namespace hairpaint::model
