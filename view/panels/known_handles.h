// The handles of groups as they are, and at which values they stand.
#pragma once

#include "model/handles/hair_handles.h"

#include <memory>
#include <vector>

namespace hairpaint::view {

/// A state of a group that its handles made: undo and redo come back to it. Hair that no handle made is a new base,
/// with all handles at their usual values. The last few states stay in memory. GUI thread.
class KnownHandles
{
public:
    struct State
    {
        model::Id group = 0;
        std::shared_ptr<const model::Head> head;
        model::HandledHair hair;
        model::HandleValues values;
        std::shared_ptr<model::HairHandles> handles;
    };
    /// The state of a group as it is committed. The group must exist, and no edit of it may be shown.
    [[nodiscard]] const State& of(model::Document& document, model::Id group);
    /// Adds a state that the group is about to have.
    void add(State state);
    void forget() { m_states.clear(); } ///< Drops all states.

private:
    static constexpr std::size_t kKept = 8;
    std::vector<State> m_states; ///< The latest last.
};

} // namespace hairpaint::view
