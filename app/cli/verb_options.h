// The options of each verb, as rows.
#pragma once

#include "app/cli/command.h"

namespace hairpaint::app {

[[nodiscard]] std::vector<CommandOption> newOptions();
[[nodiscard]] std::vector<CommandOption> listingOptions(); ///< Options of the verbs info and presets.
[[nodiscard]] std::vector<CommandOption> exportOptions();
[[nodiscard]] std::vector<CommandOption> renderOptions();
[[nodiscard]] std::vector<CommandOption> repairOptions();

/// "1024, 2048 or 4096".
[[nodiscard]] QString listOf(const QStringList& words);

} // namespace hairpaint::app
