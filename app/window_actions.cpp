// The table of the window's actions: id, words, keys, what each does. Menus, key list and help are made from it.
#include "app/main_window.h"

#include "model/commands/commands.h"
#include "view/dialogs/about_dialog.h"
#include "view/head_view.h"
#include "view/paint_view.h"
#include "view/panels/option_bar.h"
#include "view/panels/sidebar.h"
#include "view/panels/tool_bar.h"
#include "view/rendering/standard_views.h"
#include "view/widgets/value_pair.h"

#include <QApplication>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
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
    addFileActions(*menuBar()->addMenu(tr("&File")));
    addEditActions(*menuBar()->addMenu(tr("&Edit")));
    addMapActions(*menuBar()->addMenu(tr("&Map")));
    addToolActions(*menuBar()->addMenu(tr("&Tools")));
    addViewActions(*menuBar()->addMenu(tr("&View")));
    addHairActions(*menuBar()->addMenu(tr("H&air")));
    addHelpActions(*menuBar()->addMenu(tr("&Help")));
    for (const auto& tool : m_session.editor().tools())
        m_toolBar->setAction(tool->id(),
                             *m_actions.find(QLatin1StringView(QByteArray("tool.") + model::toolName(tool->id()))));

    // What the paper's context menu offers: the same actions, at hand in both areas.
    m_areaMenu = new QMenu(this);
    for (const char* id : std::initializer_list<const char*>{
             "edit.undo",      "edit.redo",  nullptr,          "edit.cut",       "edit.copy",
             "edit.paste",     "edit.clear", nullptr,          "edit.all",       "edit.none",
             "edit.invert",    nullptr,      "file.loadImage", "file.saveImage", nullptr,
             "view.wireframe", "view.night", "view.fit",       "view.home",      "view.turnToBrush"}) {
        if (id == nullptr)
            m_areaMenu->addSeparator();
        else
            m_areaMenu->addAction(m_actions.find(QLatin1StringView(id)));
    }
    for (const char* id : {"edit.all", "edit.none", "edit.invert", "edit.cut", "edit.copy", "edit.paste", "edit.clear"})
        m_optionBar->addSelectionAction(m_actions.find(QLatin1StringView(id)));
    for (const char* id : {"edit.mirror", "view.wireframe", "view.night"})
        m_toolBar->addFootAction(m_actions.find(QLatin1StringView(id)));

    const auto follow = [this] { m_actions.follow(); };
    connect(&m_session.document().undoStack(), &QUndoStack::indexChanged, this, follow);
    connect(&m_session.document(), &model::Document::changed, this, follow);
    connect(&m_session.editor(), &view::EditorState::targetChanged, this, follow);
    connect(&m_session.editor(), &view::EditorState::overlayChanged, this, follow);
    connect(&m_session.editor(), &view::EditorState::viewOptionsChanged, this, follow);
    connect(&m_session, &Session::pausedChanged, this, follow);
    connect(m_headView, &view::HeadView::weatherShownChanged, this, follow);
    m_actions.follow();
}

