// Values in the group's units.
#include "view/widgets/value_text.h"

#include "model/map_colours.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

constexpr double kFull = 65535.0;

} // namespace

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
    if (spec.texel == model::TexelKind::Colour)
        return value.colour.name();
    if (spec.texel == model::TexelKind::Index) {
        const auto index = static_cast<std::size_t>(std::max(value.index, 0));
        return index < spec.palette.size() ? paletteTitle(spec.palette[index]) : QString::number(value.index);
    }
    const ValueUnit unit = valueUnit(settings, spec.kind);
    const double shown = shownValue(settings, spec.kind, static_cast<double>(value.scalar));
    QString number = QLocale().toString(shown, 'f', unit.decimals);
    const QString zeros = QLocale().decimalPoint() + QLocale().zeroDigit();
    if (unit.decimals == 1 && number.endsWith(zeros))
        number.chop(zeros.size());
    return number + QChar(0x2009) + unit.unit;
}

QString rangeText(const sim::GroupSettings& settings, const model::MapSpec& spec)
{
    if (spec.texel != model::TexelKind::Scalar)
        return {};
    const ValueUnit unit = valueUnit(settings, spec.kind);
    const auto number = [](double value) { return QLocale().toString(value, 'g', 4); };
    return number(unit.minimum) + QChar(0x2013) + number(unit.maximum) + QChar(0x2009) + unit.unit;
}

QColor valueColour(const model::MapSpec& spec, const model::PaintValue& value, bool nightPaper)
{
    if (spec.texel == model::TexelKind::Colour)
        return value.colour;
    if (spec.texel == model::TexelKind::Scalar)
        return QColor::fromRgb(model::shownColour(
            spec, static_cast<std::uint16_t>(std::lround(std::clamp(value.scalar, 0.0F, 1.0F) * 65535.0F)),
            nightPaper));
    const auto index = static_cast<std::size_t>(std::max(value.index, 0));
    if (index >= spec.palette.size() || (index == 0 && nightPaper))
        return Qt::black;
    return QColor::fromRgb(spec.palette[index].colour);
}

model::PaintValue valueOfTexel(const model::MapSpec& spec, const sim::Texel& texel)
{
    model::PaintValue value;
    value.scalar = static_cast<float>(texel[0] / kFull);
    value.index = texel[0];
    if (spec.texel == model::TexelKind::Colour)
        value.colour = QColor::fromRgba64(texel[0], texel[1], texel[2]);
    return value;
}

QList<QColor> scaleGradient(const model::MapSpec& spec, bool nightPaper, int steps)
{
    QList<QColor> colours;
    if (spec.texel != model::TexelKind::Scalar)
        return colours;
    for (int i = 0; i < steps; ++i)
        colours.append(
            QColor::fromRgb(model::shownColour(spec, static_cast<std::uint16_t>(i * 65535 / (steps - 1)), nightPaper)));
    return colours;
}

QString paletteTitle(const model::PaletteEntry& entry)
{
    return QCoreApplication::translate("MapSpec", entry.title);
}

} // namespace hairpaint::view
