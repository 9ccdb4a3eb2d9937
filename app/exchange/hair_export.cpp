// Which frame is exported, and the export.
#include "app/exchange/hair_export.h"

#include "app/headless/settled_hair.h"
#include "model/values/sentences.h"

namespace hairpaint::app {

namespace {

constexpr int kSettleSteps = 20;
constexpr double kSettleStepSeconds = 0.1;
constexpr double kSettledPart = 0.7; ///< Fraction of all work that is done once the hair has settled.

/// Null where `progress` cancels.
std::shared_ptr<const sim::StrandFrame> settledFrame(const model::Project& project, const model::Progress& progress)
{
    SettledHair hair(project, kSettleStepSeconds);
    for (int step = 1; step < kSettleSteps; ++step) {
        if (!progress(static_cast<double>(step) / kSettleSteps))
            return nullptr;
        hair.advance(kSettleStepSeconds);
    }
    return hair.frame();
}

/// A frame, and the progress of what is made of it.
struct Shape
{
    std::shared_ptr<const sim::StrandFrame> frame; ///< Null where it was cancelled.
    model::Progress progress;
};

Shape chosenShape(const model::Project& project, const std::shared_ptr<const sim::StrandFrame>& now,
                  view::HairSource source, const model::Progress& progress)
{
    if (source == view::HairSource::Now)
        return {.frame = now, .progress = progress};
    if (source == view::HairSource::Rest)
        return {.frame = SettledHair(project, 0.0).frame(), .progress = progress};
    return {.frame = settledFrame(project, [&](double done) { return progress(kSettledPart * done); }),
            .progress = [progress](double done) { return progress(kSettledPart + (1.0 - kSettledPart) * done); }};
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

QString avatarProblem(const model::Project& project)
{
    const model::Checked<std::shared_ptr<const model::Avatar>> avatar = model::avatarOf(*project.head, {}, {});
    return avatar ? QString()
                  : model::say(QT_TRANSLATE_NOOP("Files", "This can be no avatar: %1.")).arg(avatar.error().text);
}

model::Result<void> exportChosen(const model::Project& project, const std::shared_ptr<const sim::StrandFrame>& frame,
                                 const view::HairExportChoice& choice, const QString& projectPath, const QString& path,
                                 const model::Progress& progress)
{
    model::ExportRequest request = choice.request;
    if (model::Result<void> whole = model::addProject(request, project, projectPath, path); !whole)
        return whole;
    const Shape shape = chosenShape(project, frame, choice.source, progress);
    if (shape.frame == nullptr)
        return model::cancelled(path);
    return model::exportHair(shape.frame, request, path, shape.progress);
}

model::Result<std::shared_ptr<const rendering::CardSet>>
cardsChosen(const model::Project& project, const std::shared_ptr<const sim::StrandFrame>& frame,
            const view::HairExportChoice& choice, const model::Progress& progress)
{
    constexpr double kMeasured = 0.2; // The fraction of all work that is done once the curves are found.
    const model::ExportFormat& format = choice.request.format->hasCards ? *choice.request.format : model::cardFormat();
    const model::ExportRequest wanted = format.requestFor(choice.request);
    const Shape shape = chosenShape(project, frame, choice.source, progress);
    std::optional<model::HairCards> cards;
    std::vector<sim::StrandMaterial> materials;
    if (shape.frame != nullptr)
        if (const std::optional<model::CurveSet> curves = model::CurveSet::of(
                shape.frame, wanted.curves, [&](double done) { return shape.progress(kMeasured * done); })) {
            cards = model::makeCards(*curves, wanted.cards,
                                     [&](double done) { return shape.progress(kMeasured + (1.0 - kMeasured) * done); });
            for (const model::CurveGroup& group : curves->groups())
                materials.push_back(shape.frame->groups[group.frameGroup].groom->settings.material);
        }
    if (!cards)
        return model::cancelled(project.head->name);
    return view::cardSet(*cards, shape.frame->pose, materials);
}

} // namespace hairpaint::app
