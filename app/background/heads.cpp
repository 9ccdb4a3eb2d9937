// Heads from foreign meshes: see the header.
#include "app/background/heads.h"

#include "model/files/glb_writing.h"
#include "model/files/part_selection.h"
#include "model/values/sentences.h"

#include <QFileInfo>

namespace hairpaint::app {

namespace {

constexpr int kFittedEllipsoids = 5;
/// Fractions of the whole preparation that are done once the mesh is read and the skin is made.
constexpr double kReadingFraction = 0.1;
constexpr double kSkinFraction = 0.5;

} // namespace

model::Result<ImportedHead> importHead(const QString& path, const model::HeadChoice& choice,
                                       const model::Progress& progress)
{
    model::Result<model::RiggedMesh> mesh = model::ImporterClient().readMesh(path, progress);
    if (!mesh)
        return tl::unexpected(mesh.error());
    const model::HeadGuess guess = model::chosen(model::guessHead(*mesh), choice);
    if (choice.facing && !model::turnToFront(*mesh, guess.upAxis, *choice.facing))
        return model::cannotOpen(
            path, model::Clause{.text = model::say(QT_TRANSLATE_NOOP("Files", "its face can't look along the axis that "
                                                                              "is up; choose another axis for one of "
                                                                              "them")),
                                .cure = model::Clause::Cure::OtherFile});
    if (const model::Checked<void> parts = model::choosePartsBy(*mesh, choice, guess); !parts)
        return model::cannotOpen(path, parts.error());
    return headOf(path, *mesh, choice.ownLayout, guess, progress);
}

model::Result<ImportedHead> headOf(const QString& path, const model::RiggedMesh& source, bool ownLayout,
                                   const model::HeadGuess& guess, const model::Progress& progress)
{
    model::Checked<model::ChosenHead> head = model::headOfParts(source, ownLayout);
    if (!head)
        return model::cannotOpen(path, head.error());
    model::Result<ImportedHead> made =
        remakeHead(QFileInfo(path).completeBaseName(), model::glbFromMesh(head->mesh), guess, progress);
    if (made)
        made->remarks = std::move(head->remarks);
    return made;
}

model::Result<ImportedHead> remakeHead(const QString& name, const QByteArray& sourceGlb, const model::HeadGuess& guess,
                                       const model::Progress& progress)
{
    const auto goesOn = [&progress](double done) { return !progress || progress(done); };
    if (!goesOn(kReadingFraction))
        return model::cancelled(name);
    model::Result<std::shared_ptr<const model::Head>> head =
        model::makeHead(name, sourceGlb, guess.unitScale, guess.upAxis, [&] { return goesOn(kReadingFraction); });
    if (!head)
        return tl::unexpected(head.error());
    ImportedHead result;
    result.head = std::move(*head);
    const auto keepGoing = [&](double fitted) { return goesOn(kSkinFraction + (1.0 - kSkinFraction) * fitted); };
    result.ellipsoids = sim::fitEllipsoids(result.head->skin->mesh(), kFittedEllipsoids, keepGoing);
    if (!goesOn(1.0))
        return model::cancelled(name);
    result.sourceGlb = sourceGlb;
    result.guess = guess;
    return result;
}

} // namespace hairpaint::app
