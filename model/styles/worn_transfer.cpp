// Frames on the skin of both heads.
#include "model/styles/worn_transfer.h"

#include "model/styles/style_transfer.h"
#include "sim/skin/head_warp.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>

namespace hairpaint::model {

namespace {

/// Columns: a direction of the skin, across it, outward.
glm::mat3 frameAlong(glm::vec3 directionHd, glm::vec3 normalHd)
{
    constexpr float kLeast = 1e-6F;
    glm::vec3 along = directionHd - glm::dot(directionHd, normalHd) * normalHd;
    if (glm::dot(along, along) < kLeast * kLeast)
        along = glm::cross(normalHd, std::abs(normalHd.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0));
    along = glm::normalize(along);
    return {along, glm::cross(normalHd, along), normalHd};
}

} // namespace

std::vector<Worn> carriedWorn(std::vector<Worn> worn, const std::shared_ptr<const Head>& from,
                              const std::shared_ptr<const Head>& to)
{
    constexpr float kStepM = 1e-3F; // In which the warp bends by next to nothing.
    if (!canCarry(from, to)) {
        for (Worn& one : worn)
            anchorWorn(one, to ? to->skin.get() : nullptr);
        return worn;
    }
    const sim::HeadWarp warp(*from->landmarks, *to->landmarks);
    for (Worn& one : worn) {
        if (wornSpec(one.kind).ofHead)
            continue;
        const sim::SurfacePoint before = anchorPoint(one, *from->skin);
        const glm::vec3 warped = warp(before.positionHd);
        const sim::SurfacePoint after = to->skin->nearest(warped);
        const glm::mat3 frame = frameAlong(before.tangentHd, before.normalHd);
        const glm::mat3 carried =
            frameAlong((warp(before.positionHd + kStepM * frame[0]) - warped) / kStepM, after.normalHd);
        const glm::mat3 turn = carried * glm::transpose(frame);
        one.shape.centreHd = after.positionHd + turn * (one.shape.centreHd - before.positionHd);
        one.shape.rotation = glm::normalize(glm::quat_cast(turn) * one.shape.rotation);
        one.anchor = anchorAt(after);
        if (one.patch) {
            const Worn marked{.anchor = one.patch->at};
            const sim::SurfacePoint inPatch = to->skin->nearest(warp(anchorPoint(marked, *from->skin).positionHd));
            one.patch->at = anchorAt(inPatch);
        }
    }
    return worn;
}

} // namespace hairpaint::model
