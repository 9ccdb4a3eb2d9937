// A sentence in a pill.
#include "view/head/turn_hint.h"

#include "view/theme.h"

#include <QEvent>

#include <algorithm>

namespace hairpaint::view {

TurnHint::TurnHint(QWidget& area) : QLabel(tr("Drag beside the head to turn it; the wheel zooms"), &area)
{
    setObjectName(QStringLiteral("turnHint"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAlignment(Qt::AlignCenter);
    setWordWrap(true);
    area.installEventFilter(this);
    place();
}

bool TurnHint::eventFilter(QObject* watched, QEvent* event)
{
    // What draws the area may come later, and another time.
    if (event->type() == QEvent::Resize || event->type() == QEvent::Show || event->type() == QEvent::ChildPolished)
        place();
    return QLabel::eventFilter(watched, event);
}

void TurnHint::place()
{
    ensurePolished();
    const QSize area = parentWidget()->size();
    constexpr int kSides = 26; // The pill's own, as its style says.
    const int width = std::min(fontMetrics().horizontalAdvance(text()) + kSides, area.width() - 2 * metrics::kPadding);
    resize(width, heightForWidth(width));
    move((area.width() - width) / 2, area.height() - height() - metrics::kPadding);
    raise();
}

} // namespace hairpaint::view
