// The library of styles as this program finds it: where the user's own ones lie, and a style by its name.
#pragma once

#include "model/files/preset_file.h"

#include <QString>
#include <QStringList>

#include <functional>

namespace hairpaint::app {

/// Created when a style is first saved there.
[[nodiscard]] QString ownPresetFolder();

/// By name, without regard to case, or by path.
[[nodiscard]] model::Result<model::Preset> loadPresetNamed(const QString& nameOrPath);

/// The style that the program starts with, applied to a new project on the head of new projects. Any thread.
[[nodiscard]] model::Project starterProject();
/// A new project without hair; what is painted on it differs from hair to hair as people's does. Any thread.
[[nodiscard]] model::Project baldProject();

/// The entry of the bald head in the list of styles; not a file.
[[nodiscard]] QString baldStylePath();
/// The styles as the window lists them: a bald head first, then model::listPresets.
[[nodiscard]] std::vector<model::PresetEntry> listStyles(QStringList* problems = nullptr);
/// A name for what a style of that list holds: of another content, another. Empty where its file can't be read. Any
/// thread.
[[nodiscard]] QString styleContentName(const QString& path);
/// A style of that list. Any thread.
[[nodiscard]] model::Result<model::Preset> loadStyle(const QString& path);
/// The name of a style of that list as people read it: opens its file. Any thread.
[[nodiscard]] QString styleName(const QString& path);
/// The user's own style gets another name, and a file named after it; a style of that name is replaced;
/// nothing changes where `progress` says no in time. Reads and writes the whole style. Any thread.
[[nodiscard]] model::Result<void> renameStyle(const QString& path, const QString& name,
                                              const model::Progress& progress = {});
/// The path of the user's own style of that name.
[[nodiscard]] QString ownStylePath(const QString& name);

/// Reads a style of the user's own whole, lets `change` change it and writes it under the same path. Any thread.
[[nodiscard]] model::Result<void> changeStyle(const QString& path, const std::function<void(model::Preset&)>& change,
                                              const model::Progress& progress = {});
/// Adds a file to the user's own styles; where one of its name is there already, under a name with a number. A file
/// that is one of them already adds nothing. False where nothing was added. Any thread.
[[nodiscard]] model::Result<bool> importStyle(const QString& path, const model::Progress& progress = {});
/// Writes a style of the list into a folder, under a name that is free there. Any thread.
[[nodiscard]] model::Result<void> exportStyle(const QString& path, const QString& folder,
                                              const model::Progress& progress = {});

/// Tags as people write them, with commas, in their language; those that the program knows become its own.
[[nodiscard]] QString shownTags(const QStringList& tags);
[[nodiscard]] QStringList tagsFrom(const QString& text);

} // namespace hairpaint::app
