// Strand by strand.
#include "model/importing/head_strands.h"

#include "model/importing/median.h"
#include "model/values/polyline.h"
#include "sim/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr std::size_t kStrandsAtOnce = 1U << 14U;
constexpr std::size_t kStrandsGrain = 64;
constexpr float kLeastLengthM = 1e-4F;
constexpr float kRootStretchM = 0.02F;
constexpr float kRootWayPart = 1.0F / 3.0F;
constexpr std::size_t kMostFollowed = 800; ///< Strands of which it is found where they lie further on.
constexpr float kFollowStepM = 0.01F;
constexpr int kMostFollowSteps = 24;
constexpr int kHeightSteps = 4;      ///< Until hair has risen from its root.
constexpr float kLiesBelow = 0.4F;   ///< Sine of the angle to the skin.
constexpr float kLiesUnderM = 0.02F; ///< So far over the skin hair is laid.

bool isOver(const sim::DistanceGrid& distances, const glm::vec3& positionHd)
{
    const std::optional<sim::DistanceGrid::Sample> sample = distances.at(positionHd);
    return sample && sample->distanceM > kLiesUnderM + 0.5F * distances.layout().cellM;
}

float softStep(float from, float to, float x)
{
    const float t = std::clamp((x - from) / (to - from), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

/// The part of a direction that lies in the skin.
glm::vec3 inSkin(const glm::vec3& direction, const glm::vec3& normal)
{
    return direction - normal * glm::dot(direction, normal);
}

/// Hair that stands off the skin from its root on, longer than it would by its stiffness, and does not hang.
float heldOf(std::span<const glm::vec3> axisHd, float lengthM, const glm::vec3& normalHd)
{
    const glm::vec3 quarter = pointAlong(axisHd, 0.25F * lengthM) - axisHd.front();
    const glm::vec3 end = axisHd.back() - pointAlong(axisHd, 0.5F * lengthM);
    const float rises = glm::dot(quarter, normalHd) / std::max(glm::length(quarter), 1e-6F);
    const float hangs = -end.y / std::max(glm::length(end), 1e-6F);
    // What bends over is held by less.
    const float goesOn = glm::dot(quarter, end) / std::max(glm::length(quarter) * glm::length(end), 1e-6F);
    return softStep(0.45F, 0.75F, rises) * (1.0F - softStep(0.3F, 0.8F, hangs)) * softStep(0.015F, 0.04F, lengthM) *
           glm::mix(0.8F, 1.0F, softStep(0.4F, 0.9F, goesOn));
}

/// In which direction a strand leaves the skin, unit; zero where it has none. Hair that turns has turned by its first
/// stretch already, half as much as by the second. `held`: heldOf.
glm::vec3 rootDirection(std::span<const glm::vec3> axisHd, float lengthM, const glm::vec3& normalHd, float held)
{
    constexpr float kGoesOn = 0.5F;    ///< Cosine between stretches that are one turn.
    constexpr float kHeldBends = 0.5F; ///< Most of its bend it has by its style, not by its weight.
    const float stretchM = std::min(kRootStretchM, lengthM * kRootWayPart);
    const glm::vec3 middle = pointAlong(axisHd, stretchM);
    const glm::vec3 first = middle - axisHd.front();
    const glm::vec3 flat = inSkin(first, normalHd);
    const glm::vec3 next = pointAlong(axisHd, 2.0F * stretchM) - middle;
    const glm::vec3 flatNext = inSkin(next, normalHd);
    const float length = glm::length(first);
    const float flatLength = glm::length(flat);
    const float nextLength = glm::length(flatNext);
    if (!(length > 0.0F))
        return glm::vec3(0.0F);
    if (!(flatLength > 0.0F) || !(nextLength > 0.0F) || glm::dot(flat, flatNext) < kGoesOn * flatLength * nextLength)
        return first / length;
    const glm::vec3 turned = 1.5F * flat / flatLength - 0.5F * flatNext / nextLength;
    // Likewise with the angle to the skin of hair too short for the head to bend away under it, and of hair that is
    // held and bends by its weight.
    const float rises = glm::dot(first, normalHd) / length;
    const float risesNext = glm::dot(next, normalHd) / std::max(glm::length(next), 1e-6F);
    const float bends = std::max(1.0F - softStep(0.5F, 1.0F, stretchM / kRootStretchM), kHeldBends * held);
    const float sine = std::clamp(rises + 0.5F * bends * (rises - risesNext), -1.0F, 1.0F);
    return turned * (std::sqrt(1.0F - sine * sine) / glm::length(turned)) + normalHd * sine;
}

struct FollowedStrand
{
    std::vector<SkinDirection> directions;
    std::optional<float> heightM; ///< Over the skin, where it has risen to its height in the coat.
};

/// Where a strand lies on skin, step by step, until it leaves it.
void followStrand(std::span<const glm::vec3> axisHd, const sim::Skin& skin, const sim::DistanceGrid* distances,
                  FollowedStrand& found)
{
    glm::vec3 last = pointAlong(axisHd, kRootStretchM);
    for (int step = 1; step <= kMostFollowSteps; ++step) {
        const glm::vec3 next = pointAlong(axisHd, kRootStretchM + kFollowStepM * static_cast<float>(step));
        const glm::vec3 stepHd = next - last;
        const float length = glm::length(stepHd);
        const glm::vec3 middle = 0.5F * (last + next);
        last = next;
        const bool isBeginning = step <= kHeightSteps;
        if (length < 0.5F * kFollowStepM || (!isBeginning && distances != nullptr && isOver(*distances, middle)))
            return;
        const sim::SurfacePoint under = skin.nearest(middle);
        const float height = glm::distance(under.positionHd, middle);
        if (isBeginning && std::abs(glm::dot(stepHd, under.normalHd)) < kLiesBelow * length)
            found.heightM = height;
        if (height < kLiesUnderM)
            found.directions.push_back({under.positionHd, under.normalHd, stepHd / length});
        else if (!isBeginning)
            return;
    }
}

} // namespace

std::optional<HeadStrands> strandsOnHead(const ForeignStrands& strands, const CurveTransform& transform,
                                         const sim::Skin& skin, const sim::DistanceGrid* distances,
                                         const Progress& progress)
{
    HeadStrands onHead;
    onHead.strands.reserve(strands.count());
    std::vector<float> heightsM;
    const std::size_t followEach = std::max<std::size_t>(strands.count() / kMostFollowed, 1);
    for (std::size_t first = 0; first < strands.count(); first += kStrandsAtOnce) {
        if (progress && !progress(static_cast<double>(first) / static_cast<double>(strands.count())))
            return std::nullopt;
        const std::size_t some = std::min(kStrandsAtOnce, strands.count() - first);
        std::vector<std::optional<HeadStrand>> found(some);
        std::vector<FollowedStrand> followed(some / followEach + 1);
        sim::parallelFor(some, kStrandsGrain, [&](std::size_t begin, std::size_t end) {
            StrandScratch scratch;
            std::vector<glm::vec3> pointsHd;
            for (std::size_t i = begin; i < end; ++i) {
                pointsHd.clear();
                for (const glm::vec3& point : strands.strand(first + i))
                    pointsHd.push_back(transform.toHd(point));
                const sim::SurfacePoint root = skin.nearest(pointsHd.front());
                if (!(glm::distance(root.positionHd, pointsHd.front()) <= kFurthestRootM))
                    continue;
                const StrandShape shape = measureStrand(pointsHd, scratch);
                const float held = heldOf(scratch.axisHd, shape.lengthM, root.normalHd);
                const glm::vec3 directionHd = rootDirection(scratch.axisHd, shape.lengthM, root.normalHd, held);
                if (!(shape.lengthM > kLeastLengthM) || directionHd == glm::vec3(0.0F))
                    continue;
                StrandLook look = strands.looks[first + i];
                look.rootWidth *= transform.scaleM;
                look.tipWidth *= transform.scaleM;
                found[i] = {.root = {root.positionHd, root.normalHd, directionHd},
                            .shape = shape,
                            .points = static_cast<std::uint32_t>(pointsHd.size()),
                            .look = look,
                            .held = held,
                            .source = static_cast<std::uint32_t>(first + i)};
                if (i % followEach == 0)
                    followStrand(scratch.axisHd, skin, distances, followed[i / followEach]);
            }
        });
        for (const std::optional<HeadStrand>& strand : found)
            if (strand)
                onHead.strands.push_back(*strand);
        for (const FollowedStrand& one : followed) {
            onHead.further.insert(onHead.further.end(), one.directions.begin(), one.directions.end());
            if (one.heightM)
                heightsM.push_back(*one.heightM);
        }
    }
    if (!heightsM.empty())
        onHead.heightM = medianOf(heightsM);
    return onHead;
}

} // namespace hairpaint::model
