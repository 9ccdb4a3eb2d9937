// Mouse and pen made alike.
#include "view/pointer.h"

#include <QCoreApplication>
#include <QLocale>
#include <QMouseEvent>
#include <QTabletEvent>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

PointerSample PointerSample::of(const QMouseEvent& event)
{
    return {.position = event.position(),
            .button = event.button(),
            .buttons = event.buttons(),
            .modifiers = event.modifiers(),
            .pressure = 1.0F,
            .seconds = static_cast<double>(event.timestamp()) / 1000.0};
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

model::ToolSettings draggedBrush(const model::ToolSettings& start, QPointF pixels)
{
    model::ToolSettings settings = start;
    settings.brushSizeM =
        std::clamp(start.brushSizeM * std::exp(static_cast<float>(pixels.x()) * 0.008F), 0.001F, 0.3F);
    settings.hardness = std::clamp(start.hardness - static_cast<float>(pixels.y()) * 0.004F, 0.0F, 1.0F);
    return settings;
}

model::ToolSettings draggedOpacity(const model::ToolSettings& start, QPointF pixels)
{
    model::ToolSettings settings = start;
    settings.opacity = std::clamp(start.opacity + static_cast<float>(pixels.x()) * 0.004F, 0.0F, 1.0F);
    return settings;
}

QString brushText(const model::ToolSettings& settings)
{
    const auto number = [](float value, int decimals) {
        return QLocale().toString(static_cast<double>(value), 'f', decimals);
    };
    return QCoreApplication::translate("Pointer", "Size %1 cm, hardness %2 %, opacity %3 %")
        .arg(number(settings.brushSizeM * 100.0F, 1), number(settings.hardness * 100.0F, 0),
             number(settings.opacity * 100.0F, 0));
}

} // namespace hairpaint::view
