// After a crash the next start gives the work back, with its steps, from whatever was done in the real window.
#include "app/recovery/recovery_dialog.h"
#include "model/journal/journal_format.h"
#include "model/journal/journal_reader.h"
#include "model/journal/journal_writer.h"
#include "tests/app/window_fixture.h"
#include "tests/model/archive_maker.h"
#include "tests/model/sample_project.h"
#include "tests/support/file_faults.h"
#include "tests/support/test_program.h"
#include "view/panels/status_readout.h"

#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QUuid>

#include <algorithm>
#include <array>
#include <limits>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

namespace hairpaint::app {

namespace {

/// Presses a button of the dialog that offers unsaved work, and answers what it asks then.
class Answer : public QObject
{
public:
    explicit Answer(QString button) : m_button(std::move(button)) { startTimer(20); }
    QStringList offered;
    QString question;
    QString note; ///< Of what lies where nothing can be written.

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

    void whatIsRestoredForTheFileThatIsToBeOpenedIsOpen_data()
    {
        QTest::addColumn<QString>("spelling");
        QTest::newRow("as it was") << QStringLiteral("P.hairpaint");
        QTest::newRow("by a link") << QStringLiteral("link.hairpaint");
        QTest::newRow("by another way") << QStringLiteral("way/../P.hairpaint");
    }
    void whatIsRestoredForTheFileThatIsToBeOpenedIsOpen()
    {
        QFETCH(QString, spelling);
        const QString path = m_folder.filePath(QStringLiteral("P.hairpaint"));
        QVERIFY(QDir().mkpath(m_folder.filePath(QStringLiteral("way"))));
        QFile::link(path, m_folder.filePath(QStringLiteral("link.hairpaint")));
        const QByteArray changed = crashAfterSaving(path);
        QVERIFY(!changed.isEmpty());
        openWindow(model::newProject());
        Answer answer(QStringLiteral("Restore"));
        m_window->begin(m_folder.filePath(spelling));
        QCOMPARE(answer.offered.size(), 1);
        QCOMPARE(answer.question, QString()); // Nothing is to be saved or discarded.
        QCOMPARE(savedBytes("restored.hairpaint"), changed);
        QCOMPARE(m_window->files().path(), path);
        QVERIFY(m_window->isWindowModified());
        QCOMPARE(stack().index(), 2);
        QCOMPARE(foldersLeft(), 1);
    }

    void anotherFileDoesNotTakeThePlaceOfWhatIsRestored()
    {
        const QString other = m_folder.filePath(QStringLiteral("other.hairpaint"));
        QVERIFY(model::saveProject(model::newProject(), other, {}));
        const QByteArray changed = crashAfterSaving(m_folder.filePath(QStringLiteral("P.hairpaint")));
        openWindow(model::newProject());
        Answer answer(QStringLiteral("Restore"));
        m_window->begin(other);
        QCOMPARE(answer.question, QString());
        QCOMPARE(savedBytes("restored.hairpaint"), changed);
        QVERIFY(says(QStringLiteral("'other' was not opened")));
    }

    void aFileIsOpenedWhereNothingIsRestored()
    {
        const QString path = m_folder.filePath(QStringLiteral("P.hairpaint"));
        QVERIFY(!crashAfterSaving(path).isEmpty());
        openWindow(model::newProject());
        Answer later(QStringLiteral("Not now"));
        m_window->begin(path);
        QCOMPARE(m_window->files().path(), path);
        QVERIFY(!m_window->isWindowModified());
        QCOMPARE(stack().count(), 0);
        QCOMPARE(foldersLeft(), 1);
    }

    void theFileThatIsToBeOpenedIsOfferedFirst()
    {
        const QString path = m_folder.filePath(QStringLiteral("first.hairpaint"));
        QVERIFY(!crashAfterSaving(path).isEmpty());
        openBald();
        stroke(0.3F);
        crash(); // Later, so it would come first.
        openWindow(model::newProject());
        Answer answer(QStringLiteral("Restore"));
        m_window->begin(path);
        QCOMPARE(answer.offered.size(), 2);
        QVERIFY(answer.offered.front().startsWith(QStringLiteral("first")));
        QCOMPARE(m_window->files().path(), path);
    }

