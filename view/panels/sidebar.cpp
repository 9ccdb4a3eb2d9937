// Maps on top, under them layers or hair.
#include "view/panels/sidebar.h"

#include "view/look/theme.h"

#include <QFrame>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

namespace hairpaint::view {

Sidebar::Sidebar(EditorState& state, QWidget* parent)
    : QWidget(parent), m_maps(new MapsPanel(state, this)), m_layers(new LayersPanel(state)),
      m_hair(new HairPanel(state)), m_tabs(new QTabWidget(this))
{
    setObjectName(QStringLiteral("sidebar"));
    setAttribute(Qt::WA_StyledBackground);
    setMinimumWidth(metrics::kSidebar);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_maps);
    auto* line = new QFrame(this);
    line->setObjectName(QStringLiteral("separator"));
    line->setFixedHeight(1);
    layout->addWidget(line);
    m_tabs->addTab(m_layers, tr("Layers"));
    m_tabs->addTab(m_hair, tr("Hair"));
    m_tabs->setDocumentMode(true);
    m_tabs->tabBar()->setDrawBase(false);
    layout->addWidget(m_tabs, 1);
}

void Sidebar::askWhatGrows()
{
    showHair();
    m_hair->askWhatGrows();
}

void Sidebar::showLayers()
{
    m_tabs->setCurrentWidget(m_layers);
}

void Sidebar::showHair()
{
    m_tabs->setCurrentWidget(m_hair);
}

} // namespace hairpaint::view
