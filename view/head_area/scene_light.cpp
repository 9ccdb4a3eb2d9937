// Light, skin, worn things and colours for the renderer: see the header.
#include "view/head_area/scene_light.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

// The renderer knows nothing of the model, but says the same.
static_assert(model::kSurroundingsCount == rendering::kEnvironmentCount);
static_assert(static_cast<int>(model::Surroundings::Even) == static_cast<int>(rendering::EnvironmentKind::Even));
static_assert(static_cast<int>(model::Scattering::IlluminatedLines) ==
              static_cast<int>(rendering::ScatteringModel::IlluminatedLines));

rendering::Light sceneLight(const model::LightSettings& settings)
{
    const std::array<float, 3> warmth = model::temperatureColour(settings.temperatureK);
    return {.directionWo = {std::sin(settings.azimuthRad) * std::cos(settings.elevationRad),
                            std::sin(settings.elevationRad),
                            std::cos(settings.azimuthRad) * std::cos(settings.elevationRad)},
            .colour = glm::vec3(settings.red, settings.green, settings.blue) *
                      glm::vec3(warmth[0], warmth[1], warmth[2]) * settings.intensity,
            .fill = settings.fill,
            .rim = settings.rim,
            .ambient = settings.ambient,
            .surroundings = static_cast<rendering::EnvironmentKind>(settings.surroundings),
            .scattering = static_cast<rendering::ScatteringModel>(settings.scattering)};
}

rendering::SkinShading sceneSkin(model::SkinTone tone)
{
    const model::SkinLook& look = model::skinLook(tone);
    return {.colour = linearColour(look.skin),
            .lips = linearColour(look.lips),
            .lids = linearColour(look.lids),
            .scatter = look.scatter,
            .grain = look.grain,
            .sheen = look.sheen};
}

std::shared_ptr<const sim::MeshTexture> sceneSkinTexture(const model::Project& project)
{
    return project.skin == model::SkinTone::Own && project.head ? project.head->texture : nullptr;
}

std::vector<rendering::Solid> sceneSolids(const std::vector<model::Worn>& worn, const sim::Skin* skin,
                                          std::span<const rendering::Solid> before)
{
    std::vector<rendering::Solid> solids;
    for (const model::Worn& one : worn) {
        rendering::Solid solid{.mesh = {}, .shape = one.shape, .sheen = one.sheen, .open = false};
        solid.shape.rotation = glm::normalize(one.shape.rotation); // A file may hold one of another length.
        const auto same = std::ranges::find(before, solid.shape, &rendering::Solid::shape);
        if (wornSpec(one.kind).fitted != nullptr && same != before.end()) {
            solid.mesh = same->mesh;
            solid.colour = linearColour(one.colour);
            solids.push_back(std::move(solid));
            continue;
        }
        for (model::HeadPart& surface : wornSurfaces(one, skin)) {
            solid.mesh = std::move(surface.mesh);
            solid.colour = linearColour(one.colour) * surface.colour;
            solid.open = surface.doubleSided;
            solid.masked = surface.texture && surface.alpha != sim::TextureAlpha::Opaque;
            solid.texture = std::move(surface.texture);
            solids.push_back(solid);
        }
    }
    return solids;
}

std::vector<rendering::Solid> sceneParts(const model::Head* head)
{
    constexpr float kSheen = 0.4F;
    std::vector<rendering::Solid> solids;
    if (head == nullptr)
        return solids;
    for (const model::HeadPart& part : head->parts)
        solids.push_back({.mesh = part.mesh,
                          .shape = {.centreHd = glm::vec3(0.0F), .semiAxesM = glm::vec3(1.0F)},
                          .colour = part.colour,
                          .sheen = kSheen,
                          .open = true,
                          .masked = part.texture && part.alpha != sim::TextureAlpha::Opaque,
                          .texture = part.texture});
    return solids;
}

glm::vec3 linearColour(QRgb encoded)
{
    const auto channel = [](int value) {
        const float x = static_cast<float>(value) / 255.0F;
        return x <= 0.04045F ? x / 12.92F : std::pow((x + 0.055F) / 1.055F, 2.4F);
    };
    return {channel(qRed(encoded)), channel(qGreen(encoded)), channel(qBlue(encoded))};
}

} // namespace hairpaint::view
