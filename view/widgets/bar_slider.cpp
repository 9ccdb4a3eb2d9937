// Mouse, keys and typing of the filled bar.
#include "view/widgets/bar_slider.h"

#include "view/look/theme.h"
#include "view/widgets/bar_picture.h"
#include "view/widgets/field_hint.h"
#include "view/widgets/number_edit.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QStyleHints>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

constexpr double kFine = 0.1;
constexpr int kWheelPauseMs = 350; ///< Notches closer together than this are one change.

/// Degrees stand against their number, other units a thin space away.
QString spacedUnit(const QString& unit)
{
    return unit.isEmpty() || unit == QStringLiteral("°") ? unit : QChar(0x2009) + unit;
}

} // namespace

BarSlider::BarSlider(const QString& label, QWidget* parent) : QWidget(parent), m_label(label)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::SizeHorCursor);
    setFont(themeFont(TextRole::Label));
    m_settle.setSingleShot(true);
    connect(&m_settle, &QTimer::timeout, this, &BarSlider::finish);
    describe();
}

void BarSlider::setValue(double value)
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

void BarSlider::setRange(double minimum, double maximum, int decimals)
{
    m_minimum = minimum;
    m_maximum = std::max(minimum, maximum);
    m_decimals = decimals;
    m_value = rounded(m_value);
    describe();
    update();
}

void BarSlider::setUnit(const QString& unit)
{
    m_unit = unit;
    describe();
    update();
}

void BarSlider::setExponent(double exponent)
{
    m_exponent = exponent;
    update();
}

void BarSlider::setDefaultValue(double value)
{
    m_default = value;
    m_hasDefault = true;
    describe();
}

void BarSlider::setLabel(const QString& label)
{
    m_label = label;
    describe();
    update();
}

void BarSlider::setGradient(const QList<QColor>& colours)
{
    m_gradient = colours;
    update();
}

void BarSlider::setPreferredWidth(int width)
{
    m_preferredWidth = width;
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    updateGeometry();
}

void BarSlider::setHint(const QString& hint)
{
    m_hint = hint;
    describe();
}

void BarSlider::describe()
{
    setAccessibleName(m_label);
    setAccessibleDescription(valueText());
    const QString use = m_hasDefault ? tr("Ctrl-drag for fine, double-click to type, right-click to reset")
                                     : tr("Ctrl-drag for fine, double-click to type");
    setToolTip((m_hint.isEmpty() ? m_label : m_hint) + QLatin1Char('\n') + use);
}

double BarSlider::rounded(double value) const
{
    const double power = std::pow(10.0, m_decimals);
    return std::clamp(std::round(value * power) / power, m_minimum, m_maximum);
}

double BarSlider::fractionOf(double value) const
{
    if (m_maximum <= m_minimum)
        return 0.0;
    return std::pow(std::clamp((value - m_minimum) / (m_maximum - m_minimum), 0.0, 1.0), 1.0 / m_exponent);
}

double BarSlider::valueAt(double fraction) const
{
    return rounded(m_minimum + (m_maximum - m_minimum) * std::pow(std::clamp(fraction, 0.0, 1.0), m_exponent));
}

void BarSlider::begin()
{
    m_settle.stop();
    if (m_editing)
        return;
    m_editing = true;
    m_before = m_value;
    m_told.reset();
    Q_EMIT editingBegan();
}

void BarSlider::moveTo(double value)
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

void BarSlider::finish()
{
    m_settle.stop();
    if (!m_editing)
        return;
    m_editing = false;
    m_dragging = false;
    update();
    if (m_value == m_before)
        Q_EMIT editingCancelled();
    else
        Q_EMIT editingFinished(m_value);
    // What it was told last holds, unless it has been told anew.
    if (const std::optional<double> told = m_told; told && !m_editing)
        setValue(*told);
}

void BarSlider::release()
{
    if (m_editor != nullptr)
        m_editor->leave(false);
    finish();
}

