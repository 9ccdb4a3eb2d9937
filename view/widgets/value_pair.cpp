// The value that is painted and the second one.
#include "view/widgets/value_pair.h"

#include "view/look/icons.h"
#include "view/look/theme.h"
#include "view/look/value_text.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

namespace hairpaint::view {

namespace {

constexpr int kSide = 18;
constexpr int kArrow = 12;

} // namespace

ValuePair::ValuePair(EditorState& state, QWidget* parent) : QWidget(parent), m_state(state)
{
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(tr("Value and second value"));
    setAttribute(Qt::WA_Hover);
    const auto redraw = [this] { update(); };
    connect(&state.tools(), &ToolBox::settingsChanged, this, redraw);
    connect(&state.target(), &EditTarget::changed, this, redraw);
    connect(&state.options(), &ViewOptions::changed, this, redraw);
}

void ValuePair::paintEvent(QPaintEvent* /*event*/)
{
    const Theme theme = Theme::current();
    const model::MapSpec& spec = model::mapSpec(m_state.target().map());
    model::ToolSettings settings = m_state.tools().settings();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const auto square = [&](bool second, const model::PaintValue& value) {
        const QRectF field = QRectF(squareRect(second)).adjusted(0.5, 0.5, -0.5, -0.5);
        painter.setPen(QPen(theme.panel, 3.0));
        painter.setBrush(valueColour(spec, value, m_state.options().nightPaper()));
        painter.drawRoundedRect(field, 3.0, 3.0);
        painter.setPen(QPen(theme.dimText, 1.0));
        painter.drawRoundedRect(field, 3.0, 3.0);
    };
    square(true, settings.secondValue(spec.kind));
    square(false, settings.value(spec.kind));
    const QColor ink = underMouse() ? theme.text : theme.dimText;
    const QPointF corner = QRectF(arrowRect()).center() - QPointF(kArrow, kArrow) / 2.0;
    painter.drawPixmap(corner, iconPixmap(QStringLiteral("swap"), kArrow, ink, devicePixelRatioF()));
    if (hasFocus()) {
        painter.setPen(QPen(theme.accent, 1.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.75, 0.75, -0.75, -0.75), 4.0, 4.0);
    }
}

QRect ValuePair::squareRect(bool second) const
{
    const QPoint corner = second ? QPoint(width() - kSide - 1, height() - kSide - 1) : QPoint(1, 1);
    return {corner, QSize(kSide, kSide)};
}

QRect ValuePair::arrowRect() const
{
    const QRect front = squareRect(false);
    return {QPoint(front.right() + 2, 0), QPoint(width() - 1, squareRect(true).top() - 1)};
}

void ValuePair::mouseReleaseEvent(QMouseEvent* event)
{
    const QPoint at = event->position().toPoint();
    if (event->button() != Qt::LeftButton)
        return;
    if (squareRect(false).contains(at))
        Q_EMIT pickWanted(false);
    else if (squareRect(true).contains(at))
        Q_EMIT pickWanted(true);
    else if (arrowRect().contains(at))
        swapValues(m_state);
}

void ValuePair::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Space || event->key() == Qt::Key_Return)
        Q_EMIT pickWanted(false);
    else
        QWidget::keyPressEvent(event);
}

bool ValuePair::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const model::MapSpec& spec = model::mapSpec(m_state.target().map());
        model::ToolSettings settings = m_state.tools().settings();
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                           tr("Paints %1; the second value is %2. Click a square to choose, the arrow to swap (X)")
                               .arg(valueText(m_state.target().settings(), spec, settings.value(spec.kind)),
                                    valueText(m_state.target().settings(), spec, settings.secondValue(spec.kind))),
                           this);
        return true;
    }
    return QWidget::event(event);
}

void swapValues(EditorState& state)
{
    model::ToolSettings settings = state.tools().settings();
    std::swap(settings.value(state.target().map()), settings.secondValue(state.target().map()));
    state.tools().setSettings(settings);
}

void resetValues(EditorState& state)
{
    model::ToolSettings settings = state.tools().settings();
    model::ToolSettings fresh = state.tools().startSettings();
    settings.value(state.target().map()) = fresh.value(state.target().map());
    settings.secondValue(state.target().map()) = fresh.secondValue(state.target().map());
    state.tools().setSettings(settings);
}

} // namespace hairpaint::view
