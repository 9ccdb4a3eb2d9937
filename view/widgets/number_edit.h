// The line in which a number is typed, laid over the field that shows it.
#pragma once

#include "view/look/number_text.h"

#include <QLineEdit>

namespace hairpaint::view {

/// Enter takes what is typed, or says at the field why it can't be and stays open; Esc leaves. Leaving it for another
/// field takes what can be read. What nobody touched changes nothing.
class NumberEdit : public QLineEdit
{
    Q_OBJECT
public:
    /// `text`: what it opens with, all of it selected.
    NumberEdit(const QString& text, NumberField field, QWidget* host);
    /// Leaves it: what can be read is entered where `keep`.
    void leave(bool keep);

Q_SIGNALS:
    void entered(double value);        ///< In the field's unit. left() follows.
    void left(const QString& problem); ///< It is over. Why what is typed was not taken; empty where it was, or Esc.

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void enter();

    NumberField m_field;
    QString m_opened; ///< With this text.
    bool m_isOver = false;
};

} // namespace hairpaint::view
