// The lean of new hair: which way, and how long.
#include "sim/motion/first_fall.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hairpaint::sim {

namespace {

constexpr float kLeanMs2 = 8.0F; ///< Acceleration of a whole lean, m/s2: of gravity's order, so hair clears a shoulder.
constexpr std::size_t kWholeSteps = 60; ///< The lean is whole for so long,
constexpr std::size_t kLevels = 8;      ///< then falls off by as many levels,
constexpr std::size_t kLevelSteps = 10; ///< each so long: 1.2 s in all, less than pictures let hair settle for.
constexpr float kDivideM = 0.003F;      ///< Half the width of the step between back and forward.
constexpr float kReachM = 0.02F;        ///< Length beyond the shoulders' height over which the lean comes in.
/// How far before the neck's pivot hair divides: fraction of the neck's height. On people some 1 cm.
constexpr float kBeforePivot = 0.16F;
/// Further away from where it divides hair meets no shoulder, and that before the face would fall into it: the lean
/// goes from whole to none.
constexpr float kWholeM = 0.02F;
constexpr float kNoneM = 0.035F;
constexpr float kWholeBackM = 0.06F;
constexpr float kNoneBackM = 0.08F;

glm::vec3 forwardOf(const Neck& neck)
{
    return {-neck.acrossHd.z, 0.0F, neck.acrossHd.x};
}

/// 1 where hair divides, 0 far before or behind.
float beside(float sideM)
{
    const float whole = sideM > 0.0F ? kWholeM : kWholeBackM;
    const float none = sideM > 0.0F ? kNoneM : kNoneBackM;
    return std::clamp((none - std::abs(sideM)) / (none - whole), 0.0F, 1.0F);
}

} // namespace

FirstFall FirstFall::begun()
{
    FirstFall fall;
    fall.begin();
    return fall;
}

std::size_t FirstFall::apply(const Neck& neck, GroupGains& gains) const
{
    constexpr std::size_t kEnd = kWholeSteps + kLevels * kLevelSteps;
    gains.leans = neck.hasShoulders() && m_stepsDone < kEnd;
    if (!gains.leans)
        return std::numeric_limits<std::size_t>::max();
    std::size_t left = kWholeSteps - m_stepsDone;
    float strength = 1.0F;
    if (m_stepsDone >= kWholeSteps) {
        const std::size_t level = (m_stepsDone - kWholeSteps) / kLevelSteps;
        left = kWholeSteps + (level + 1) * kLevelSteps - m_stepsDone;
        strength = 1.0F - static_cast<float>(level + 1) / static_cast<float>(kLevels + 1);
    }
    constexpr auto kStep = static_cast<float>(kStepSeconds);
    const glm::vec3 lean = forwardOf(neck) * (kLeanMs2 * kStep * kStep * strength);
    gains.lean = {lean.x, lean.y, lean.z};
    return left;
}

bool reachesShoulders(std::span<const glm::vec3> restHd, float segmentM, const Neck& neck)
{
    return neck.hasShoulders() && restHd.front().y - segmentM * static_cast<float>(restHd.size() - 1) < neck.shouldersY;
}

float leanOf(std::span<const glm::vec3> hangingHd, float segmentM, const Neck& neck)
{
    if (!neck.hasShoulders())
        return 0.0F;
    for (std::size_t i = 1; i < hangingHd.size(); ++i) {
        const glm::vec3& above = hangingHd[i - 1];
        const glm::vec3& below = hangingHd[i];
        if (!(above.y >= neck.headY && below.y < neck.headY))
            continue;
        const float part = (above.y - neck.headY) / (above.y - below.y);
        const glm::vec3 crossing = above + (below - above) * part;
        const float leftM = segmentM * (static_cast<float>(hangingHd.size() - i) - part);
        const float reach = std::clamp((leftM - (neck.headY - neck.shouldersY)) / kReachM, 0.0F, 1.0F);
        const float sideM =
            glm::dot(crossing - neck.pivotHd, forwardOf(neck)) - kBeforePivot * (neck.headY - neck.shouldersY);
        return reach * std::clamp(sideM / kDivideM, -1.0F, 1.0F) * beside(sideM);
    }
    return 0.0F;
}

} // namespace hairpaint::sim
