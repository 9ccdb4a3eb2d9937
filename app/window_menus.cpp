// The window's menus: every action with its key.
#include "app/main_window.h"

#include "model/commands/commands.h"
#include "view/head_view.h"
#include "view/paint_view.h"
#include "view/panels/option_bar.h"
#include "view/panels/sidebar.h"
#include "view/panels/tool_bar.h"
#include "view/widgets/value_pair.h"

#include <QFileInfo>
#include <QMenuBar>
#include <QUndoStack>

namespace hairpaint::app {

namespace {

/// A menu would take the & of a name for a mark of its own.
QString inMenu(QString name)
{
    return name.replace(QLatin1Char('&'), QStringLiteral("&&"));
}

} // namespace

void MainWindow::buildMenus()
{
    buildFileMenu();
    buildEditMenu();
    buildMapMenu();
    buildToolMenu();
    buildViewMenu();
    buildHairMenu();
    buildHelpMenu();

    // What the paper's context menu offers: the same actions, at hand in both areas.
    m_areaMenu = new QMenu(this);
    for (const char* id : std::initializer_list<const char*>{
             "edit.undo", "edit.redo", nullptr, "edit.cut", "edit.copy", "edit.paste", "edit.clear", nullptr,
             "edit.all", "edit.none", "edit.invert", nullptr, "file.loadImage", "file.saveImage", nullptr,
             "view.wireframe", "view.night", "view.fit", "view.home"}) {
        if (id == nullptr)
            m_areaMenu->addSeparator();
        else
            m_areaMenu->addAction(m_actions.find(QLatin1StringView(id)));
    }
    for (const char* id : {"edit.all", "edit.none", "edit.invert", "edit.cut", "edit.copy", "edit.paste", "edit.clear"})
        m_optionBar->addSelectionAction(m_actions.find(QLatin1StringView(id)));
    for (const char* id : {"edit.mirror", "view.wireframe", "view.night"})
        m_toolBar->addFootAction(m_actions.find(QLatin1StringView(id)));
}

void MainWindow::buildFileMenu()
{
    QMenu& menu = *menuBar()->addMenu(tr("&File"));
    m_actions.add(menu, {.id = "file.new",
                         .text = tr("&New"),
                         .key = QKeySequence::New,
                         .run = [this] { m_files.newProject(); },
                         .icon = "new"});
    m_actions.add(menu, {.id = "file.open",
                         .text = tr("&Open…"),
                         .key = QKeySequence::Open,
                         .run = [this] { m_files.open(); },
                         .icon = "open"});
    m_recentMenu = menu.addMenu(tr("Open &recent"));
    m_actions.add(menu, {.id = "file.save",
                         .text = tr("&Save"),
                         .key = QKeySequence::Save,
                         .run = [this] { m_files.save(); },
                         .icon = "save"});
    m_actions.add(menu, {.id = "file.saveAs",
                         .text = tr("Save &as…"),
                         .key = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
                         .run = [this] { m_files.saveAs(); }});
    menu.addSeparator();
    m_actions.add(menu, {.id = "file.loadImage",
                         .text = tr("Load &image into map…"),
                         .run = [this] { m_exchange.importImage(false); },
                         .icon = "import"});
    m_actions.add(menu, {.id = "file.loadGrey", .text = tr("Load &grey image into map…"), .run = [this] {
                             m_exchange.importImage(true);
                         }});
    m_actions.add(menu, {.id = "file.saveImage",
                         .text = tr("Save &map as image…"),
                         .run = [this] { m_exchange.exportMap(); },
                         .icon = "export"});
    menu.addSeparator();
    m_actions.add(menu,
                  {.id = "file.importHead", .text = tr("Import &head…"), .run = [this] { m_exchange.importHead(); }});
    m_actions.add(menu, {.id = "file.builtInHead", .text = tr("Use the &built-in head"), .run = [this] {
                             m_exchange.useBuiltInHead();
                         }});
    menu.addSeparator();
    m_actions.add(menu, {.id = "file.exportHair",
                         .text = tr("&Export hair…"),
                         .key = QKeySequence(Qt::CTRL | Qt::Key_E),
                         .run = [this] { m_exchange.exportHair(); }});
    m_actions.add(menu, {.id = "file.picture",
                         .text = tr("Save &picture…"),
                         .key = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P),
                         .run = [this] { m_exchange.savePicture(); }});
    menu.addSeparator();
    m_actions.add(menu,
                  {.id = "file.quit", .text = tr("&Quit"), .key = QKeySequence(Qt::CTRL | Qt::Key_Q), .run = [this] {
                       close();
                   }});
}

