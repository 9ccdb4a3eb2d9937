// Heads from foreign meshes.
#pragma once

#include "model/files/head_file.h"
#include "model/files/importer_client.h"

#include <QStringList>

namespace hairpaint::app {

struct ImportedHead
{
    std::shared_ptr<const model::Head> head;
    std::vector<sim::Ellipsoid> ellipsoids; ///< Colliders fitted to the skin.
    QByteArray sourceGlb;
    model::HeadGuess guess; ///< The unit and axis it was made with.
    QStringList remarks{};  ///< Remarks on the parts and the layout; see model::ChosenHead.
};

/// Makes a head of any mesh that the helper reads and that has uvs, in the space that the user or the file gives.
/// Blocking; any thread.
[[nodiscard]] model::Result<ImportedHead> importHead(const QString& path, const model::HeadChoice& choice = {},
                                                     const model::Progress& progress = {});
/// Makes a head of a mesh whose parts were chosen (see model::choosePartsBy).
[[nodiscard]] model::Result<ImportedHead> headOf(const QString& path, const model::RiggedMesh& source, bool ownLayout,
                                                 const model::HeadGuess& guess, const model::Progress& progress = {});
/// Makes a head of the same source with another unit and axis.
[[nodiscard]] model::Result<ImportedHead> remakeHead(const QString& name, const QByteArray& sourceGlb,
                                                     const model::HeadGuess& guess,
                                                     const model::Progress& progress = {});

} // namespace hairpaint::app
