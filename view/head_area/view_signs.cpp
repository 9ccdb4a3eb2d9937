// The picture of the signs.
#include "view/head_area/view_signs.h"

#include "view/look/icons.h"
#include "view/look/theme.h"

#include <QPainter>

namespace hairpaint::view {

namespace {

constexpr int kHeight = 24;
constexpr int kIcon = 14;

} // namespace

ViewSigns::ViewSigns(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("viewSigns"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFont(themeFont(TextRole::Status));
    hide();
}

void ViewSigns::show(bool paused, bool refining, std::size_t triangles)
{
    QStringList words;
    if (paused)
        words.append(tr("Paused"));
    if (refining)
        words.append(tr("Refining…"));
    if (triangles > 0)
        words.append(tr("Cards: %L1 triangles").arg(triangles));
    m_paused = paused;
    m_text = words.join(QStringLiteral("  ·  "));
    setAccessibleName(m_text);
    resize(fontMetrics().horizontalAdvance(m_text) + 2 * metrics::kGap + (paused ? kIcon + metrics::kGrid : 0),
           kHeight);
    setVisible(!m_text.isEmpty());
    update();
}

void ViewSigns::paintEvent(QPaintEvent* /*event*/)
{
    const Theme theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor ground = theme.panel;
    ground.setAlphaF(0.85F);
    painter.setPen(theme.line);
    painter.setBrush(ground);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kHeight / 2.0, kHeight / 2.0);
    QRect words = rect().adjusted(metrics::kGap, 0, -metrics::kGap, 0);
    if (m_paused) {
        painter.drawPixmap(QPointF(words.left(), (kHeight - kIcon) / 2.0),
                           iconPixmap(QStringLiteral("pause"), kIcon, theme.accent, devicePixelRatioF()));
        words.setLeft(words.left() + kIcon + metrics::kGrid);
    }
    painter.setPen(m_paused ? theme.text : theme.dimText);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, m_text);
}

} // namespace hairpaint::view
