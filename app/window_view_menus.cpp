// The window's View, Hair and Help menus, and what they open.
#include "app/main_window.h"

#include "app/languages.h"
#include "view/rendering/standard_views.h"

#include "model/commands/commands.h"
#include "view/dialogs/about_dialog.h"
#include "view/dialogs/light_dialog.h"
#include "view/dialogs/wind_dialog.h"
#include "view/head_view.h"
#include "view/paint_view.h"
#include "view/panels/sidebar.h"
#include "view/panels/status_readout.h"

#include <QActionGroup>
#include <QApplication>
#include <QKeyEvent>
#include <QMenuBar>

namespace hairpaint::app {

void MainWindow::buildViewMenu()
{
    QMenu& menu = *menuBar()->addMenu(tr("&View"));
    auto* areas = new QActionGroup(this);
    areas->addAction(m_actions.add(menu, {.id = "view.both",
                                          .text = tr("&Both areas"),
                                          .key = QKeySequence(Qt::Key_F1),
                                          .run = [this] { showAreas(Areas::Both); },
                                          .checkable = true}));
    areas->addAction(m_actions.add(menu, {.id = "view.head",
                                          .text = tr("&3D area only"),
                                          .key = QKeySequence(Qt::Key_F2),
                                          .run = [this] { showAreas(Areas::Head); },
                                          .checkable = true}));
    areas->addAction(m_actions.add(menu, {.id = "view.paint",
                                          .text = tr("&Paint area only"),
                                          .key = QKeySequence(Qt::Key_F3),
                                          .run = [this] { showAreas(Areas::Paint); },
                                          .checkable = true}));
    m_actions.add(menu, {.id = "view.swap",
                         .text = tr("&Swap sides"),
                         .key = QKeySequence(Qt::Key_F4),
                         .run = [this] { swapAreas(); },
                         .icon = "swap"});
    QAction* panels = m_actions.add(menu, {.id = "view.panels", .text = tr("&Hide panels\tTab"), .checkable = true});
    connect(panels, &QAction::triggered, this, [this](bool on) { setPanelsHidden(on); });
    menu.addSeparator();
    m_actions.add(menu, {.id = "view.fit",
                         .text = tr("&Fit"),
                         .key = QKeySequence(Qt::Key_F),
                         .run =
                             [this] {
                                 if (m_headView->underMouse())
                                     m_headView->fit();
                                 else
                                     m_paintView->fit();
                             },
                         .icon = "fit"});
    m_actions.add(menu, {.id = "view.home",
                         .text = tr("&Reset view"),
                         .key = QKeySequence(Qt::Key_Home),
                         .run =
                             [this] {
                                 if (m_headView->underMouse())
                                     m_headView->resetCamera();
                                 else
                                     m_paintView->resetView();
                             },
                         .icon = "home"});
    m_actions.add(menu, {.id = "view.mirror",
                         .text = tr("&Mirror the paint area"),
                         .key = QKeySequence(Qt::SHIFT | Qt::Key_M),
                         .run = [this] { m_paintView->mirrorView(); }});
    view::EditorState& editor = m_session.editor();
    QAction* wireframe =
        m_actions.add(menu, {.id = "view.wireframe", .text = tr("&Wireframe"), .icon = "wireframe", .checkable = true});
    QAction* night =
        m_actions.add(menu, {.id = "view.night", .text = tr("&Night paper"), .icon = "paper", .checkable = true});
    wireframe->setChecked(editor.wireframe());
    night->setChecked(editor.nightPaper());
    connect(wireframe, &QAction::toggled, &editor, [&editor](bool on) { editor.setWireframe(on); });
    connect(night, &QAction::toggled, &editor, [&editor](bool on) { editor.setNightPaper(on); });
    connect(&editor, &view::EditorState::viewOptionsChanged, this, [&editor, wireframe, night] {
        wireframe->setChecked(editor.wireframe());
        night->setChecked(editor.nightPaper());
    });
    menu.addSeparator();
    QMenu& sides = *menu.addMenu(tr("&Look from"));
    const std::pair<QString, rendering::StandardView> views[] = {
        {tr("&Front"), rendering::StandardView::Front}, {tr("&Back"), rendering::StandardView::Back},
        {tr("&Left"), rendering::StandardView::Left},   {tr("&Right"), rendering::StandardView::Right},
        {tr("&Top"), rendering::StandardView::Top},     {tr("T&hree-quarter"), rendering::StandardView::ThreeQuarter}};
    for (const auto& [title, side] : views)
        sides.addAction(title, this, [this, side = side] { m_headView->setView(side); });
    menu.addSeparator();
    auto* themes = new QActionGroup(this);
    const auto addTheme = [&](const char* id, const QString& title, view::ThemeKind kind) {
        const auto choose = [this, kind] {
            view::Preferences preferences = m_preferences;
            preferences.theme = kind;
            setPreferences(preferences);
        };
        themes->addAction(m_actions.add(menu, {.id = id, .text = title, .run = choose, .checkable = true}));
    };
    addTheme("view.dark", tr("&Dark theme"), view::ThemeKind::Dark);
    addTheme("view.light", tr("Li&ght theme"), view::ThemeKind::Light);
}

void MainWindow::buildHairMenu()
{
    QMenu& menu = *menuBar()->addMenu(tr("H&air"));
    model::Document& document = m_session.document();
    QAction* wind = m_actions.add(menu, {.id = "hair.wind",
                                         .text = tr("&Wind"),
                                         .key = QKeySequence(Qt::Key_W),
                                         .run = [this] { m_session.toggleWind(); },
                                         .icon = "wind",
                                         .checkable = true});
    const auto followWind = [wind, &document] { wind->setChecked(document.project().wind.enabled); };
    connect(&document, &model::Document::changed, this, followWind);
    followWind();
    m_actions.add(menu, {.id = "hair.windDialog",
                         .text = tr("W&ind…"),
                         .key = QKeySequence(Qt::SHIFT | Qt::Key_W),
                         .run = [this] { showWind(); }});
    m_actions.add(menu, {.id = "hair.lightDialog",
                         .text = tr("&Light…"),
                         .key = QKeySequence(Qt::SHIFT | Qt::Key_L),
                         .run = [this] { showLight(); },
                         .icon = "light"});
    QAction* weather = m_actions.add(menu, {.id = "hair.weather",
                                            .text = tr("Weat&her keys"),
                                            .key = QKeySequence(Qt::Key_F7),
                                            .icon = "weather",
                                            .checkable = true});
    connect(weather, &QAction::triggered, m_headView, &view::HeadView::setWeatherShown);
    menu.addSeparator();
    QAction* pause = m_actions.add(menu, {.id = "hair.pause",
                                          .text = tr("&Pause"),
                                          .key = QKeySequence(Qt::Key_F8),
                                          .icon = "pause",
                                          .checkable = true});
    connect(pause, &QAction::triggered, &m_session, &Session::setPaused);
    m_actions.add(menu, {.id = "hair.reset",
                         .text = tr("&Reset the simulation"),
                         .key = QKeySequence(Qt::SHIFT | Qt::Key_F8),
                         .run = [this] { m_session.resetHair(); },
                         .icon = "reset"});
    menu.addSeparator();
    m_actions.add(menu, {.id = "hair.addGroup",
                         .text = tr("&Add hair group"),
                         .run = [this] { m_sidebar->hair().addGroup(); },
                         .icon = "group-add"});
    m_actions.add(menu, {.id = "hair.removeGroup", .text = tr("Remo&ve hair group"), .run = [this] {
                             m_sidebar->hair().removeGroup();
                         }});
    menu.addSeparator();
    m_actions.add(menu,
                  {.id = "hair.saveStyle", .text = tr("&Save style…"), .run = [this] { m_exchange.saveStyle(); }});
}

void MainWindow::buildHelpMenu()
{
    QMenu& menu = *menuBar()->addMenu(tr("&Help"));
    m_actions.add(menu,
                  {.id = "help.help", .text = tr("&Help…"), .key = QKeySequence(Qt::SHIFT | Qt::Key_F1), .run = [this] {
                       showHelp(view::HelpDialog::Topic::Tools, this);
                   }});
    m_actions.add(menu, {.id = "help.keys", .text = tr("&Keys…"), .run = [this] {
                             showHelp(view::HelpDialog::Topic::Keys, this);
                         }});
    m_actions.add(
        menu,
        {.id = "help.about", .text = tr("&About Hair Paint"), .run = [this] {
             view::AboutDialog(QApplication::applicationVersion(), m_headView->rendererDescription(), this).exec();
         }});
}

void MainWindow::changeBrushSize(float factor)
{
    model::ToolSettings settings = m_session.editor().toolSettings();
    settings.brushSizeM = std::clamp(settings.brushSizeM * factor, 0.001F, 0.3F);
    m_session.editor().setToolSettings(settings);
}

void MainWindow::selectAll()
{
    m_session.editor().selection().setRectangle(QRectF(0.0, 0.0, 1.0, 1.0));
}

void MainWindow::copySelection()
{
    m_clip = model::copyClip(m_session.document(), m_session.editor().target(), m_session.editor().selection());
    m_status->showMessage(tr("Copied from %1").arg(model::mapSpec(m_clip->map).titleText()));
}

void MainWindow::cutSelection()
{
    m_session.document().endEdit(); // What is cut is what is there then.
    copySelection();
    const model::LayerAddress target = m_session.editor().target();
    m_session.document().push(model::clearCommand(m_session.document(), target, m_session.editor().selection(),
                                                  tr("Cut %1").arg(model::mapSpec(target.map).titleText())));
}

void MainWindow::pasteClip()
{
    if (!m_clip) {
        m_status->showMessage(tr("Nothing was copied yet: select a part of a map and copy it first"));
        return;
    }
    m_session.document().push(model::pasteCommand(m_session.document(), m_session.editor().target(), *m_clip,
                                                  m_session.editor().selection()));
}

void MainWindow::clearSelection()
{
    const model::LayerAddress target = m_session.editor().target();
    m_session.document().push(model::clearCommand(m_session.document(), target, m_session.editor().selection(),
                                                  tr("Clear %1").arg(model::mapSpec(target.map).titleText())));
}

namespace {

/// Opens the one dialog of its kind over the window, or brings it to the front.
template<typename Dialog>
void showOnly(QWidget* window, view::EditorState& editor, const std::function<void(QDialog&)>& prepare)
{
    auto* dialog = window->findChild<Dialog*>();
    if (dialog == nullptr) {
        dialog = new Dialog(editor, window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        prepare(*dialog);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

} // namespace

void MainWindow::showWind()
{
    showOnly<view::WindDialog>(this, m_session.editor(),
                               [this](QDialog& dialog) { addHelpKey(dialog, view::HelpDialog::Topic::Wind); });
}

void MainWindow::showLight()
{
    showOnly<view::LightDialog>(this, m_session.editor(),
                                [this](QDialog& dialog) { addHelpKey(dialog, view::HelpDialog::Topic::Light); });
}

void MainWindow::showPreferences()
{
    auto* dialog = new view::PreferencesDialog(m_preferences, languages(), m_actions.bindings(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    addHelpKey(*dialog, view::HelpDialog::Topic::Preferences);
    connect(dialog, &view::PreferencesDialog::preferencesChanged, this, &MainWindow::setPreferences);
    connect(dialog, &view::PreferencesDialog::keyChanged, &m_actions, &ActionSet::remember);
    dialog->show();
}

namespace {

/// F1 in a dialog. No shortcut: the window's own F1 reaches into its tool windows, and two of them are none.
class HelpKey : public QObject
{
public:
    HelpKey(QDialog& dialog, std::function<void()> show) : QObject(&dialog), m_show(std::move(show)) {}

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
        if (!isKey || static_cast<QKeyEvent*>(event)->key() != Qt::Key_F1)
            return QObject::eventFilter(watched, event);
        if (event->type() == QEvent::KeyPress)
            m_show();
        event->accept();
        return true;
    }

private:
    std::function<void()> m_show;
};

} // namespace

void MainWindow::showHelp(view::HelpDialog::Topic topic, QWidget* over)
{
    auto* dialog = over->findChild<view::HelpDialog*>(QString(), Qt::FindDirectChildrenOnly);
    if (dialog == nullptr)
        dialog = new view::HelpDialog(m_session.editor(), m_actions.bindings(), over);
    dialog->showTopic(topic);
}

void MainWindow::addHelpKey(QDialog& dialog, view::HelpDialog::Topic topic)
{
    dialog.installEventFilter(new HelpKey(dialog, [this, topic, over = &dialog] { showHelp(topic, over); }));
}

void MainWindow::setPreferences(const view::Preferences& preferences)
{
    if (preferences == m_preferences)
        return;
    m_preferences = preferences;
    m_settings.setPreferences(preferences);
    m_session.editor().setNightPaper(!preferences.whitePaper);
    applyTheme();
}

} // namespace hairpaint::app
