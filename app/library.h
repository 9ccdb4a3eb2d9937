// The library of styles as this program finds it: where the user's own ones lie, and a style by its name.
#pragma once

#include "model/files/preset_file.h"

#include <QString>

namespace hairpaint::app {

/// Made when a style is first saved there.
[[nodiscard]] QString ownPresetFolder();

/// By name, without regard to case, or by path.
[[nodiscard]] model::Result<model::Preset> loadPresetNamed(const QString& nameOrPath);

/// The style that the program starts with, applied to a new project on the built-in head.
[[nodiscard]] model::Project starterProject();

} // namespace hairpaint::app