    void manyStepsAreKeptOnceMoreWhenTheyAreRestored()
    {
        openBald();
        model::Document& document = session().document();
        for (int i = 1; i <= 40; ++i) {
            document.push(model::setBackgroundCommand(document, 0xFF000000U + static_cast<unsigned>(i)));
            m_window->keepWork(); // So that none is left out.
        }
        crash();
        for (int turn = 0; turn < 2; ++turn) {
            openWindow(model::newProject());
            Answer answer(QStringLiteral("Restore"));
            offer();
            QCOMPARE(stack().count(), 40);
            crash();
        }
    }

#ifdef Q_OS_LINUX
    void workThatLiesWhereNothingCanBeWrittenIsOffered_data()
    {
        QTest::addColumn<bool>("isFull");
        QTest::newRow("read-only") << false;
        QTest::newRow("full") << true;
    }
    void workThatLiesWhereNothingCanBeWrittenIsOffered()
    {
        QFETCH(bool, isFull);
        openBald();
        stroke(0.5F);
        stroke(0.6F);
        const QByteArray work = savedBytes("work.hairpaint");
        crash();
        leaveLock(onlyFolder());
        const QByteArray place = QFile::encodeName(QFileInfo(JournalFolder::root()).absolutePath());
        {
            const test::FileRefusal refusal(place.constData(),
                                            isFull ? test::FileRefusal::Why::Full : test::FileRefusal::Why::ReadOnly);
            openWindow(model::newProject());
            {
                Answer later(QStringLiteral("Not now"));
                offer();
                QCOMPARE(later.offered.size(), 1);
                QCOMPARE(later.note.isEmpty(), isFull); // What is full can be emptied.
            }
            Answer answer(QStringLiteral("Restore"));
            offer();
            QCOMPARE(answer.offered.size(), 1);
            QCOMPARE(savedBytes("restored.hairpaint"), work);
            QCOMPARE(stack().index(), 2);
            QVERIFY(says(QStringLiteral("no safety copy")));
            QCOMPARE(foldersLeft(), 1); // It is nowhere else.
            const auto other = std::make_unique<MainWindow>(model::newProject(), QString());
            other->offerUnsavedWork(); // Would wait for an answer: but this window has it.
        }
        stroke(0.7F);
        QTRY_VERIFY_WITH_TIMEOUT(!says(QStringLiteral("no safety copy")), kPatienceMs);
        QTRY_COMPARE_WITH_TIMEOUT(foldersLeft(), 1, kPatienceMs); // This window's own.
        const QByteArray more = savedBytes("more.hairpaint");
        crash();
        openWindow(model::newProject());
        Answer again(QStringLiteral("Restore"));
        offer();
        QCOMPARE(again.offered.size(), 1);
        QCOMPARE(savedBytes("again.hairpaint"), more);
        QCOMPARE(stack().index(), 3);
    }

    void whatCantBeRemovedIsNotSaidToBeDiscarded()
    {
        openBald();
        stroke(0.5F);
        crash();
        leaveLock(onlyFolder());
        const QByteArray place = QFile::encodeName(QFileInfo(JournalFolder::root()).absolutePath());
        const test::FileRefusal refusal(place.constData(), test::FileRefusal::Why::ReadOnly);
        openWindow(model::newProject());
        class DiscardThenLater : public Answer
        {
        public:
            DiscardThenLater() : Answer(QStringLiteral("Discard")) {}
            QString refused;

        protected:
            void timerEvent(QTimerEvent* event) override
            {
                auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
                if (box != nullptr && box->text().contains(QStringLiteral("can't be removed"))) {
                    refused = box->text();
                    box->reject();
                } else if (!refused.isEmpty() && box == nullptr) {
                    if (auto* dialog = qobject_cast<RecoveryDialog*>(QApplication::activeModalWidget()))
                        dialog->reject();
                } else {
                    Answer::timerEvent(event);
                }
            }
        } answer;
        offer();
        QVERIFY(answer.refused.contains(QStringLiteral("Untitled")));
        QCOMPARE(foldersLeft(), 1);
        QVERIFY(says(QStringLiteral("unsaved work is kept")));
    }
#endif

