// Values in the group's units.
#include "view/look/value_text.h"

#include "model/maps/map_colours.h"
#include "model/maps/texel_ops.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

ValueUnit valueUnit(const sim::GroupSettings& settings, model::MapKind map)
{
    const model::MapScale* scale = model::mapSpec(map).scale;
    if (scale == nullptr)
        return {};
    return {.unit = scale->unit(settings),
            .minimum = scale->shown(settings, 0.0),
            .maximum = scale->shown(settings, 1.0),
            .decimals = scale->decimals(settings)};
}

double shownValue(const sim::GroupSettings& settings, model::MapKind map, double value)
{
    const model::MapScale* scale = model::mapSpec(map).scale;
    return scale == nullptr ? value : scale->shown(settings, value);
}

double mapValue(const sim::GroupSettings& settings, model::MapKind map, double shown)
{
    const model::MapScale* scale = model::mapSpec(map).scale;
    return std::clamp(scale == nullptr ? shown : scale->value(settings, shown), 0.0, 1.0);
}

QString valueText(const sim::GroupSettings& settings, const model::MapSpec& spec, const model::PaintValue& value)
{
    return model::texelOps(spec).text(settings, spec, value);
}

QString rangeText(const sim::GroupSettings& settings, const model::MapSpec& spec)
{
    if (spec.scale == nullptr)
        return {};
    const ValueUnit unit = valueUnit(settings, spec.kind);
    const auto number = [](double value) { return QLocale().toString(value, 'g', 4); };
    return number(unit.minimum) + QChar(0x2013) + number(unit.maximum) + QChar(0x2009) + unit.unit;
}

QColor valueColour(const model::MapSpec& spec, const model::PaintValue& value, bool nightPaper)
{
    return QColor::fromRgb(model::shownTexel(spec, model::texelOf(spec, value), nightPaper));
}

model::PaintValue valueOfTexel(const model::MapSpec& spec, const sim::Texel& texel)
{
    return model::texelOps(spec).paintValue(texel);
}

QList<QColor> scaleGradient(const model::MapSpec& spec, bool nightPaper, int steps)
{
    QList<QColor> colours;
    if (spec.scale == nullptr)
        return colours;
    for (int i = 0; i < steps; ++i)
        colours.append(
            QColor::fromRgb(model::shownColour(spec, static_cast<std::uint16_t>(i * 65535 / (steps - 1)), nightPaper)));
    return colours;
}

} // namespace hairpaint::view
