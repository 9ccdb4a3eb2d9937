// Things that sit on ties go where their ties go.
#pragma once

#include "model/project/worn.h"

#include <functional>
#include <map>
#include <vector>

namespace hairpaint::model {

struct Project;

/// The tie that a new thing of the kind sits on (WornSpec::seat) that is put on at a point; null: none.
[[nodiscard]] const Worn* tieBeside(const std::vector<Worn>& all, const WornSpec& spec, glm::vec3 positionHd);
/// Puts it on the tie as its kind's seat tells. From then on it goes with the tie (followTies).
void sitOn(Worn& worn, const Worn& tie);

/// After things changed from `before` to `all`: what sits on a tie (Worn::tie) that was moved, turned or sized, or
/// whose bun was, is moved with it, unless it was moved itself; what sits on a tie that is gone is gone too. What was
/// itself moved away from its tie sits on it no more. Run again it changes nothing. Returns whether it changed
/// anything.
bool followTies(std::vector<Worn>& all, const std::vector<Worn>& before);

/// Runs an edit of a project, after which things follow their ties.
void runFollowingTies(Project& project, const std::function<void(Project&)>& edit);

/// After things got other ids, old id to new: what sat on a tie that has none of them sits on none.
void renameTies(std::vector<Worn>& all, const std::map<Id, Id>& ids);

} // namespace hairpaint::model