void BarSlider::cancel()
{
    m_settle.stop();
    if (!m_editing)
        return;
    m_value = m_before;
    m_told.reset();
    m_editing = false;
    m_dragging = false;
    describe();
    update();
    Q_EMIT editingCancelled();
}

void BarSlider::stepBy(double steps)
{
    double step = (m_maximum - m_minimum) / 100.0;
    step = std::max(step, std::pow(10.0, -m_decimals));
    moveTo(m_value + steps * step);
}

void BarSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::RightButton) {
        if (m_dragging) {
            cancel();
        } else if (m_hasDefault) {
            begin();
            moveTo(m_default);
            finish();
        }
        return;
    }
    if (event->button() != Qt::LeftButton)
        return;
    if (m_settle.isActive())
        finish(); // Another change than the click or the notch before it.
    begin();
    m_dragging = true;
    m_moved = false;
    m_lastX = event->position().x();
    m_pressX = m_lastX;
    m_dragFraction = (event->modifiers() & Qt::ControlModifier) != 0 ? fractionOf(m_value) : m_lastX / width();
    moveTo(valueAt(m_dragFraction));
}

void BarSlider::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_dragging)
        return;
    const double x = event->position().x();
    const double gain = (event->modifiers() & Qt::ControlModifier) != 0 ? kFine : 1.0;
    m_dragFraction += (x - m_lastX) / width() * gain;
    // A hand that double-clicks trembles.
    m_moved = m_moved || std::abs(x - m_pressX) > QGuiApplication::styleHints()->mouseDoubleClickDistance();
    m_lastX = x;
    moveTo(valueAt(m_dragFraction));
}

void BarSlider::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !m_dragging)
        return;
    m_dragging = false;
    // A click may be the first half of a double-click, which must leave the value as it was.
    if (m_moved)
        finish();
    else
        m_settle.start(QGuiApplication::styleHints()->mouseDoubleClickInterval());
}

void BarSlider::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        mousePressEvent(event);
        return;
    }
    cancel();
    openEditor();
}

void BarSlider::wheelEvent(QWheelEvent* event)
{
    if (!hasFocus()) {
        event->ignore();
        return;
    }
    event->accept();
    m_wheelRest += event->angleDelta().y();
    const int notches = m_wheelRest / QWheelEvent::DefaultDeltasPerStep;
    m_wheelRest -= notches * QWheelEvent::DefaultDeltasPerStep;
    if (notches == 0)
        return;
    begin();
    stepBy(notches * ((event->modifiers() & Qt::ShiftModifier) != 0 ? 10.0 : 1.0));
    m_settle.start(kWheelPauseMs);
}

void BarSlider::keyPressEvent(QKeyEvent* event)
{
    const double size = (event->modifiers() & Qt::ShiftModifier) != 0 ? 10.0 : 1.0;
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
        begin();
        stepBy(-size);
        return;
    case Qt::Key_Right:
    case Qt::Key_Up:
        begin();
        stepBy(size);
        return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_F2:
        openEditor();
        return;
    case Qt::Key_Escape:
        if (m_editing) {
            cancel();
            return;
        }
        break;
    default:
        if (startsTyping(*event)) {
            openEditor();
            m_editor->setText(event->text());
            return;
        }
        break;
    }
    QWidget::keyPressEvent(event);
}

