// Heads in the window: see the header.
#include "app/exchange/head_exchange.h"

#include "app/background/heads.h"
#include "model/document/scene_commands.h"
#include "model/files/importer_client.h"
#include "model/styles/style_transfer.h"
#include "model/values/sentences.h"
#include "view/dialogs/head_import_dialog.h"
#include "view/dialogs/landmarks_dialog.h"

#include <QFileInfo>

namespace hairpaint::app {

HeadExchange::HeadExchange(Session& session, FileWork& files) : QObject(&files), m_session(session), m_files(files) {}

Doing HeadExchange::preparing(const QString& name)
{
    return {.text = tr("Preparing %1").arg(name),
            .whenCancelled = tr("The head was not replaced by '%1': cancelled").arg(name)};
}

void HeadExchange::importHead()
{
    const QString path =
        m_files.askOpenPath(tr("Import head"), tr("Meshes (*.glb *.gltf *.vrm *.obj *.fbx *.ply *.dae *.3ds *.x3d)"));
    if (!path.isEmpty())
        importHeadFrom(path);
}

void HeadExchange::importHeadFrom(const QString& path)
{
    m_session.editor().tools().commitStroke();
    const QString name = QFileInfo(path).fileName();
    const std::optional<model::RiggedMesh> mesh = m_files.read<model::RiggedMesh>(
        path, [path](const model::Progress& progress) { return model::ImporterClient().readMesh(path, progress); });
    if (!mesh)
        return;
    view::HeadImportDialog dialog(*mesh, name, &m_files.window());
    m_files.announce(dialog, view::HelpDialog::Topic::HeadImport);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const model::HeadGuess guess{.unitScale = dialog.unitScale(), .upAxis = dialog.upAxis()};
    model::RiggedMesh source = dialog.source();
    (void)model::turnToFront(source, guess.upAxis, dialog.facing()); // It never looks up.
    const std::optional<model::Result<ImportedHead>> made =
        m_files.jobs().await<ImportedHead>(preparing(name), [&](const model::Progress& progress) {
            return headOf(path, source, dialog.makesLayout(), guess, progress);
        });
    if (!made)
        return;
    if (!*made)
        return m_files.complain(made->error().message);
    std::shared_ptr<const model::Head> head = (*made)->head;
    if (dialog.carriesHair() && (head = withLandmarksAsked(head)) == nullptr)
        return;
    replaceHead(head, (*made)->ellipsoids, dialog.carriesHair());
    if (!(*made)->remarks.isEmpty())
        m_files.tell(name + QStringLiteral(": ") + (*made)->remarks.join(QStringLiteral("; ")));
}

std::shared_ptr<const model::Head> HeadExchange::withLandmarksAsked(const std::shared_ptr<const model::Head>& head)
{
    view::LandmarksDialog dialog(head, &m_files.window());
    m_files.announce(dialog, view::HelpDialog::Topic::HeadImport);
    if (dialog.exec() != QDialog::Accepted)
        return nullptr;
    return head->landmarks == dialog.landmarks() ? head : model::withLandmarks(*head, dialog.landmarks());
}

void HeadExchange::moveLandmarks()
{
    m_session.editor().tools().commitStroke();
    const model::Project& project = m_session.document().committed();
    if (project.head == nullptr || project.head->builtIn)
        return;
    const std::shared_ptr<const model::Head> head = withLandmarksAsked(project.head);
    if (head != nullptr && head != project.head)
        replaceHead(head, model::shapesOfHead(project.worn), true);
}

void HeadExchange::useBuiltInHead(const model::NamedHead& named)
{
    m_session.editor().tools().commitStroke();
    using HeadPtr = std::shared_ptr<const model::Head>;
    const std::optional<model::Result<HeadPtr>> head = m_files.jobs().await<HeadPtr>(
        preparing(named.title), [&named](const model::Progress&) -> model::Result<HeadPtr> {
            const model::Checked<HeadPtr> known = model::builtInHead(named.name);
            return known ? model::Result<HeadPtr>(*known) : model::cannotOpen(named.title, known.error());
        });
    if (!head)
        return;
    if (!*head)
        return m_files.complain(head->error().message);
    replaceHead(**head, model::builtInEllipsoids(named.name), true);
}

void HeadExchange::replaceHead(const std::shared_ptr<const model::Head>& head, std::vector<sim::Ellipsoid> ellipsoids,
                               bool carriesHair)
{
    using Groups = std::vector<model::HairGroup>;
    model::Document& document = m_session.document();
    m_session.endPreviews(); // What is only shown does not go along.
    std::optional<Groups> groups;
    if (carriesHair && document.committed().head && !document.committed().head->landmarks)
        m_files.tell(tr("The head so far has no landmarks; the maps stay as they lie"));
    // A style that was being loaded may come while the hair is carried: what is there then counts.
    for (model::Project before; carriesHair && !(groups && before.groups == document.committed().groups);) {
        before = document.committed();
        std::optional<model::Result<Groups>> carried = m_files.jobs().await<Groups>(
            {.text = tr("Carrying the hair over"), .whenCancelled = tr("The head was not replaced: cancelled")},
            [&before, &head](const model::Progress& progress) -> model::Result<Groups> {
                std::optional<Groups> moved = model::carriedGroups(before.groups, before.head, head, progress);
                return moved ? model::Result<Groups>(std::move(*moved)) : model::cancelled(head->name);
            });
        if (!carried)
            return;
        if (!*carried)
            return m_files.complain(carried->error().message);
        groups = std::move(**carried);
    }
    document.push(model::setHeadCommand(document, head, std::move(ellipsoids), std::move(groups)));
}

} // namespace hairpaint::app
