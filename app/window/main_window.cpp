// The window's wiring: see the header.
#include "app/window/main_window.h"

#include "app/background/map_resolving.h"
#include "app/headless/picture.h"
#include "app/recovery/recovery.h"
#include "app/settings/tool_memory.h"
#include "app/window/dropped_file.h"
#include "app/window/frame_meter.h"
#include "app/window/menus/area_menu.h"
#include "app/window/menus/edit_menu.h"
#include "app/window/menus/file_menu.h"
#include "app/window/menus/hair_menu.h"
#include "app/window/menus/help_menu.h"
#include "app/window/menus/map_menu.h"
#include "app/window/menus/tools_menu.h"
#include "app/window/menus/view_menu.h"
#include "app/window/opening_sign.h"
#include "app/window/style_strip_controller.h"
#include "app/window/workspace.h"
#include "view/head_area/head_view.h"
#include "view/head_area/turn_hint.h"
#include "view/paint_area/paint_view.h"
#include "view/panels/option_bar.h"
#include "view/panels/sidebar.h"
#include "view/panels/status_readout.h"
#include "view/panels/style_strip.h"
#include "view/panels/tool_bar.h"
#include "view/widgets/drop_hint.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDialog>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMenuBar>
#include <QMimeData>
#include <QUndoStack>

#include <algorithm>
#include <utility>

