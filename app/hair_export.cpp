// Which frame is exported, and the export.
#include "app/hair_export.h"

#include "app/cli/settled_hair.h"
#include "model/files/sentences.h"
#include "model/skin_tone.h"

namespace hairpaint::app {

namespace {

constexpr int kSettleSteps = 20;
constexpr double kSettleStepSeconds = 0.1;
constexpr double kSettledPart = 0.7; ///< Of all work.

/// Null where `progress` cancels.
std::shared_ptr<const sim::StrandFrame> settledFrame(const model::Project& project, const model::Progress& progress)
{
    SettledHair hair(project, kSettleStepSeconds);
    for (int step = 1; step < kSettleSteps; ++step) {
        if (!progress(kSettledPart * step / kSettleSteps))
            return nullptr;
        hair.advance(kSettleStepSeconds);
    }
    return hair.frame();
}

} // namespace

std::vector<view::ExportableGroup> exportableGroups(const model::Project& project, const sim::StrandFrame& frame)
{
    std::vector<view::ExportableGroup> groups;
    for (const sim::GroupFrame& shown : frame.groups) {
        const model::HairGroup* group = project.group(shown.groom->groupId);
        if (group != nullptr && shown.groom->visible)
            groups.push_back({.id = group->id, .name = group->name, .hairs = shown.groom->drawnCount});
    }
    return groups;
}

model::Result<void> exportChosen(const model::Project& project, const std::shared_ptr<const sim::StrandFrame>& frame,
                                 const view::HairExportChoice& choice, const QString& path,
                                 const model::Progress& progress)
{
    model::ExportRequest request = choice.request;
    request.colliders = project.ellipsoids;
    request.skinColour = model::skinLook(project.skin).skin;
    if (choice.source == view::HairSource::Now)
        return model::exportHair(frame, request, path, progress);
    if (choice.source == view::HairSource::Rest)
        return model::exportHair(SettledHair(project, 0.0).frame(), request, path, progress);
    const std::shared_ptr<const sim::StrandFrame> settled = settledFrame(project, progress);
    if (settled == nullptr)
        return model::cancelled(path);
    return model::exportHair(settled, request, path,
                             [&progress](double done) { return progress(kSettledPart + (1.0 - kSettledPart) * done); });
}

} // namespace hairpaint::app
