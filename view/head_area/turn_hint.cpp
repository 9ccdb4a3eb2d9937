// A sentence in a pill.
#include "view/head_area/turn_hint.h"

#include "view/look/theme.h"

#include <QEvent>

#include <algorithm>

namespace hairpaint::view {

TurnHint::TurnHint(QWidget& area) : QLabel(tr("Drag beside the head to turn it; the wheel zooms"), &area)
{
    setObjectName(QStringLiteral("turnHint"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAlignment(Qt::AlignCenter);
    area.installEventFilter(this);
    reposition();
}

bool TurnHint::eventFilter(QObject* watched, QEvent* event)
{
    // What draws the area may come later, and another time.
    if (event->type() == QEvent::Resize || event->type() == QEvent::Show || event->type() == QEvent::ChildPolished)
        reposition();
    return QLabel::eventFilter(watched, event);
}

void TurnHint::reposition()
{
    ensurePolished();
    const QSize area = parentWidget()->size();
    setWordWrap(false);
    const QSize whole = sizeHint();
    const int width = std::min(whole.width(), area.width() - 2 * metrics::kPadding);
    setWordWrap(width < whole.width());
    resize(width, wordWrap() ? heightForWidth(width) : whole.height());
    move((area.width() - width) / 2, area.height() - height() - metrics::kPadding);
    raise();
}

} // namespace hairpaint::view
