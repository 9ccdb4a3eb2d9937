// A change that the user can make, as an undo command. It holds ids, never pointers into the project. Making one first
// ends the edit that runs, by its policy.
#pragma once

#include <QUndoCommand>

#include <memory>

namespace hairpaint::model {

using CommandPtr = std::unique_ptr<QUndoCommand>;

} // namespace hairpaint::model