namespace hairpaint::app {

namespace {

constexpr QSize kSmallestWindow(960, 600);
constexpr QSize kFirstWindow(1440, 900);
constexpr QSize kThumbnail(256, 256);
constexpr int kReasonMs = 20'000; ///< For reading why there is no picture or no hair, or what others did.

/// Draws what the 3D area shows now.
ProjectFiles::Picture thumbnailOf(rendering::Scene scene)
{
    return [scene = std::move(scene)](const model::Progress& progress) {
        const model::Result<QImage> picture =
            model::guarded(MainWindow::tr("Drawing the picture"), [&]() -> model::Result<QImage> {
                return PictureMaker().sketch(scene, kThumbnail, progress);
            });
        return picture.value_or(QImage());
    };
}

} // namespace

MainWindow::MainWindow(model::Project project, std::unique_ptr<Settings> settings)
    : m_ownSettings(std::move(settings)), m_settings(*m_ownSettings), m_session(std::move(project)),
      m_firstHair(m_session), m_jobs(*this), m_freedMemory(m_session.document(), m_jobs),
      m_files(m_session, m_settings, m_jobs, *this), m_journal(m_session.document(), JournalFolder::root()),
      m_exchange(m_session, m_settings, m_jobs, *this), m_actions(m_settings, *this), m_preferences(m_settings),
      m_clipCommands(m_session, m_exchange.maps()), m_dialogs(*this, m_session.editor(), m_actions, m_preferences),
      m_focusReturn(this), m_dialogPositions(*this, m_settings, [this] {
          const view::HeadView& head = m_workspace->headView();
          return head.isVisible() ? QRect(head.mapToGlobal(QPoint(0, 0)), head.size()) : QRect();
      })
{
    view::applyTheme(*qApp, m_preferences.current().theme); // First: what is built asks how large its text is.
    setAcceptDrops(true);
    setMinimumSize(kSmallestWindow);
    m_workspace = new Workspace(m_session.editor(), m_jobs, m_firstHair, m_preferences.current());
    m_firstHair.showIn(m_workspace->headView());
    setCentralWidget(m_workspace);
    m_keys = std::make_unique<PositionKeys>(m_actions, m_session, *m_workspace);
    buildMenus();
    offerActions();
    followActions();
    connectSession();
    connectAreas();
    connectFiles();
    auto* styles = new StyleStripController(m_workspace->styleStrip(), m_exchange.styles(), m_settings, m_jobs,
                                            m_session.document());
    connect(styles, &StyleStripController::landmarksWanted, this, [this] { m_exchange.heads().moveLandmarks(); });
    view::StatusReadout& status = m_workspace->status();
    connect(styles, &StyleStripController::failed, &status,
            [&status](const QString& problem) { status.showMessage(problem, true); });
    m_exchange.styles().setCamera([this] { return m_workspace->headView().pictureScene().camera; });
    connect(&m_workspace->styleStrip(), &view::StyleStrip::asking, m_workspace,
            [this] { m_workspace->setPanelsHidden(false); });
    m_firstHair.then(styles, [styles] { styles->refresh(); });
    m_files.setPath({});
    m_session.document().resolveIn(resolvedByJobs(m_jobs, &m_session));
    recallToolOptions(m_settings, m_session.editor());
    m_session.editor().options().setNightPaper(!m_preferences.current().whitePaper);
    if (!restoreGeometry(m_settings.windowGeometry()))
        resize(kFirstWindow);
    m_workspace->showAreas(Workspace::Areas::Both);
    m_workspace->paintView().setFocus(); // Keys mean tools and maps from the first moment.
}

MainWindow::~MainWindow()
{
    // Everything on the window refers to the session, which as a member goes before the window's children would.
    qDeleteAll(findChildren<QDialog*>(Qt::FindDirectChildrenOnly));
    for (QObject* source : std::initializer_list<QObject*>{&m_session, &m_session.document(), &m_session.editor(),
                                                           &m_session.document().undoStack()})
        source->disconnect(this);
    m_workspace = nullptr; // The window may still hear that it is active no more.
    delete takeCentralWidget();
}

view::PaintView& MainWindow::paintView()
{
    return m_workspace->paintView();
}

view::HeadView& MainWindow::headView()
{
    return m_workspace->headView();
}

void MainWindow::buildMenus()
{
    QMenuBar* bar = menuBar();
    view::EditorState& editor = m_session.editor();
    view::HeadView& head = m_workspace->headView();
    view::Sidebar& sidebar = m_workspace->sidebar();
    m_fileMenu = new FileMenu(tr("&File"), m_actions, m_files, m_exchange, editor, bar);
    for (QMenu* menu : std::initializer_list<QMenu*>{
             m_fileMenu,
             new EditMenu(tr("&Edit"), m_actions, m_session, m_clipCommands, sidebar.layers(), m_dialogs, bar),
             new MapMenu(tr("&Map"), m_actions, m_session, sidebar.layers(), m_jobs, bar),
             new ToolsMenu(tr("&Tools"), m_actions, editor, bar),
             new ViewMenu(tr("&View"), m_actions, *m_workspace, editor, m_preferences, m_exchange, bar),
             new HairMenu(tr("H&air"), m_actions, m_session, *m_workspace, m_dialogs, m_exchange, m_jobs, bar),
             new HelpMenu(tr("&Help"), m_actions, m_dialogs, head, bar)})
        bar->addMenu(menu);
}

void MainWindow::offerActions()
{
    const auto action = [this](const char* id) { return m_actions.find(QLatin1StringView(id)); };
    for (const auto& tool : m_session.editor().tools().all())
        m_workspace->toolBar().setAction(tool->id(), *action((QByteArray("tool.") + tool->name()).constData()));
    for (const char* id :
         {"edit.all", "edit.none", "edit.invert", "edit.cut", "edit.copy", "edit.paste", "edit.fill", "edit.clear"})
        m_workspace->optionBar().addSelectionAction(action(id));
    for (const char* id : {"edit.mirror", "view.wireframe", "view.night"})
        m_workspace->toolBar().addFootAction(action(id));
}

void MainWindow::followActions()
{
    const auto follow = [this] { m_actions.follow(); };
    connect(&m_session.document().undoStack(), &QUndoStack::indexChanged, this, follow);
    connect(&m_session.document(), &model::Document::changed, this, follow);
    connect(&m_session.editor().target(), &view::EditTarget::changed, this, follow);
    connect(&m_session.editor().tools(), &view::ToolBox::overlayChanged, this, follow);
    connect(&m_session.editor().options(), &view::ViewOptions::changed, this, follow);
    connect(&m_session, &Session::pausedChanged, this, follow);
    connect(&m_workspace->headView(), &view::HeadView::weatherShownChanged, this, follow);
    connect(m_workspace, &Workspace::arranged, this, follow);
    m_actions.follow();
}

void MainWindow::connectSession()
{
    view::HeadView& head = m_workspace->headView();
    view::StatusReadout& status = m_workspace->status();
    connect(&m_session, &Session::frameChanged, this,
            [&head, &status](const std::shared_ptr<const sim::StrandFrame>& frame) {
                head.setFrame(frame);
                status.setSimulationMs(frame->stepMilliseconds);
            });
    connect(&m_session, &Session::hairFailed, &status,
            [&status](const QString& reason) { status.showMessage(reason, true, kReasonMs); });
    connect(&m_session, &Session::pausedChanged, &head, &view::HeadView::setHairPaused);
    connect(&m_session, &Session::pausedChanged, &status, &view::StatusReadout::setPaused);
    connect(&m_session.document(), &model::Document::undone, &status,
            [&status](const QString& name) { status.showMessage(tr("Undone: %1").arg(name)); });
    connect(&m_session.document(), &model::Document::redone, &status,
            [&status](const QString& name) { status.showMessage(tr("Redone: %1").arg(name)); });
    connect(&m_session.document(), &model::Document::modifiedChanged, this, &MainWindow::showTitle);
}

void MainWindow::connectAreas()
{
    view::HeadView& head = m_workspace->headView();
    view::PaintView& paint = m_workspace->paintView();
    view::StatusReadout& status = m_workspace->status();
    connect(&head, &view::HeadView::puffWanted, &m_session, &Session::puff);
    connect(&head, &view::HeadView::poseWanted, &m_session, &Session::setPose);
    connect(&head, &view::HeadView::lightWanted, &m_session, &Session::changeLight);
    connect(&head, &view::HeadView::windWanted, &m_session, &Session::changeWind);
    new FrameMeter(head, m_session, status); // Belongs to the status line.
    connect(&head, &view::HeadView::glUnavailable, &status,
            [&status](const QString& reason) { status.showMessage(reason, true, kReasonMs); });
    if (!m_settings.viewTurned()) {
        auto* hint = new view::TurnHint(head);
        connect(&head, &view::HeadView::viewTurned, hint, [this, hint] {
            m_settings.setViewTurned();
            hint->deleteLater();
        });
        // A tool that draws over the picture begins beside the head, too.
        view::ToolBox& tools = m_session.editor().tools();
        const auto follow = [hint, &tools] { hint->setVisible(tools.active().pictureHandler() == nullptr); };
        connect(&tools, &view::ToolBox::activeChanged, hint, follow);
    }
    const auto showMessage = [&status](const QString& text) { status.showMessage(text); };
    connect(&head, &view::HeadView::statusText, &status, showMessage);
    connect(&paint, &view::PaintView::statusText, &status, showMessage);
    connect(&m_clipCommands, &ClipCommands::told, &status, showMessage);
    connect(&m_clipCommands, &ClipCommands::filesWanted, this, &MainWindow::openFiles);
    connect(&m_exchange.work(), &FileWork::done, &status, showMessage);
    connect(&m_jobs, &Jobs::cancelled, &status,
            [&status](const QString& sentence) { status.showMessage(sentence, false, kReasonMs); });
    auto* onHead = new AreaMenu(AreaMenu::Area::Head, m_actions, this);
    auto* onMap = new AreaMenu(AreaMenu::Area::Map, m_actions, this);
    connect(&head, &view::HeadView::contextMenuWanted, onHead, [onHead](const QPoint& at) { onHead->popup(at); });
    connect(&paint, &view::PaintView::contextMenuWanted, onMap, [onMap](const QPoint& at) { onMap->popup(at); });
}

void MainWindow::connectFiles()
{
    m_files.setThumbnailMaker([this] {
        rendering::Scene scene = m_workspace->headView().pictureScene();
        scene.cards.reset();
        return thumbnailOf(scene);
    });
    PictureExchange& pictures = m_exchange.pictures();
    pictures.setSource([this] {
        const view::HeadView& shown = m_workspace->headView();
        return ShownScene{.scene = shown.pictureScene(), .px = shown.size() * shown.devicePixelRatioF()};
    });
    new OpeningSign(m_files, m_session, m_workspace->headView()); // Belongs to the area.
    connect(&m_files, &ProjectFiles::pathChanged, this, &MainWindow::showTitle);
    connect(&m_files, &ProjectFiles::pathChanged, this,
            [this] { m_journal.setPath(m_files.path(), [this] { return m_files.knownFile(); }); });
    connect(&m_files, &ProjectFiles::pathChanged, this, [this] { m_exchange.hair().setProjectPath(m_files.path()); });
    view::StatusReadout& status = m_workspace->status();
    connect(&m_files, &ProjectFiles::changedOutside, &status,
            [&status](const QString& text) { status.showMessage(text, true, kReasonMs); });
    connect(&m_journal, &Journal::stopped, &status, &view::StatusReadout::setUnprotected);
    connect(&m_journal, &Journal::resumed, &status, [&status] { status.setUnprotected({}); });
    connect(&m_journal, &Journal::kept, this, &MainWindow::forgetRestored);
    view::HeadView& head = m_workspace->headView();
    connect(&head, &view::HeadView::frameDrawn, &pictures, &PictureExchange::followView);
    connect(&m_exchange.hair(), &HairExchange::cardsMade, &head, &view::HeadView::showCards);
    connect(&head, &view::HeadView::cardsShownChanged, this, [this] { m_actions.follow(); });
    const auto addHelp = [this](QDialog& dialog, view::HelpDialog::Topic topic) {
        m_dialogs.addHelpKey(dialog, topic);
    };
    connect(&m_exchange.work(), &FileWork::dialogMade, this, addHelp);
    connect(&m_preferences, &LivePreferences::changed, this, &MainWindow::applyPreferences);
}

void MainWindow::begin(const QString& file)
{
    // As a journal has it; the program may have been started elsewhere then.
    const QString path = file.isEmpty() ? QString() : QFileInfo(file).absoluteFilePath();
    const bool isRestored = offerUnsavedWork(path);
    if (path.isEmpty())
        return;
    if (!isRestored || fileKind(path) != FileKind::Project)
        return openFile(path);
    if (m_files.isOpen(path))
        return;
    m_settings.addRecentFile(path);
    showTitle();
    m_workspace->status().showMessage(
        tr("'%1' was not opened, since '%2' was restored and is not saved; save it, then open '%1' by File > Open "
           "recent.")
            .arg(QFileInfo(path).completeBaseName(), m_files.displayName()),
        false, kReasonMs);
}

bool MainWindow::offerUnsavedWork(const QString& file)
{
    sweepBeside(m_settings.recentFiles());
    UnsavedAnswer answer = askForUnsavedWork(JournalFolder::root(), m_jobs, *this, file);
    std::optional<RestoredWork>& restored = answer.restored;
    view::StatusReadout& status = m_workspace->status();
    if (!answer.problem.isEmpty())
        status.showMessage(tr("Unsaved work could not be read: %1").arg(answer.problem), true, kReasonMs);
    else if (answer.isKept)
        status.showMessage(tr("The unsaved work is kept; the next start offers it again."), false, kReasonMs);
    if (!restored)
        return false;
    m_journal.setPaused(true);
    const bool isRestored = m_files.restore(restored->work);
    m_journal.setPaused(false);
    if (!isRestored)
        return false;
    m_restored = std::move(restored->folder);
    m_journal.takeOver(restored->work);
    // Only when the journal has it is it nowhere else.
    (void)m_jobs.awaitUntil(ProjectFiles::restoring(), [this] { return m_journal.idle(); });
    return true;
}

void MainWindow::forgetRestored()
{
    if (m_restored)
        m_restored->remove();
    m_restored.reset();
}

void MainWindow::keepWork()
{
    m_session.document().settle(); // An unfinished stroke is work too.
    m_journal.lookAfterFolder();
    m_journal.flush();
    rememberGeometry();
}

void MainWindow::rememberGeometry()
{
    m_settings.setWindowGeometry(saveGeometry());
    rememberToolOptions(m_settings, m_session.editor());
}

void MainWindow::openFiles(const QStringList& paths)
{
    QStringList images;
    for (const QString& path : paths)
        if (fileKind(path) == FileKind::Image)
            images += path;
    const bool areStyles =
        std::ranges::all_of(paths, [](const QString& path) { return fileKind(path) == FileKind::Style; });
    if (images.size() > 1 && images.size() == paths.size())
        m_exchange.maps().importImages(images);
    else if (paths.size() > 1 && areStyles)
        m_exchange.styles().importStyles(paths);
    else if (!paths.isEmpty())
        openFile(paths.front());
}

void MainWindow::openFile(const QString& path)
{
    switch (fileKind(path)) {
    case FileKind::Project:
        m_files.openPath(path);
        break;
    case FileKind::Style:
        m_exchange.styles().applyFrom(path);
        break;
    case FileKind::Head:
        m_exchange.heads().importHeadFrom(path);
        break;
    case FileKind::Curves:
        m_exchange.hair().importHairFrom(path);
        break;
    case FileKind::Image:
        m_exchange.maps().importImageFrom(path, std::nullopt);
        break;
    }
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!m_files.mayDiscard()) {
        event->ignore();
        return;
    }
    m_journal.discard();
    forgetRestored();
    rememberGeometry();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    const Dropped dropped = whatIsDropped(*event->mimeData());
    if (dropped.isNothing())
        return;
    event->acceptProposedAction();
    m_workspace->dropHint().showText(dropText(dropped, model::mapSpec(m_session.editor().target().map())));
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent* /*event*/)
{
    m_workspace->dropHint().hide();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    const Dropped dropped = whatIsDropped(*event->mimeData());
    event->acceptProposedAction();
    m_workspace->dropHint().hide();
    // The source program waits for the drop to end; a dialog would keep it waiting.
    QMetaObject::invokeMethod(
        this, [this, dropped] { m_clipCommands.take(dropped); }, Qt::QueuedConnection);
}

