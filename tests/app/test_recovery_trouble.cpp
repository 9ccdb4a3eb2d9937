// Unsaved work where disks, links and other programs are against it: it is offered, or it is told why not, and
// nothing of anybody else's is touched.
#include "app/recovery/recovery.h"
#include "model/journal/journal_format.h"
#include "model/journal/journal_records.h"
#include "model/journal/journal_writer.h"
#include "tests/app/recovery_fixture.h"
#include "tests/support/file_faults.h"
#include "tests/support/test_program.h"

#include <limits>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

namespace hairpaint::app {

class TestRecoveryTrouble : public QObject, private RecoveryFixture
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareRecovery("hairpaint-trouble-test"); }
    void init() { clearRecovery(); }
    void cleanup() { m_window.reset(); }

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
        const QByteArray path = QFile::encodeName(QFileInfo(JournalFolder::root()).absolutePath());
        {
            const test::FileRefusal refusal(path.constData(),
                                            isFull ? test::FileRefusal::Why::Full : test::FileRefusal::Why::ReadOnly);
            openEmpty();
            {
                RecoveryAnswer later(QStringLiteral("Not now"));
                offer();
                QCOMPARE(later.offered.size(), 1);
                QCOMPARE(later.note.isEmpty(), isFull); // What is full can be emptied.
            }
            RecoveryAnswer answer(QStringLiteral("Restore"));
            offer();
            QCOMPARE(answer.offered.size(), 1);
            QCOMPARE(savedBytes("restored.hairpaint"), work);
            QCOMPARE(stack().index(), 2);
            QVERIFY(says(QStringLiteral("no safety copy")));
            QCOMPARE(foldersLeft(), 1); // It is nowhere else.
            const auto other = std::make_unique<MainWindow>(test::smallProject());
            other->offerUnsavedWork(); // Would wait for an answer: but this window has it.
        }
        stroke(0.7F);
        QTRY_VERIFY_WITH_TIMEOUT(!says(QStringLiteral("no safety copy")), kPatienceMs);
        QTRY_COMPARE_WITH_TIMEOUT(foldersLeft(), 1, kPatienceMs); // This window's own.
        const QByteArray more = savedBytes("more.hairpaint");
        crash();
        openEmpty();
        RecoveryAnswer again(QStringLiteral("Restore"));
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
        const QByteArray path = QFile::encodeName(QFileInfo(JournalFolder::root()).absolutePath());
        const test::FileRefusal refusal(path.constData(), test::FileRefusal::Why::ReadOnly);
        openEmpty();
        class DiscardThenLater : public RecoveryAnswer
        {
        public:
            DiscardThenLater() : RecoveryAnswer(QStringLiteral("Discard")) {}
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
                    RecoveryAnswer::timerEvent(event);
                }
            }
        } answer;
        offer();
        QVERIFY(answer.refused.contains(QStringLiteral("Untitled")));
        QCOMPARE(foldersLeft(), 1);
        QVERIFY(says(QStringLiteral("unsaved work is kept")));
    }
#endif

#ifdef Q_OS_UNIX // Nobody removes the folder of a file that is open on Windows.
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
        openEmpty();
        RecoveryAnswer answer(QStringLiteral("Restore"));
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
        openEmpty();
        hurryJobs();
        const QByteArray path = QFile::encodeName(JournalFolder::root());
        {
            const test::FileStall stall(path.constData());
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
        RecoveryAnswer answer(QStringLiteral("Restore"));
        offer();
        QCOMPARE(stack().index(), 1);
    }

    void theEndOfTheProgramKnowsOfASweepOnASilentDisk()
    {
        const QByteArray folder = QFile::encodeName(JournalFolder::root());
        {
            const test::FileStall stall(folder.constData());
            sweepBeside({JournalFolder::root() + QStringLiteral("/hair.hairpaint")});
            QTRY_VERIFY_WITH_TIMEOUT(test::FileStall::waiting() > 0, kPatienceMs);
            QVERIFY(Jobs::anyLeft());
        }
        QTRY_VERIFY_WITH_TIMEOUT(!Jobs::anyLeft(), kPatienceMs);
    }
#endif

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
        RecoveryAnswer answer(QStringLiteral("Not now"));
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
        openEmpty();
        offer(); // There is nothing to choose from.
        QVERIFY(says(QStringLiteral("damaged")));
        QCOMPARE(foldersLeft(), 1);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestRecoveryTrouble, Widgets)
#include "test_recovery_trouble.moc"
