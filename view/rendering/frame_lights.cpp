// Takes the lights out of the frame's constants.
#include "view/rendering/frame_lights.h"

namespace hairpaint::rendering {

FarLight keyLight(const FrameConstants& constants)
{
    return {.towardWo = glm::vec3(constants.keyWo), .colour = glm::vec3(constants.keyColour)};
}

FarLight fillLight(const FrameConstants& constants)
{
    return {.towardWo = glm::vec3(constants.fillWo), .colour = glm::vec3(constants.fillColour)};
}

FarLight rimLight(const FrameConstants& constants)
{
    return {.towardWo = glm::vec3(constants.rimWo), .colour = glm::vec3(constants.rimColour)};
}

Irradiance irradianceIn(const FrameConstants& constants)
{
    Irradiance around{};
    for (std::size_t i = 0; i < around.size(); ++i)
        around.at(i) = glm::vec3(constants.around.at(i));
    return around;
}

HairLighting hairLighting(const FrameConstants& constants, const sim::StrandMaterial& material)
{
    return {.eyeWo = glm::vec3(constants.eyeWo),
            .key = keyLight(constants),
            .fill = fillLight(constants),
            .rim = rimLight(constants),
            .around = irradianceIn(constants),
            .headWo = glm::vec3(constants.headWo),
            .headRadiusM = constants.headWo.w,
            .scattering = static_cast<ScatteringModel>(static_cast<int>(constants.keyWo.w)),
            .shine = material.shine,
            .shape = fibreShape(material.roughness),
            .highlightExponent = highlightExponent(material.roughness)};
}

} // namespace hairpaint::rendering
