// The frame's lights as the formulas take them.
#pragma once

#include "view/rendering/frame_constants.h"
#include "view/rendering/light/hair_light.h"

namespace hairpaint::rendering {

[[nodiscard]] FarLight keyLight(const FrameConstants& constants);
[[nodiscard]] FarLight fillLight(const FrameConstants& constants);
[[nodiscard]] FarLight rimLight(const FrameConstants& constants);
[[nodiscard]] Irradiance irradianceIn(const FrameConstants& constants);
[[nodiscard]] HairLighting hairLighting(const FrameConstants& constants, const sim::StrandMaterial& material);

} // namespace hairpaint::rendering
