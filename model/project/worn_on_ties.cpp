// A thing and its tie as one rigid body, which grows with the tie.
#include "model/project/worn_on_ties.h"

#include "model/project/project.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace hairpaint::model {

namespace {

const Worn* find(const std::vector<Worn>& all, Id id)
{
    const auto found = std::ranges::find(all, id, &Worn::id);
    return found != all.end() ? &*found : nullptr;
}

/// Outer radius of what a thing of the kind sits on: the ring, or the coil of a bun.
float seatRadiusM(const WornSpec& spec, const Worn& tie)
{
    const bool isOnCoil = spec.seat && spec.seat->aroundHair && tie.coilRadiusM > 0.0F;
    return isOnCoil ? tie.coilRadiusM : tie.shape.semiAxesM.x;
}

/// How far from the tie's middle a thing of the kind is put on it, over the tie's own height off the skin.
float reachM(const WornSpec& spec, const Worn& tie)
{
    return seatRadiusM(spec, tie) + tie.shape.semiAxesM.x;
}

bool isSameSeat(const WornSpec& spec, const Worn& a, const Worn& b)
{
    return a.shape.centreHd == b.shape.centreHd && a.shape.rotation == b.shape.rotation &&
           seatRadiusM(spec, a) == seatRadiusM(spec, b);
}

void carryWith(Worn& worn, const Worn& before, const Worn& tie)
{
    const sim::Ellipsoid& was = before.shape;
    const sim::Ellipsoid& now = tie.shape;
    const glm::quat turn = glm::normalize(now.rotation) * glm::conjugate(glm::normalize(was.rotation));
    const WornSpec& spec = wornSpec(worn.kind);
    const float wasM = seatRadiusM(spec, before);
    const float grown = wasM > 0.0F ? seatRadiusM(spec, tie) / wasM : 1.0F;
    worn.shape.centreHd = now.centreHd + turn * (worn.shape.centreHd - was.centreHd) * grown;
    worn.shape.rotation = glm::normalize(turn * worn.shape.rotation);
    worn.anchor = tie.anchor;
}

/// The turn about the tie's axis from its y to the side on which a point is.
glm::quat towardSide(const Worn& tie, glm::vec3 positionHd)
{
    constexpr float kOnAxis = 0.05F; // In the ring's radii; there it has no side.
    const glm::vec3 away = glm::conjugate(glm::normalize(tie.shape.rotation)) * (positionHd - tie.shape.centreHd);
    const float length = glm::length(glm::vec2(away));
    if (length <= kOnAxis * tie.shape.semiAxesM.x)
        return {1.0F, 0.0F, 0.0F, 0.0F};
    // Of half the angle; opposite to y it is a half turn.
    const float cosine = std::sqrt(std::max(0.0F, 0.5F * (1.0F + away.y / length)));
    const float sine = std::sqrt(std::max(0.0F, 0.5F * (1.0F - away.y / length)));
    return glm::normalize(glm::quat(cosine, 0.0F, 0.0F, std::copysign(sine, -away.x)));
}

} // namespace

const Worn* tieBeside(const std::vector<Worn>& all, const WornSpec& spec, glm::vec3 positionHd)
{
    if (!spec.seat)
        return nullptr;
    const Worn* nearest = nullptr;
    float nearestM = std::numeric_limits<float>::max();
    for (const Worn& one : all) {
        if (!wornSpec(one.kind).tie)
            continue;
        const float awayM = glm::distance(one.shape.centreHd, positionHd);
        if (awayM < std::min(nearestM, reachM(spec, one))) {
            nearest = &one;
            nearestM = awayM;
        }
    }
    return nearest;
}

void sitOn(Worn& worn, const Worn& tie)
{
    const WornSpec& spec = wornSpec(worn.kind);
    if (!spec.seat)
        return;
    const TieSeat& seat = *spec.seat;
    glm::quat turn = glm::normalize(tie.shape.rotation);
    if (seat.aroundHair)
        turn = turn * towardSide(tie, worn.shape.centreHd);
    const float awayM =
        seat.ringRadii * seatRadiusM(spec, tie) + seat.ownRadii * worn.shape.semiAxesM.x / spec.proportions.x;
    worn.shape.centreHd = tie.shape.centreHd + turn * glm::vec3(0.0F, awayM, 0.0F);
    worn.shape.rotation = glm::normalize(turn * seat.turn);
    worn.anchor = tie.anchor;
    worn.tie = tie.id;
}

bool followTies(std::vector<Worn>& all, const std::vector<Worn>& before)
{
    if (std::ranges::all_of(all, [](const Worn& one) { return one.tie == 0; }))
        return false;
    bool changed = std::erase_if(all, [ties = all](const Worn& one) {
                       return one.tie != 0 && find(ties, one.tie) == nullptr;
                   }) > 0;
    for (Worn& one : all) {
        const Worn* tieBefore = one.tie != 0 ? find(before, one.tie) : nullptr;
        const Worn* was = find(before, one.id);
        if (tieBefore == nullptr || was == nullptr || was->tie != one.tie)
            continue; // Both are new: as they were put on.
        const Worn& tie = *find(all, one.tie);
        const WornSpec& spec = wornSpec(one.kind);
        const bool isMoved = one.shape.centreHd != was->shape.centreHd || one.shape.rotation != was->shape.rotation;
        if (isMoved) {
            constexpr float kAway = 1.5F; // Of how near it is put on.
            const bool isAway = isSameSeat(spec, tie, *tieBefore) &&
                                glm::distance(one.shape.centreHd, tie.shape.centreHd) > kAway * reachM(spec, tie);
            one.tie = isAway ? 0 : one.tie;
            changed |= isAway;
        } else if (!isSameSeat(spec, tie, *tieBefore)) {
            carryWith(one, *tieBefore, tie);
            changed = true;
        }
    }
    return changed;
}

void runFollowingTies(Project& project, const std::function<void(Project&)>& edit)
{
    const std::vector<Worn> before = project.worn;
    edit(project);
    if (project.worn != before)
        followTies(project.worn, before);
}

void renameTies(std::vector<Worn>& all, const std::map<Id, Id>& ids)
{
    for (Worn& one : all) {
        const auto found = ids.find(one.tie);
        one.tie = found != ids.end() ? found->second : 0;
    }
}

} // namespace hairpaint::model
