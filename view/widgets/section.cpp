// A titled part of a panel that folds.
#include "view/widgets/section.h"

#include "view/look/icons.h"
#include "view/look/theme.h"

#include <QToolButton>
#include <QVBoxLayout>

namespace hairpaint::view {

Section::Section(const QString& title, QWidget* parent)
    : QWidget(parent), m_title(new QToolButton(this)), m_body(new QWidget(this)), m_layout(new QVBoxLayout(m_body))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::kGrid);
    m_title->setText(title);
    m_title->setObjectName(QStringLiteral("sectionTitle"));
    m_title->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_title->setIconSize(QSize(16, 16));
    m_title->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_title->setFixedHeight(metrics::kRow);
    m_title->setFocusPolicy(Qt::TabFocus);
    m_layout->setContentsMargins(0, 0, 0, metrics::kGap);
    m_layout->setSpacing(metrics::kGrid);
    layout->addWidget(m_title);
    layout->addWidget(m_body);
    connect(m_title, &QToolButton::clicked, this, [this] { setOpen(!m_open); });
    setOpen(true);
}

void Section::setOpen(bool open)
{
    m_open = open;
    m_title->setIcon(icon(open ? QStringLiteral("chevron-down") : QStringLiteral("chevron-right")));
    m_title->setAccessibleDescription(open ? tr("Open") : tr("Folded"));
    m_body->setVisible(open);
}

} // namespace hairpaint::view