void MainWindow::addFileActions(QMenu& menu)
{
    m_actions.add(menu, {{"file.new", tr("&New"), {QKeySequence::New}, [this] { m_files.newProject(); }, "new"},
                         {"file.newBald",
                          tr("New with a &bald head"),
                          {},
                          [this] {
                              if (m_files.newBaldProject()) // Only Density makes hair there.
                                  m_session.editor().setActiveMap(model::MapKind::Density);
                          }},
                         {"file.open", tr("&Open…"), {QKeySequence::Open}, [this] { m_files.open(); }, "open"}});
    m_recentMenu = menu.addMenu(tr("Open &recent"));
    m_actions.add(menu,
                  {{"file.save", tr("&Save"), {QKeySequence::Save}, [this] { m_files.save(); }, "save"},
                   {"file.saveAs", tr("Save &as…"), {Qt::CTRL | Qt::SHIFT | Qt::Key_S}, [this] { m_files.saveAs(); }}});
    menu.addSeparator();
    m_actions.add(
        menu, {{"file.loadImage", tr("Load &image into map…"), {}, [this] { m_exchange.importImage(false); }, "import"},
               {"file.loadGrey", tr("Load &grey image into map…"), {}, [this] { m_exchange.importImage(true); }},
               {"file.saveImage", tr("Save &map as image…"), {}, [this] { m_exchange.exportMap(); }, "export"}});
    menu.addSeparator();
    m_actions.add(menu,
                  {{"file.importHead", tr("Import &head…"), {}, [this] { m_exchange.importHead(); }},
                   {"file.builtInHead", tr("Use the built-in hea&d"), {}, [this] { m_exchange.useBuiltInHead(); }}});
    menu.addSeparator();
    m_actions.add(
        menu, {{"file.exportHair", tr("&Export hair…"), {Qt::CTRL | Qt::Key_E}, [this] { m_exchange.exportHair(); }},
               {"file.picture", tr("Save &picture…"), {Qt::CTRL | Qt::SHIFT | Qt::Key_P}, [this] {
                    m_exchange.savePicture();
                }}});
    menu.addSeparator();
    m_actions.add(menu, {{"file.quit", tr("&Quit"), {Qt::CTRL | Qt::Key_Q}, [this] { close(); }}});
}

void MainWindow::fillRecentMenu()
{
    m_recentMenu->clear();
    for (const QString& path : m_settings.recentFiles())
        m_recentMenu->addAction(inMenu(QFileInfo(path).fileName()), this, [this, path] { m_files.openPath(path); })
            ->setToolTip(path);
    m_recentMenu->setEnabled(!m_recentMenu->isEmpty());
}

void MainWindow::addEditActions(QMenu& menu)
{
    model::Document& document = m_session.document();
    view::EditorState& editor = m_session.editor();
    QUndoStack& stack = document.undoStack();
    m_actions.add(
        menu,
        {{.id = "edit.undo",
          .text = tr("&Undo"),
          .keys = {Qt::CTRL | Qt::Key_Z},
          .run = [&document] { document.undo(); },
          .icon = "undo",
          // While a tool runs, undo cancels it or its last part, whatever the stack holds.
          .enabled = [&document, &editor] { return document.canUndo() || editor.stroking(); },
          .label = [&stack] { return stack.canUndo() ? tr("&Undo %1").arg(inMenu(stack.undoText())) : tr("&Undo"); }},
         {.id = "edit.redo",
          .text = tr("&Redo"),
          .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y},
          .run = [&document] { document.redo(); },
          .icon = "redo",
          .enabled = [&stack] { return stack.canRedo(); },
          .label = [&stack] { return stack.canRedo() ? tr("&Redo %1").arg(inMenu(stack.redoText())) : tr("&Redo"); }}});
    menu.addSeparator();
    m_actions.add(menu, {{"edit.cut", tr("Cu&t"), {QKeySequence::Cut}, [this] { cutSelection(); }},
                         {"edit.copy", tr("&Copy"), {QKeySequence::Copy}, [this] { copySelection(); }},
                         {"edit.paste", tr("&Paste"), {QKeySequence::Paste}, [this] { pasteClip(); }},
                         {"edit.duplicate",
                          tr("&Duplicate layer"),
                          {Qt::CTRL | Qt::Key_J},
                          [this] { m_sidebar->layers().duplicateLayer(); },
                          "duplicate"},
                         {"edit.clear", tr("C&lear"), {Qt::Key_Delete}, [this] { clearSelection(); }}});
    menu.addSeparator();
    m_actions.add(menu, {{"edit.all", tr("Select &all"), {Qt::CTRL | Qt::Key_A}, [this] { selectAll(); }},
                         {"edit.none",
                          tr("Select &none"),
                          {Qt::CTRL | Qt::SHIFT | Qt::Key_A},
                          [&editor] { editor.selection().setRectangle({}); }},
                         {"edit.invert", tr("&Invert selection"), {Qt::CTRL | Qt::SHIFT | Qt::Key_I}, [&editor] {
                              editor.selection().invert();
                          }}});
    menu.addSeparator();
    m_actions.add(menu, {{.id = "edit.mirror",
                          .text = tr("&Mirror painting"),
                          .keys = {Qt::Key_L},
                          .run = [&editor] { editor.setMirror(!editor.mirror()); },
                          .icon = "mirror",
                          .on = [&editor] { return editor.mirror(); }}});
    menu.addSeparator();
    m_actions.add(menu, {{"edit.preferences",
                          tr("Pre&ferences…"),
                          {Qt::CTRL | Qt::Key_Comma},
                          [this] { showPreferences(); },
                          "settings"}});
}