    void aFolderThatSomebodyRemovesIsMadeAgain_data()
    {
        QTest::addColumn<bool>("byStep");
        QTest::newRow("with the next step") << true;
        QTest::newRow("when it is looked after") << false;
    }
    void aFolderThatSomebodyRemovesIsMadeAgain()
    {
        QFETCH(bool, byStep);
        openBald();
        stroke(0.4F);
        stroke(0.5F);
        m_window->keepWork();
        QCOMPARE(foldersLeft(), 1);
        QVERIFY(QDir(JournalFolder::root()).removeRecursively());
        if (byStep) {
            stroke(0.6F);
        } else {
            QEvent activated(QEvent::WindowActivate);
            QCoreApplication::sendEvent(m_window.get(), &activated);
        }
        QTRY_COMPARE_WITH_TIMEOUT(foldersLeft(), 1, kPatienceMs);
        const QByteArray work = savedBytes("work.hairpaint");
        crash();
        openWindow(model::newProject());
        Answer answer(QStringLiteral("Restore"));
        offer();
        QCOMPARE(answer.offered.size(), 1);
        QCOMPARE(savedBytes("restored.hairpaint"), work);
        QCOMPARE(stack().index(), byStep ? 3 : 2);
    }

    void aFolderThatCantBeMadeAgainIsTold()
    {
        openBald();
        stroke(0.4F);
        m_window->keepWork();
        QVERIFY(QDir(JournalFolder::root()).removeRecursively());
        test::writeBytes(JournalFolder::root(), "in the way");
        stroke(0.5F);
        QTRY_VERIFY_WITH_TIMEOUT(says(QStringLiteral("no safety copy")), kPatienceMs);
        QVERIFY(QFile::remove(JournalFolder::root()));
    }

#ifdef Q_OS_UNIX
    void nothingIsDeletedThroughALink()
    {
        const QString precious = m_folder.filePath(QStringLiteral("precious"));
        QVERIFY(QDir().mkpath(precious));
        test::writeBytes(precious + QStringLiteral("/file"), "precious");
        const QString folder = makeFolder();
        QVERIFY(QDir().rmdir(folder));
        QVERIFY(QFile::link(precious, folder));
        // In a folder that is one, too.
        const QString left = makeFolder();
        QVERIFY(QFile::link(precious + QStringLiteral("/file"), left + QStringLiteral("/lock")));
        QVERIFY(QFile::link(precious, left + QStringLiteral("/more")));
        openBald();
        offer();
        stroke(0.5F);
        m_window->keepWork();
        QCOMPARE(test::readBytes(precious + QStringLiteral("/file")), QByteArray("precious"));
        QFile::remove(folder);
        QFile::remove(left + QStringLiteral("/more"));
    }

    void aPipeIsNoJournalAndKeepsNobodyWaiting()
    {
        const QString folder = makeFolder();
        QCOMPARE(::mkfifo(QFile::encodeName(folder + QStringLiteral("/journal")).constData(), 0600), 0);
        const QString other = makeFolder();
        QCOMPARE(::mkfifo(QFile::encodeName(other + QStringLiteral("/lock")).constData(), 0600), 0);
        const QString device = makeFolder();
        QVERIFY(QFile::link(QStringLiteral("/dev/zero"), device + QStringLiteral("/journal")));
        openBald();
        offer(); // Would wait for a writer.
        QVERIFY(!m_window->isWindowModified());
    }
#endif

#ifdef Q_OS_LINUX
    void theWindowLivesWhileTheDiskOfTheJournalsIsSilent()
    {
        openBald();
        stroke(0.5F);
        crash();
        openWindow(model::newProject());
        hurryJobs();
        const QByteArray place = QFile::encodeName(JournalFolder::root());
        {
            const test::FileStall stall(place.constData());
            class Cancel : public QObject
            {
            public:
                Cancel() { startTimer(5); }

            protected:
                void timerEvent(QTimerEvent* /*event*/) override
                {
                    QWidget* waiting = QApplication::activeModalWidget();
                    if (waiting != nullptr && waiting->objectName() == QLatin1String("progressWindow") &&
                        test::FileStall::waiting() > 0)
                        static_cast<QDialog*>(waiting)->reject();
                }
            } cancel;
            m_window->offerUnsavedWork();
            QVERIFY2(test::FileStall::askedByMain() == 0, test::FileStall::lastByMain());
            QVERIFY(says(QStringLiteral("does not answer")));
        }
        QTRY_VERIFY_WITH_TIMEOUT(!Jobs::anyLeft(), kPatienceMs);
        Answer answer(QStringLiteral("Restore"));
        offer();
        QCOMPARE(stack().index(), 1);
    }
#endif

