// Keeps the options of the tools between runs.
#pragma once

#include "app/settings/settings.h"
#include "view/editing/editor_state.h"

namespace hairpaint::app {

/// Every row that a tool names (model/tools/tool_options.h); what is painted with stays as it is. GUI thread.
void recallToolOptions(const Settings& settings, view::EditorState& editor);
void rememberToolOptions(Settings& settings, const view::EditorState& editor);

} // namespace hairpaint::app
