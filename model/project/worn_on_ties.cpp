// A thing and its tie as one rigid body, which grows with the tie.
#include "model/project/worn_on_ties.h"

#include "model/project/project.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

constexpr float kAwayRadii = 3.0F; ///< Of the tie: further away from its middle a thing does not sit on it.

const Worn* find(const std::vector<Worn>& all, Id id)
{
    const auto found = std::ranges::find(all, id, &Worn::id);
    return found != all.end() ? &*found : nullptr;
}

bool sameShape(const sim::Ellipsoid& a, const sim::Ellipsoid& b)
{
    return a.centreHd == b.centreHd && a.rotation == b.rotation && a.semiAxesM == b.semiAxesM;
}

void carryWith(Worn& worn, const sim::Ellipsoid& was, const Worn& tie)
{
    const sim::Ellipsoid& now = tie.shape;
    const glm::quat turn = glm::normalize(now.rotation) * glm::conjugate(glm::normalize(was.rotation));
    const float grown = was.semiAxesM.x > 0.0F ? now.semiAxesM.x / was.semiAxesM.x : 1.0F;
    worn.shape.centreHd = now.centreHd + turn * (worn.shape.centreHd - was.centreHd) * grown;
    worn.shape.rotation = glm::normalize(turn * worn.shape.rotation);
    worn.anchor = tie.anchor;
}

} // namespace

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
        const bool isMoved = one.shape.centreHd != was->shape.centreHd || one.shape.rotation != was->shape.rotation;
        if (isMoved) {
            const bool isAway =
                sameShape(tie.shape, tieBefore->shape) &&
                glm::distance(one.shape.centreHd, tie.shape.centreHd) > kAwayRadii * tie.shape.semiAxesM.x;
            one.tie = isAway ? 0 : one.tie;
            changed |= isAway;
        } else if (!sameShape(tie.shape, tieBefore->shape)) {
            carryWith(one, tieBefore->shape, tie);
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
