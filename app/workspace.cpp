// Layout of areas and panels: see the header.
#include "app/workspace.h"

#include "app/library.h"
#include "view/head_view.h"
#include "view/map_legend.h"
#include "view/paint_view.h"
#include "view/panels/option_bar.h"
#include "view/panels/sidebar.h"
#include "view/panels/status_readout.h"
#include "view/panels/style_strip.h"
#include "view/panels/tool_bar.h"
#include "view/widgets/drop_hint.h"

#include <QKeyEvent>
#include <QVBoxLayout>

namespace hairpaint::app {

namespace {

view::StartBackdrop backdropsIn(Jobs& jobs)
{
    return [&jobs](const std::function<view::BackdropPtr()>& make, QObject* receiver,
                   const std::function<void(const view::BackdropPtr&)>& done) {
        // Nobody is told what went wrong: the map is painted on without a backdrop too.
        jobs.start<view::BackdropPtr>(
            {}, [make](const model::Progress&) -> model::Result<view::BackdropPtr> { return make(); }, receiver,
            [done](const model::Result<view::BackdropPtr>& made) { done(made.value_or(nullptr)); });
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

Workspace::Workspace(view::EditorState& editor, Jobs& jobs, const view::Preferences& preferences)
{
    const view::Theme theme = view::Theme::of(preferences.theme);
    m_toolBar = new view::ToolBar(editor);
    m_optionBar = new view::OptionBar(editor);
    m_paintView = new view::PaintView(editor, theme, backdropsIn(jobs));
    m_headView = new view::HeadView(editor, theme, preferences.presenter);
    m_legend = new view::MapLegend(m_headView);
    m_sidebar = new view::Sidebar(editor);
    m_styleStrip = new view::StyleStrip(editor, loadStyle, stylesIn(jobs));
    m_status = new view::StatusReadout(editor);
    layOut();
    m_dropHint = new view::DropHint(this);
    m_paintView->installEventFilter(this);
    m_headView->installEventFilter(this);
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

void Workspace::setTheme(const view::Theme& theme)
{
    m_paintView->setTheme(theme);
    m_headView->setTheme(theme);
}

bool Workspace::eventFilter(QObject* watched, QEvent* event)
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
    return QWidget::eventFilter(watched, event);
}

} // namespace hairpaint::app
