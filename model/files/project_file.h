// Projects on disk: `.hairpaint`. The format is specified in model/files/hairpaint_format.md.
#pragma once

#include "model/project/project.h"
#include "model/values/error.h"
#include "model/values/progress.h"

#include <QImage>

#include <atomic>
#include <functional>

namespace hairpaint::model {
class EncodedLayers;

/// Any thread. Runs no foreign decoder. A file that is missing, truncated, foreign, hostile or oversized gives an
/// error.
[[nodiscard]] Result<Project> loadProject(const QString& path, EncodedLayers* cache = nullptr,
                                          const Progress& progress = {});
/// Atomic. Same project, same bytes, the thumbnail aside. Any thread, on a copy of the project.
[[nodiscard]] Result<void> saveProject(const Project& project, const QString& path, const QImage& thumbnail,
                                       EncodedLayers* cache = nullptr, const Progress& progress = {});

/// A project on the first of the built-in heads, with one empty group "Scalp".
[[nodiscard]] Project newProject();

} // namespace hairpaint::model
