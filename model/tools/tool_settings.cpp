// What maps are painted with at first, and values as texels.
#include "model/tools/tool_settings.h"

#include "model/compositor.h"

namespace hairpaint::model {

sim::Texel PaintValue::texel(const MapSpec& spec) const
{
    if (spec.texel == TexelKind::Scalar)
        return {unit16(scalar), 0, 0, 0};
    if (spec.texel == TexelKind::Index)
        return {static_cast<std::uint16_t>(index), 0, 0, 0};
    const QRgba64 exact = colour.rgba64();
    return {exact.red(), exact.green(), exact.blue(), 0};
}

std::array<PaintValue, kMapKindCount> firstPaintValues()
{
    std::array<PaintValue, kMapKindCount> values{};
    const auto at = [&values](MapKind map) -> PaintValue& { return values[static_cast<std::size_t>(map)]; };
    at(MapKind::Density).scalar = 0.8F;
    at(MapKind::Length).scalar = 0.5F; // 15 of 30 cm.
    at(MapKind::Curl).scalar = 0.6F;
    at(MapKind::Braid).index = 1;
    at(MapKind::Colour).colour = QColor(0x8A, 0x4B, 0x2A); // Chestnut.
    at(MapKind::Clump).scalar = 0.6F;
    at(MapKind::Gel).scalar = 1.0F;
    return values;
}

std::array<PaintValue, kMapKindCount> secondPaintValues()
{
    std::array<PaintValue, kMapKindCount> values{};
    for (PaintValue& value : values) {
        value.scalar = 0.0F;
        value.index = 0;
        value.colour = QColor(0x1A, 0x14, 0x12);
    }
    return values;
}

} // namespace hairpaint::model
