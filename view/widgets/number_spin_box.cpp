// Between Qt's spin box and the reading of numbers.
#include "view/widgets/number_spin_box.h"

#include "view/look/number_text.h"
#include "view/widgets/field_hint.h"

#include <QLineEdit>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

NumberSpinBox::NumberSpinBox(const QString& unit, QWidget* parent) : QSpinBox(parent), m_unit(unit)
{
    setSuffix(QStringLiteral(" ") + unit);
}

tl::expected<double, QString> NumberSpinBox::read(QString text) const
{
    // The box's own, behind what was typed.
    if (text.endsWith(suffix()))
        text.chop(suffix().size());
    return readNumber(text, {.unit = m_unit, .whole = true});
}

QValidator::State NumberSpinBox::validate(QString& input, int& /*position*/) const
{
    const auto number = read(input);
    const bool fits = number && *number > minimum() - 0.5 && *number < maximum() + 0.5;
    return fits ? QValidator::Acceptable : QValidator::Intermediate;
}

int NumberSpinBox::valueFromText(const QString& text) const
{
    const auto number = read(text);
    return number ? static_cast<int>(std::lround(std::clamp<double>(*number, minimum(), maximum()))) : value();
}

void NumberSpinBox::fixup(QString& input) const
{
    const auto number = read(input);
    if (number) {
        input = textFromValue(valueFromText(input)) + suffix();
        return;
    }
    if (isVisible())
        FieldHint::showAt(*lineEdit(), tr("%1 It stays %2.").arg(number.error(), textFromValue(value()) + suffix()),
                          FieldHint::Tone::Problem);
}

} // namespace hairpaint::view
