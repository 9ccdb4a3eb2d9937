// The formulas of strands, for one point at a time.
#include "view/rendering/software/card_light.h"

#include "view/rendering/frame_lights.h"
#include "view/rendering/light/hair_light_inl.h"

namespace hairpaint::rendering {

CardLight::CardLight(const FrameConstants& constants) : m_constants(constants), m_lighting(hairLighting(constants, {}))
{}

glm::vec3 CardLight::on(const CardCorner& corner) const
{
    namespace simd = HWY_NAMESPACE;
    constexpr float kRoundM = 0.04F; ///< A lock is lit as if it bulged by that, so that its sides differ.
    const glm::mat3 turn(m_constants.woFromHd);
    HairLighting lighting = m_lighting;
    lighting.shine = corner.shine;
    lighting.shape = fibreShape(corner.roughness);
    lighting.highlightExponent = highlightExponent(corner.roughness);
    const auto triple = [](const glm::vec3& v) { return simd::Triple<float>{v.x, v.y, v.z}; };
    const glm::vec3 positionWo =
        glm::vec3(m_constants.woFromHd * glm::vec4(corner.positionHd, 1.0F)) + kRoundM * (turn * corner.normalHd);
    const glm::vec3 colour = glm::clamp(corner.colour, 0.004F, 1.0F);
    const simd::Triple<float> lit =
        simd::hairLight(lighting, simd::HairPoint<float>{.position = triple(positionWo),
                                                         .tangent = triple(turn * corner.tangentHd),
                                                         .colour = triple(colour),
                                                         .depth = simd::fibreDepth(triple(colour)),
                                                         .turned = 0.0F,
                                                         .towardKey = kCrossedByCards,
                                                         .towardEye = kCrossedByCards,
                                                         .towardRim = kCrossedByCards});
    return glm::vec3(lit.x, lit.y, lit.z) / colour;
}

} // namespace hairpaint::rendering
