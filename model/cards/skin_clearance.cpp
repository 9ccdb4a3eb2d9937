// The strip's surface is sampled along and across each segment; what is too low lifts the segment's ends.
#include "model/cards/skin_clearance.h"

#include "sim/skin/skin.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

constexpr float kClearanceM = 0.8e-3F;
constexpr float kDeepestM = 0.02F; ///< Deeper is not what a strip's straightness does.
constexpr int kLiftRounds = 8;
constexpr int kStepsAlong = 4;

/// How a point has to move to be clear of the skin, Wo; 0 where it is.
glm::vec3 outward(const sim::Skin& skin, const sim::HeadPose& pose, const glm::vec3& positionWo)
{
    const glm::vec3 positionHd = glm::conjugate(pose.rotation) * (positionWo - pose.positionWo);
    const sim::SurfacePoint near = skin.nearest(positionHd);
    const float above = glm::dot(positionHd - near.positionHd, near.normalHd);
    if (above >= kClearanceM || above < -kDeepestM)
        return glm::vec3(0.0F);
    return pose.rotation * ((kClearanceM - above) * near.normalHd);
}

/// Whether anything had to be moved.
bool lifted(const sim::Skin& skin, const sim::HeadPose& pose, std::vector<StripNode>& nodes)
{
    bool any = false;
    std::vector<glm::vec3> moves(nodes.size(), glm::vec3(0.0F));
    const auto raise = [&moves](std::size_t node, const glm::vec3& move) {
        if (glm::dot(move, move) > glm::dot(moves[node], moves[node]))
            moves[node] = move;
    };
    for (std::size_t n = 0; n + 1 < nodes.size(); ++n)
        for (int step = 0; step <= kStepsAlong; ++step) {
            const float part = static_cast<float>(step) / static_cast<float>(kStepsAlong);
            for (const float across : {-1.0F, 0.0F, 1.0F}) {
                const auto edge = [across](const StripNode& node) {
                    return node.middleWo + across * node.halfWidthM * node.sideWo;
                };
                const glm::vec3 move = outward(skin, pose, glm::mix(edge(nodes[n]), edge(nodes[n + 1]), part));
                if (move == glm::vec3(0.0F))
                    continue;
                any = true;
                if (part < 1.0F)
                    raise(n, move);
                if (part > 0.0F)
                    raise(n + 1, move);
            }
        }
    for (std::size_t n = 0; n < nodes.size(); ++n)
        nodes[n].middleWo += moves[n];
    return any;
}

} // namespace

void keepAboveSkin(const CurveSet& set, CardStrip& strip)
{
    const sim::Skin* skin = set.skin();
    if (skin == nullptr)
        return;
    bool any = false;
    for (int round = 0; round < kLiftRounds && lifted(*skin, set.pose(), strip.nodes); ++round)
        any = true;
    if (!any)
        return;
    constexpr float kShortestM = 1e-6F;
    for (std::size_t n = 1; n < strip.nodes.size(); ++n)
        strip.nodes[n].alongM =
            strip.nodes[n - 1].alongM +
            std::max(glm::distance(strip.nodes[n - 1].middleWo, strip.nodes[n].middleWo), kShortestM);
}

} // namespace hairpaint::model
