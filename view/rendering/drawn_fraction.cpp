// Widths on the picture, and the fractions that follow.
#include "view/rendering/drawn_fraction.h"

#include <algorithm>

namespace hairpaint::rendering {
namespace {

/// Thinner hairs are drawn by fewer, as much wider ones while the picture moves, samples.
constexpr float kThinnestDrawn = 0.5F;

} // namespace

float samplesPerM(const FrameConstants& constants)
{
    constexpr float kHeadM = 0.12F; ///< Hair is about so much nearer than the head's middle.
    const float distanceM =
        std::max(glm::distance(glm::vec3(constants.eyeWo), glm::vec3(constants.headWo)) - kHeadM, 0.05F);
    return constants.gridSize.z / distanceM;
}

std::size_t hairsForGrids(const FrameConstants& constants, bool fine)
{
    constexpr float kForAHead = 6144.0F;
    constexpr float kHeadM = 0.5F; // About as much hair is seen of it.
    constexpr float kFinely = 4.0F;
    const float nearer = std::max(kHeadM * samplesPerM(constants) / constants.target.y, 1.0F);
    return static_cast<std::size_t>(kForAHead * std::min(nearer * nearer, 64.0F) * (fine ? kFinely : 1.0F));
}

float hairWidthSp(const sim::StrandMaterial& material, const FrameConstants& constants)
{
    return material.widthM * samplesPerM(constants);
}

float fractionThatTells(float widthSp)
{
    return std::clamp(widthSp / kThinnestDrawn, 1.0F / 64.0F, 1.0F);
}

float listedDetail(float fraction)
{
    constexpr float kStep = 1.0905077F; // Eight an octave.
    float listed = 1.0F;
    while (listed > fraction * (1.0F + kFadingPart) * kStep)
        listed /= kStep;
    return listed;
}

float deepFraction(const DepthOfCoat& depth, float widthSp, float fraction)
{
    return std::clamp(widthSp / (fraction * depth.widest), depth.leastFraction, 1.0F);
}

} // namespace hairpaint::rendering
