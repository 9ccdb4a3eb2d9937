// After a crash the next start gives the work back, with its steps, from whatever was done in the real window.
#include "app/styles/library.h"
#include "model/document/scene_commands.h"
#include "model/journal/journal_reader.h"
#include "tests/app/box_answer.h"
#include "tests/app/recovery_fixture.h"
#include "tests/model/sample_project.h"
#include "tests/support/test_program.h"

namespace hairpaint::app {

class TestRecovery : public QObject, private RecoveryFixture
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareRecovery("hairpaint-recovery-test"); }
    void init() { clearRecovery(); }
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
        openEmpty();
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

        openEmpty();
        RecoveryAnswer answer(QStringLiteral("Restore"));
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
        openEmpty();
        RecoveryAnswer again(QStringLiteral("Restore"));
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
        openEmpty();
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
        openEmpty();
        RecoveryAnswer answer(QStringLiteral("Restore"));
        offer();
        QVERIFY(answer.offered.front().contains(QStringLiteral("kept")));
        QCOMPARE(savedBytes("restored.hairpaint"), changed);
        QCOMPARE(m_window->files().path(), path);
        QVERIFY(m_window->isWindowModified());
    }

    void whatOthersChangedAfterTheCrashIsNotReplacedWithoutAQuestion()
    {
        openBald();
        stroke(0.5F);
        const QString path = m_folder.filePath(QStringLiteral("shared.hairpaint"));
        m_window->files().setPath(path);
        QVERIFY(m_window->files().save());
        stroke(0.6F);
        crash();
        QVERIFY(model::saveProject(starterProject(), path, {}));
        const auto read = [&path] {
            QFile file(path);
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        const QByteArray others = read();
        openEmpty();
        QSignalSpy told(&m_window->files(), &ProjectFiles::changedOutside);
        {
            const RecoveryAnswer answer(QStringLiteral("Restore")); // Not of the question below.
            offer();
        }
        QCOMPARE(m_window->files().path(), path);
        QTRY_COMPARE_WITH_TIMEOUT(told.count(), 1, kPatienceMs);
        BoxAnswer question(QStringLiteral("Cancel"));
        QVERIFY(!m_window->files().save());
        QCOMPARE(question.asked.size(), 1);
        QVERIFY(question.asked.front().contains(QStringLiteral("was changed by another program")));
        QCOMPARE(read(), others);
    }

    void workCanBeLeftForLaterOrDiscarded()
    {
        openBald();
        stroke(0.5F);
        crash();
        openEmpty();
        {
            RecoveryAnswer later(QStringLiteral("Not now"));
            offer();
            QCOMPARE(later.offered.size(), 1);
        }
        QCOMPARE(foldersLeft(), 1);
        QVERIFY(!m_window->isWindowModified());
        RecoveryAnswer discard(QStringLiteral("Discard"));
        offer();
        QVERIFY(discard.question.contains(QStringLiteral("Untitled")));
        QCOMPARE(foldersLeft(), 0);
    }

    void escapeLeavesTheQuestionAndKeepsTheWork()
    {
        openBald();
        stroke(0.5F);
        crash();
        openEmpty();
        const auto kept = [this] {
            const auto labels = m_window->findChild<view::StatusReadout*>()->findChildren<QLabel*>();
            return std::ranges::any_of(labels, [](const QLabel* label) {
                return label->isVisible() && label->text().contains(QStringLiteral("unsaved work is kept"));
            });
        };
        QVERIFY(!kept());
        {
            RecoveryAnswer escape(QStringLiteral("Esc"));
            offer();
            QCOMPARE(escape.offered.size(), 1);
        }
        QVERIFY(kept());
        QCOMPARE(foldersLeft(), 1);
        QVERIFY(!m_window->isWindowModified());
        key(Qt::Key_W); // The window takes keys as ever.
        RecoveryAnswer restore(QStringLiteral("Restore"));
        offer();
        QCOMPARE(restore.offered.size(), 1);
        QCOMPARE(stack().count(), 1);
    }

    void aWindowThatIsOpenIsNotRobbed()
    {
        openBald();
        stroke(0.5F);
        auto other = std::make_unique<MainWindow>(test::smallProject());
        QTRY_COMPARE_WITH_TIMEOUT(foldersLeft(), 1, kPatienceMs);
        other->offerUnsavedWork(); // Would wait for an answer.
        QCOMPARE(foldersLeft(), 1);
    }

    void closingLeavesNothingBehind()
    {
        openBald();
        stroke(0.5F);
        QTRY_COMPARE_WITH_TIMEOUT(foldersLeft(), 1, kPatienceMs);
        RecoveryAnswer discard(QStringLiteral("Discard")); // Answers the question about unsaved changes.
        QVERIFY(m_window->close());
        QCOMPARE(foldersLeft(), 0);
    }

    void whatIsRestoredForTheFileThatIsToBeOpenedIsOpen_data()
    {
        QTest::addColumn<QString>("spelling");
        QTest::newRow("as it was") << QStringLiteral("P.hairpaint");
        QTest::newRow("by a link") << QStringLiteral("link.hairpaint");
        QTest::newRow("by another path") << QStringLiteral("way/../P.hairpaint");
    }
    void whatIsRestoredForTheFileThatIsToBeOpenedIsOpen()
    {
        QFETCH(QString, spelling);
        const QString path = m_folder.filePath(QStringLiteral("P.hairpaint"));
        QVERIFY(QDir().mkpath(m_folder.filePath(QStringLiteral("way"))));
        QFile::link(path, m_folder.filePath(QStringLiteral("link.hairpaint")));
        const QByteArray changed = crashAfterSaving(path);
        QVERIFY(!changed.isEmpty());
        openEmpty();
        RecoveryAnswer answer(QStringLiteral("Restore"));
        m_window->begin(m_folder.filePath(spelling));
        QCOMPARE(answer.offered.size(), 1);
        QCOMPARE(answer.question, QString()); // Nothing is to be saved or discarded.
        QCOMPARE(savedBytes("restored.hairpaint"), changed);
        QCOMPARE(m_window->files().path(), path);
        QVERIFY(m_window->isWindowModified());
        QCOMPARE(stack().index(), 2);
        QCOMPARE(foldersLeft(), 1);
    }

    void anotherFileDoesNotOverwriteWhatIsRestored()
    {
        const QString other = m_folder.filePath(QStringLiteral("other.hairpaint"));
        QVERIFY(model::saveProject(model::newProject(), other, {}));
        const QByteArray changed = crashAfterSaving(m_folder.filePath(QStringLiteral("P.hairpaint")));
        openEmpty();
        RecoveryAnswer answer(QStringLiteral("Restore"));
        m_window->begin(other);
        QCOMPARE(answer.question, QString());
        QCOMPARE(savedBytes("restored.hairpaint"), changed);
        QVERIFY(says(QStringLiteral("'other' was not opened")));
    }

    void aFileIsOpenedWhereNothingIsRestored()
    {
        const QString path = m_folder.filePath(QStringLiteral("P.hairpaint"));
        QVERIFY(!crashAfterSaving(path).isEmpty());
        openEmpty();
        RecoveryAnswer later(QStringLiteral("Not now"));
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
        openEmpty();
        RecoveryAnswer answer(QStringLiteral("Restore"));
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
            openEmpty();
            RecoveryAnswer answer(QStringLiteral("Restore"));
            offer();
            QCOMPARE(stack().count(), 40);
            crash();
        }
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
