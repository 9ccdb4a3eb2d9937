// The document's light, skin, worn things and colours as the renderer wants them.
#pragma once

#include "model/project/project.h"
#include "view/rendering/scene.h"

namespace hairpaint::view {

[[nodiscard]] rendering::Light sceneLight(const model::LightSettings& settings);
[[nodiscard]] rendering::SkinShading sceneSkin(model::SkinTone tone);
/// What is worn and drawn.
[[nodiscard]] std::vector<rendering::Solid> sceneSolids(const std::vector<model::Worn>& worn);
/// An sRGB colour in linear light.
[[nodiscard]] glm::vec3 linearColour(QRgb encoded);

} // namespace hairpaint::view
