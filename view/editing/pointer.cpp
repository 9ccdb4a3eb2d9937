// Mouse and pen made alike.
#include "view/editing/pointer.h"

#include <QMouseEvent>
#include <QTabletEvent>

#include <algorithm>

namespace hairpaint::view {

PointerSample PointerSample::of(const QMouseEvent& event)
{
    return {.position = event.position(),
            .button = event.button(),
            .buttons = event.buttons(),
            .modifiers = event.modifiers(),
            .pressure = 1.0F,
            .seconds = static_cast<double>(event.timestamp()) / 1000.0,
            .again = event.type() == QEvent::MouseButtonDblClick};
}

PointerSample PointerSample::of(const QTabletEvent& event)
{
    return {.position = event.position(),
            .button = event.button(),
            .buttons = event.buttons(),
            .modifiers = event.modifiers(),
            .pressure = std::clamp(static_cast<float>(event.pressure()), 0.0F, 1.0F),
            .seconds = static_cast<double>(event.timestamp()) / 1000.0};
}

} // namespace hairpaint::view
