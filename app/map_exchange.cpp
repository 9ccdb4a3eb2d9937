// Dialogs, and the work behind them.
#include "app/map_exchange.h"

#include "app/save_dialog.h"
#include "model/exporting/uv_sheet.h"
#include "model/files/sentences.h"
#include "model/names.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include <algorithm>

namespace hairpaint::app {

MapExchange::MapExchange(Session& session, Settings& settings, Jobs& jobs, QWidget& window)
    : QObject(&window), m_session(session), m_settings(settings), m_jobs(jobs), m_window(window),
      m_outside(session, jobs)
{
    connect(&m_outside, &OutsideEdit::told, this, &MapExchange::done);
    connect(&m_outside, &OutsideEdit::failed, this, &MapExchange::complain);
}

std::vector<model::WantedMap> MapExchange::wantedMaps(view::MapRange range)
{
    model::Document& document = m_session.document();
    const view::EditorState& editor = m_session.editor();
    std::vector<model::WantedMap> maps;
    maps.reserve(document.committed().groups.size() * model::mapSpecs().size());
    for (const model::HairGroup& group : document.committed().groups)
        for (const model::MapSpec& spec : model::mapSpecs()) {
            const bool isGroup = range == view::MapRange::All || group.id == editor.activeGroup();
            if (isGroup && (range != view::MapRange::Active || spec.kind == editor.activeMap()))
                maps.push_back(
                    {.group = group.name, .kind = spec.kind, .resolved = document.resolvedNow(group.id, spec.kind)});
        }
    return maps;
}

void MapExchange::saveMaps()
{
    m_session.endPreviews(); // What is only shown is no part of a map.
    const view::EditorState& editor = m_session.editor();
    const model::HairGroup* group = m_session.document().committed().group(editor.activeGroup());
    if (group == nullptr)
        return complain(tr("There is no hair group whose maps they could be; add one in the panel Hair."));
    view::ExportMapsDialog dialog(model::mapSpec(editor.activeMap()).titleText(), model::shownName(group->name),
                                  m_choice, &m_window);
    Q_EMIT dialogMade(dialog, view::HelpDialog::Topic::MapExport);
    if (dialog.exec() != QDialog::Accepted)
        return;
    m_choice = dialog.choice();
    const QString folder = QFileDialog::getExistingDirectory(&m_window, dialog.windowTitle(), m_settings.lastFolder());
    if (folder.isEmpty())
        return;
    m_settings.setLastFolder(folder);
    const std::vector<model::WantedMap> maps = wantedMaps(m_choice.range);
    QStringList there = model::mapImageNames(maps, *m_choice.options.format);
    const int count = static_cast<int>(there.size());
    there.removeIf([&folder](const QString& name) { return !QFileInfo::exists(QDir(folder).filePath(name)); });
    if (!there.isEmpty() &&
        QMessageBox::warning(&m_window, dialog.windowTitle(),
                             tr("There are already %Ln of these files, '%1' among them. Replace them?", nullptr,
                                static_cast<int>(there.size()))
                                 .arg(there.front()),
                             QMessageBox::Yes | QMessageBox::No, QMessageBox::No) != QMessageBox::Yes)
        return;
    const std::optional<model::Result<void>> written =
        m_jobs.await<void>(tr("Writing maps"), [&](const model::Progress& progress) {
            return model::writeMapImages(maps, folder, m_choice.options, progress);
        });
    if (written && !*written)
        complain(written->error().message);
    else if (written)
        Q_EMIT done(tr("%Ln maps written", nullptr, count));
}

void MapExchange::saveSheet()
{
    const std::shared_ptr<const model::Head> head = m_session.document().committed().head;
    const QString path = askSavePath(m_window, {.title = tr("Save UV sheet"),
                                                .suggestedPath = m_settings.lastFolder() + QLatin1Char('/') +
                                                                 tr("uv-sheet") + QStringLiteral(".pdf"),
                                                .filter = tr("PDF documents (*.pdf);;SVG drawings (*.svg)"),
                                                .suffix = QStringLiteral("pdf")});
    if (path.isEmpty())
        return;
    m_settings.setLastFolder(QFileInfo(path).absolutePath());
    const QString name = QFileInfo(path).fileName();
    const std::optional<model::Result<void>> written =
        m_jobs.await<void>(tr("Writing %1").arg(name), [&](const model::Progress& progress) -> model::Result<void> {
            if (!progress(0.0))
                return model::cancelled(path);
            return model::writeUvSheet(head->skin->mesh(), path);
        });
    if (written && !*written)
        complain(written->error().message);
    else if (written)
        Q_EMIT done(tr("%1 written").arg(name));
}

void MapExchange::editOutside()
{
    m_session.endPreviews();
    m_outside.begin();
}

void MapExchange::complain(const QString& message)
{
    QMessageBox::warning(&m_window, tr("Hair Paint"), message);
}

} // namespace hairpaint::app
