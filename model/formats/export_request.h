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
    QString author{};                                      ///< Of avatars; empty is "Unknown".
    std::vector<HeadPart> parts{};                         ///< Of the head's character, Hd;
    std::shared_ptr<const sim::MeshTexture> headTexture{}; ///< and what its file shows on the skin.
    std::vector<Worn> worn{};                              ///< See ExportSettings.
    QRgb skinColour = 0xFF808080;                          ///< Likewise.
    std::shared_ptr<const Avatar> avatar{};                ///< There where the format is one of avatars.
};

/// Adds what the project gives: what is worn, colour of the skin, and the avatar where the format is one of avatars. It
/// is named as the project's file is, and as `path`, the file that would be written, where the project was never saved
/// and `projectPath` is empty. Fails where the head has no such skeleton.
[[nodiscard]] Result<void> addProject(ExportRequest& request, const Project& project, const QString& projectPath,
                                      const QString& path);

/// What the format does not take is left out (see ExportFormat::requestFor). Atomic: nothing is written where it fails
/// or `progress`, which never steps back, cancels. Any thread.
[[nodiscard]] Result<void> exportHair(const std::shared_ptr<const sim::StrandFrame>& frame, const ExportRequest& wanted,
                                      const QString& path, const Progress& progress = {});

} // namespace hairpaint::model
