// Choosing a position, and remembering one.
#include "app/settings/dialog_positions.h"

#include <QApplication>
#include <QDialog>
#include <QEvent>
#include <QFileDialog>
#include <QMessageBox>
#include <QScreen>

#include <algorithm>
#include <array>
#include <limits>

namespace hairpaint::app {

namespace {

constexpr int kGapPx = 12;
/// Assumed size of a window's frame before there is one, px.
constexpr QSize kFramePx(8, 36);
/// A window manager may put a window that far from where it was told to; the user moves it further.
constexpr int kSlackPx = 16;
constexpr QPoint kInTitle(40, 16); ///< A point from a dialog's corner; the screen that it is on counts as the dialog's.

qint64 areaOf(const QRect& rect)
{
    return rect.isEmpty() ? 0 : qint64{rect.width()} * rect.height();
}

} // namespace

QPoint insideScreen(QPoint wanted, QSize size, const QRect& screen)
{
    // Right and bottom first: the title, on top, is what a dialog is moved by.
    return {std::max(screen.left(), std::min(wanted.x(), screen.right() + 1 - size.width())),
            std::max(screen.top(), std::min(wanted.y(), screen.bottom() + 1 - size.height()))};
}

QPoint positionBesideHead(QSize size, const DialogRoom& room)
{
    const QRect& head = room.head;
    const int top = (head.isEmpty() ? room.window : head).top() + kGapPx;
    const int atRight = room.window.right() + 1 - kGapPx - size.width();
    // Over the paint area, on either side of the head; then at the window's edges, then as far as the screen goes.
    const std::array<int, 6> lefts = {head.left() - kGapPx - size.width(),
                                      head.right() + 1 + kGapPx,
                                      room.window.left() + kGapPx,
                                      atRight,
                                      room.screen.left(),
                                      room.screen.right() + 1 - size.width()};
    QPoint best;
    qint64 leastHidden = std::numeric_limits<qint64>::max();
    // Where there is no room beside it, the strip of styles below it gives some.
    for (const int y : {top, room.window.bottom() + 1 - kGapPx - size.height()})
        for (const int left : lefts) {
            const QPoint at = insideScreen({head.isEmpty() ? atRight : left, y}, size, room.screen);
            // What leaves the window is away from the work, which is less bad than to lie over the head.
            const QRect covered(at, size);
            const qint64 hidden = 4 * areaOf(covered & head) + areaOf(covered) - areaOf(covered & room.window);
            if (hidden < leastHidden) {
                leastHidden = hidden;
                best = at;
            }
        }
    return best;
}

DialogPositions::DialogPositions(QWidget& window, Settings& settings, std::function<QRect()> head)
    : QObject(&window), m_window(window), m_settings(settings), m_head(std::move(head))
{
    qApp->installEventFilter(this);
}

bool DialogPositions::isOurs(const QDialog& dialog) const
{
    return dialog.isWindow() && dialog.parentWidget() == &m_window &&
           qobject_cast<const QMessageBox*>(&dialog) == nullptr &&
           qobject_cast<const QFileDialog*>(&dialog) == nullptr &&
           dialog.objectName() != QLatin1String("progressWindow");
}

bool DialogPositions::eventFilter(QObject* watched, QEvent* event)
{
    const QEvent::Type type = event->type();
    const bool isShown = type == QEvent::Show || type == QEvent::Hide;
    if ((isShown && !event->spontaneous()) || type == QEvent::Resize)
        if (auto* dialog = qobject_cast<QDialog*>(watched); dialog != nullptr && isOurs(*dialog)) {
            if (type == QEvent::Show)
                position(*dialog);
            else if (type == QEvent::Hide)
                remember(*dialog);
            else
                keepInside(*dialog);
        }
    return QObject::eventFilter(watched, event);
}

void DialogPositions::position(QDialog& dialog)
{
    const std::optional<QPoint> left = m_settings.dialogPosition(QString::fromLatin1(dialog.metaObject()->className()));
    const QScreen* screen = left ? QGuiApplication::screenAt(*left + kInTitle) : nullptr;
    const QRect free = (screen != nullptr ? screen : m_window.screen())->availableGeometry();
    dialog.resize(dialog.size().boundedTo(free.size() - kFramePx)); // Those that can be smaller are.
    const QSize size = dialog.size() + kFramePx;
    const QPoint at =
        left ? insideScreen(*left, size, free)
             : positionBesideHead(size, {.window = m_window.frameGeometry(), .head = m_head(), .screen = free});
    dialog.move(at);
    m_positions[&dialog] = at;
}

void DialogPositions::keepInside(QDialog& dialog)
{
    const auto known = m_positions.find(&dialog);
    if (known == m_positions.end())
        return;
    const QPoint at = insideScreen(dialog.pos(), dialog.size() + kFramePx, dialog.screen()->availableGeometry());
    if (at == dialog.pos())
        return;
    if (!isMoved(dialog, known->second))
        known->second = at;
    dialog.move(at);
}

bool DialogPositions::isMoved(const QDialog& dialog, QPoint from)
{
    return (dialog.pos() - from).manhattanLength() > kSlackPx;
}

void DialogPositions::remember(QDialog& dialog)
{
    const auto known = m_positions.find(&dialog);
    if (known == m_positions.end())
        return;
    if (isMoved(dialog, known->second))
        m_settings.setDialogPosition(QString::fromLatin1(dialog.metaObject()->className()), dialog.pos());
    m_positions.erase(known);
}

} // namespace hairpaint::app
