// After a crash the next start gives the work back, with its steps, from whatever was done in the real window.
#include "app/recovery/recovery_dialog.h"
#include "model/journal/journal_reader.h"
#include "model/journal/journal_writer.h"
#include "tests/app/window_fixture.h"
#include "tests/model/sample_project.h"
#include "tests/support/test_program.h"
#include "view/panels/status_readout.h"

#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>

namespace hairpaint::app {

namespace {

/// Presses a button of the dialog that offers unsaved work, and answers what it asks then.
class Answer : public QObject
{
public:
    explicit Answer(QString button) : m_button(std::move(button)) { startTimer(20); }
    QStringList offered;
    QString question;

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

int foldersLeft()
{
    return static_cast<int>(QDir(JournalFolder::root()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size());
}

} // namespace

class TestRecovery : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    void openBald()
    {
        model::Project project = model::newProject();
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

private Q_SLOTS:
    void initTestCase()
    {
        prepareApplication();
        QCoreApplication::setApplicationName(QStringLiteral("hairpaint-recovery-test")); // A root of its own.
    }
    void init() { QDir(JournalFolder::root()).removeRecursively(); }
    void cleanup() { m_window.reset(); }

    void nothingIsKeptOrOfferedWithoutWork()
    {
        openBald();
        offer(); // Would wait for an answer.
        QCOMPARE(foldersLeft(), 0);
        QVERIFY(m_window->close());
        QCOMPARE(foldersLeft(), 0);
    }

    void windOnOrOffIsNoWork_data()
    {
        QTest::addColumn<bool>("crashes");
        QTest::newRow("closed") << false;
        QTest::newRow("killed") << true;
    }
    void windOnOrOffIsNoWork()
    {
        QFETCH(bool, crashes);
        openBald();
        key(Qt::Key_W);
        QVERIFY(session().document().committed().wind.enabled);
        QCOMPARE(stack().count(), 0);
        QVERIFY(!m_window->isWindowModified());
        if (crashes)
            crash();
        else
            QVERIFY(m_window->close()); // A question would wait for an answer.
        QCOMPARE(foldersLeft(), 0);
        if (!crashes)
            return;
        openWindow(model::newProject());
        offer(); // So would this.
    }

    void windOnOrOffIsSavedWithTheProject()
    {
        openBald();
        key(Qt::Key_W);
        const QString path = m_folder.filePath(QStringLiteral("windy.hairpaint"));
        m_window->files().setPath(path);
        QVERIFY(m_window->files().save());
        QVERIFY(model::loadProject(path)->wind.enabled);
    }

    void workOfAWindowThatIsGoneComesBackWithItsSteps()
    {
        openBald();
        for (const float v : {0.4F, 0.5F, 0.6F})
            stroke(v);
        QCOMPARE(stack().index(), 3);
        const QByteArray third = savedBytes("third.hairpaint");
        key(Qt::Key_Z, Qt::ControlModifier);
        const QByteArray second = savedBytes("second.hairpaint");
        QVERIFY(second != third);
        crash();
        QCOMPARE(foldersLeft(), 1);

        openWindow(model::newProject());
        Answer answer(QStringLiteral("Restore"));
        offer();
        QCOMPARE(answer.offered.size(), 1);
        QVERIFY2(answer.offered.front().contains(QStringLiteral("Untitled")), qPrintable(answer.offered.front()));
        QVERIFY2(answer.offered.front().contains(QStringLiteral("2 step")), qPrintable(answer.offered.front()));
        QCOMPARE(savedBytes("restored.hairpaint"), second);
        QVERIFY(m_window->isWindowModified());
        QCOMPARE(stack().count(), 3);
        key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(stack().index(), 3);
        QCOMPARE(savedBytes("redone.hairpaint"), third);
        key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(savedBytes("undone.hairpaint"), second);
        key(Qt::Key_Z, Qt::ControlModifier);
        key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(stack().index(), 0);
        stroke(0.7F);
        const QByteArray another = savedBytes("another.hairpaint");
        QCOMPARE(foldersLeft(), 1); // The new window's alone.
        // And once more.
        crash();
        openWindow(model::newProject());
        Answer again(QStringLiteral("Restore"));
        offer();
        QCOMPARE(savedBytes("again.hairpaint"), another);
    }

