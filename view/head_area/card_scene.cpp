// Hair cards for the renderer: see the header.
#include "view/head_area/card_scene.h"

#include "model/cards/card_mesh.h"

#include <utility>

namespace hairpaint::view {

std::shared_ptr<const rendering::CardSet> cardSet(model::HairCards& cards, const sim::HeadPose& pose,
                                                  std::span<const sim::StrandMaterial> materials)
{
    auto set = std::make_shared<rendering::CardSet>();
    const glm::quat back = glm::conjugate(pose.rotation);
    for (std::size_t group = 0; group < cards.finest().caps.size(); ++group) {
        const model::CardMesh mesh = model::cardMesh(cards, cards.finest(), group);
        const auto first = static_cast<std::uint32_t>(set->corners.size());
        for (const model::CardVertex& vertex : mesh.vertices)
            set->corners.push_back({.positionHd = back * (vertex.position - pose.positionWo),
                                    .normalHd = back * vertex.normal,
                                    .uv = vertex.uv,
                                    .shine = materials[group].shine,
                                    .roughness = materials[group].roughness});
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
            set->triangles.push_back(first + glm::uvec3(mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]));
    }
    rendering::CardTexture atlas{.side = cards.images.size(), .texels = {}};
    atlas.texels.reserve(cards.images.texels().size());
    for (std::size_t i = 0; i < cards.images.texels().size(); ++i)
        atlas.texels.emplace_back(cards.images.texels()[i].colour, cards.images.alpha()[i]);
    set->levels = rendering::withSmallerLevels(std::move(atlas));
    set->cutoff = model::kCardCutoff;
    rendering::tellHairOfCorners(*set);
    return set;
}

} // namespace hairpaint::view
