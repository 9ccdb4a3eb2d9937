// Heads from foreign meshes: see the header.
#include "app/heads.h"

#include <QFileInfo>

namespace hairpaint::app {

namespace {

constexpr int kFittedEllipsoids = 5;

} // namespace

model::Result<ImportedHead> importHead(const QString& path, const model::Progress& progress)
{
    const model::Result<sim::HeadMesh> mesh = model::ImporterClient().readMesh(path, progress);
    if (!mesh)
        return tl::unexpected(mesh.error());
    return remakeHead(QFileInfo(path).completeBaseName(), model::writeGlb(*mesh), model::guessHead(*mesh));
}

model::Result<ImportedHead> remakeHead(const QString& name, const QByteArray& sourceGlb, const model::HeadGuess& guess)
{
    model::Result<std::shared_ptr<const model::Head>> head =
        model::makeHead(name, sourceGlb, guess.unitScale, guess.upAxis);
    if (!head)
        return tl::unexpected(head.error());
    ImportedHead result;
    result.head = std::move(*head);
    result.ellipsoids = sim::fitEllipsoids(result.head->skin->mesh(), kFittedEllipsoids);
    result.sourceGlb = sourceGlb;
    result.guess = guess;
    return result;
}

} // namespace hairpaint::app
