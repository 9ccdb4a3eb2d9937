// Keys of the window that go by their position on the keyboard, since many layouts can't type them.
#pragma once

#include "app/window/physical_keys.h"
#include "model/project/map_spec.h"

#include <optional>

class QAction;
class QKeyEvent;

namespace hairpaint::app {

class ActionSet;
class Session;
class Workspace;

/// Brackets and digits trigger the actions that have those keys. Alt and a digit: strands take that map's colours while
/// both are held. Everything outlives it. GUI thread.
class PositionKeys
{
public:
    PositionKeys(ActionSet& actions, Session& session, Workspace& workspace)
        : m_actions(actions), m_session(session), m_workspace(workspace)
    {}

    /// False leaves the key to others.
    [[nodiscard]] bool press(const QKeyEvent& event);
    void release(const QKeyEvent& event);
    /// As if all keys were released: another window gets their releases.
    void letGo() { lookAt(std::nullopt); }

private:
    void lookAt(std::optional<model::MapKind> map);
    /// The action that has that key, null where it has been given another.
    [[nodiscard]] QAction* actionAt(PhysicalKey key) const;

    ActionSet& m_actions;
    Session& m_session;
    Workspace& m_workspace;
};

} // namespace hairpaint::app
