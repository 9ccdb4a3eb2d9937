// The kind of a file that is dropped on the window or named on the command line.
#pragma once

#include "model/project/map_spec.h"

#include <QString>

namespace hairpaint::app {

enum class FileKind
{
    Project,
    Style,
    Head,
    Curves,
    Image ///< Whatever is none of the others.
};

/// By its ending.
[[nodiscard]] FileKind fileKind(const QString& path);

/// What letting go of it will do, in a sentence; an image goes into `map`.
[[nodiscard]] QString dropText(FileKind kind, const model::MapSpec& map);

} // namespace hairpaint::app
