// Two vertices a node, two triangles a segment.
#include "model/cards/card_mesh.h"

#include "model/exporting/unit_vectors.h"

namespace hairpaint::model {

namespace {

constexpr float kSteep = 1e-3F;

CardVertex vertexOf(const CardStrip& strip, const StripNode& node, const AtlasPatch& patch, float right, float atlasPx)
{
    constexpr float kLean = 0.5F;
    CardVertex vertex;
    vertex.position = node.middleWo + right * node.halfWidthM * node.sideWo;
    vertex.normal = glm::normalize(node.normalWo + right * kLean * node.sideWo);
    vertex.tangent =
        glm::vec4(glm::normalize(node.sideWo - glm::dot(node.sideWo, vertex.normal) * vertex.normal), 1.0F);
    const glm::vec2 corner(patch.x, patch.y);
    const glm::vec2 size(patch.width, patch.height);
    vertex.uv = (corner + size * glm::vec2(0.5F + 0.5F * right, node.alongM / strip.lengthM())) / atlasPx;
    return vertex;
}

/// Its triangles come first: it lies under all others.
void addCap(const HairCards& cards, const CardLevel& level, std::size_t group, CardMesh& mesh)
{
    if (!level.caps[group])
        return;
    const AtlasPatch& patch = cards.capPatch(group);
    const ScalpCap& cap = *level.caps[group];
    const auto atlasPx = static_cast<float>(cards.images.size());
    mesh.vertices.reserve(cap.vertices.size());
    for (const ScalpCap::Vertex& corner : cap.vertices) {
        // To the right on the flattened skin is about across the outward direction, seen from there.
        const glm::vec3 right = glm::cross(cap.upWo(), corner.normalWo);
        const float length = glm::length(right);
        const glm::vec3 tangent = length > kSteep ? right / length : anyAcross(corner.normalWo);
        const glm::vec2 uv = glm::clamp(cap.uv(corner.flatM), 0.0F, 1.0F);
        mesh.vertices.push_back(
            {.position = corner.positionWo,
             .normal = corner.normalWo,
             .tangent = glm::vec4(tangent, 1.0F),
             .uv = (glm::vec2(patch.x, patch.y) + glm::vec2(patch.width, patch.height) * uv) / atlasPx});
    }
    for (const glm::uvec3& triangle : cap.triangles)
        for (int i = 0; i < 3; ++i)
            mesh.indices.push_back(triangle[i]);
}

} // namespace

CardMesh cardMesh(const HairCards& cards, const CardLevel& level, std::size_t group)
{
    CardMesh mesh;
    addCap(cards, level, group, mesh);
    if (cards.bones)
        mesh.bones.resize(mesh.vertices.size()); // The cap stays with the head.
    const auto atlasPx = static_cast<float>(cards.images.size());
    for (std::size_t i = 0; i < level.strips.size(); ++i) {
        if (level.groups[i] != group)
            continue;
        const CardStrip& strip = level.strips[i];
        const AtlasPatch& patch = cards.patches[level.patchOf[i]];
        for (std::size_t n = 0; n < strip.nodes.size(); ++n) {
            const auto at = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back(vertexOf(strip, strip.nodes[n], patch, -1.0F, atlasPx));
            mesh.vertices.push_back(vertexOf(strip, strip.nodes[n], patch, 1.0F, atlasPx));
            if (cards.bones)
                mesh.bones.insert(mesh.bones.end(), 2,
                                  cards.bones->weightsAt(level.chainOf[i], strip.nodes[n].middleWo));
            if (n + 1 < strip.nodes.size())
                for (const std::uint32_t corner : {0U, 2U, 1U, 1U, 2U, 3U})
                    mesh.indices.push_back(at + corner);
        }
    }
    return mesh;
}

CardMesh movedMesh(CardMesh mesh, const JointPose& frame)
{
    for (CardVertex& vertex : mesh.vertices) {
        vertex.position = frame.position + frame.rotation * vertex.position;
        vertex.normal = glm::normalize(frame.rotation * vertex.normal);
        vertex.tangent = glm::vec4(glm::normalize(frame.rotation * glm::vec3(vertex.tangent)), vertex.tangent.w);
    }
    return mesh;
}

} // namespace hairpaint::model