    void savedWorkIsNotOffered()
    {
        openBald();
        stroke(0.5F);
        const QString path = m_folder.filePath(QStringLiteral("safe.hairpaint"));
        m_window->files().setPath(path);
        QVERIFY(m_window->files().save());
        crash();
        QCOMPARE(foldersLeft(), 1);
        openWindow(model::newProject());
        offer();
        QCOMPARE(foldersLeft(), 0);
    }

    void whatWasChangedAfterSavingKeepsItsFile()
    {
        openBald();
        stroke(0.5F);
        const QString path = m_folder.filePath(QStringLiteral("kept.hairpaint"));
        m_window->files().setPath(path);
        QVERIFY(m_window->files().save());
        stroke(0.6F);
        const QByteArray changed = savedBytes("changed.hairpaint");
        crash();
        openWindow(model::newProject());
        Answer answer(QStringLiteral("Restore"));
        offer();
        QVERIFY(answer.offered.front().contains(QStringLiteral("kept")));
        QCOMPARE(savedBytes("restored.hairpaint"), changed);
        QCOMPARE(m_window->files().path(), path);
        QVERIFY(m_window->isWindowModified());
    }

    void workCanBeLeftForLaterOrDiscarded()
    {
        openBald();
        stroke(0.5F);
        crash();
        openWindow(model::newProject());
        {
            Answer later(QStringLiteral("Not now"));
            offer();
            QCOMPARE(later.offered.size(), 1);
        }
        QCOMPARE(foldersLeft(), 1);
        QVERIFY(!m_window->isWindowModified());
        Answer discard(QStringLiteral("Discard"));
        offer();
        QVERIFY(discard.question.contains(QStringLiteral("Untitled")));
        QCOMPARE(foldersLeft(), 0);
    }

    void escapeLeavesTheQuestionAndKeepsTheWork()
    {
        openBald();
        stroke(0.5F);
        crash();
        openWindow(model::newProject());
        const auto kept = [this] {
            const auto labels = m_window->findChild<view::StatusReadout*>()->findChildren<QLabel*>();
            return std::ranges::any_of(labels, [](const QLabel* label) {
                return label->isVisible() && label->text().contains(QStringLiteral("unsaved work is kept"));
            });
        };
        QVERIFY(!kept());
        {
            Answer escape(QStringLiteral("Esc"));
            offer();
            QCOMPARE(escape.offered.size(), 1);
        }
        QVERIFY(kept());
        QCOMPARE(foldersLeft(), 1);
        QVERIFY(!m_window->isWindowModified());
        key(Qt::Key_W); // The window takes keys as ever.
        Answer restore(QStringLiteral("Restore"));
        offer();
        QCOMPARE(restore.offered.size(), 1);
        QCOMPARE(stack().count(), 1);
    }

    void aWindowThatIsOpenIsNotRobbed()
    {
        openBald();
        stroke(0.5F);
        auto other = std::make_unique<MainWindow>(model::newProject(), QString());
        QTRY_COMPARE_WITH_TIMEOUT(foldersLeft(), 1, kPatienceMs);
        other->offerUnsavedWork(); // Would wait for an answer.
        QCOMPARE(foldersLeft(), 1);
    }

    void closingLeavesNothingBehind()
    {
        openBald();
        stroke(0.5F);
        QTRY_COMPARE_WITH_TIMEOUT(foldersLeft(), 1, kPatienceMs);
        Answer discard(QStringLiteral("Discard")); // Of changes, which is asked by a box.
        QVERIFY(m_window->close());
        QCOMPARE(foldersLeft(), 0);
    }

    void whereNothingCanBeWrittenASignSaysSo()
    {
        QVERIFY(QDir().mkpath(QFileInfo(JournalFolder::root()).absolutePath()));
        QFile inTheWay(JournalFolder::root());
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        inTheWay.close();
        openBald();
        const auto* saved = m_window->findChild<QLabel*>(QStringLiteral("saved"));
        stroke(0.5F);
        QTRY_VERIFY_WITH_TIMEOUT(saved->text().contains(QStringLiteral("no safety copy")), kPatienceMs);
        QVERIFY(inTheWay.remove());
        stroke(0.6F);
        QTRY_VERIFY_WITH_TIMEOUT(!saved->text().contains(QStringLiteral("no safety copy")), kPatienceMs);
        QVERIFY(saved->text().contains(QStringLiteral("Not saved")));
        QCOMPARE(foldersLeft(), 1);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestRecovery, Widgets)
#include "test_recovery.moc"
