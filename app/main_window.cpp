// Layout and wiring of the window: see the header.
#include "app/main_window.h"

#include "app/background/map_resolving.h"
#include "app/dropped_file.h"
#include "app/library.h"
#include "app/physical_keys.h"
#include "app/picture.h"
#include "view/head_view.h"
#include "view/map_legend.h"
#include "view/paint_view.h"
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
#include <QMenuBar>
#include <QMimeData>
#include <QUndoStack>
#include <QVBoxLayout>

namespace hairpaint::app {

namespace {

constexpr QSize kSmallestWindow(1100, 680);
constexpr QSize kFirstWindow(1440, 900);
constexpr QSize kThumbnail(256, 256);

/// Draws what the 3D area shows now; without OpenGL a file has no picture.
ProjectFiles::Picture thumbnailOf(rendering::Scene scene)
{
    return [scene = std::move(scene)](const model::Progress& progress) {
        const model::Result<QImage> picture =
            model::guarded(MainWindow::tr("Drawing the picture"), [&]() -> model::Result<QImage> {
                const model::Result<std::unique_ptr<PictureMaker>> maker = PictureMaker::create();
                return maker ? (*maker)->sketch(scene, kThumbnail, progress) : tl::unexpected(maker.error());
            });
        return picture.value_or(QImage());
    };
}

} // namespace

MainWindow::MainWindow(model::Project project, const QString& path, QWidget* parent)
    : QMainWindow(parent), m_session(std::move(project)), m_jobs(*this), m_files(m_session, m_settings, m_jobs, *this),
      m_exchange(m_session, m_settings, m_jobs, *this), m_stylePictures(m_jobs), m_actions(m_settings, *this),
      m_preferences(m_settings.preferences())
{
    setAcceptDrops(true);
    setMinimumSize(kSmallestWindow);
    buildLayout();
    buildMenus();
    connectViews();
    applyTheme();
    refreshStyles();
    m_files.setPath(path);
    m_session.document().resolveIn(resolvedByJobs(m_jobs, &m_session));
    m_session.editor().setNightPaper(!m_preferences.whitePaper);
    if (!restoreGeometry(m_settings.windowGeometry()))
        resize(kFirstWindow);
    showAreas(Areas::Both);
    for (QWidget* area : std::initializer_list<QWidget*>{this, m_paintView, m_headView})
        area->installEventFilter(this);
    m_paintView->setFocus(); // Keys mean tools and maps from the first moment.
}

MainWindow::~MainWindow()
{
    // Everything on the window refers to the session, which as a member goes before the window's children would.
    qDeleteAll(findChildren<QDialog*>(Qt::FindDirectChildrenOnly));
    m_legend = nullptr; // Goes with the 3D area, and the window may still hear that it is active no more.
    delete takeCentralWidget();
    for (QObject* source : std::initializer_list<QObject*>{&m_session, &m_session.document(), &m_session.editor(),
                                                           &m_session.document().undoStack()})
        source->disconnect(this);
}

void MainWindow::buildLayout()
{
    view::EditorState& editor = m_session.editor();
    const view::Theme theme = view::Theme::of(m_preferences.theme);
    m_toolBar = new view::ToolBar(editor);
    m_optionBar = new view::OptionBar(editor);
    m_paintView = new view::PaintView(
        editor, theme,
        [this](const std::function<view::BackdropPtr()>& make, QObject* receiver,
               const std::function<void(const view::BackdropPtr&)>& done) {
            // Nobody is told what went wrong: the map is painted on without a backdrop too.
            m_jobs.start<view::BackdropPtr>(
                {}, [make](const model::Progress&) -> model::Result<view::BackdropPtr> { return make(); }, receiver,
                [done](const model::Result<view::BackdropPtr>& made) { done(made.value_or(nullptr)); });
        });
    m_headView = new view::HeadView(editor, theme, m_preferences.presenter);
    m_legend = new view::MapLegend(m_headView);
    m_sidebar = new view::Sidebar(editor);
    m_styleStrip =
        new view::StyleStrip(editor, loadStyle,
                             [this](const QString& doing, const std::function<model::Result<model::Preset>()>& load,
                                    QObject* receiver, const std::function<void(model::Result<model::Preset>)>& done) {
                                 m_jobs.start<model::Preset>(
                                     doing, [load](const model::Progress&) { return load(); }, receiver, done);
                             });
    m_status = new view::StatusReadout(editor);

    m_splitter = new QSplitter(Qt::Horizontal);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setHandleWidth(4);
    m_splitter->addWidget(m_paintView);
    m_splitter->addWidget(m_headView);
    m_splitter->setStretchFactor(0, 10);
    m_splitter->setStretchFactor(1, 11);
    m_splitter->setSizes({1000, 1100});

    auto* middle = new QVBoxLayout;
    middle->setContentsMargins(0, 0, 0, 0);
    middle->setSpacing(0);
    middle->addWidget(m_splitter, 1);
    middle->addWidget(m_styleStrip);

    auto* row = new QHBoxLayout;
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(m_toolBar);
    row->addLayout(middle, 1);
    row->addWidget(m_sidebar);

    auto* whole = new QWidget;
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_optionBar);
    column->addLayout(row, 1);
    column->addWidget(m_status);
    setCentralWidget(whole);
    m_dropHint = new view::DropHint(whole);
}

