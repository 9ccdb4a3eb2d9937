// A value, the change that is being made to it, and its picture.
#include "view/widgets/bar_value.h"

#include "view/look/theme.h"
#include "view/widgets/bar_picture.h"

#include <QEvent>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

/// Degrees stand against their number, other units a thin space away.
QString spacedUnit(const QString& unit)
{
    return unit.isEmpty() || unit == QStringLiteral("°") ? unit : QChar(0x2009) + unit;
}

} // namespace

BarValue::BarValue(const QString& label, QWidget* parent) : QWidget(parent), m_label(label)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFont(themeFont(TextRole::Label));
    m_settle.setSingleShot(true);
    connect(&m_settle, &QTimer::timeout, this, &BarValue::finish);
    describe();
}

void BarValue::setValue(double value)
{
    if (m_editing) {
        m_told = value;
        return;
    }
    m_told.reset();
    value = rounded(value);
    if (value == m_value)
        return;
    m_value = value;
    describe();
    update();
}

void BarValue::setRange(double minimum, double maximum, int decimals)
{
    m_minimum = minimum;
    m_maximum = std::max(minimum, maximum);
    m_decimals = decimals;
    m_value = rounded(m_value);
    describe();
    update();
}

void BarValue::setUnit(const QString& unit)
{
    m_unit = unit;
    describe();
    update();
}

void BarValue::setExponent(double exponent)
{
    m_exponent = exponent;
    update();
}

void BarValue::setDefaultValue(double value)
{
    m_default = value;
    m_hasDefault = true;
    describe();
}

void BarValue::setLabel(const QString& label)
{
    m_label = label;
    describe();
    update();
}

void BarValue::setGradient(const QList<QColor>& colours)
{
    m_gradient = colours;
    update();
}

void BarValue::setPreferredWidth(int width)
{
    m_preferredWidth = width;
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    updateGeometry();
}

void BarValue::setHint(const QString& hint)
{
    m_hint = hint;
    describe();
}

void BarValue::describe()
{
    setAccessibleName(m_label);
    setAccessibleDescription(valueText());
    const QString use = m_hasDefault ? tr("Ctrl-drag for fine, double-click to type, right-click to reset")
                                     : tr("Ctrl-drag for fine, double-click to type");
    setToolTip((m_hint.isEmpty() ? m_label : m_hint) + QLatin1Char('\n') + use);
}

double BarValue::rounded(double value) const
{
    const double power = std::pow(10.0, m_decimals);
    return std::clamp(std::round(value * power) / power, m_minimum, m_maximum);
}

double BarValue::fractionOf(double value) const
{
    if (m_maximum <= m_minimum)
        return 0.0;
    return std::pow(std::clamp((value - m_minimum) / (m_maximum - m_minimum), 0.0, 1.0), 1.0 / m_exponent);
}

double BarValue::valueAt(double fraction) const
{
    return rounded(m_minimum + (m_maximum - m_minimum) * std::pow(std::clamp(fraction, 0.0, 1.0), m_exponent));
}

void BarValue::begin()
{
    m_settle.stop();
    if (m_editing)
        return;
    m_editing = true;
    m_before = m_value;
    m_told.reset();
    Q_EMIT editingBegan();
}

void BarValue::moveTo(double value)
{
    value = rounded(value);
    if (value == m_value)
        return;
    m_value = value;
    m_told.reset();
    describe();
    update();
    Q_EMIT valueChanged(m_value);
}

void BarValue::finish()
{
    m_settle.stop();
    if (!m_editing)
        return;
    m_editing = false;
    update();
    if (m_value == m_before)
        Q_EMIT editingCancelled();
    else
        Q_EMIT editingFinished(m_value);
    // What it was told last holds, unless it has been told anew.
    if (const std::optional<double> told = m_told; told && !m_editing)
        setValue(*told);
}

void BarValue::cancel()
{
    m_settle.stop();
    if (!m_editing)
        return;
    m_value = m_before;
    m_told.reset();
    m_editing = false;
    describe();
    update();
    Q_EMIT editingCancelled();
}

void BarValue::stepBy(double steps)
{
    double step = (m_maximum - m_minimum) / 100.0;
    step = std::max(step, std::pow(10.0, -m_decimals));
    moveTo(m_value + steps * step);
}

QString BarValue::valueText() const
{
    return numberText(m_value);
}

QString BarValue::numberText(double value) const
{
    return QLocale().toString(value, 'f', m_decimals) + spacedUnit(m_unit);
}

QSize BarValue::sizeHint() const
{
    return {std::max(minimumSizeHint().width(), m_preferredWidth), metrics::kSlider};
}

QSize BarValue::minimumSizeHint() const
{
    const QFontMetrics font = fontMetrics();
    return {font.horizontalAdvance(m_label) + font.horizontalAdvance(numberText(m_maximum)) + 3 * kBarInset,
            metrics::kSlider};
}

void BarValue::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    paintBar(painter, rect(),
             {.label = m_label,
              .value = valueText(),
              .fraction = fractionOf(m_value),
              .gradient = m_gradient,
              .exponent = m_exponent,
              .enabled = isEnabled(),
              .hovered = isEnabled() && underMouse(),
              .focused = hasFocus()});
}

void BarValue::enterEvent(QEnterEvent* event)
{
    update();
    QWidget::enterEvent(event);
}

void BarValue::leaveEvent(QEvent* event)
{
    update();
    QWidget::leaveEvent(event);
}

void BarValue::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::EnabledChange || event->type() == QEvent::PaletteChange)
        update();
    QWidget::changeEvent(event);
}

} // namespace hairpaint::view
