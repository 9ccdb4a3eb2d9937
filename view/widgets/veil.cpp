// The window's colour, and the words in a pill of the panel's.
#include "view/widgets/veil.h"

#include "view/look/theme.h"

#include <QAccessible>
#include <QEvent>
#include <QPainter>

namespace hairpaint::view {

namespace {

constexpr int kWords = Qt::AlignCenter | Qt::TextWordWrap | Qt::TextWrapAnywhere; ///< File names have few gaps.
constexpr double kMostOfWidth = 0.8;
constexpr QMarginsF kAroundWords(20.0, 12.0, 20.0, 12.0);

} // namespace

Veil::Veil(QWidget* parent, float density) : QWidget(parent), m_density(density)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    parent->installEventFilter(this);
    hide();
}

void Veil::showText(const QString& text)
{
    m_text = text;
    setAccessibleName(text);
    setVisible(!text.isEmpty());
    if (text.isEmpty())
        return;
    setGeometry(parentWidget()->rect());
    raise();
    update();
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

bool Veil::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize)
        setGeometry(parentWidget()->rect());
    return QWidget::eventFilter(watched, event);
}

void Veil::paintEvent(QPaintEvent* /*event*/)
{
    const Theme theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor veil = theme.window;
    veil.setAlphaF(m_density);
    painter.fillRect(rect(), veil);
    painter.setFont(themeFont(TextRole::Title));
    QRectF most(0.0, 0.0, width() * kMostOfWidth, height());
    most.moveCenter(QRectF(rect()).center());
    const QRectF words = painter.boundingRect(most, kWords, m_text);
    painter.setPen(QPen(theme.line, 1.0));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(words.marginsAdded(kAroundWords), metrics::kRadius, metrics::kRadius);
    painter.setPen(theme.text);
    painter.drawText(words.adjusted(-1.0, 0.0, 1.0, 0.0), kWords, m_text);
}

} // namespace hairpaint::view
