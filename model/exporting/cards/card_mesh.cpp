// Two vertices a node, two triangles a segment.
#include "model/exporting/cards/card_mesh.h"

namespace hairpaint::model {

namespace {

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

} // namespace

CardMesh cardMesh(const HairCards& cards, std::size_t group)
{
    CardMesh mesh;
    const auto atlasPx = static_cast<float>(cards.images.size());
    for (std::size_t i = 0; i < cards.strips.size(); ++i) {
        if (cards.groups[i] != group)
            continue;
        const CardStrip& strip = cards.strips[i];
        for (std::size_t n = 0; n < strip.nodes.size(); ++n) {
            const auto at = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back(vertexOf(strip, strip.nodes[n], cards.patches[i], -1.0F, atlasPx));
            mesh.vertices.push_back(vertexOf(strip, strip.nodes[n], cards.patches[i], 1.0F, atlasPx));
            if (n + 1 < strip.nodes.size())
                for (const std::uint32_t corner : {0U, 2U, 1U, 1U, 2U, 3U})
                    mesh.indices.push_back(at + corner);
        }
    }
    return mesh;
}

} // namespace hairpaint::model