void MainWindow::keyReleaseEvent(QKeyEvent* event)
{
    m_keys->release(*event);
    QMainWindow::keyReleaseEvent(event);
}

bool MainWindow::event(QEvent* event)
{
    // Another window gets the release of a key that is held now.
    if (event->type() == QEvent::WindowDeactivate && m_workspace != nullptr)
        m_keys->letGo();
    if (event->type() == QEvent::WindowActivate) {
        m_files.lookOutside();
        m_journal.lookAfterFolder();
    }
    return QMainWindow::event(event);
}

void MainWindow::keyPressEvent(QKeyEvent* event)
{
    if (!m_keys->press(*event))
        QMainWindow::keyPressEvent(event);
}

void MainWindow::applyPreferences()
{
    m_session.editor().options().setNightPaper(!m_preferences.current().whitePaper);
    view::applyTheme(*qApp, m_preferences.current().theme);
    m_workspace->setTheme(view::Theme::of(m_preferences.current().theme));
    m_actions.follow();
}

void MainWindow::showTitle()
{
    setWindowTitle(QStringLiteral("%1[*] - Hair Paint").arg(m_files.displayName()));
    const bool modified = m_session.document().modified();
    setWindowModified(modified);
    using Saved = view::StatusReadout::Saved;
    m_workspace->status().setSaved(modified ? Saved::No : m_files.path().isEmpty() ? Saved::NothingToSave : Saved::Yes);
    m_fileMenu->showRecentFiles(m_settings.recentFiles());
}

} // namespace hairpaint::app