void MainWindow::fillRecentMenu()
{
    m_recentMenu->clear();
    for (const QString& path : m_settings.recentFiles())
        m_recentMenu->addAction(inMenu(QFileInfo(path).fileName()), this, [this, path] { m_files.openPath(path); })
            ->setToolTip(path);
    m_recentMenu->setEnabled(!m_recentMenu->isEmpty());
}

void MainWindow::buildEditMenu()
{
    QMenu& menu = *menuBar()->addMenu(tr("&Edit"));
    model::Document& document = m_session.document();
    QUndoStack& stack = document.undoStack();
    QAction* undo = m_actions.add(menu, {.id = "edit.undo",
                                         .text = tr("&Undo"),
                                         .key = QKeySequence(Qt::CTRL | Qt::Key_Z),
                                         .run = [&document] { document.undo(); },
                                         .icon = "undo"});
    QAction* redo = m_actions.add(menu, {.id = "edit.redo",
                                         .text = tr("&Redo"),
                                         .key = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z),
                                         .run = [&document] { document.redo(); },
                                         .icon = "redo"});
    redo->setShortcuts({redo->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    const auto follow = [this, undo, redo, &stack, &document] {
        // While a tool runs, undo cancels it or its last part, whatever the stack holds.
        undo->setEnabled(document.canUndo() || m_session.editor().stroking());
        redo->setEnabled(stack.canRedo());
        undo->setText(stack.canUndo() ? tr("&Undo %1").arg(inMenu(stack.undoText())) : tr("&Undo"));
        redo->setText(stack.canRedo() ? tr("&Redo %1").arg(inMenu(stack.redoText())) : tr("&Redo"));
    };
    connect(&stack, &QUndoStack::indexChanged, this, follow);
    connect(&document, &model::Document::changed, this, follow);
    connect(&m_session.editor(), &view::EditorState::overlayChanged, this, follow);
    follow();
    menu.addSeparator();
    m_actions.add(menu,
                  {.id = "edit.cut", .text = tr("Cu&t"), .key = QKeySequence::Cut, .run = [this] { cutSelection(); }});
    m_actions.add(
        menu, {.id = "edit.copy", .text = tr("&Copy"), .key = QKeySequence::Copy, .run = [this] { copySelection(); }});
    m_actions.add(
        menu, {.id = "edit.paste", .text = tr("&Paste"), .key = QKeySequence::Paste, .run = [this] { pasteClip(); }});
    m_actions.add(menu, {.id = "edit.duplicate",
                         .text = tr("&Duplicate layer"),
                         .key = QKeySequence(Qt::CTRL | Qt::Key_J),
                         .run = [this] { m_sidebar->layers().duplicateLayer(); },
                         .icon = "duplicate"});
    m_actions.add(menu, {.id = "edit.clear", .text = tr("C&lear"), .key = QKeySequence(Qt::Key_Delete), .run = [this] {
                             clearSelection();
                         }});
    menu.addSeparator();
    m_actions.add(
        menu, {.id = "edit.all", .text = tr("Select &all"), .key = QKeySequence(Qt::CTRL | Qt::Key_A), .run = [this] {
                   selectAll();
               }});
    m_actions.add(menu, {.id = "edit.none",
                         .text = tr("Select &none"),
                         .key = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A),
                         .run = [this] { m_session.editor().selection().setRectangle({}); }});
    m_actions.add(menu, {.id = "edit.invert",
                         .text = tr("&Invert selection"),
                         .key = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I),
                         .run = [this] { m_session.editor().selection().invert(); }});
    menu.addSeparator();
    QAction* mirror = m_actions.add(menu, {.id = "edit.mirror",
                                           .text = tr("&Mirror painting"),
                                           .key = QKeySequence(Qt::Key_L),
                                           .icon = "mirror",
                                           .checkable = true});
    mirror->setChecked(m_session.editor().mirror());
    connect(mirror, &QAction::toggled, this, [this](bool on) { m_session.editor().setMirror(on); });
    connect(&m_session.editor(), &view::EditorState::viewOptionsChanged, mirror,
            [this, mirror] { mirror->setChecked(m_session.editor().mirror()); });
    menu.addSeparator();
    m_actions.add(menu, {.id = "edit.preferences",
                         .text = tr("Pre&ferences…"),
                         .key = QKeySequence(Qt::CTRL | Qt::Key_Comma),
                         .run = [this] { showPreferences(); },
                         .icon = "settings"});
}