void MainWindow::connectViews()
{
    const auto showMessage = [this](const QString& text) { m_status->showMessage(text); };
    connect(&m_session, &Session::frameChanged, this, [this](const std::shared_ptr<const sim::StrandFrame>& frame) {
        m_headView->setFrame(frame);
        m_status->setSimulationMs(frame->stepMilliseconds);
    });
    connect(&m_session, &Session::hairFailed, m_status,
            [this](const QString& reason) { m_status->showMessage(reason, true, 20'000); });
    connect(&m_session, &Session::pausedChanged, m_headView, &view::HeadView::setHairPaused);
    connect(&m_session, &Session::pausedChanged, m_status, &view::StatusReadout::setPaused);
    connect(m_headView, &view::HeadView::puffWanted, &m_session, &Session::puff);
    connect(m_headView, &view::HeadView::poseWanted, &m_session, &Session::setPose);
    connect(m_headView, &view::HeadView::lightWanted, &m_session, &Session::changeLight);
    connect(m_headView, &view::HeadView::windWanted, &m_session, &Session::changeWind);
    connect(m_headView, &view::HeadView::frameDrawn, this, &MainWindow::onFrameDrawn);
    connect(m_headView, &view::HeadView::glUnavailable, m_status,
            [this](const QString& reason) { m_status->showMessage(reason, true, 20'000); });
    connect(m_headView, &view::HeadView::statusText, this, showMessage);
    connect(m_paintView, &view::PaintView::statusText, this, showMessage);
    connect(&m_session.document(), &model::Document::undone, m_status,
            [this](const QString& name) { m_status->showMessage(tr("Undone: %1").arg(name)); });
    connect(&m_session.document(), &model::Document::redone, m_status,
            [this](const QString& name) { m_status->showMessage(tr("Redone: %1").arg(name)); });
    connect(m_headView, &view::HeadView::contextMenuWanted, this, &MainWindow::showAreaMenu);
    connect(m_paintView, &view::PaintView::contextMenuWanted, this, &MainWindow::showAreaMenu);

    m_files.setThumbnailMaker([this] { return thumbnailOf(m_headView->pictureScene()); });
    m_exchange.setSceneSource([this] { return m_headView->pictureScene(); });
    connect(&m_files, &ProjectFiles::pathChanged, this, &MainWindow::showTitle);
    connect(&m_session.document(), &model::Document::modifiedChanged, this, &MainWindow::showTitle);
    connect(&m_exchange, &Exchange::stylesChanged, this, &MainWindow::refreshStyles);
    connect(&m_exchange, &Exchange::done, this, showMessage);
    connect(&m_exchange, &Exchange::headDialogMade, this,
            [this](QDialog& dialog) { addHelpKey(dialog, view::HelpDialog::Topic::HeadImport); });
    connect(m_styleStrip, &view::StyleStrip::saveStyleRequested, &m_exchange, &Exchange::saveStyle);
    connect(m_styleStrip, &view::StyleStrip::renameStyleRequested, &m_exchange, &Exchange::renameStyle);
    connect(m_styleStrip, &view::StyleStrip::deleteStyleRequested, &m_exchange, &Exchange::deleteStyle);
    connect(m_styleStrip, &view::StyleStrip::pictureWanted, &m_stylePictures, &StylePictures::make);
    connect(&m_stylePictures, &StylePictures::made, m_styleStrip, &view::StyleStrip::setPicture);
    connect(m_styleStrip, &view::StyleStrip::failed, m_status,
            [this](const QString& message) { m_status->showMessage(message, true); });
}

void MainWindow::openFile(const QString& path)
{
    switch (fileKind(path)) {
    case FileKind::Project:
        m_files.openPath(path);
        break;
    case FileKind::Style:
        m_exchange.applyStyleFrom(path);
        break;
    case FileKind::Head:
        m_exchange.importHeadFrom(path);
        break;
    case FileKind::Image:
        m_exchange.importImageFrom(path, false);
        break;
    }
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!m_files.mayDiscard()) {
        event->ignore();
        return;
    }
    m_settings.setWindowGeometry(saveGeometry());
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (!event->mimeData()->hasUrls() || !event->mimeData()->urls().constFirst().isLocalFile())
        return;
    event->acceptProposedAction();
    const QString path = event->mimeData()->urls().constFirst().toLocalFile();
    m_dropHint->showText(dropText(fileKind(path), model::mapSpec(m_session.editor().activeMap())));
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent* /*event*/)
{
    m_dropHint->hide();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    const QString path = event->mimeData()->urls().constFirst().toLocalFile();
    event->acceptProposedAction();
    m_dropHint->hide();
    // The source program waits for the drop to end; a dialog would keep it waiting.
    QMetaObject::invokeMethod(
        this, [this, path] { openFile(path); }, Qt::QueuedConnection);
}

void MainWindow::lookAt(std::optional<model::MapKind> map)
{
    m_session.lookAt(map);
    const model::HairGroup* group = m_session.document().project().group(m_session.editor().activeGroup());
    if (map && group != nullptr)
        m_legend->showMap(model::mapSpec(*map), group->settings);
    else
        m_legend->hide();
}

void MainWindow::keyReleaseEvent(QKeyEvent* event)
{
    if (!event->isAutoRepeat() && (event->key() == Qt::Key_Alt || digitOf(physicalKey(*event)) > 0))
        lookAt(std::nullopt);
    QMainWindow::keyReleaseEvent(event);
}

bool MainWindow::event(QEvent* event)
{
    // Another window gets the release of a key that is held now.
    if (event->type() == QEvent::WindowDeactivate && m_legend != nullptr)
        lookAt(std::nullopt);
    return QMainWindow::event(event);
}

void MainWindow::keyPressEvent(QKeyEvent* event)
{
    if (event->modifiers() == Qt::AltModifier) {
        const int digit = digitOf(physicalKey(*event));
        if (digit >= 1 && digit <= model::kMapKindCount) {
            if (!event->isAutoRepeat())
                lookAt(static_cast<model::MapKind>(digit - 1));
            return;
        }
    }
    QAction* action = event->modifiers() == Qt::NoModifier ? actionAt(physicalKey(*event)) : nullptr;
    if (action != nullptr)
        action->trigger();
    else
        QMainWindow::keyPressEvent(event);
}

QAction* MainWindow::actionAt(PhysicalKey key) const
{
    QByteArray id;
    const int digit = digitOf(key);
    if (key == PhysicalKey::BracketLeft)
        id = "tool.smaller";
    else if (key == PhysicalKey::BracketRight)
        id = "tool.larger";
    else if (digit >= 1 && digit <= model::kMapKindCount)
        id = QByteArray("map.") + model::mapSpec(static_cast<model::MapKind>(digit - 1)).id;
    QAction* action = m_actions.find(QLatin1StringView(id));
    return action != nullptr && action->shortcut() == QKeySequence(usualKey(key)) ? action : nullptr;
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event)
{
    // Tab hides the panels while an area has the focus; elsewhere it moves the focus, as Qt does by itself when the
    // widget that has it is hidden.
    if (event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Tab && key->modifiers() == Qt::NoModifier) {
            setPanelsHidden(!m_panelsHidden);
            return true;
        }
    }
    return QMainWindow::eventFilter(watched, event);
}

void MainWindow::showAreas(Areas areas)
{
    m_paintView->setVisible(areas != Areas::Head);
    m_headView->setVisible(areas != Areas::Paint);
    m_areas = areas;
    m_actions.follow();
}

void MainWindow::swapAreas()
{
    const QList<int> sizes = m_splitter->sizes();
    m_splitter->insertWidget(0, m_splitter->widget(1));
    m_splitter->setSizes({sizes.value(1), sizes.value(0)});
}

void MainWindow::setPanelsHidden(bool hidden)
{
    m_panelsHidden = hidden;
    for (QWidget* panel : {static_cast<QWidget*>(m_toolBar), static_cast<QWidget*>(m_optionBar),
                           static_cast<QWidget*>(m_sidebar), static_cast<QWidget*>(m_styleStrip)})
        panel->setVisible(!hidden);
    m_actions.follow();
}

void MainWindow::applyTheme()
{
    const view::Theme theme = view::Theme::of(m_preferences.theme);
    QApplication::setPalette(theme.palette());
    qApp->setStyleSheet(theme.styleSheet());
    m_paintView->setTheme(theme);
    m_headView->setTheme(theme);
}

void MainWindow::showTitle()
{
    setWindowTitle(QStringLiteral("%1[*] - Hair Paint").arg(m_files.displayName()));
    const bool modified = m_session.document().modified();
    setWindowModified(modified);
    using Saved = view::StatusReadout::Saved;
    m_status->setSaved(modified ? Saved::No : m_files.path().isEmpty() ? Saved::NothingToSave : Saved::Yes);
    fillRecentMenu();
}

void MainWindow::refreshStyles()
{
    struct Library
    {
        std::vector<model::PresetEntry> entries;
        QStringList problems;
    };
    m_jobs.start<Library>(
        tr("Reading the styles"),
        [](const model::Progress&) -> model::Result<Library> {
            Library library;
            library.entries = listStyles(&library.problems);
            return library;
        },
        this,
        [this, number = ++m_libraryNumber](const model::Result<Library>& library) {
            if (number != m_libraryNumber)
                return; // It was asked for again meanwhile.
            m_stylePictures.forget();
            if (library)
                m_styleStrip->setEntries(library->entries);
            const QString problem = !library ? library.error().message : library->problems.value(0);
            if (!problem.isEmpty())
                m_status->showMessage(problem, true);
        });
}

void MainWindow::showAreaMenu(const QPoint& globalPosition)
{
    m_areaMenu->popup(globalPosition);
}

void MainWindow::onFrameDrawn(const rendering::FrameStatistics& statistics)
{
    const double seconds = m_sinceFrame.isValid() ? static_cast<double>(m_sinceFrame.nsecsElapsed()) * 1e-9 : 1.0;
    m_sinceFrame.start();
    // A pause is no slow frame: the picture was still.
    if (seconds < 0.5) {
        const double rate = 1.0 / std::max(seconds, 1e-3);
        m_frameRate = m_frameRate > 0.0 ? m_frameRate * 0.9 + rate * 0.1 : rate;
        m_status->setFramesPerSecond(m_frameRate);
    }
    const auto& frame = m_session.frame();
    // A fine picture takes its time, and one of hair that rests takes less than one of hair that moves.
    if (frame && !frame->asleep && !m_session.paused() && !statistics.inSteps)
        m_session.setDrawTime(statistics.milliseconds);
    if (frame)
        m_status->setHairs(static_cast<qint64>(statistics.drawnHairs), static_cast<qint64>(frame->hairCount),
                           frame->limit);
    else
        m_status->setHairs(static_cast<qint64>(statistics.drawnHairs), 0);
}

} // namespace hairpaint::app
