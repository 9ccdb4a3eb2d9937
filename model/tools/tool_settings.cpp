// What tools and maps begin with.
#include "model/tools/tool_settings.h"

#include "model/tools/tool_list.h"

namespace hairpaint::model {

ToolSettings::ToolSettings()
{
    for (const ToolOption* row : toolOptions())
        putOption(*this, *row, standardOf(*row));
}

std::array<PaintValue, kMapKindCount> firstPaintValues()
{
    std::array<PaintValue, kMapKindCount> values{};
    for (const MapSpec& spec : mapSpecs())
        values[sim::indexOf(spec.kind)] = spec.firstPaint;
    return values;
}

std::array<PaintValue, kMapKindCount> secondPaintValues()
{
    std::array<PaintValue, kMapKindCount> values{};
    for (PaintValue& value : values) {
        value.scalar = 0.0F;
        value.index = 0;
        value.colour = QColor(0xC8, 0x9B, 0x5A); // Blond.
        value.direction = glm::vec2(0.0F);
    }
    return values;
}

} // namespace hairpaint::model
