// The document's light, skin, worn things and colours as the renderer wants them.
#pragma once

#include "model/project/project.h"
#include "view/rendering/scene.h"

#include <span>
#include <vector>

namespace hairpaint::view {

[[nodiscard]] rendering::Light sceneLight(const model::LightSettings& settings);
[[nodiscard]] rendering::SkinShading sceneSkin(model::SkinTone tone);
/// What is shown on the head's skin; null where its colours are.
[[nodiscard]] std::shared_ptr<const sim::MeshTexture> sceneSkinTexture(const model::Project& project);
/// What is worn and drawn, as many for a thing as model::surfaceCount() tells. `before`: of an earlier call with that
/// skin, whose meshes are taken for things that follow the head and lie as they did.
[[nodiscard]] std::vector<rendering::Solid> sceneSolids(const std::vector<model::Worn>& worn, const sim::Skin* skin,
                                                        std::span<const rendering::Solid> before = {});
/// The parts of the head's character; none where there is no head.
[[nodiscard]] std::vector<rendering::Solid> sceneParts(const model::Head* head);
/// An sRGB colour in linear light.
[[nodiscard]] glm::vec3 linearColour(QRgb encoded);

} // namespace hairpaint::view
