// Bringing the JSON of older format versions up to the present one, a step a version.
#pragma once

#include "model/values/sentences.h"

#include <QJsonObject>

namespace hairpaint::model {

inline constexpr int kFormatVersion = 4;     ///< The newest version: of files whose character has several parts.
inline constexpr int kWornFormatVersion = 3; ///< The version of files in which something is worn.
/// The version of files that need none newer, so that older programs read them.
inline constexpr int kPlainFormatVersion = 2;

/// Errors: a clause, where the version is missing or newer than this program's.
[[nodiscard]] Checked<QJsonObject> migrated(QJsonObject root);

} // namespace hairpaint::model
