// Values in the group's units.
#include "view/widgets/value_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::view {

namespace {

constexpr double kFull = 65535.0;
constexpr double kPerSquareCm = 1e-4;
constexpr double kShortGroupM = 0.03; ///< Groups with shorter hair are measured in mm.

/// Turns at the red values 0, .2, .4, .6, .8 and 1: the paper's table 1.
constexpr std::array kTurns{0.0, 0.5, 1.0, 4.0, 8.0, 16.0};

double turns(double red)
{
    const double place = std::clamp(red, 0.0, 1.0) * 5.0;
    const auto level = std::min<std::size_t>(static_cast<std::size_t>(place), kTurns.size() - 2);
    return std::lerp(kTurns[level], kTurns[level + 1], place - static_cast<double>(level));
}

double redOf(double wanted)
{
    for (std::size_t level = 0; level + 1 < kTurns.size(); ++level)
        if (wanted <= kTurns[level + 1])
            return (static_cast<double>(level) +
                    std::max(0.0, wanted - kTurns[level]) / (kTurns[level + 1] - kTurns[level])) /
                   5.0;
    return 1.0;
}

double lengthScale(const sim::GroupSettings& settings)
{
    return static_cast<double>(settings.greatestLengthM) < kShortGroupM ? 1000.0 : 100.0;
}

QString text(const char* source)
{
    return QCoreApplication::translate("ValueText", source);
}

} // namespace

ValueUnit valueUnit(const sim::GroupSettings& settings, model::MapKind map)
{
    ValueUnit unit;
    unit.minimum = shownValue(settings, map, 0.0);
    unit.maximum = shownValue(settings, map, 1.0);
    switch (map) {
    case model::MapKind::Density:
        unit.unit = text(QT_TRANSLATE_NOOP("ValueText", "hairs/cm²"));
        unit.decimals = unit.maximum < 20.0 ? 1 : 0;
        break;
    case model::MapKind::Length:
        unit.unit = lengthScale(settings) > 100.0 ? text(QT_TRANSLATE_NOOP("ValueText", "mm"))
                                                  : text(QT_TRANSLATE_NOOP("ValueText", "cm"));
        unit.decimals = 1;
        break;
    case model::MapKind::Curl:
        unit.unit = settings.turnsMode == sim::TurnsMode::PerHair
                        ? text(QT_TRANSLATE_NOOP("ValueText", "turns"))
                        : text(QT_TRANSLATE_NOOP("ValueText", "turns per %1 cm"))
                              .arg(QLocale().toString(static_cast<double>(settings.turnsPerLengthM) * 100.0, 'g', 3));
        unit.decimals = 1;
        break;
    case model::MapKind::Clump:
    case model::MapKind::Gel:
        unit.unit = QStringLiteral("%");
        break;
    case model::MapKind::Braid:
    case model::MapKind::Colour:
        break;
    }
    return unit;
}

double shownValue(const sim::GroupSettings& settings, model::MapKind map, double value)
{
    switch (map) {
    case model::MapKind::Density:
        return value * static_cast<double>(settings.greatestDensityPerM2) * kPerSquareCm;
    case model::MapKind::Length:
        return std::lerp(static_cast<double>(settings.shortestLengthM), static_cast<double>(settings.greatestLengthM),
                         value) *
               lengthScale(settings);
    case model::MapKind::Curl:
        return turns(value);
    default:
        return value * 100.0;
    }
}

double mapValue(const sim::GroupSettings& settings, model::MapKind map, double shown)
{
    double value = 0.0;
    switch (map) {
    case model::MapKind::Density:
        value = shown / (static_cast<double>(settings.greatestDensityPerM2) * kPerSquareCm);
        break;
    case model::MapKind::Length: {
        const double range =
            static_cast<double>(settings.greatestLengthM) - static_cast<double>(settings.shortestLengthM);
        if (range > 0.0)
            value = (shown / lengthScale(settings) - static_cast<double>(settings.shortestLengthM)) / range;
        break;
    }
    case model::MapKind::Curl:
        value = redOf(shown);
        break;
    default:
        value = shown / 100.0;
        break;
    }
    return std::clamp(value, 0.0, 1.0);
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
        return QColor::fromRgb(model::scaleToColour(spec, value.scalar, nightPaper));
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
        colours.append(QColor::fromRgb(
            model::scaleToColour(spec, static_cast<float>(i) / static_cast<float>(steps - 1), nightPaper)));
    return colours;
}

QString paletteTitle(const model::PaletteEntry& entry)
{
    return QCoreApplication::translate("MapSpec", entry.title);
}

} // namespace hairpaint::view
