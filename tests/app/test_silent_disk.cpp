// A network folder whose server does not answer: the window lives on, nothing is lost, and another folder can be
// chosen.
#include "app/background/journal_folder.h"
#include "model/document/scene_commands.h"
#include "model/journal/journal_reader.h"
#include "tests/app/box_answer.h"
#include "tests/app/window_fixture.h"
#include "tests/model/archive_maker.h"
#include "tests/support/file_faults.h"
#include "tests/support/test_program.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace hairpaint::app {

#ifdef Q_OS_LINUX
namespace {

/// Cancels what takes long once the window has lived for many moments while the disk is waited for, and gives another
/// path where one is asked for.
class Patient : public BoxAnswer
{
public:
    Patient(const QString& button, QString otherPath = {}) : BoxAnswer(button), m_otherPath(std::move(otherPath)) {}
    int cancelled = 0;

    bool ends(QWidget& dialog) override
    {
        auto* buttons = dialog.findChild<QDialogButtonBox*>();
        if (dialog.objectName() == QLatin1String("progressWindow")) {
            // Elsewhere the disk answers.
            if (m_otherPath.isEmpty() && test::FileStall::waiting() > 0 && ++m_moments > kMoments &&
                buttons->button(QDialogButtonBox::Cancel)->isEnabled()) {
                ++cancelled;
                buttons->button(QDialogButtonBox::Cancel)->click();
            }
            return true;
        }
        if (dialog.inherits("QFileDialog") && !m_otherPath.isEmpty()) {
            dialog.findChild<QLineEdit*>()->setText(m_otherPath);
            for (QAbstractButton* button : buttons->buttons())
                if (buttons->buttonRole(button) == QDialogButtonBox::AcceptRole)
                    button->click();
            return true;
        }
        return false;
    }

private:
    static constexpr int kMoments = 20;
    QString m_otherPath;
    int m_moments = 0;
};

} // namespace
#endif

class TestSilentDisk : public QObject, private WindowFixture
{
    Q_OBJECT
#ifdef Q_OS_LINUX
private:
    QString m_server; ///< The folder.
    QByteArray m_pathBytes;
    QString m_path;

    void openSaved()
    {
        openWindow(test::smallProject());
        hurryJobs();
        m_window->files().setPath(m_path);
        QVERIFY(m_window->files().save());
        // It has looked at what it wrote, and has heard of all that this changed.
        do {
            QTRY_VERIFY_WITH_TIMEOUT(!m_window->files().isLooking(), kPatienceMs);
            test::handleDueEvents();
        } while (m_window->files().isLooking());
        model::Document& document = session().document();
        document.push(model::setBackgroundCommand(document, 0xFF112233U));
    }

private Q_SLOTS:
    void initTestCase()
    {
        prepareApplication();
        m_server = m_folder.filePath(QStringLiteral("server"));
        m_pathBytes = QFile::encodeName(m_server);
        m_path = m_server + QStringLiteral("/shared.hairpaint");
    }
    void init()
    {
        QDir(m_server).removeRecursively();
        QVERIFY(QDir().mkpath(m_server));
        QFile::remove(m_folder.filePath(QStringLiteral("other.hairpaint")));
    }
    void cleanup()
    {
        m_window.reset();
    }

