// Mouse, keys and typing of the filled bar.
#include "view/widgets/bar_slider.h"

#include "view/widgets/field_hint.h"
#include "view/widgets/number_edit.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QStyleHints>
#include <QWheelEvent>

#include <cmath>

namespace hairpaint::view {

namespace {

constexpr double kFine = 0.1;
constexpr int kWheelPauseMs = 350; ///< Notches closer together than this are one change.

} // namespace

BarSlider::BarSlider(const QString& label, QWidget* parent) : BarValue(label, parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::SizeHorCursor);
    // However a change ends, nothing is dragged any more.
    connect(this, &BarValue::editingFinished, this, [this] { m_dragging = false; });
    connect(this, &BarValue::editingCancelled, this, [this] { m_dragging = false; });
}

void BarSlider::release()
{
    if (m_editor != nullptr)
        m_editor->leave(false);
    finish();
}

void BarSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::RightButton) {
        if (m_dragging) {
            cancel();
        } else if (const std::optional<double> reset = defaultValue()) {
            begin();
            moveTo(*reset);
            finish();
        }
        return;
    }
    if (event->button() != Qt::LeftButton)
        return;
    if (finishesSoon())
        finish(); // Another change than the click or the notch before it.
    begin();
    m_dragging = true;
    m_moved = false;
    m_lastX = event->position().x();
    m_pressX = m_lastX;
    m_dragFraction = (event->modifiers() & Qt::ControlModifier) != 0 ? fractionOf(value()) : m_lastX / width();
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
        finishIn(QGuiApplication::styleHints()->mouseDoubleClickInterval());
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
    finishIn(kWheelPauseMs);
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
        if (editing()) {
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
        if ((editing() && key->key() == Qt::Key_Escape) || key->key() == Qt::Key_F2 || startsTyping(*key)) {
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
        new NumberEdit(locale.toString(value(), 'f', decimals()), {.unit = unit(), .whole = decimals() == 0}, this);
    m_editor->setGeometry(rect());
    m_editor->setAccessibleName(label());
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
    const double beyond = 0.5 * std::pow(10.0, -decimals());
    if (!isVisible() || (typed <= maximum() + beyond && typed >= minimum() - beyond))
        return;
    const QString sentence = typed > maximum() ? tr("%1 is the most that can be set here.").arg(numberText(maximum()))
                                               : tr("%1 is the least that can be set here.").arg(numberText(minimum()));
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

} // namespace hairpaint::view
