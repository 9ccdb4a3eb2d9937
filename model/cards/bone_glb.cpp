// Nodes of joints; springs and colliders of VRMC_springBone 1.0 (VRM Consortium).
#include "model/cards/bone_glb.h"

#include "model/exporting/glb_buffer.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

/// Units of VRMC_springBone 1.0: 1 is a usual stiffness, 0.4 a usual drag.
QJsonObject springJoint(int node, const sim::PhysicsSettings& physics)
{
    constexpr float kHitRadiusM = 0.01F;
    constexpr float kStiffnessPerM = 20.0F;
    constexpr float kGravity = 0.3F;
    constexpr float kDragSeconds = 0.2F;
    const auto number = [](float value) { return static_cast<double>(value); };
    return {{QStringLiteral("node"), node},
            {QStringLiteral("hitRadius"), number(kHitRadiusM)},
            {QStringLiteral("stiffness"), number(kStiffnessPerM * physics.stiffnessM)},
            {QStringLiteral("gravityPower"), number(kGravity * physics.gravityScale)},
            {QStringLiteral("gravityDir"), QJsonArray{0.0, -1.0, 0.0}},
            {QStringLiteral("dragForce"), number(std::clamp(kDragSeconds * physics.damping, 0.0F, 1.0F))}};
}

/// An ellipsoid becomes the capsule along its longest axis.
void addColliders(const BoneRoot& root, const JointPose& head, std::span<const sim::Ellipsoid> colliders,
                  QJsonObject& springBone)
{
    QJsonArray shapes;
    QJsonArray all;
    for (const sim::Ellipsoid& ellipsoid : colliders) {
        const glm::vec3& axes = ellipsoid.semiAxesM;
        const int longest = axes.x > axes.y ? (axes.x > axes.z ? 0 : 2) : (axes.y > axes.z ? 1 : 2);
        const float radius = 0.5F * (axes[(longest + 1) % 3] + axes[(longest + 2) % 3]);
        glm::vec3 half(0.0F);
        half[longest] = std::max(axes[longest] - radius, 0.0F);
        const glm::quat back = glm::conjugate(root.pose.rotation);
        half = back * (head.rotation * (ellipsoid.rotation * half));
        const glm::vec3 centre = back * (head.rotation * ellipsoid.centreHd + head.position - root.pose.position);
        const QJsonObject capsule{{QStringLiteral("offset"), jsonNumbers(centre - half)},
                                  {QStringLiteral("radius"), static_cast<double>(radius)},
                                  {QStringLiteral("tail"), jsonNumbers(centre + half)}};
        all.append(static_cast<int>(shapes.size()));
        shapes.append(QJsonObject{{QStringLiteral("node"), root.node},
                                  {QStringLiteral("shape"), QJsonObject{{QStringLiteral("capsule"), capsule}}}});
    }
    springBone.insert(QStringLiteral("colliders"), shapes);
    springBone.insert(
        QStringLiteral("colliderGroups"),
        QJsonArray{QJsonObject{{QStringLiteral("name"), QStringLiteral("Head")}, {QStringLiteral("colliders"), all}}});
}

} // namespace

std::vector<SpringChain> springsOf(const CurveSet& curves, const std::vector<BoneChain>& chains, const JointPose& frame)
{
    std::vector<SpringChain> springs;
    springs.reserve(chains.size());
    for (const BoneChain& chain : chains) {
        SpringChain& spring = springs.emplace_back(
            SpringChain{.name = QStringLiteral("%1 %2").arg(curves.groups()[chain.group].name).arg(springs.size() + 1),
                        .joints = {},
                        .physics = curves.physics(chain.group)});
        for (const glm::vec3& joint : chain.jointsWo)
            spring.joints.push_back(frame.position + frame.rotation * joint);
    }
    return springs;
}

BoneGlb boneGlb(std::span<const SpringChain> chains, std::span<const sim::Ellipsoid> colliders, const JointPose& head,
                const BoneRoot& root, int firstNode)
{
    BoneGlb made{
        .nodes = {}, .below = {}, .joints = {root.node}, .inverseBind = {inverseBind(root.pose)}, .springBone = {}};
    const glm::quat back = glm::conjugate(root.pose.rotation);
    QJsonArray springs;
    for (const SpringChain& chain : chains) {
        QJsonArray links;
        glm::vec3 parent = root.pose.position;
        for (std::size_t j = 0; j < chain.joints.size(); ++j) {
            const int node = firstNode + static_cast<int>(made.nodes.size());
            const glm::vec3& position = chain.joints[j];
            QJsonObject joint{{QStringLiteral("name"), QStringLiteral("%1.%2").arg(chain.name).arg(j + 1)},
                              {QStringLiteral("translation"), jsonNumbers(back * (position - parent))}};
            if (j + 1 < chain.joints.size())
                joint.insert(QStringLiteral("children"), QJsonArray{node + 1});
            made.nodes.append(joint);
            made.joints.append(node);
            links.append(springJoint(node, chain.physics));
            made.inverseBind.push_back(inverseBind({.position = position, .rotation = root.pose.rotation}));
            if (j == 0)
                made.below.append(node);
            parent = position;
        }
        QJsonObject spring{{QStringLiteral("name"), chain.name}, {QStringLiteral("joints"), links}};
        if (!colliders.empty())
            spring.insert(QStringLiteral("colliderGroups"), QJsonArray{0});
        springs.append(spring);
    }
    made.springBone = {{QStringLiteral("specVersion"), QStringLiteral("1.0")}, {QStringLiteral("springs"), springs}};
    if (!colliders.empty())
        addColliders(root, head, colliders, made.springBone);
    return made;
}

} // namespace hairpaint::model
