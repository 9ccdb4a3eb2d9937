// A sentence with two buttons: see the header.
#include "view/panels/style_notice.h"

#include "view/look/icons.h"
#include "view/look/theme.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>

namespace hairpaint::view {

StyleNotice::StyleNotice(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("styleNotice"));
    setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(metrics::kPadding, metrics::kGrid, metrics::kGrid, metrics::kGrid);
    row->setSpacing(metrics::kGap);
    m_sentence = new QLabel(this);
    auto* undo = new QPushButton(tr("Undo"), this);
    auto* close = new QToolButton(this);
    close->setIcon(icon(QStringLiteral("close")));
    close->setToolTip(tr("Close"));
    close->setAccessibleName(tr("Close"));
    close->setFocusPolicy(Qt::TabFocus);
    row->addWidget(m_sentence, 1);
    row->addWidget(undo);
    row->addWidget(close);
    connect(undo, &QPushButton::clicked, this, &StyleNotice::undoChosen);
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    hide();
}

void StyleNotice::tell(const QString& sentence)
{
    m_sentence->setText(sentence);
    setAccessibleName(sentence);
    setVisible(!sentence.isEmpty());
    if (sentence.isEmpty())
        return;
    settle();
    raise();
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void StyleNotice::settle()
{
    const QSize size(std::min(sizeHint().width(), parentWidget()->width()), sizeHint().height());
    const QSize around = parentWidget()->size();
    setGeometry(
        QRect(QPoint((around.width() - size.width()) / 2, around.height() - size.height() - metrics::kGrid), size));
}

} // namespace hairpaint::view
