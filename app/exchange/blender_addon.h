// Installs our add-on for Blender, which reads `.hair` files.
#pragma once

#include "model/values/error.h"
#include "model/values/progress.h"

#include <QStringList>

namespace hairpaint::app {

/// The script's name.
[[nodiscard]] QString blenderAddonName();
/// The folders of add-ons of each Blender, 3.4 or later, that the user has started once; they need not be there yet.
[[nodiscard]] QStringList blenderAddonFolders();
/// "3.4" of such a folder.
[[nodiscard]] QString blenderVersionOf(const QString& addonFolder);
/// Makes the folder and writes the script into it. Atomic.
[[nodiscard]] model::Result<void> installBlenderAddon(const QString& addonFolder, const model::Progress& progress = {});
/// Only writes the script. Atomic.
[[nodiscard]] model::Result<void> saveBlenderAddon(const QString& path, const model::Progress& progress = {});

} // namespace hairpaint::app
