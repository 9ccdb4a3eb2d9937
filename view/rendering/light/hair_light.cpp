// The light on a group's hair out of the frame's constants.
#include "view/rendering/light/hair_light.h"

namespace hairpaint::rendering {

HairLighting hairLighting(const FrameConstants& constants, const sim::StrandMaterial& material)
{
    return {.eyeWo = glm::vec3(constants.eyeWo),
            .key = {glm::vec3(constants.keyWo), glm::vec3(constants.keyColour)},
            .fill = {glm::vec3(constants.fillWo), glm::vec3(constants.fillColour)},
            .rim = {glm::vec3(constants.rimWo), glm::vec3(constants.rimColour)},
            .around = irradianceIn(constants),
            .headWo = glm::vec3(constants.headWo),
            .headRadiusM = constants.headWo.w,
            .scattering = static_cast<Scattering>(static_cast<int>(constants.keyWo.w)),
            .shine = material.shine,
            .shape = fibreShape(material.roughness),
            .highlightExponent = highlightExponent(material.roughness)};
}

} // namespace hairpaint::rendering
