// Transforms vertices of the head and of what is worn as head.vert does.
#include "model/exporting/posed_mesh.h"

#include "model/exporting/unit_vectors.h"
#include "sim/motion/head_motion.h"
#include "sim/skin/skin.h"

#include <glm/gtc/quaternion.hpp>

namespace hairpaint::model {

PosedMesh plainHead(const sim::HeadMesh& mesh)
{
    constexpr glm::vec3 kUprightZ(0.0F, 0.0F, 1.0F);
    PosedMesh head;
    head.vertices.reserve(mesh.positionsHd.size());
    for (std::size_t i = 0; i < mesh.positionsHd.size(); ++i)
        head.vertices.push_back({.position = mesh.positionsHd[i],
                                 .normal = unitOr(mesh.normalsHd[i], kUprightZ),
                                 .uv = glm::vec2(mesh.uvs[i].x, 1.0F - mesh.uvs[i].y)});
    head.indices.reserve(3 * mesh.triangles.size());
    for (const glm::uvec3& triangle : mesh.triangles)
        for (int i = 0; i < 3; ++i)
            head.indices.push_back(triangle[i]);
    return head;
}

namespace {

/// From Hd to Wo.
void hold(PosedMesh& head, const CurveSet& set)
{
    const sim::HeadPose& pose = set.pose();
    const sim::NeckTurn neck = sim::neckTurn(set.neck(), pose);
    const glm::quat whole(neck.turn[3], neck.turn[0], neck.turn[1], neck.turn[2]);
    const glm::vec3 pivotHd(neck.pivot[0], neck.pivot[1], neck.pivot[2]);
    for (HeadVertexOut& vertex : head.vertices) {
        const glm::vec3 hd = vertex.position;
        // The shoulders stay while the head turns: back by what has turned too much.
        const float below = glm::smoothstep(0.0F, 1.0F, (neck.headY - hd.y) * neck.perTwistM);
        const glm::quat back =
            glm::conjugate(glm::normalize(glm::quat(1.0F, 0.0F, 0.0F, 0.0F) * (1.0F - below) + whole * below));
        vertex.position = pose.rotation * (back * (hd - pivotHd) + pivotHd) + pose.positionWo;
        vertex.normal = pose.rotation * (back * vertex.normal);
    }
}

/// On its head.
PosedMesh bodyOf(const Worn& worn, const sim::HeadMesh& mesh)
{
    PosedMesh body = plainHead(mesh);
    const sim::Ellipsoid& shape = worn.shape;
    const glm::quat rotation = glm::normalize(shape.rotation);
    for (HeadVertexOut& vertex : body.vertices) {
        vertex.position = shape.centreHd + rotation * (vertex.position * shape.semiAxesM);
        vertex.normal = rotation * glm::normalize(vertex.normal / shape.semiAxesM);
    }
    return body;
}

} // namespace

PosedMesh posedHead(const CurveSet& set)
{
    if (set.skin() == nullptr)
        return {};
    PosedMesh head = plainHead(set.skin()->mesh());
    hold(head, set);
    return head;
}

PosedMesh posedPart(const CurveSet& set, const HeadPart& part)
{
    PosedMesh own = plainHead(*part.mesh);
    hold(own, set);
    return own;
}

PosedMesh posedWorn(const CurveSet& set, const Worn& worn, const sim::HeadMesh& mesh)
{
    PosedMesh body = bodyOf(worn, mesh);
    hold(body, set);
    return body;
}

PosedMesh turnedWorn(const Worn& worn, const sim::HeadMesh& mesh, const glm::quat& turn)
{
    PosedMesh turned = bodyOf(worn, mesh);
    for (HeadVertexOut& vertex : turned.vertices) {
        vertex.position = turn * vertex.position;
        vertex.normal = turn * vertex.normal;
    }
    return turned;
}

} // namespace hairpaint::model