bool BarSlider::startsTyping(const QKeyEvent& event) const
{
    const QString text = event.text();
    return m_reachedByKey && text.size() == 1 && (text.front().isDigit() || QStringLiteral("-.,").contains(text)) &&
           (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
}

void BarSlider::keyReleaseEvent(QKeyEvent* event)
{
    const bool arrow = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right || event->key() == Qt::Key_Up ||
                       event->key() == Qt::Key_Down;
    if (arrow && !event->isAutoRepeat() && !m_dragging)
        finish();
    else
        QWidget::keyReleaseEvent(event);
}

bool BarSlider::event(QEvent* event)
{
    // While a value changes Esc takes it back, whatever else the window uses Esc for. Digits are the value's where the
    // keyboard came to it: after a click they still choose maps.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if ((m_editing && key->key() == Qt::Key_Escape) || key->key() == Qt::Key_F2 || startsTyping(*key)) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void BarSlider::focusInEvent(QFocusEvent* event)
{
    if (event->reason() == Qt::MouseFocusReason)
        m_reachedByKey = false;
    else if (event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason)
        m_reachedByKey = true;
    update();
    QWidget::focusInEvent(event);
}

void BarSlider::focusOutEvent(QFocusEvent* event)
{
    if (m_editor == nullptr)
        finish();
    update();
    QWidget::focusOutEvent(event);
}

void BarSlider::hideEvent(QHideEvent* event)
{
    // A popup that closes is left as any other field is.
    if (m_editor != nullptr)
        m_editor->leave(true);
    finish();
    QWidget::hideEvent(event);
}

void BarSlider::openEditor()
{
    if (m_editor != nullptr)
        return;
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    m_editor =
        new NumberEdit(locale.toString(m_value, 'f', m_decimals), {.unit = m_unit, .whole = m_decimals == 0}, this);
    m_editor->setGeometry(rect());
    m_editor->setAccessibleName(m_label);
    connect(m_editor, &NumberEdit::entered, this, &BarSlider::take);
    connect(m_editor, &NumberEdit::left, this, &BarSlider::closeEditor);
    QWidget::setTabOrder(this, m_editor);
    m_editor->show();
    m_editor->setFocus();
}

void BarSlider::take(double typed)
{
    begin();
    moveTo(typed);
    finish();
    // Rounding alone is nothing to tell.
    const double beyond = 0.5 * std::pow(10.0, -m_decimals);
    if (!isVisible() || (typed <= m_maximum + beyond && typed >= m_minimum - beyond))
        return;
    const QString sentence = typed > m_maximum ? tr("%1 is the most that can be set here.").arg(numberText(m_maximum))
                                               : tr("%1 is the least that can be set here.").arg(numberText(m_minimum));
    FieldHint::showAt(*this, sentence, FieldHint::Tone::Note);
}

void BarSlider::closeEditor(const QString& problem)
{
    NumberEdit* editor = m_editor;
    m_editor = nullptr;
    const bool hadFocus = editor->hasFocus();
    editor->hide();
    editor->deleteLater();
    if (hadFocus)
        setFocus();
    if (!problem.isEmpty() && isVisible())
        FieldHint::showAt(*this, tr("%1 It stays %2.").arg(problem, valueText()), FieldHint::Tone::Problem);
}

void BarSlider::resizeEvent(QResizeEvent* event)
{
    if (m_editor != nullptr)
        m_editor->setGeometry(rect());
    QWidget::resizeEvent(event);
}

QString BarSlider::valueText() const
{
    return numberText(m_value);
}

QString BarSlider::numberText(double value) const
{
    return QLocale().toString(value, 'f', m_decimals) + spacedUnit(m_unit);
}

QSize BarSlider::sizeHint() const
{
    return {std::max(minimumSizeHint().width(), m_preferredWidth), metrics::kSlider};
}

QSize BarSlider::minimumSizeHint() const
{
    const QFontMetrics font = fontMetrics();
    return {font.horizontalAdvance(m_label) + font.horizontalAdvance(numberText(m_maximum)) + 3 * kBarInset,
            metrics::kSlider};
}

void BarSlider::paintEvent(QPaintEvent* /*event*/)
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

void BarSlider::enterEvent(QEnterEvent* event)
{
    update();
    QWidget::enterEvent(event);
}

void BarSlider::leaveEvent(QEvent* event)
{
    update();
    QWidget::leaveEvent(event);
}

void BarSlider::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::EnabledChange || event->type() == QEvent::PaletteChange)
        update();
    QWidget::changeEvent(event);
}

} // namespace hairpaint::view