void MainWindow::addMapActions(QMenu& menu)
{
    view::EditorState& editor = m_session.editor();
    for (const model::MapSpec& spec : model::mapSpecs()) {
        const QByteArray id = QByteArray("map.") + spec.id;
        const PhysicalKey digit = digitKey(static_cast<int>(spec.kind) + 1);
        m_actions.add(
            menu, {{.id = id,
                    .text = spec.titleText(),
                    .keys = digit == PhysicalKey::Other ? QList<QKeySequence>() : QList<QKeySequence>{usualKey(digit)},
                    .run = [&editor, kind = spec.kind] { editor.setActiveMap(kind); },
                    .on = [&editor, kind = spec.kind] { return editor.activeMap() == kind; }}});
    }
    menu.addSeparator();
    m_actions.add(
        menu, {{"map.addLayer",
                tr("&Add layer"),
                {Qt::CTRL | Qt::SHIFT | Qt::Key_N},
                [this] { m_sidebar->layers().addLayer(); },
                "add"},
               {"map.removeLayer", tr("&Remove layer"), {}, [this] { m_sidebar->layers().removeLayer(); }, "remove"},
               {"map.layerUp",
                tr("Layer &up"),
                {Qt::CTRL | Qt::Key_PageUp},
                [this] { m_sidebar->layers().moveLayer(1); },
                "up"},
               {"map.layerDown",
                tr("Layer &down"),
                {Qt::CTRL | Qt::Key_PageDown},
                [this] { m_sidebar->layers().moveLayer(-1); },
                "down"}});
    menu.addSeparator();
    fillMapSizeMenu(*menu.addMenu(tr("Map &size")));
}

