// The File menu: see the header.
#include "app/window/menus/file_menu.h"

#include "model/files/head_file.h"

#include <QFileInfo>

namespace hairpaint::app {

FileMenu::FileMenu(const QString& title, ActionSet& actions, ProjectFiles& files, Exchange& exchange,
                   view::EditorState& editor, QWidget* parent)
    : QMenu(title, parent), m_files(files)
{
    addProjectActions(actions, editor);
    addSeparator();
    addMapActions(actions, exchange.maps());
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
                                 editor.target().setMap(model::MapKind::Density);
                         }},
                        {"file.open", tr("&Open…"), {QKeySequence::Open}, [this] { m_files.open(); }, "open"}});
    m_recent = addMenu(tr("Open &recent"));
    actions.add(*this,
                {{"file.save", tr("&Save"), {QKeySequence::Save}, [this] { m_files.save(); }, "save"},
                 {"file.saveAs", tr("Save &as…"), {Qt::CTRL | Qt::SHIFT | Qt::Key_S}, [this] { m_files.saveAs(); }}});
}

void FileMenu::addMapActions(ActionSet& actions, MapExchange& maps)
{
    actions.add(
        *this,
        {{"file.loadImage", tr("Load &image into map…"), {}, [&maps] { maps.importImage(std::nullopt); }, "import"},
         {"file.loadGrey", tr("Load &grey image into map…"), {}, [&maps] { maps.importImage(true); }},
         {"file.loadImages", tr("Loa&d maps…"), {}, [&maps] { maps.importFolder(); }},
         {"file.saveImage", tr("Save &map as image…"), {}, [&maps] { maps.exportMap(); }, "export"},
         {"file.saveImages", tr("Sa&ve maps as images…"), {}, [&maps] { maps.saveMaps(); }},
         {"file.editOutside", tr("Edit layer in ano&ther program"), {}, [&maps] { maps.editOutside(); }},
         {"file.uvSheet", tr("Save &UV sheet…"), {}, [&maps] { maps.saveSheet(); }}});
}

void FileMenu::addExchangeActions(ActionSet& actions, Exchange& exchange, const view::EditorState& editor)
{
    addHeads(*addMenu(tr("Replace &head")), actions, exchange.heads(), editor);
    addSeparator();
    HairExchange& hair = exchange.hair();
    actions.add(*this,
                {{"file.exportHair", tr("&Export hair…"), {Qt::CTRL | Qt::Key_E}, [&hair] { hair.exportHair(); }},
                 {"file.importHair", tr("Import hair &curves…"), {}, [&hair] { hair.importHair(); }},
                 {"file.blender", tr("Install B&lender add-on"), {}, [&hair] { hair.installBlenderAddon(); }},
                 {"file.picture", tr("Save &picture…"), {Qt::CTRL | Qt::SHIFT | Qt::Key_P}, [&exchange] {
                      exchange.pictures().savePicture();
                  }}});
}

void FileMenu::addHeads(QMenu& menu, ActionSet& actions, HeadExchange& heads, const view::EditorState& editor)
{
    for (const model::NamedHead& head : model::builtInHeads())
        actions.add(menu, {{"file.head." + head.name.toLatin1(), inMenu(head.title), {}, [&heads, head] {
                                heads.useBuiltInHead(head);
                            }}});
    menu.addSeparator();
    const model::Document& document = editor.document();
    actions.add(menu, {{"file.importHead", tr("&Import head…"), {}, [&heads] { heads.importHead(); }},
                       {.id = "file.landmarks",
                        .text = tr("&Landmarks…"),
                        .run = [&heads] { heads.moveLandmarks(); },
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
