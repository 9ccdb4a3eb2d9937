// The mean over one turn of a coil is the line that it coils around, and how often the strand goes round that line are
// its turns. The one needs the other, so they are found together, in a few rounds.
#include "model/importing/strand_shape.h"

#include "model/values/polyline.h"
#include "sim/base/rounded.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr float kFewestTurns = 1.2F; ///< With fewer, nothing tells a coil from a bend.
constexpr float kLeastRadiusM = 3e-4F;
constexpr float kSteady = 0.8F; ///< Least fraction of its turning that a coil does in one direction.
/// Greatest root mean square deviation of a coil's radius, as a fraction of the radius.
constexpr float kUneven = 0.35F;
constexpr float kLongestM = 100.0F; ///< Longer strands are no hair.
constexpr float kLookedAt = 0.6F;   ///< Fraction of a strand's length at which its phase is measured.
/// Fraction of a strand from its root in which a coil may not have its full radius yet.
constexpr float kEasesIn = 0.3F;
constexpr int kRounds = 3;
constexpr std::size_t kFewestEven = 64;
constexpr std::size_t kMostEven = 1024;

/// How much the direction turns along a polyline in all, rad.
float turning(std::span<const glm::vec3> points)
{
    float sum = 0.0F;
    glm::vec3 last(0.0F);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::vec3 step = points[i] - points[i - 1];
        const float length = glm::length(step);
        if (!(length > 1e-7F))
            continue;
        const glm::vec3 direction = step / length;
        if (last != glm::vec3(0.0F))
            sum += sim::acosRounded(std::clamp(glm::dot(direction, last), -1.0F, 1.0F));
        last = direction;
    }
    return sum;
}

void measureAlong(std::span<const glm::vec3> points, std::vector<float>& alongM)
{
    alongM.assign(1, 0.0F);
    for (std::size_t i = 1; i < points.size(); ++i)
        alongM.push_back(alongM.back() + glm::distance(points[i - 1], points[i]));
}

void spaceEvenly(std::span<const glm::vec3> points, StrandScratch& scratch)
{
    const std::size_t count = std::clamp(points.size() * 4, kFewestEven, kMostEven);
    const float step = scratch.alongM.back() / static_cast<float>(count - 1);
    scratch.evenHd.clear();
    scratch.sums.assign(1, glm::dvec3(0.0));
    std::size_t segment = 1;
    for (std::size_t i = 0; i < count; ++i) {
        const float at = step * static_cast<float>(i);
        while (segment + 1 < points.size() && scratch.alongM[segment] < at)
            ++segment;
        const float length = scratch.alongM[segment] - scratch.alongM[segment - 1];
        const float part = length > 0.0F ? (at - scratch.alongM[segment - 1]) / length : 0.0F;
        scratch.evenHd.push_back(glm::mix(points[segment - 1], points[segment], std::clamp(part, 0.0F, 1.0F)));
        scratch.sums.push_back(scratch.sums.back() + glm::dvec3(scratch.evenHd.back()));
    }
}

/// Mean of the strand over `windowM` around a point.
glm::vec3 meanAround(const StrandScratch& scratch, float atM, float windowM)
{
    const auto last = static_cast<double>(scratch.evenHd.size() - 1);
    const double perM = last / scratch.alongM.back();
    const auto inside = [&](double at) { return std::clamp(at, 0.0, last + 1.0); };
    const auto sumUntil = [&](double at) {
        const auto whole = std::min(static_cast<std::size_t>(at), scratch.evenHd.size() - 1);
        return scratch.sums[whole] + glm::dvec3(scratch.evenHd[whole]) * (at - static_cast<double>(whole));
    };
    const double middle = atM * perM + 0.5;
    const double half = 0.5 * windowM * perM;
    const double from = inside(middle - half);
    const double until = inside(middle + half);
    return glm::vec3((sumUntil(until) - sumUntil(from)) / (until - from));
}

/// A coil as it was found with a window, which holds its inner part alone.
struct Coiling
{
    float turns = 0.0F;
    float radiusM = 0.0F;
    float lengthM = 0.0F;
    float turnM = 0.0F; ///< Length of the strand itself in one turn.
    bool isSteady = false;
};