    void anOddClockHidesNothing()
    {
        // Of windows that were killed while the clock was wrong by decades, or stood before all times.
        constexpr qint64 kYearMs = qint64{365} * 24 * 3600 * 1000;
        const qint64 now = QDateTime::currentMSecsSinceEpoch();
        const std::array<qint64, 5> times{-kYearMs, 0, now - 30 * kYearMs, now, now + 30 * kYearMs};
        const auto setTime = [](const QString& path, qint64 time) {
            QFile file(path);
            return file.open(QIODevice::ReadWrite) &&
                   file.setFileTime(QDateTime::fromMSecsSinceEpoch(time), QFileDevice::FileModificationTime);
        };
        for (std::size_t i = 0; i < times.size(); ++i) {
            const QString folder = makeFolder();
            const QString journal = folder + QStringLiteral("/journal");
            model::JournalWriter writer(journal);
            QVERIFY(writer.append({.project = model::newProject(),
                                   .path = QStringLiteral("/folder/work %1.hairpaint").arg(i),
                                   .step = {},
                                   .index = 0,
                                   .count = 0,
                                   .timeMs = times[i]}));
            leaveLock(folder);
            QVERIFY(setTime(journal, times[i]));
            QVERIFY(setTime(folder + QStringLiteral("/lock"), times[times.size() - 1 - i]));
        }
        // Nor does it take a lock from a window that lives.
        openBald();
        stroke(0.5F);
        m_window->keepWork();
        for (const QString& name : QDir(JournalFolder::root()).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
            const QString lock = JournalFolder::root() + QLatin1Char('/') + name + QStringLiteral("/lock");
            QVERIFY(setTime(lock, now - 30 * kYearMs));
        }
        const auto other = std::make_unique<MainWindow>(model::newProject(), QString());
        Answer answer(QStringLiteral("Not now"));
        other->offerUnsavedWork();
        QCOMPARE(answer.offered.size(), static_cast<qsizetype>(times.size()));
        for (qsizetype i = 0; i < answer.offered.size(); ++i) // The newest first.
            QVERIFY2(answer.offered[i].startsWith(QStringLiteral("work %1").arg(answer.offered.size() - 1 - i)),
                     qPrintable(answer.offered[i]));
    }

    void whatAJournalSaysOfItselfIsBounded()
    {
        const QString folder = makeFolder();
        {
            model::JournalWriter writer(folder + QStringLiteral("/journal"));
            const QString endless = QLatin1Char('/') + QString(5'000'000, QLatin1Char('n'));
            QVERIFY(writer.append({.project = model::newProject(),
                                   .path = endless,
                                   .step = endless,
                                   .index = 0,
                                   .count = 0,
                                   .timeMs = std::numeric_limits<qint64>::max()}));
        }
        openBald();
        Answer answer(QStringLiteral("Not now"));
        offer();
        QCOMPARE(answer.offered.size(), 1);
        QVERIFY(answer.offered.front().size() < 2000);
    }

    void aJournalThatCantBeReadIsTold()
    {
        openBald();
        stroke(0.5F);
        crash();
        const QString journal = onlyFolder() + QStringLiteral("/journal");
        model::StateFields notOurs;
        notOurs.project = "{}";
        QByteArray bytes = model::recordBytes(model::RecordKind::Start, model::journalStart());
        bytes += model::recordBytes(model::RecordKind::State, model::statePayload(notOurs));
        test::writeBytes(journal, bytes);
        openWindow(model::newProject());
        offer(); // There is nothing to choose from.
        QVERIFY(says(QStringLiteral("damaged")));
        QCOMPARE(foldersLeft(), 1);
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
