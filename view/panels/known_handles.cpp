// States of groups, found again by what handles change.
#include "view/panels/known_handles.h"

#include <algorithm>
#include <utility>

namespace hairpaint::view {

const KnownHandles::State& KnownHandles::of(model::Document& document, model::Id group)
{
    const model::Project& project = document.committed();
    const model::HairGroup& now = *project.group(group);
    const model::HandledHair hair = model::HandledHair::of(now);
    const auto known = std::ranges::find_if(m_states, [&](const State& state) {
        return state.group == group && state.head == project.head && state.hair == hair;
    });
    if (known != m_states.end()) {
        std::rotate(known, known + 1, m_states.end());
        return m_states.back();
    }
    add({.group = group,
         .head = project.head,
         .hair = hair,
         .values = {},
         .handles = std::make_shared<model::HairHandles>(now, project.head,
                                                         document.resolvedNow(group, model::MapKind::Density),
                                                         document.resolvedNow(group, model::MapKind::Direction))});
    return m_states.back();
}

void KnownHandles::add(State state)
{
    if (m_states.size() == kKept)
        m_states.erase(m_states.begin());
    m_states.push_back(std::move(state));
}

} // namespace hairpaint::view
