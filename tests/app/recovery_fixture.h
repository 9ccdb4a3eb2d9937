// A window that is gone without a word, and the next one that offers what it left.
#pragma once

#include "app/recovery/recovery_dialog.h"
#include "tests/app/window_fixture.h"
#include "tests/model/archive_maker.h"
#include "view/panels/status_readout.h"

#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QUuid>

#include <algorithm>

namespace hairpaint::app {

/// Presses a button of the dialog that offers unsaved work, and answers what it asks then.
class RecoveryAnswer : public QObject
{
public:
    explicit RecoveryAnswer(QString button) : m_button(std::move(button)) { startTimer(20); }
    QStringList offered;
    QString question;
    QString note; ///< The note about work in a folder that can't be written; empty where it is not shown.

protected:
    void timerEvent(QTimerEvent* /*event*/) override
    {
        QWidget* waiting = QApplication::activeModalWidget();
        if (auto* box = qobject_cast<QMessageBox*>(waiting)) {
            question = box->text();
            box->button(QMessageBox::Discard)->click();
        } else if (auto* dialog = qobject_cast<RecoveryDialog*>(waiting)) {
            const auto* list = dialog->findChild<QListWidget*>();
            offered.clear();
            const auto* unwritable = dialog->findChild<QLabel*>(QStringLiteral("unwritable"));
            note = unwritable->isVisible() ? unwritable->text() : QString();
            for (int row = 0; row < list->count(); ++row)
                offered += list->item(row)->text();
            if (m_button == QLatin1String("Esc")) // As the keyboard has it: to whatever has the focus.
                return QTest::keyClick(dialog->windowHandle(), Qt::Key_Escape);
            for (QPushButton* button : dialog->findChildren<QPushButton*>())
                if (button->text().remove(QLatin1Char('&')) ==
                    m_button) // Not from here: what it asks needs this timer.
                    QMetaObject::invokeMethod(button, &QPushButton::click, Qt::QueuedConnection);
        }
    }

private:
    QString m_button;
};

inline int foldersLeft()
{
    return static_cast<int>(QDir(JournalFolder::root()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size());
}

/// A test derives from it and from QObject; it calls prepareRecovery() first and clearRecovery() before each function.
class RecoveryFixture : protected WindowFixture
{
protected:
    void openEmpty() { openWindow(test::smallProject()); }

    void openBald()
    {
        model::Project project = test::smallProject();
        project.wind.enabled = false;
        openWindow(std::move(project));
        key(Qt::Key_1);
        key(Qt::Key_B);
    }

    void stroke(float v)
    {
        QWidget& paper = m_window->paintView();
        drag(paper, paintPoint(0.3F, v), paintPoint(0.7F, v));
    }

    void offer()
    {
        m_window->offerUnsavedWork();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }

    /// The window goes without a word, as when the process is killed once the disk has the last step.
    void crash()
    {
        m_window->keepWork();
        m_window.reset();
    }

    /// A stroke that P.hairpaint has, and one that it has not; then a crash. The content in the end.
    QByteArray crashAfterSaving(const QString& path)
    {
        openBald();
        stroke(0.5F);
        m_window->files().setPath(path);
        if (!m_window->files().save())
            return {};
        stroke(0.6F);
        const QByteArray changed = savedBytes("changed.hairpaint");
        crash();
        return changed;
    }

    [[nodiscard]] bool says(const QString& text) const
    {
        const auto labels = m_window->findChild<view::StatusReadout*>()->findChildren<QLabel*>();
        return std::ranges::any_of(
            labels, [&text](const QLabel* label) { return label->isVisible() && label->text().contains(text); });
    }

    /// One more folder in which a window seems to have left something.
    static QString makeFolder()
    {
        const QString folder =
            JournalFolder::root() + QLatin1Char('/') + QUuid::createUuid().toString(QUuid::WithoutBraces);
        QDir().mkpath(folder);
        return folder;
    }
    static QString onlyFolder()
    {
        return JournalFolder::root() + QLatin1Char('/') +
               QDir(JournalFolder::root()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).value(0);
    }
    /// What a killed window leaves beside its journal; nobody has that number.
    static void leaveLock(const QString& folder)
    {
        test::writeBytes(folder + QStringLiteral("/lock"), "999999999\nhairpaint\n");
    }

    /// A root of its own.
    static void prepareRecovery(const char* name)
    {
        prepareApplication();
        QCoreApplication::setApplicationName(QLatin1StringView(name));
    }
    static void clearRecovery() { QDir(JournalFolder::root()).removeRecursively(); }
};

} // namespace hairpaint::app
