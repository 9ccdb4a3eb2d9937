// What maps are painted with at first.
#include "model/tools/tool_settings.h"

namespace hairpaint::model {

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
