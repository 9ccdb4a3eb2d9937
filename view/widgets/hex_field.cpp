// See the header.
#include "view/widgets/hex_field.h"

#include "view/look/colour_text.h"
#include "view/widgets/field_hint.h"

#include <QFocusEvent>

namespace hairpaint::view {

HexField::HexField(QWidget* parent) : QLineEdit(parent)
{
    setMaxLength(40); // What other programs put into the clipboard.
    setFixedWidth(88);
    connect(this, &QLineEdit::textEdited, this, [this] {
        markRefused(*this, false);
        FieldHint::hideAt(*this);
    });
    connect(this, &QLineEdit::returnPressed, this, [this] { take(true); });
}

void HexField::showColour(const QColor& colour)
{
    m_colour = colour;
    if (!(window()->focusWidget() == this && isModified()))
        setText(colour.name());
}

void HexField::focusOutEvent(QFocusEvent* event)
{
    // editingFinished is not told again after Enter.
    if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason)
        take(false);
    QLineEdit::focusOutEvent(event);
}

void HexField::take(bool stays)
{
    if (!isModified())
        return;
    const QString typed = text().trimmed();
    if (const std::optional<QColor> colour = colourFromText(typed)) {
        setModified(false);
        Q_EMIT colourTyped(*colour);
        setText(m_colour.name());
        return;
    }
    const QString sentence = tr("“%1” is no colour; type six digits of 0–9 and A–F, such as %2, or rgb(26, 43, 60).")
                                 .arg(typed, m_colour.name());
    markRefused(*this, stays);
    if (!stays) // The colour painted is shown again.
        setText(m_colour.name());
    if (isVisible())
        FieldHint::showAt(*this, sentence, FieldHint::Tone::Problem);
}

} // namespace hairpaint::view