    void whatCantBeSavedStaysOpenAndGoesElsewhere_data()
    {
        QTest::addColumn<QByteArray>("call");
        for (const char* call : {"statx", "open", "write", "fsync"})
            QTest::newRow(call) << QByteArray(call);
    }
    void whatCantBeSavedStaysOpenAndGoesElsewhere()
    {
        QFETCH(QByteArray, call);
        openSaved();
        const QByteArray before = test::readBytes(m_path);
        const QString other = m_folder.filePath(QStringLiteral("other.hairpaint"));
        {
            const test::FileStall stall(m_pathBytes.constData(), call.constData());
            {
                Patient patient(QStringLiteral("Cancel"));
                QVERIFY(!m_window->files().save());
                QCOMPARE(patient.cancelled, 1);
                QCOMPARE(patient.asked.size(), 1);
                QVERIFY2(test::FileStall::askedByMain() == 0, test::FileStall::lastByMain());
                QVERIFY(patient.asked.front().contains(QStringLiteral("shared.hairpaint")));
                QVERIFY(session().document().modified());

                // What waits there is not waited for again.
                QVERIFY(!m_window->files().save());
                QCOMPARE(patient.cancelled, 1);
                QCOMPARE(patient.asked.size(), 2);
            }
            Patient goesElsewhere(QStringLiteral("Save under another name..."), other);
            QVERIFY(m_window->files().save());
            QVERIFY(!session().document().modified());
            QVERIFY(QFile::exists(other));
            QVERIFY2(test::FileStall::askedByMain() == 0, test::FileStall::lastByMain());
        }
        // It was called off, so the one who answers late replaces nothing.
        QTRY_VERIFY_WITH_TIMEOUT(!Jobs::anyLeft(), kPatienceMs);
        QVERIFY(test::readBytes(m_path) == before);
        QCOMPARE(QDir(m_server).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).size(), 1);
        m_window->files().setPath(m_path);
        QVERIFY(m_window->files().save());
        QVERIFY(test::readBytes(m_path) != before);
    }

    void whatDoesNotOpenLeavesTheWindow()
    {
        openSaved();
        m_window->files().setPath({});
        {
            const test::FileStall stall(m_pathBytes.constData());
            Patient patient(QStringLiteral("Cancel"));
            QVERIFY(!m_window->files().openPath(m_path));
            QCOMPARE(patient.cancelled, 1);
            QCOMPARE(patient.asked.size(), 1);
            QVERIFY(patient.asked.front().contains(QStringLiteral("shared.hairpaint")));
            QVERIFY2(test::FileStall::askedByMain() == 0, test::FileStall::lastByMain());
            QVERIFY(m_window->files().path().isEmpty());
        }
        QTRY_VERIFY_WITH_TIMEOUT(!Jobs::anyLeft(), kPatienceMs);
        BoxAnswer discard(QStringLiteral("Discard"));
        QVERIFY(m_window->files().openPath(m_path));
    }

    void theWindowAsksNothingOfItsOwn()
    {
        openSaved();
        QSignalSpy told(&m_window->files(), &ProjectFiles::changedOutside);
        {
            const test::FileStall stall(m_pathBytes.constData());
            m_window->files().lookOutside();
            QTRY_VERIFY_WITH_TIMEOUT(test::FileStall::waiting() > 0, kPatienceMs);
            for (const char* action : {"edit.undo", "edit.redo"})
                m_window->actions().find(QLatin1StringView(action))->trigger();
            BoxAnswer stay(QStringLiteral("Cancel"));
            QVERIFY(!m_window->close()); // It asks.
            QCOMPARE(stay.asked.size(), 1);
            m_window->files().lookOutside();
            test::handleDueEvents();
            QVERIFY2(test::FileStall::askedByMain() == 0, test::FileStall::lastByMain());
            QFile::remove(m_path); // By the main thread, as if by others.
        }
        QTRY_COMPARE_WITH_TIMEOUT(told.size(), 1, kPatienceMs);
    }

    void aSilentDataFolderHoldsNothingUp_data()
    {
        QTest::addColumn<bool>("isSaved");
        QTest::newRow("closed") << true;
        QTest::newRow("ended by the system") << false;
    }
    void aSilentDataFolderHoldsNothingUp()
    {
        QFETCH(bool, isSaved);
        QDir(JournalFolder::root()).removeRecursively(); // What other tests left.
        const QByteArray data = QFile::encodeName(QFileInfo(JournalFolder::root()).absolutePath());
        openSaved();
        m_window->keepWork();
        m_window->journal().setPatience(std::chrono::milliseconds(50));
        const auto* saved = m_window->findChild<QLabel*>(QStringLiteral("saved"));
        {
            const test::FileStall stall(data.constData());
            session().document().push(model::setBackgroundCommand(session().document(), 0xFF445566U));
            QTRY_VERIFY_WITH_TIMEOUT(test::FileStall::waiting() > 0, kPatienceMs);
            QTRY_VERIFY_WITH_TIMEOUT(
                (m_window->journal().lookAfterFolder(), saved->text().contains(QStringLiteral("no safety copy"))),
                kPatienceMs);
            if (isSaved) {
                QVERIFY(m_window->files().save());
                QVERIFY(m_window->close());
            } else {
                m_window->keepWork();
            }
            QVERIFY2(test::FileStall::askedByMain() == 0, test::FileStall::lastByMain());
            m_window.reset();
            QVERIFY(Jobs::anyLeft());
        }
        QTRY_VERIFY_WITH_TIMEOUT(!Jobs::anyLeft(), kPatienceMs);
        // Who answers late still keeps, or removes, what was asked for.
        QCOMPARE(JournalFolder::abandoned(JournalFolder::root()).size(), isSaved ? 0U : 1U);
        for (const auto& folder : JournalFolder::abandoned(JournalFolder::root()))
            folder->remove();
    }

    void aSilentSettingsFolderHoldsNothingUp()
    {
        openSaved();
        const QByteArray config =
            QFile::encodeName(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation));
        {
            const test::FileStall stall(config.constData());
            m_window->resize(m_window->width() - 8, m_window->height());
            m_window->keepWork();
            test::handleDueEvents();
            QTRY_VERIFY_WITH_TIMEOUT(test::FileStall::waiting() > 0, kPatienceMs);
            m_window.reset();
            QVERIFY2(test::FileStall::askedByMain() == 0, test::FileStall::lastByMain());
            QVERIFY(Jobs::anyLeft());
        }
        QTRY_VERIFY_WITH_TIMEOUT(!Jobs::anyLeft(), kPatienceMs);
    }

    void stepsThatWaitForASilentDiskAreOfTheirOwnHistory()
    {
        const QTemporaryDir root;
        const QByteArray rootBytes = QFile::encodeName(root.path());
        model::Document document(model::newProject());
        const auto step = [&document](unsigned number) {
            document.push(model::setBackgroundCommand(document, 0xFF000000U | number));
        };
        model::Project other = model::newProject();
        other.seed = 7;
        Journal journal(document, root.path());
        journal.setPatience(std::chrono::milliseconds(20));
        step(1);
        journal.flush();
        {
            const test::FileStall stall(rootBytes.constData());
            for (unsigned i = 2; i < 12; ++i)
                step(i);
            document.replace(other);
            test::handleDueEvents();
            for (unsigned i = 1; i < 19; ++i) // So many that the steps left of both histories would be one row.
                step(i);
            test::handleDueEvents();
            QVERIFY2(test::FileStall::askedByMain() == 0, test::FileStall::lastByMain());
        }
        journal.flush();
        QTRY_VERIFY_WITH_TIMEOUT(journal.idle(), kPatienceMs);
        const QStringList folders = QDir(root.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
        QCOMPARE(folders.size(), 1);
        const auto work = model::readJournal(root.filePath(folders.front() + u'/' + JournalFolder::fileName()));
        QVERIFY(work && *work);
        QCOMPARE((*work)->steps.at((*work)->current).index, 18);
        for (const model::JournalState& state : (*work)->steps)
            QCOMPARE(state.project.seed, other.seed);
    }
#endif
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestSilentDisk, Widgets)
#include "test_silent_disk.moc"
