// Curves and cards: see the header.
#include "app/exchange/hair_exchange.h"

#include "app/exchange/blender_addon.h"
#include "app/exchange/hair_export.h"
#include "model/document/group_commands.h"
#include "model/importing/curve_import.h"
#include "model/importing/curve_reader.h"
#include "model/values/sentences.h"
#include "view/dialogs/hair_import_dialog.h"

#include <QFileInfo>
#include <QMessageBox>

namespace hairpaint::app {

HairExchange::HairExchange(Session& session, FileWork& files) : QObject(&files), m_session(session), m_files(files)
{
    connect(&session, &Session::frameChanged, this, &HairExchange::followHair);
    connect(&session.document(), &model::Document::changed, this, [this](const model::Change& change) {
        if (change.aspect == model::Change::Aspect::Head || change.aspect == model::Change::Aspect::Everything)
            followHead();
    });
}

std::shared_ptr<const sim::StrandFrame> HairExchange::currentHair(const QString& whenCancelled)
{
    const std::shared_ptr<const void> whole = m_session.wholeHair();
    const bool came =
        m_files.jobs().awaitUntil({.text = tr("Waiting for the newest hair"), .whenCancelled = whenCancelled}, [this] {
            m_session.endPreviews(); // Also those that come late.
            return m_session.hair() != Session::Hair::Underway;
        });
    if (!came)
        return nullptr;
    if (m_session.hair() == Session::Hair::Current)
        return m_session.frame();
    m_files.complain(tr("There is not enough memory for this hair; take less density or smaller maps."));
    return nullptr;
}

QString HairExchange::notExportedText()
{
    return tr("The hair was not exported: cancelled");
}

void HairExchange::exportHair()
{
    if (m_dialog == nullptr) {
        const std::shared_ptr<const sim::StrandFrame> frame = currentHair(notExportedText());
        if (frame == nullptr)
            return;
        const model::Project project = m_session.document().committed();
        m_export.request.author = m_files.settings().avatarAuthor();
        m_dialog = new view::ExportHairDialog(exportableGroups(project, *frame), m_export, &m_files.window());
        m_dialog->setAttribute(Qt::WA_DeleteOnClose);
        m_dialog->setAvatarProblem(avatarProblem(project));
        m_files.announce(*m_dialog, view::HelpDialog::Topic::HairExport);
        connect(m_dialog, &QDialog::finished, this, [this] { m_dialog.clear(); }); // It goes by itself.
        connect(m_dialog, &view::ExportHairDialog::exportWanted, this, &HairExchange::exportChosenHair);
        connect(m_dialog, &view::ExportHairDialog::previewWanted, this, [this] {
            rememberChoice();
            previewChosen();
        });
    }
    m_dialog->show();
    m_dialog->raise();
    m_dialog->activateWindow();
}

void HairExchange::rememberChoice()
{
    m_export = m_dialog->choice();
    m_files.settings().setAvatarAuthor(m_export.request.author);
}

void HairExchange::followHair()
{
    const std::shared_ptr<const sim::StrandFrame> frame = m_session.frame();
    if (m_dialog == nullptr || frame == nullptr || frame->preview)
        return;
    m_dialog->setGroups(exportableGroups(m_session.document().committed(), *frame));
}

void HairExchange::followHead()
{
    if (m_dialog != nullptr)
        m_dialog->setAvatarProblem(avatarProblem(m_session.document().committed()));
}

void HairExchange::exportChosenHair()
{
    rememberChoice();
    const std::shared_ptr<const sim::StrandFrame> frame = currentHair(notExportedText());
    if (frame == nullptr)
        return;
    const model::Project project = m_session.document().committed();
    view::HairExportChoice choice = m_export;
    const QString suffix = QString::fromLatin1(choice.request.format->suffix);
    const QString path =
        m_files.askSavePath({.title = tr("Export hair"),
                             .suggestedPath = choice.request.format->isAvatar ? project.head->name : tr("hair"),
                             .filter = QStringLiteral("%1 (*.%2)").arg(choice.request.format->titleText(), suffix),
                             .suffix = suffix,
                             .otherSuffixes = model::exportSuffixes()});
    if (path.isEmpty())
        return;
    // The name's ending may tell of another format.
    if (const model::ExportFormat* named = model::findExportFormat(path, choice.request.format))
        choice.request.format = named;
    const bool isWritten = m_files.write(
        path, [project, frame, choice, path, projectPath = m_projectPath](const model::Progress& progress) {
            return exportChosen(project, frame, choice, projectPath, path, progress);
        });
    if (isWritten && m_dialog != nullptr)
        m_dialog->accept();
}

QString HairExchange::noCardsText()
{
    return tr("No cards were made: cancelled");
}

void HairExchange::previewCards()
{
    model::CurveOptions& curves = m_export.request.curves;
    curves = {};
    previewChosen();
}

void HairExchange::previewChosen()
{
    const std::shared_ptr<const sim::StrandFrame> frame = currentHair(noCardsText());
    if (frame == nullptr)
        return;
    model::CurveOptions& curves = m_export.request.curves;
    if (curves.groups.empty()) // All of them.
        for (const view::ExportableGroup& group : exportableGroups(m_session.document().committed(), *frame))
            curves.groups.push_back({.id = group.id, .name = group.name});
    using CardsPtr = std::shared_ptr<const rendering::CardSet>;
    const model::Project project = m_session.document().committed();
    const std::optional<model::Result<CardsPtr>> cards = m_files.jobs().await<CardsPtr>(
        {.text = tr("Making cards"), .whenCancelled = noCardsText()},
        [&](const model::Progress& progress) { return cardsChosen(project, frame, m_export, progress); });
    if (!cards)
        return;
    if (!*cards)
        return m_files.complain(cards->error().message);
    if ((**cards)->triangles.empty())
        return m_files.complain(tr("There is no hair to make cards of; paint some density first."));
    Q_EMIT cardsMade(**cards);
}

void HairExchange::importHair()
{
    const QString patterns = QStringLiteral("*.") + model::curveFileEndings().join(QLatin1String(" *."));
    if (const QString path = m_files.askOpenPath(tr("Import hair"), tr("Hair curves (%1)").arg(patterns));
        !path.isEmpty())
        importHairFrom(path);
}

void HairExchange::importHairFrom(const QString& path)
{
    using Groups = std::vector<model::HairGroup>;
    model::Document& document = m_session.document();
    m_session.endPreviews(); // What is only shown is no ground to add to.
    const QString name = QFileInfo(path).fileName();
    const std::shared_ptr<const model::Head> head = document.committed().head;
    const auto curves = std::make_shared<model::ForeignCurves>();
    std::optional<view::HairImportSample> sample = m_files.read<view::HairImportSample>(
        path, [path, curves, head](const model::Progress& progress) -> model::Result<view::HairImportSample> {
            return model::withinMemory(path, model::cannotOpen, [&]() -> model::Result<view::HairImportSample> {
                model::Result<model::ForeignCurves> read = model::readCurves(path, progress);
                if (!read)
                    return tl::unexpected(read.error());
                *curves = std::move(*read);
                return view::HairImportSample::of(*curves, head);
            });
        });
    if (!sample)
        return;
    view::HairImportDialog dialog(std::move(*sample), name, &m_files.window());
    m_files.announce(dialog, view::HelpDialog::Topic::HairImport);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const model::CurveSpaceChoice choice = dialog.choice();
    const auto remarks = std::make_shared<model::CurveRemarks>();
    std::optional<Groups> groups =
        m_files.read<Groups>(path, [path, choice, curves, head, remarks](const model::Progress& progress) {
            return model::groupsFromCurves(std::move(*curves), path, choice, head, progress, remarks.get());
        });
    if (!groups)
        return;
    if (document.committed().head != head)
        return m_files.complain(tr("The head was replaced while '%1' was read; import it again.").arg(name));
    const std::size_t before = document.committed().groups.size();
    document.push(model::importHairCommand(document, std::move(*groups), name));
    if (document.committed().groups.size() > before)
        m_session.editor().target().setGroup(document.committed().groups[before].id);
    if (!remarks->unread.isEmpty())
        m_files.tell(QStringLiteral("%1: %2").arg(name, model::unreadFiles(remarks->unread)));
    else if (remarks->leftOut > 0)
        m_files.tell(
            tr("%1 imported; %Ln strands left out, which are broken", nullptr, static_cast<int>(remarks->leftOut))
                .arg(name));
    else
        m_files.tell(tr("%1 imported").arg(name));
}

void HairExchange::installBlenderAddon()
{
    const QStringList folders = blenderAddonFolders();
    if (folders.isEmpty()) {
        const QString name = blenderAddonName();
        const QString path = m_files.askSavePath({.title = tr("Save Blender add-on"),
                                                  .suggestedPath = QFileInfo(name).completeBaseName(),
                                                  .filter = tr("Python scripts (*.py)"),
                                                  .suffix = QFileInfo(name).suffix()});
        if (!path.isEmpty())
            m_files.write(path, [path](const model::Progress& progress) { return saveBlenderAddon(path, progress); });
        return;
    }
    const bool installed = m_files.change(
        {.text = tr("Installing the add-on"), .whenCancelled = tr("The Blender add-on was not installed: cancelled")},
        folders.front(), [folders](const model::Progress& progress) -> model::Result<void> {
            for (const QString& folder : folders)
                if (model::Result<void> one = app::installBlenderAddon(folder, progress); !one)
                    return one;
            return {};
        });
    if (!installed)
        return;
    QStringList versions;
    for (const QString& folder : folders)
        versions += blenderVersionOf(folder);
    QMessageBox::information(&m_files.window(), tr("Blender add-on"),
                             tr("The add-on is installed in Blender %1. Turn on “Hair Paint hair” there under Edit > "
                                "Preferences > Add-ons; then File > Import reads hair that is exported as .hair.")
                                 .arg(versions.join(QLatin1String(", "))));
}

} // namespace hairpaint::app