void MainWindow::fillMapSizeMenu(QMenu& menu)
{
    menu.setObjectName(QStringLiteral("mapSizeMenu"));
    for (int size = sim::TiledRaster::kSmallestSize; size <= sim::TiledRaster::kLargestSize; size *= 2) {
        QAction* action = menu.addAction(tr("%1 × %1").arg(size), this, [this, size] {
            model::Document& document = m_session.document();
            document.endEdit();
            const model::LayerAddress target = m_session.editor().target();
            const auto run = [this](const QString& doing, const auto& work) {
                const auto done = m_jobs.await<bool>(doing, [&work](const model::Progress& progress) {
                    work(progress);
                    return model::Result<bool>(true);
                });
                if (done && !*done)
                    QMessageBox::warning(this, tr("Hair Paint"), done->error().message);
                return done && *done;
            };
            document.push(model::resizeMapCommand(document, target.group, target.map, size, run));
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

void MainWindow::addToolActions(QMenu& menu)
{
    view::EditorState& editor = m_session.editor();
    for (const auto& tool : editor.tools()) {
        const char* name = model::toolName(tool->id());
        const auto choose = [&editor, tool = tool->id()] {
            if (tool == model::ToolId::Eraser)
                editor.toggleTool(tool);
            else
                editor.setActiveTool(tool);
        };
        m_actions.add(menu, {{QByteArray("tool.") + name, tool->title(), {tool->defaultKey()}, choose, name}});
    }
    menu.addSeparator();
    m_actions.add(menu,
                  {{"tool.swapValues", tr("S&wap values"), {Qt::Key_X}, [&editor] { view::swapValues(editor); }},
                   {"tool.resetValues", tr("&Reset values"), {Qt::Key_D}, [&editor] { view::resetValues(editor); }},
                   {"tool.smaller",
                    tr("S&maller brush"),
                    {usualKey(PhysicalKey::BracketLeft)},
                    [this] { changeBrushSize(1.0F / 1.15F); }},
                   {"tool.larger", tr("&Larger brush"), {usualKey(PhysicalKey::BracketRight)}, [this] {
                        changeBrushSize(1.15F);
                    }}});
}

void MainWindow::addViewActions(QMenu& menu)
{
    view::EditorState& editor = m_session.editor();
    const auto area = [this](const char* id, const QString& text, Qt::Key key, Areas areas) {
        return ActionRow{.id = id,
                         .text = text,
                         .keys = {key},
                         .run = [this, areas] { showAreas(areas); },
                         .on = [this, areas] { return m_areas == areas; }};
    };
    m_actions.add(menu, {area("view.both", tr("&Both areas"), Qt::Key_F1, Areas::Both),
                         area("view.head", tr("&3D area only"), Qt::Key_F2, Areas::Head),
                         area("view.paint", tr("&Paint area only"), Qt::Key_F3, Areas::Paint),
                         {"view.swap", tr("&Swap sides"), {Qt::Key_F4}, [this] { swapAreas(); }, "swap"},
                         {.id = "view.panels",
                          .text = tr("&Hide panels\tTab"),
                          .run = [this] { setPanelsHidden(!m_panelsHidden); },
                          .on = [this] { return m_panelsHidden; }}});
    menu.addSeparator();
    const auto underMouse = [this](void (view::HeadView::*head)(), void (view::PaintView::*paint)()) {
        return [this, head, paint] { m_headView->underMouse() ? (m_headView->*head)() : (m_paintView->*paint)(); };
    };
    m_actions.add(
        menu,
        {{"view.fit", tr("&Fit"), {Qt::Key_F}, underMouse(&view::HeadView::fit, &view::PaintView::fit), "fit"},
         {"view.home",
          tr("&Reset view"),
          {Qt::Key_Home},
          underMouse(&view::HeadView::resetCamera, &view::PaintView::resetView),
          "home"},
         {"view.turnToBrush", tr("&Turn to the brush"), {Qt::Key_Period}, [this] { m_headView->turnToBrush(); }},
         {"view.mirror", tr("&Mirror the paint area"), {Qt::SHIFT | Qt::Key_M}, [this] { m_paintView->mirrorView(); }},
         {.id = "view.wireframe",
          .text = tr("&Wireframe"),
          .run = [&editor] { editor.setWireframe(!editor.wireframe()); },
          .icon = "wireframe",
          .on = [&editor] { return editor.wireframe(); }},
         {.id = "view.night",
          .text = tr("&Night paper"),
          .run = [&editor] { editor.setNightPaper(!editor.nightPaper()); },
          .icon = "paper",
          .on = [&editor] { return editor.nightPaper(); }}});
    menu.addSeparator();
    QMenu& sides = *menu.addMenu(tr("&Look from"));
    using rendering::StandardView;
    const auto side = [this](const char* id, const QString& text, QKeyCombination key, StandardView view) {
        return ActionRow{.id = id, .text = text, .keys = {key}, .run = [this, view] { m_headView->setView(view); }};
    };
    // The number pad as in Blender.
    constexpr Qt::KeyboardModifier kPad = Qt::KeypadModifier;
    m_actions.add(
        sides,
        {side("look.front", tr("&Front"), kPad | Qt::Key_1, StandardView::Front),
         side("look.back", tr("&Back"), QKeyCombination(Qt::ControlModifier | kPad, Qt::Key_1), StandardView::Back),
         side("look.right", tr("&Right"), kPad | Qt::Key_3, StandardView::Right),
         side("look.left", tr("&Left"), QKeyCombination(Qt::ControlModifier | kPad, Qt::Key_3), StandardView::Left),
         side("look.top", tr("&Top"), kPad | Qt::Key_7, StandardView::Top),
         side("look.bottom", tr("B&elow"), QKeyCombination(Qt::ControlModifier | kPad, Qt::Key_7),
              StandardView::Bottom),
         side("look.threeQuarter", tr("T&hree-quarter"), kPad | Qt::Key_5, StandardView::ThreeQuarter)});
    menu.addSeparator();
    const auto theme = [this](const char* id, const QString& text, view::ThemeKind kind) {
        return ActionRow{.id = id,
                         .text = text,
                         .run =
                             [this, kind] {
                                 view::Preferences preferences = m_preferences;
                                 preferences.theme = kind;
                                 setPreferences(preferences);
                             },
                         .on = [this, kind] { return m_preferences.theme == kind; }};
    };
    m_actions.add(menu, {theme("view.dark", tr("&Dark theme"), view::ThemeKind::Dark),
                         theme("view.light", tr("Li&ght theme"), view::ThemeKind::Light)});
}

void MainWindow::addHairActions(QMenu& menu)
{
    model::Document& document = m_session.document();
    m_actions.add(menu, {{.id = "hair.wind",
                          .text = tr("&Wind"),
                          .keys = {Qt::Key_W},
                          .run = [this] { m_session.toggleWind(); },
                          .icon = "wind",
                          .on = [&document] { return document.project().wind.enabled; }},
                         {"hair.windDialog", tr("W&ind…"), {Qt::SHIFT | Qt::Key_W}, [this] { showWind(); }},
                         {"hair.lightDialog", tr("&Light…"), {Qt::SHIFT | Qt::Key_L}, [this] { showLight(); }, "light"},
                         {.id = "hair.weather",
                          .text = tr("Weat&her keys"),
                          .keys = {Qt::Key_F7},
                          .run = [this] { m_headView->setWeatherShown(!m_headView->weatherShown()); },
                          .icon = "weather",
                          .on = [this] { return m_headView->weatherShown(); }}});
    menu.addSeparator();
    m_actions.add(menu, {{.id = "hair.pause",
                          .text = tr("&Pause"),
                          .keys = {Qt::Key_F8},
                          .run = [this] { m_session.setPaused(!m_session.paused()); },
                          .icon = "pause",
                          .on = [this] { return m_session.paused(); }},
                         {"hair.reset",
                          tr("&Reset the simulation"),
                          {Qt::SHIFT | Qt::Key_F8},
                          [this] { m_session.resetHair(); },
                          "reset"}});
    menu.addSeparator();
    m_actions.add(menu,
                  {{"hair.addGroup", tr("&Add hair group…"), {}, [this] { m_sidebar->askWhatGrows(); }, "group-add"},
                   {"hair.removeGroup", tr("Remo&ve hair group"), {}, [this] { m_sidebar->hair().removeGroup(); }}});
    menu.addSeparator();
    m_actions.add(menu, {{"hair.saveStyle", tr("&Save style…"), {}, [this] { m_exchange.saveStyle(); }}});
}

void MainWindow::addHelpActions(QMenu& menu)
{
    m_actions.add(
        menu,
        {{"help.help",
          tr("&Help…"),
          {Qt::SHIFT | Qt::Key_F1},
          [this] { showHelp(view::HelpDialog::Topic::Tools, this); }},
         {"help.keys", tr("&Keys…"), {}, [this] { showHelp(view::HelpDialog::Topic::Keys, this); }},
         {"help.about", tr("&About Hair Paint"), {}, [this] {
              view::AboutDialog(QApplication::applicationVersion(), m_headView->rendererDescription(), this).exec();
          }}});
}

} // namespace hairpaint::app
