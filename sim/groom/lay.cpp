// The path of a hair over the head, step by step.
#include "sim/groom/lay.h"

#include "sim/groom/group_settings.h"
#include "sim/groom/rest_shape.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr float kStandsBelow = 0.15F; ///< A field less flat than this holds no hair to the head;
constexpr float kLiesFrom = 0.45F;    ///< one flatter than this does, fully.
constexpr float kPerLyingRange = 1.0F / (kLiesFrom - kStandsBelow);
constexpr float kTurnM = 0.008F;        ///< Along which hair turns to another direction.
constexpr float kStepM = 0.018F;        ///< Longest step over the skin.
constexpr float kSteepest = 0.6F;       ///< Sine of the angle at which a hair goes back to the skin;
constexpr float kSteepestOfLong = 0.2F; ///< of long hair, whose weight draws it straight past hollows such as the neck.
constexpr float kMostPush = 0.5F;       ///< Of a step, out of the head.
constexpr float kClearM = 0.0005F;      ///< Nothing is laid nearer to the skin.

} // namespace

bool isUpright(const MapSampler& direction)
{
    return direction.isUniform() && direction.vector(glm::vec2(0.5F)) == DirectionVector(0.0F);
}

Growth Lay::growthAt(const LayRoot& root, float falls) const
{
    const DirectionVector natural = m_natural != nullptr ? m_natural->vector(root.uv) : DirectionVector(0.0F);
    return growthDirections(m_direction.vector(root.uv), m_natural != nullptr ? &natural : nullptr, root.positionHd,
                            root.frame)
        .of(falls);
}

std::size_t Lay::mostPassed(int nodes)
{
    // Where a segment takes one step, one a segment; else steps are longer than half the longest.
    constexpr auto kOfShortSteps = static_cast<std::size_t>(kFurthestM / (0.5F * kStepM)) + 2;
    return std::max(static_cast<std::size_t>(nodes - 1), kOfShortSteps);
}

void Lay::lay(const LayRoot& root, float lengthM, std::span<glm::vec3> nodesHd, std::span<std::uint32_t> passed) const
{
    std::ranges::fill(passed, SkinBand::kNone);
    const float falls = fallFraction(lengthM);
    const Growth grown = growthAt(root, falls);
    if (grown.flatness == 0.0F) {
        straightRest({root.positionHd, root.frame.normal}, lengthM, nodesHd);
        return;
    }
    const float segmentM = lengthM / static_cast<float>(nodesHd.size() - 1);
    const int steps = std::max(static_cast<int>(std::ceil(segmentM / kStepM)), 1);
    const float stepM = segmentM / static_cast<float>(steps);
    const float perClimbM = 1.0F / std::max(stepM, kTurnM);
    const float diving = kSteepest + (kSteepestOfLong - kSteepest) * falls;
    const float turning = stepM / (stepM + kTurnM);
    const float coatM = std::min(m_coatM, 0.001F + 0.12F * lengthM) * (0.3F + 0.7F * root.chance);
    glm::vec3 direction =
        grown.alongHd * grown.flatness + root.frame.normal * std::sqrt(1.0F - grown.flatness * grown.flatness);
    bool lies = m_field != nullptr && grown.flatness > kStandsBelow;
    float pathM = 0.0F;
    std::size_t passes = 0;
    nodesHd[0] = root.positionHd;
    for (std::size_t i = 1; i < nodesHd.size(); ++i) {
        glm::vec3 place = nodesHd[i - 1];
        int left = steps;
        for (; left > 0 && lies; --left) {
            const std::uint32_t index = pathM < kFurthestM ? m_field->indexAt(place) : SkinBand::kNone;
            lies = index != SkinBand::kNone;
            if (!lies)
                break;
            if (passes < passed.size())
                passed[passes++] = index;
            const LayField::Cell& cell = (*m_field)[index];
            const Growth growth = cell.directions.of(falls);
            const float heightM = cell.heightM(place);
            // Nothing is laid inside the head; stubble, whose steps are shorter than cells are flat, goes on all the
            // same.
            if (pathM > 0.0F && heightM < kClearM && heightM > -SkinBand::kReachM)
                place += cell.normalHd * std::min(kClearM - heightM, kMostPush * stepM);
            lies = growth.flatness > kStandsBelow;
            const float sine = std::clamp((coatM - heightM) * perClimbM, -diving, kSteepest);
            const float sine2 = sine * sine;
            const float cosine = 1.0F - sine2 * (0.5F + 0.125F * sine2);
            const float follows = std::clamp((growth.flatness - kStandsBelow) * kPerLyingRange, 0.0F, 1.0F) * turning;
            direction += (growth.alongHd * cosine + cell.normalHd * sine - direction) * follows;
            const float square = glm::dot(direction, direction);
            direction *= 1.0F / std::sqrt(std::max(square, 1e-6F));
            place += direction * stepM;
            pathM += stepM;
        }
        place += direction * (stepM * static_cast<float>(left));
        const glm::vec3 edge = place - nodesHd[i - 1];
        nodesHd[i] = nodesHd[i - 1] + edge * (segmentM / std::sqrt(std::max(glm::dot(edge, edge), 1e-16F)));
    }
}

} // namespace hairpaint::sim
