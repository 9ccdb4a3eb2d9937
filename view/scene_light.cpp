// Light, skin and colours for the renderer: see the header.
#include "view/scene_light.h"

#include <cmath>

namespace hairpaint::view {

rendering::Light sceneLight(const model::LightSettings& settings)
{
    return {.directionWo = {std::sin(settings.azimuthRad) * std::cos(settings.elevationRad),
                            std::sin(settings.elevationRad),
                            std::cos(settings.azimuthRad) * std::cos(settings.elevationRad)},
            .colour = glm::vec3(settings.red, settings.green, settings.blue) * settings.intensity,
            .ambient = settings.ambient};
}

rendering::Skin sceneSkin(model::SkinTone tone)
{
    const model::SkinLook& look = model::skinLook(tone);
    return {.colour = linearColour(look.skin),
            .lips = linearColour(look.lips),
            .lids = linearColour(look.lids),
            .scatter = look.scatter,
            .grain = look.grain,
            .sheen = look.sheen};
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
