// A field for the hex digits of a colour, or whatever else names one.
#pragma once

#include <QColor>
#include <QLineEdit>

namespace hairpaint::view {

/// Takes what other programs put into the clipboard, too (view/look/colour_text.h), on Enter or when it is left. What
/// is no colour is marked and told of below the field: after Enter it stays to be mended, else the colour is shown
/// again.
class HexField : public QLineEdit
{
    Q_OBJECT
public:
    explicit HexField(QWidget* parent = nullptr);
    /// Leaves alone what is being typed.
    void showColour(const QColor& colour);

Q_SIGNALS:
    void colourTyped(const QColor& colour);

protected:
    void focusOutEvent(QFocusEvent* event) override;

private:
    void take(bool stays);

    QColor m_colour;
};

} // namespace hairpaint::view
