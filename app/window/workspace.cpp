// Layout of areas and panels: see the header.
#include "app/window/workspace.h"

#include "app/styles/library.h"
#include "app/window/first_hair.h"
#include "view/head_area/head_view.h"
#include "view/paint_area/map_legend.h"
#include "view/paint_area/paint_view.h"
#include "view/panels/option_bar.h"
#include "view/panels/sidebar.h"
#include "view/panels/status_readout.h"
#include "view/panels/style_strip.h"
#include "view/panels/tool_bar.h"
#include "view/widgets/drop_hint.h"
#include "view/widgets/focus_ring.h"

#include <QAbstractButton>
#include <QApplication>
#include <QKeyEvent>
#include <QVBoxLayout>

namespace hairpaint::app {

namespace {

view::StartBackdrop backdropsIn(Jobs& jobs, FirstHair& firstHair)
{
    return [&jobs, &firstHair](const std::function<view::BackdropPtr()>& make, QObject* receiver,
                               const std::function<void(const view::BackdropPtr&)>& done) {
        firstHair.then(receiver, [&jobs, make, receiver, done] {
            // Nobody is told what went wrong: the map is painted on without a backdrop too.
            jobs.start<view::BackdropPtr>(
                {}, [make](const model::Progress&) -> model::Result<view::BackdropPtr> { return make(); }, receiver,
                [done](const model::Result<view::BackdropPtr>& made) { done(made.value_or(nullptr)); });
        });
    };
}

view::StyleStrip::Start stylesIn(Jobs& jobs)
{
    return [&jobs](const QString& doing, const std::function<model::Result<model::Preset>()>& load, QObject* receiver,
                   const std::function<void(model::Result<model::Preset>)>& done) {
        jobs.start<model::Preset>(
            doing, [load](const model::Progress&) { return load(); }, receiver, done);
    };
}

} // namespace

Workspace::Workspace(view::EditorState& editor, Jobs& jobs, FirstHair& firstHair, const view::Preferences& preferences)
{
    const view::Theme theme = view::Theme::of(preferences.theme);
    m_toolBar = new view::ToolBar(editor);
    m_optionBar = new view::OptionBar(editor);
    m_paintView = new view::PaintView(editor, theme, backdropsIn(jobs, firstHair));
    m_headView = new view::HeadView(editor, theme, preferences.presenter);
    m_legend = new view::MapLegend(m_headView);
    m_sidebar = new view::Sidebar(editor);
    m_styleStrip = new view::StyleStrip(editor, loadStyle, stylesIn(jobs));
    m_status = new view::StatusReadout(editor);
    layOut();
    m_dropHint = new view::DropHint(this);
    nameFocusAreas();
}

void Workspace::layOut()
{
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

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_optionBar);
    column->addLayout(row, 1);
    column->addWidget(m_status);
}

void Workspace::showAreas(Areas areas)
{
    m_paintView->setVisible(areas != Areas::Head);
    m_headView->setVisible(areas != Areas::Paint);
    m_areas = areas;
    Q_EMIT arranged();
}

void Workspace::swapAreas()
{
    const QList<int> sizes = m_splitter->sizes();
    m_splitter->insertWidget(0, m_splitter->widget(1));
    m_splitter->setSizes({sizes.value(1), sizes.value(0)});
}

void Workspace::setPanelsHidden(bool hidden)
{
    m_panelsHidden = hidden;
    for (QWidget* panel : std::initializer_list<QWidget*>{m_toolBar, m_optionBar, m_sidebar, m_styleStrip})
        panel->setVisible(!hidden);
    Q_EMIT arranged();
}

void Workspace::findStyle()
{
    if (m_panelsHidden)
        setPanelsHidden(false);
    m_styleStrip->startSearch();
}

void Workspace::setTheme(const view::Theme& theme)
{
    m_paintView->setTheme(theme);
    m_headView->setTheme(theme);
}

void Workspace::nameFocusAreas()
{
    m_focusAreas = new FocusAreas(
        {{.widget = m_optionBar},
         {.widget = m_toolBar},
         {.widget = m_paintView},
         {.widget = m_headView},
         {.widget = &m_sidebar->maps()},
         {.widget = &m_sidebar->layers(), .uncover = [this] { m_sidebar->showLayers(); }, .container = m_sidebar},
         {.widget = &m_sidebar->hair(), .uncover = [this] { m_sidebar->showHair(); }, .container = m_sidebar},
         {.widget = m_styleStrip}},
        this);
    for (QWidget* area : std::initializer_list<QWidget*>{m_paintView, m_headView})
        new view::FocusRing(area);
}

bool Workspace::focusNextPrevChild(bool next)
{
    return m_focusAreas->stepWithin(next) || QWidget::focusNextPrevChild(next);
}

void Workspace::keyPressEvent(QKeyEvent* event)
{
    // Keys that the widget with the focus had no use for. A button takes only the space bar by itself.
    QWidget* focus = QApplication::focusWidget();
    auto* button = qobject_cast<QAbstractButton*>(focus);
    QWidget* area = m_paintView->isVisible() ? static_cast<QWidget*>(m_paintView) : m_headView;
    if (button != nullptr && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter))
        button->click();
    else if (event->key() == Qt::Key_Escape && focus != m_paintView && focus != m_headView)
        area->setFocus(Qt::ShortcutFocusReason);
    else
        QWidget::keyPressEvent(event);
}

} // namespace hairpaint::app
