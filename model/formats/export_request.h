// What is wanted of an export, and how it is carried out: the window's dialog and the command line fill the same
// request.
#pragma once

#include "model/exporting/avatar.h"
#include "model/exporting/curve_set.h"
#include "model/exporting/export_space.h"
#include "model/project/project.h"
#include "model/values/error.h"

#include <QString>

#include <memory>
#include <vector>

namespace hairpaint::model {

struct ExportFormat;
struct ExportTarget;

struct ExportRequest
{
    const ExportFormat* format = nullptr;
    const ExportTarget* target = nullptr;
    CurveOptions curves{};
    CardSettings cards{};
    QString author{};              ///< Author of an exported avatar; empty is "Unknown".
    std::vector<HeadPart> parts{}; ///< Parts of the head's character, Hd.
    /// The texture on the head's skin; null where its file has none.
    std::shared_ptr<const sim::MeshTexture> headTexture{};
    std::vector<Worn> worn{};               ///< See ExportSettings.
    QRgb skinColour = 0xFF808080;           ///< Colour of the skin of an exported head.
    std::shared_ptr<const Avatar> avatar{}; ///< Null for formats other than avatars.
};

/// Adds what the project gives: worn things, the head's parts, texture and skin colour, and for formats of avatars the
/// avatar. It has the name of the project's file, and of `path`, the file to be written, where the project was never
/// saved and `projectPath` is empty. Fails where the head's skeleton has no avatar's bones.
[[nodiscard]] Result<void> addProject(ExportRequest& request, const Project& project, const QString& projectPath,
                                      const QString& path);

/// What the format does not take is left out (see ExportFormat::requestFor). Atomic: nothing is written where it fails
/// or `progress`, which never steps back, cancels. Any thread.
[[nodiscard]] Result<void> exportHair(const std::shared_ptr<const sim::StrandFrame>& frame, const ExportRequest& wanted,
                                      const QString& path, const Progress& progress = {});

} // namespace hairpaint::model
