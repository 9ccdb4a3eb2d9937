// Hairstyles on disk: `.hairpreset`, and the library of built-in and own ones.
// Any thread. Errors: a file that is missing, truncated, foreign, hostile or oversized gives one sentence that names
// it; so does want of memory.
#pragma once

#include "model/styles/preset.h"
#include "model/values/error.h"
#include "model/values/progress.h"

namespace hairpaint::model {

[[nodiscard]] Result<Preset> loadPreset(const QString& path); ///< Also resource paths (":/presets/bob.hairpreset").
[[nodiscard]] Result<void> savePreset(const Preset& preset, const QString& path, const Progress& progress = {});

/// What the library knows without reading the maps.
struct PresetEntry
{
    QString path;
    QString name;
    QStringList tags;
    QString folder; ///< "built-in" or "own".
    QImage picture;
};

/// The entry of one file.
[[nodiscard]] Result<PresetEntry> presetEntry(const QString& path);

/// Paths of the built-in styles (":/presets"), in the order of the lines of its order.txt, one base name each.
[[nodiscard]] QStringList builtInPresets();

/// Built-in styles (":/presets", in the order of the lines of its order.txt, one base name each), then those in
/// `ownFolder` by name. Files that can't be read are left out and named in `problems`.
[[nodiscard]] std::vector<PresetEntry> listPresets(const QString& ownFolder, QStringList* problems = nullptr);

} // namespace hairpaint::model
