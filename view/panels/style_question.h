// What the strip asks before a style replaces hair that it is not evidently about.
#pragma once

#include <QList>
#include <QPointer>
#include <QStringList>
#include <QWidget>

class QLabel;
class QPushButton;

namespace hairpaint::view {

/// A sentence with three buttons at the foot of its parent, over what is there; nothing waits for it. Return takes the
/// button in focus, arrows and Tab go from one to the next, Esc keeps. Closed, it gives the focus back.
class StyleQuestion : public QWidget
{
    Q_OBJECT
public:
    explicit StyleQuestion(QWidget* parent);
    /// `groups`: shown names.
    void ask(const QString& style, const QStringList& groups);
    void close(); ///< Closes it without an answer.

Q_SIGNALS:
    void keepChosen();    ///< The style, but these groups stay.
    void replaceChosen(); ///< The style with all its groups.
    void cancelChosen();  ///< The style is not applied.

protected:
    bool eventFilter(QObject* watched, QEvent* event) override; ///< Reads the keys of the buttons.

private:
    void step(int by); ///< Moves the focus by so many buttons.

    QLabel* m_text = nullptr;
    QPushButton* m_keep = nullptr;
    QPushButton* m_replace = nullptr;
    QList<QPushButton*> m_buttons;
    QPointer<QWidget> m_focusBefore;
};

} // namespace hairpaint::view
