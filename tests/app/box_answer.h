// Somebody who answers message boxes.
#pragma once

#include <QAbstractButton>
#include <QApplication>
#include <QFileDialog>
#include <QMessageBox>
#include <QObject>
#include <QStringList>

namespace hairpaint::app {

/// Presses the button of that name in each message box that waits while it lives; a box without it and dialogs of files
/// are cancelled.
class BoxAnswer : public QObject
{
public:
    explicit BoxAnswer(QString button) : m_button(std::move(button)) { startTimer(5); }
    QStringList asked; ///< What the boxes said.
    bool sawFileDialog = false;

protected:
    /// Whether it was another dialog, which is done with.
    virtual bool ends(QWidget& /*dialog*/) { return false; }

    void timerEvent(QTimerEvent* /*event*/) override
    {
        QWidget* waiting = QApplication::activeModalWidget();
        if (waiting == nullptr || ends(*waiting))
            return;
        if (auto* files = qobject_cast<QFileDialog*>(waiting)) {
            sawFileDialog = true;
            return files->reject();
        }
        auto* box = qobject_cast<QMessageBox*>(waiting);
        if (box == nullptr)
            return;
        asked += box->text();
        for (QAbstractButton* button : box->buttons())
            if (button->text().remove(QLatin1Char('&')) == m_button)
                return button->click();
        box->reject();
    }

private:
    QString m_button;
};

} // namespace hairpaint::app
