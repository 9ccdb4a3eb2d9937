// A body as a mesh of USD's text form.
#pragma once

#include "model/exporting/export_space.h"
#include "model/exporting/worn_body.h"

#include <QString>

#include <string>

namespace hairpaint::model {

/// The text of a Mesh of that name below /Hair, in `space`, with its material inside, so that it can be taken along
/// alone.
[[nodiscard]] std::string usdMesh(const WornBody& body, const QString& name, const ExportSpace& space);

} // namespace hairpaint::model
