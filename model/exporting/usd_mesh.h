// A body as a mesh of USD's text form.
#pragma once

#include "model/exporting/export_space.h"
#include "model/exporting/worn_body.h"

#include <QString>

#include <string>

namespace hairpaint::model {

/// The text of a Mesh of that name below /Hair, in `space`, with its material inside, so that it can be taken along
/// alone. `image`: the file of its texture, beside the text's own; empty where it has none.
[[nodiscard]] std::string usdMesh(const WornBody& body, const QString& name, const QString& image,
                                  const ExportSpace& space);

} // namespace hairpaint::model