void MainWindow::buildMapMenu()
{
    QMenu& menu = *menuBar()->addMenu(tr("&Map"));
    for (const model::MapSpec& spec : model::mapSpecs()) {
        const QByteArray id = QByteArray("map.") + spec.id;
        QAction* action =
            m_actions.add(menu, {.id = id.constData(),
                                 .text = spec.titleText(),
                                 .key = QKeySequence(usualKey(digitKey(static_cast<int>(spec.kind) + 1))),
                                 .run = [this, kind = spec.kind] { m_session.editor().setActiveMap(kind); },
                                 .checkable = true});
        connect(action, &QAction::triggered, action, [action] { action->setChecked(true); });
        const auto follow = [this, kind = spec.kind, action] {
            action->setChecked(m_session.editor().activeMap() == kind);
        };
        connect(&m_session.editor(), &view::EditorState::targetChanged, action, follow);
        follow();
    }
    menu.addSeparator();
    m_actions.add(menu, {.id = "map.addLayer",
                         .text = tr("&Add layer"),
                         .key = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N),
                         .run = [this] { m_sidebar->layers().addLayer(); },
                         .icon = "add"});
    m_actions.add(menu, {.id = "map.removeLayer",
                         .text = tr("&Remove layer"),
                         .run = [this] { m_sidebar->layers().removeLayer(); },
                         .icon = "remove"});
    m_actions.add(menu, {.id = "map.layerUp",
                         .text = tr("Layer &up"),
                         .key = QKeySequence(Qt::CTRL | Qt::Key_PageUp),
                         .run = [this] { m_sidebar->layers().moveLayer(1); },
                         .icon = "up"});
    m_actions.add(menu, {.id = "map.layerDown",
                         .text = tr("Layer &down"),
                         .key = QKeySequence(Qt::CTRL | Qt::Key_PageDown),
                         .run = [this] { m_sidebar->layers().moveLayer(-1); },
                         .icon = "down"});
    menu.addSeparator();
    buildMapSizeMenu(*menu.addMenu(tr("Map &size")));
}

void MainWindow::buildMapSizeMenu(QMenu& menu)
{
    menu.setObjectName(QStringLiteral("mapSizeMenu"));
    for (int size = sim::TiledRaster::kSmallestSize; size <= sim::TiledRaster::kLargestSize; size *= 2) {
        QAction* action = menu.addAction(tr("%1 × %1").arg(size), this, [this, size] {
            model::Document& document = m_session.document();
            const model::LayerAddress target = m_session.editor().target();
            QGuiApplication::setOverrideCursor(Qt::WaitCursor);
            document.push(model::resizeMapCommand(document, target.group, target.map, size));
            QGuiApplication::restoreOverrideCursor();
        });
        action->setCheckable(true);
        action->setData(size);
    }
    connect(&menu, &QMenu::aboutToShow, &menu, [this, &menu] {
        const view::EditorState& editor = m_session.editor();
        const model::HairGroup* group = m_session.document().project().group(editor.activeGroup());
        for (QAction* action : menu.actions()) {
            action->setEnabled(group != nullptr);
            action->setChecked(group != nullptr && group->map(editor.activeMap()).size == action->data().toInt());
        }
    });
}

void MainWindow::buildToolMenu()
{
    QMenu& menu = *menuBar()->addMenu(tr("&Tools"));
    view::EditorState& editor = m_session.editor();
    for (const auto& tool : editor.tools()) {
        const QByteArray id = QByteArray("tool.") + model::toolName(tool->id());
        QAction* action = m_actions.add(menu, {.id = id.constData(),
                                               .text = tool->title(),
                                               .key = tool->defaultKey(),
                                               .run =
                                                   [&editor, tool = tool->id()] {
                                                       if (tool == model::ToolId::Eraser)
                                                           editor.toggleTool(tool);
                                                       else
                                                           editor.setActiveTool(tool);
                                                   },
                                               .icon = model::toolName(tool->id())});
        m_toolBar->setKey(tool->id(), action->shortcut());
    }
    menu.addSeparator();
    m_actions.add(
        menu, {.id = "tool.swapValues", .text = tr("S&wap values"), .key = QKeySequence(Qt::Key_X), .run = [&editor] {
                   view::swapValues(editor);
               }});
    m_actions.add(
        menu, {.id = "tool.resetValues", .text = tr("&Reset values"), .key = QKeySequence(Qt::Key_D), .run = [&editor] {
                   view::resetValues(editor);
               }});
    m_actions.add(menu, {.id = "tool.smaller",
                         .text = tr("S&maller brush"),
                         .key = QKeySequence(usualKey(PhysicalKey::BracketLeft)),
                         .run = [this] { changeBrushSize(1.0F / 1.15F); }});
    m_actions.add(menu, {.id = "tool.larger",
                         .text = tr("&Larger brush"),
                         .key = QKeySequence(usualKey(PhysicalKey::BracketRight)),
                         .run = [this] { changeBrushSize(1.15F); }});
}

} // namespace hairpaint::app
