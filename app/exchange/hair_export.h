// Exporting hair from the window: the dialog's choice, carried out.
#pragma once

#include "model/project/project.h"
#include "view/dialogs/export_hair_dialog.h"
#include "view/head_area/card_scene.h"

namespace hairpaint::app {

/// The visible groups of a project, with the hairs that a frame shows of them.
[[nodiscard]] std::vector<view::ExportableGroup> exportableGroups(const model::Project& project,
                                                                  const sim::StrandFrame& frame);

/// Why the head can be no avatar, as a sentence; empty where it can.
[[nodiscard]] QString avatarProblem(const model::Project& project);

/// `frame`: the hair as it is now. The other shapes are made anew, which takes its time. Any thread; nothing is written
/// where it fails or `progress` cancels. `projectPath`: as of model::addProject.
[[nodiscard]] model::Result<void> exportChosen(const model::Project& project,
                                               const std::shared_ptr<const sim::StrandFrame>& frame,
                                               const view::HairExportChoice& choice, const QString& projectPath,
                                               const QString& path, const model::Progress& progress);

/// The cards that it would write, for a preview.
[[nodiscard]] model::Result<std::shared_ptr<const rendering::CardSet>>
cardsChosen(const model::Project& project, const std::shared_ptr<const sim::StrandFrame>& frame,
            const view::HairExportChoice& choice, const model::Progress& progress);

} // namespace hairpaint::app
