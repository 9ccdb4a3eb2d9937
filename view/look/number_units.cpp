// The table of units.
#include "view/look/number_units.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <numbers>
#include <utility>

namespace hairpaint::view {

namespace {

using enum NumberUnit::Dimension;

constexpr NumberUnit kNumberUnits[] = {
    {Length, "um", 1e-6},
    {Length, QT_TRANSLATE_NOOP("NumberText", "mm|millimetre|millimetres|millimeter|millimeters"), 1e-3},
    {Length, QT_TRANSLATE_NOOP("NumberText", "cm|centimetre|centimetres|centimeter|centimeters"), 1e-2},
    {Length, QT_TRANSLATE_NOOP("NumberText", "m|metre|metres|meter|meters"), 1.0},
    {Length, QT_TRANSLATE_NOOP("NumberText", "in|inch|inches|\"|''"), 0.0254},
    {Length, QT_TRANSLATE_NOOP("NumberText", "ft|foot|feet|'"), 0.3048},
    {Angle, QT_TRANSLATE_NOOP("NumberText", "°|deg|degree|degrees"), std::numbers::pi / 180.0},
    {Angle, QT_TRANSLATE_NOOP("NumberText", "rad|radian|radians"), 1.0},
    {Speed, "m/s", 1.0},
    {Speed, "km/h|kph", 1.0 / 3.6},
    {Speed, "mph", 0.44704},
    {PerArea, QT_TRANSLATE_NOOP("NumberText", "hairs/cm²|/cm²"), 1e4},
    {PerArea, QT_TRANSLATE_NOOP("NumberText", "hairs/mm²|/mm²"), 1e6},
    {PerArea, QT_TRANSLATE_NOOP("NumberText", "hairs/in²|/in²"), 1.0 / (0.0254 * 0.0254)},
};

QStringList unitNames(const NumberUnit& row)
{
    QStringList names = QString::fromUtf8(row.names).split(QLatin1Char('|'));
    const QString translated = QCoreApplication::translate("NumberText", row.names);
    if (translated != QString::fromUtf8(row.names))
        names = translated.split(QLatin1Char('|')) + names;
    return names;
}

} // namespace

QString plainNumberText(QString text)
{
    constexpr std::pair<char16_t, const char*> kFractions[] = {{u'½', " 1/2"}, {u'¼', " 1/4"}, {u'¾', " 3/4"}};
    for (const auto& [sign, spelt] : kFractions)
        text.replace(QChar(sign), QLatin1StringView(spelt));
    text = text.normalized(QString::NormalizationForm_KC).toLower();
    QString result;
    for (const QChar one : std::as_const(text)) {
        switch (one.unicode()) {
        case u'\u2212': // Minus, and the dashes that stand for it.
        case u'\u2013':
        case u'\u2014':
            result += QLatin1Char('-');
            break;
        case u'×':
        case u'·':
            result += QLatin1Char('*');
            break;
        case u'÷':
        case u'\u2044': // Fraction slash.
            result += QLatin1Char('/');
            break;
        case u'μ':
            result += QLatin1Char('u');
            break;
        case u'\u2018':
        case u'\u2019':
        case u'\u2032': // Prime.
            result += QLatin1Char('\'');
            break;
        case u'\u201c':
        case u'\u201d':
            result += QLatin1Char('"');
            break;
        case u'\u066b': // Arabic decimal sign; its sign of thousands is left out.
            result += QLatin1Char(',');
            break;
        case u'\u066c':
            break;
        default:
            if (one.isSpace())
                result += QLatin1Char(' ');
            else if (one.digitValue() >= 0)
                result += QLatin1Char(static_cast<char>('0' + one.digitValue()));
            else
                result += one;
        }
    }
    return result.simplified();
}

const NumberUnit* findNumberUnit(const QString& plainName)
{
    const auto* const found = std::ranges::find_if(kNumberUnits, [&](const NumberUnit& row) {
        return std::ranges::any_of(unitNames(row),
                                   [&](const QString& name) { return plainNumberText(name) == plainName; });
    });
    return found == std::end(kNumberUnits) ? nullptr : found;
}

QString usableUnits(const QString& unit, const NumberUnit* own)
{
    QStringList usable{unit};
    if (own != nullptr)
        for (const NumberUnit& row : kNumberUnits)
            if (row.dimension == own->dimension && &row != own && row.factor > 1e-5) // Nobody types micrometres.
                usable.append(unitNames(row).first());
    return usable.join(QStringLiteral(", "));
}

} // namespace hairpaint::view
