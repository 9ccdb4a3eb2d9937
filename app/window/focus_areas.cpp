// The order of the keyboard's focus through the window: see the header.
#include "app/window/focus_areas.h"

#include "view/widgets/bar_slider.h"

#include <QAbstractButton>
#include <QApplication>
#include <QButtonGroup>
#include <QWidget>

#include <algorithm>
#include <utility>

namespace hairpaint::app {

namespace {

bool isWithin(const QWidget& area, const QWidget* widget)
{
    return widget != nullptr && (widget == &area || area.isAncestorOf(widget));
}

bool takesFocus(const QWidget& area, const QWidget* widget)
{
    return isWithin(area, widget) && widget->isVisible() && widget->isEnabled() && widget->focusProxy() == nullptr &&
           (widget->focusPolicy() & Qt::TabFocus) == Qt::TabFocus;
}

/// The widget of the area that Tab comes to after `from`, which may be `from` itself; null where none takes the focus.
QWidget* neighbour(const QWidget& area, QWidget* from, bool forward)
{
    QWidget* next = from;
    do
        next = forward ? next->nextInFocusChain() : next->previousInFocusChain();
    while (next != from && !takesFocus(area, next));
    return takesFocus(area, next) ? next : nullptr;
}

/// The one that is chosen among buttons that exclude each other; null where there are none.
QWidget* chosenIn(const QWidget& area)
{
    const QList<QAbstractButton*> buttons = area.findChildren<QAbstractButton*>();
    const auto found = std::ranges::find_if(buttons, [&area](const QAbstractButton* button) {
        const bool excludes = button->autoExclusive() || (button->group() != nullptr && button->group()->exclusive());
        return excludes && button->isChecked() && takesFocus(area, button);
    });
    return found == buttons.end() ? nullptr : *found;
}

} // namespace

FocusAreas::FocusAreas(std::vector<Area> areas, QObject* parent) : QObject(parent), m_areas(std::move(areas))
{
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget* /*before*/, QWidget* now) {
        if (const std::ptrdiff_t index = indexOf(now); index >= 0)
            m_areas[static_cast<std::size_t>(index)].lastFocused = now;
    });
}

std::ptrdiff_t FocusAreas::indexOf(const QWidget* widget) const
{
    const auto found =
        std::ranges::find_if(m_areas, [widget](const Area& area) { return isWithin(*area.widget, widget); });
    return found == m_areas.end() ? -1 : found - m_areas.begin();
}

bool FocusAreas::enter(Area& area, bool forward)
{
    if (!(area.container != nullptr ? area.container : area.widget)->isVisible())
        return false;
    if (area.uncover)
        area.uncover();
    // Where buttons come first, the chosen one; an area that begins with a slider is entered there.
    QWidget* first = takesFocus(*area.widget, area.widget) ? area.widget : neighbour(*area.widget, area.widget, true);
    QWidget* wanted = qobject_cast<view::BarSlider*>(first) == nullptr ? chosenIn(*area.widget) : nullptr;
    if (wanted == nullptr)
        wanted = area.lastFocused;
    if (!takesFocus(*area.widget, wanted))
        wanted = first;
    if (wanted == nullptr)
        return false;
    wanted->setFocus(forward ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    return true;
}

void FocusAreas::step(bool forward)
{
    const auto count = static_cast<std::ptrdiff_t>(m_areas.size());
    const std::ptrdiff_t now = indexOf(QApplication::focusWidget());
    const std::ptrdiff_t start = now >= 0 ? now : (forward ? -1 : count);
    for (std::ptrdiff_t i = 1; i <= count; ++i) {
        const std::ptrdiff_t index = (start + (forward ? i : -i) + 2 * count) % count;
        if (index != now && enter(m_areas[static_cast<std::size_t>(index)], forward))
            return;
    }
}

bool FocusAreas::stepWithin(bool forward)
{
    QWidget* now = QApplication::focusWidget();
    const std::ptrdiff_t index = indexOf(now);
    if (index < 0)
        return false;
    QWidget* next = neighbour(*m_areas[static_cast<std::size_t>(index)].widget, now, forward);
    if (next == nullptr || next == now)
        step(forward);
    else
        next->setFocus(forward ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    return true;
}

} // namespace hairpaint::app
