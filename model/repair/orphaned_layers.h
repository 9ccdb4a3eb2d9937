// Layers whose images are there and of which a damaged project.json says nothing.
#pragma once

#include "model/repair/mended_json.h"

#include <QStringList>

namespace hairpaint::model {

/// Puts them into `root`, what mendedJson gives: on top of their map's layers, by their numbers, in their group or in a
/// new one. `names`: of the archive's entries.
void adoptOrphans(QJsonObject& root, const QStringList& names, const SizeOfLayer& sizeOfLayer, Losses& losses);

} // namespace hairpaint::model
