// The order in which menus offer what can be tied and put on.
#pragma once

#include "model/project/worn.h"

#include <vector>

namespace hairpaint::app {

/// Ties, then what only adorns, then what stands for parts of the head; null: a line between them. GUI thread.
[[nodiscard]] std::vector<const model::WornSpec*> wornInMenus();

} // namespace hairpaint::app
