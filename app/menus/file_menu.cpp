// The File menu: see the header.
#include "app/menus/file_menu.h"

#include "model/files/head_file.h"

#include <QFileInfo>

namespace hairpaint::app {

FileMenu::FileMenu(const QString& title, ActionSet& actions, ProjectFiles& files, Exchange& exchange, MapExchange& maps,
                   view::EditorState& editor, QWidget* parent)
    : QMenu(title, parent), m_files(files)
{
    addProjectActions(actions, editor);
    addSeparator();
    addMapActions(actions, exchange, maps);
    addSeparator();
    addExchangeActions(actions, exchange, editor);
    addSeparator();
    actions.add(*this,
                {{"file.quit", tr("&Quit"), {Qt::CTRL | Qt::Key_Q}, [this] { parentWidget()->window()->close(); }}});
}

void FileMenu::addProjectActions(ActionSet& actions, view::EditorState& editor)
{
    actions.add(*this, {{"file.new", tr("&New"), {QKeySequence::New}, [this] { m_files.newProject(); }, "new"},
                        {"file.newBald",
                         tr("New with a &bald head"),
                         {},
                         [this, &editor] {
                             if (m_files.newBaldProject()) // Only Density makes hair there.
                                 editor.setActiveMap(model::MapKind::Density);
                         }},
                        {"file.open", tr("&Open…"), {QKeySequence::Open}, [this] { m_files.open(); }, "open"}});
    m_recent = addMenu(tr("Open &recent"));
    actions.add(*this,
                {{"file.save", tr("&Save"), {QKeySequence::Save}, [this] { m_files.save(); }, "save"},
                 {"file.saveAs", tr("Save &as…"), {Qt::CTRL | Qt::SHIFT | Qt::Key_S}, [this] { m_files.saveAs(); }}});
}

void FileMenu::addMapActions(ActionSet& actions, Exchange& exchange, MapExchange& maps)
{
    actions.add(
        *this,
        {{"file.loadImage", tr("Load &image into map…"), {}, [&exchange] { exchange.importImage(false); }, "import"},
         {"file.loadGrey", tr("Load &grey image into map…"), {}, [&exchange] { exchange.importImage(true); }},
         {"file.saveImage", tr("Save &map as image…"), {}, [&exchange] { exchange.exportMap(); }, "export"},
         {"file.saveImages", tr("Sa&ve maps as images…"), {}, [&maps] { maps.saveMaps(); }},
         {"file.editOutside", tr("Edit layer in ano&ther program"), {}, [&maps] { maps.editOutside(); }},
         {"file.uvSheet", tr("Save &UV sheet…"), {}, [&maps] { maps.saveSheet(); }}});
}

void FileMenu::addExchangeActions(ActionSet& actions, Exchange& exchange, const view::EditorState& editor)
{
    addHeads(*addMenu(tr("Replace &head")), actions, exchange, editor);
    addSeparator();
    actions.add(
        *this,
        {{"file.exportHair", tr("&Export hair…"), {Qt::CTRL | Qt::Key_E}, [&exchange] { exchange.exportHair(); }},
         {"file.importHair", tr("Import hair &curves…"), {}, [&exchange] { exchange.importHair(); }},
         {"file.blender", tr("Install B&lender add-on"), {}, [&exchange] { exchange.installBlenderAddon(); }},
         {"file.picture", tr("Save &picture…"), {Qt::CTRL | Qt::SHIFT | Qt::Key_P}, [&exchange] {
              exchange.savePicture();
          }}});
}

void FileMenu::addHeads(QMenu& menu, ActionSet& actions, Exchange& exchange, const view::EditorState& editor)
{
    for (const model::NamedHead& head : model::builtInHeads())
        actions.add(menu, {{"file.head." + head.name.toLatin1(), inMenu(head.title), {}, [&exchange, head] {
                                exchange.useBuiltInHead(head);
                            }}});
    menu.addSeparator();
    const model::Document& document = editor.document();
    actions.add(menu, {{"file.importHead", tr("&Import head…"), {}, [&exchange] { exchange.importHead(); }},
                       {.id = "file.landmarks",
                        .text = tr("&Landmarks…"),
                        .run = [&exchange] { exchange.moveLandmarks(); },
                        .enabled = [&document] { return !document.project().head->builtIn; }}});
}

void FileMenu::showRecentFiles(const QStringList& paths)
{
    m_recent->clear();
    for (const QString& path : paths)
        m_recent->addAction(inMenu(QFileInfo(path).fileName()), this, [this, path] { m_files.openPath(path); })
            ->setToolTip(path);
    m_recent->setEnabled(!m_recent->isEmpty());
}

} // namespace hairpaint::app
