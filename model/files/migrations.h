// Bringing the JSON of older format versions up to the present one, a step a version.
#pragma once

#include "model/values/sentences.h"

#include <QJsonObject>

namespace hairpaint::model {

inline constexpr int kFormatVersion = 2;

/// Errors: a clause, where the version is missing or newer than this program's.
[[nodiscard]] Checked<QJsonObject> migrated(QJsonObject root);

} // namespace hairpaint::model