/// Writes the axis, with the strand's own root and the foot of its tip.
Coiling coilingOf(std::span<const glm::vec3> points, float windowM, StrandScratch& scratch)
{
    const float lengthM = scratch.alongM.back();
    std::vector<glm::vec3>& axis = scratch.axisHd;
    axis.assign(1, points.front());
    glm::vec3 lastCentre(0.0F);
    glm::vec3 lastDirection(0.0F);
    glm::vec3 lastAside(0.0F);
    float lastAtM = 0.0F;
    float innerM = 0.0F;
    float innerAlongM = 0.0F;
    float round = 0.0F;
    float anyRound = 0.0F;
    float radii = 0.0F;
    float radii2 = 0.0F;
    float counted = 0.0F;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float atM = scratch.alongM[i];
        if (atM < 0.5F * windowM || atM > lengthM - 0.5F * windowM)
            continue;
        const glm::vec3 centre = meanAround(scratch, atM, windowM);
        // Over a whole window, so that what a window of not quite one turn leaves of the coil turns nothing round.
        const float ahead = std::min(0.5F * windowM, lengthM - 0.5F * windowM - atM + 0.1F * windowM);
        const float behind = std::min(0.5F * windowM, atM - 0.5F * windowM + 0.1F * windowM);
        const glm::vec3 step = meanAround(scratch, atM + ahead, windowM) - meanAround(scratch, atM - behind, windowM);
        if (!(glm::dot(step, step) > 0.0F))
            continue;
        const glm::vec3 direction = glm::normalize(step);
        const glm::vec3 offset = points[i] - centre;
        const glm::vec3 aside = offset - direction * glm::dot(offset, direction);
        if (lastDirection != glm::vec3(0.0F)) {
            innerAlongM += atM - lastAtM;
            innerM += glm::dot(centre - lastCentre, direction);
            // The last one, carried along by what turns one direction into the other.
            const glm::vec3 bisector = lastDirection + direction;
            const glm::vec3 carried =
                lastAside - bisector * (2.0F * glm::dot(bisector, lastAside) / glm::dot(bisector, bisector));
            const glm::vec3 turned = carried - direction * (2.0F * glm::dot(direction, carried));
            const float angle =
                sim::atan2Rounded(glm::dot(glm::cross(turned, aside), direction), glm::dot(turned, aside));
            round += angle;
            anyRound += std::abs(angle);
        }
        if (atM > kEasesIn * lengthM) {
            const float radius = glm::length(aside);
            radii += radius;
            radii2 += radius * radius;
            counted += 1.0F;
        }
        axis.push_back(centre);
        lastCentre = centre;
        lastAtM = atM;
        lastDirection = direction;
        lastAside = aside;
    }
    if (axis.size() < 3)
        return {};
    axis.push_back(lastCentre + lastDirection * std::max(glm::dot(points.back() - lastCentre, lastDirection), 0.0F));
    const float wholeM = glm::distance(axis[0], axis[1]) + innerM + glm::distance(lastCentre, axis.back());
    if (!(innerM > 0.0F))
        return {};
    return {.turns = std::abs(round) / glm::two_pi<float>() * wholeM / innerM,
            .radiusM = counted > 0.0F ? radii / counted : 0.0F,
            .lengthM = wholeM,
            .turnM = innerAlongM * glm::two_pi<float>() / std::max(std::abs(round), 1e-3F),
            .isSteady =
                std::abs(round) > kSteady * anyRound && radii2 * counted < (1.0F + kUneven * kUneven) * radii * radii};
}

glm::vec3 asideAt(std::span<const glm::vec3> points, float atM, float windowM, const StrandScratch& scratch)
{
    const glm::vec3 offset = pointAlong(points, atM) - meanAround(scratch, atM, windowM);
    const glm::vec3 step =
        meanAround(scratch, atM + 0.5F * windowM, windowM) - meanAround(scratch, atM - 0.5F * windowM, windowM);
    const glm::vec3 aside = offset - step * (glm::dot(offset, step) / std::max(glm::dot(step, step), 1e-12F));
    const float length = glm::length(aside);
    return length > 0.0F ? aside / length : glm::vec3(0.0F);
}

} // namespace

StrandShape measureStrand(std::span<const glm::vec3> pointsHd, StrandScratch& scratch)
{
    measureAlong(pointsHd, scratch.alongM);
    const float lengthM = scratch.alongM.back();
    const auto straight = [&] {
        scratch.axisHd.assign(pointsHd.begin(), pointsHd.end());
        return StrandShape{.lengthM = lengthM};
    };
    const float turns = turning(pointsHd) / glm::two_pi<float>();
    if (!(turns > 0.35F) || !(lengthM > 0.0F && lengthM < kLongestM))
        return straight();
    spaceEvenly(pointsHd, scratch);
    float turnM = lengthM / std::max(turns, kFewestTurns);
    Coiling found;
    for (int round = 0; round < kRounds; ++round) {
        found = coilingOf(pointsHd, std::min(turnM, lengthM / kFewestTurns), scratch);
        if (found.turns < kFewestTurns)
            return straight();
        turnM = found.turnM;
    }
    if (!found.isSteady || found.radiusM < kLeastRadiusM)
        return straight();
    return {.lengthM = found.lengthM,
            .turns = found.turns,
            .radiusM = found.radiusM,
            .asideHd = asideAt(pointsHd, kLookedAt * lengthM, std::min(turnM, lengthM / kFewestTurns), scratch)};
}

} // namespace hairpaint::model
