// What was done to a style, and its undo.
#pragma once

#include <QWidget>

class QLabel;

namespace hairpaint::view {

/// A sentence with "Undo" over the foot of its parent, until it is taken back, closed or replaced by another; no
/// clock takes it away. Tab of the strip reaches it. GUI thread.
class StyleNotice : public QWidget
{
    Q_OBJECT
public:
    explicit StyleNotice(QWidget* parent);
    void tell(const QString& sentence); ///< An empty one hides it.
    void settle();                      ///< At its position, after the parent has got another size.

Q_SIGNALS:
    void undoChosen();

private:
    QLabel* m_sentence = nullptr;
};

} // namespace hairpaint::view
