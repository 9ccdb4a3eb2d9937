// Names that the program gives by itself: groups, layers, the built-in styles and their tags.
#pragma once

#include <QString>

namespace hairpaint::model {

/// A new group's or layer's name, as it stands in files: "Group 2", "Layer 1". English, so that the same work gives the
/// same file in every language.
[[nodiscard]] QString groupName(qsizetype number);
[[nodiscard]] QString numberedName(const QString& name, qsizetype number); ///< "Beard 2".
[[nodiscard]] QString layerName(qsizetype number);

/// A name as people read it: translated where the program gave it, else as it is.
[[nodiscard]] QString shownName(const QString& name);

} // namespace hairpaint::model
