// Paints the frame and the sentence in a pill of the panel's colour.
#include "view/widgets/drop_hint.h"

#include "view/theme.h"

#include <QPainter>

namespace hairpaint::view {

DropHint::DropHint(QWidget* parent) : QWidget(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    hide();
}

void DropHint::showText(const QString& text)
{
    m_text = text;
    setAccessibleName(text);
    setGeometry(parentWidget()->rect());
    show();
    raise();
    update();
}

void DropHint::paintEvent(QPaintEvent* /*event*/)
{
    const Theme theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor veil = theme.window;
    veil.setAlphaF(0.5F);
    painter.fillRect(rect(), veil);
    painter.setPen(QPen(theme.accent, 2.0));
    const QRectF frame = QRectF(rect()).adjusted(9.0, 9.0, -9.0, -9.0);
    painter.drawRoundedRect(frame, metrics::kRadius, metrics::kRadius);
    painter.setFont(themeFont(TextRole::Title));
    QRectF words =
        painter.boundingRect(frame.adjusted(32.0, 32.0, -32.0, -32.0), Qt::AlignCenter | Qt::TextWordWrap, m_text);
    painter.setPen(QPen(theme.line, 1.0));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(words.adjusted(-20.0, -14.0, 20.0, 14.0), metrics::kRadius, metrics::kRadius);
    painter.setPen(theme.text);
    painter.drawText(words.adjusted(-1.0, 0.0, 1.0, 0.0), Qt::AlignCenter | Qt::TextWordWrap, m_text);
}

} // namespace hairpaint::view
