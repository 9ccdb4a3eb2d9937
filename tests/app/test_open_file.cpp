// A project's file that others work on too: nothing of theirs is replaced without a question.
#include "model/disk/earlier_versions.h"
#include "model/document/scene_commands.h"
#include "tests/app/box_answer.h"
#include "tests/app/window_fixture.h"
#include "tests/model/archive_maker.h"
#include "tests/support/file_faults.h"
#include "tests/support/test_program.h"
#include "view/widgets/veil.h"

#include <QLabel>

#include <algorithm>

namespace hairpaint::app {

class TestOpenFile : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    QString m_path;

    void openSaved()
    {
        openWindow(test::smallProject());
        m_path = m_folder.filePath(QStringLiteral("shared.hairpaint"));
        QFile::remove(m_path);
        m_window->files().setPath(m_path);
        QVERIFY(m_window->files().save());
    }

    void changeBackground(QRgb colour)
    {
        model::Document& document = session().document();
        document.push(model::setBackgroundCommand(document, colour));
        QVERIFY(document.modified());
    }

    /// Another program writes the file.
    void writeOutside(const QByteArray& bytes)
    {
        QFile file(m_path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }

private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void cleanup() { m_window.reset(); }

    void theHairOfTheProjectBeforeIsNotShownAsTheNewOnes()
    {
        const QString path = m_folder.filePath(QStringLiteral("curls.hairpaint"));
        QVERIFY(model::saveProject(test::smallProject(), path, {}));
        openWindow(starterProject());
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 100, kPatienceMs);
        view::HeadView& area = m_window->headView();
        const auto* veil = area.findChild<view::Veil*>();
        QTRY_VERIFY_WITH_TIMEOUT(area.pictureScene().hair != nullptr, kPatienceMs);
        QVERIFY(!veil->isVisible());
        QStringList told;
        QObject onlooker;
        connect(&m_window->files(), &ProjectFiles::openingBegan, &onlooker, [&] {
            QVERIFY(veil->isVisible());
            told += veil->text();
        });
        QVERIFY(m_window->files().openPath(path));
        QVERIFY(veil->isVisible());
        told += veil->text();
        QVERIFY(area.pictureScene().hair == nullptr);
        area.setFrame(session().frame()); // One of the old ones that comes late.
        QVERIFY(area.pictureScene().hair == nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(!veil->isVisible(), kPatienceMs);
        QVERIFY(area.pictureScene().hair != nullptr);
        QCOMPARE(hairs(), std::size_t{0});
        QCOMPARE(told.size(), 2);
        for (const QString& text : told)
            QVERIFY2(text.contains(QStringLiteral("curls")), qPrintable(text));

        // What can't be opened leaves all as it was.
        test::writeBytes(path, "nothing");
        BoxAnswer answer(QStringLiteral("Cancel"));
        QVERIFY(!m_window->files().openPath(path));
        QVERIFY(!veil->isVisible());
        QVERIFY(area.pictureScene().hair != nullptr);
    }

#ifdef Q_OS_LINUX
    /// A window that was killed leaves its lock, which can't be removed where nothing can be written.
    void aFileIsNotOpenElsewhereWhereALockCantBeRemoved_data()
    {
        QTest::addColumn<bool>("isFull");
        QTest::newRow("read-only") << false;
        QTest::newRow("full") << true;
    }
    void aFileIsNotOpenElsewhereWhereALockCantBeRemoved()
    {
        QFETCH(bool, isFull);
        openSaved();
        const QString locks =
            QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/open/");
        const QString name = QDir(locks).entryList(QDir::Files).value(0);
        QVERIFY(!name.isEmpty());
        m_window.reset();
        QVERIFY(!QFile::exists(locks + name));
        test::writeBytes(locks + name, "999999999\nhairpaint\n");
        openWindow(test::smallProject());
        const QByteArray path = QFile::encodeName(QFileInfo(locks).path());
        const test::FileRefusal refusal(path.constData(),
                                        isFull ? test::FileRefusal::Why::Full : test::FileRefusal::Why::ReadOnly);
        BoxAnswer answer(QStringLiteral("Open anyway"));
        QVERIFY(m_window->files().openPath(m_path));
        QCOMPARE(answer.asked, QStringList());
        const auto other = std::make_unique<MainWindow>(test::smallProject());
        QVERIFY(other->files().openPath(m_path));
        QCOMPARE(answer.asked.size(), 1); // This one is.
    }
#endif

    void savingAgainAsksNothing()
    {
        openSaved();
        BoxAnswer answer(QStringLiteral("Cancel"));
        for (const QRgb colour : {0xFF112233U, 0xFF445566U}) {
            changeBackground(colour);
            QVERIFY(m_window->files().save());
        }
        QCOMPARE(answer.asked, QStringList());
        QVERIFY(!session().document().modified());
    }

    void whatAnotherProgramWroteIsNotReplacedUnasked()
    {
        openSaved();
        writeOutside("theirs");
        changeBackground(0xFF112233U);
        {
            BoxAnswer stop(QStringLiteral("Cancel"));
            QVERIFY(!m_window->files().save());
            QCOMPARE(stop.asked.size(), 1);
            QVERIFY2(stop.asked.front().contains(QStringLiteral("shared")), qPrintable(stop.asked.front()));
        }
        QCOMPARE(test::readBytes(m_path), QByteArray("theirs"));
        QVERIFY(session().document().modified());
        {
            BoxAnswer other(QStringLiteral("Save under another name..."));
            QVERIFY(!m_window->files().save()); // The dialog was cancelled.
        }
        QCOMPARE(test::readBytes(m_path), QByteArray("theirs"));
        BoxAnswer replace(QStringLiteral("Replace"));
        QVERIFY(m_window->files().save());
        QVERIFY(model::loadProject(m_path));
        changeBackground(0xFF778899U);
        QVERIFY(m_window->files().save());
        QCOMPARE(replace.asked.size(), 1);
    }

    void whatAnotherProgramDoesIsSaidAtOnce()
    {
        openSaved();
        changeBackground(0xFF112233U);
        QSignalSpy told(&m_window->files(), &ProjectFiles::changedOutside);
        writeOutside("theirs");
        QTRY_COMPARE_WITH_TIMEOUT(told.size(), 1, kPatienceMs);
        const QString text = told.front().front().toString();
        QVERIFY2(text.contains(QStringLiteral("shared")), qPrintable(text));
        const auto labels = m_window->findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels, [&](const QLabel* label) { return label->text() == text; }));
        m_window->files().lookOutside(); // Said once.
        QVERIFY(QFile::remove(m_path));
        QTRY_COMPARE_WITH_TIMEOUT(told.size(), 2, kPatienceMs);
        QVERIFY(told.back().front().toString() != text);
        QVERIFY(m_window->files().save()); // It is not there to be replaced.
        changeBackground(0xFF445566U);
        QVERIFY(m_window->files().save());
        // What this window does is no news, so the next that is heard of is theirs.
        writeOutside("theirs again");
        QTRY_COMPARE_WITH_TIMEOUT(told.size(), 3, kPatienceMs);
        QCOMPARE(told.back().front().toString(), text);
    }

    void earlierVersionsAreKeptOnDemand()
    {
        openSaved();
        view::Preferences preferences = Settings().preferences();
        QVERIFY(!preferences.earlierVersions);
        QList<QByteArray> saved{test::readBytes(m_path)};
        for (const bool keep : {false, true, true, true, true}) {
            preferences.earlierVersions = keep;
            Settings().setPreferences(preferences);
            m_window.reset();
            openWindow(test::smallProject());
            QVERIFY(m_window->files().openPath(m_path));
            changeBackground(0xFF000000U + static_cast<QRgb>(saved.size()) * 1000U);
            QVERIFY(m_window->files().save());
            saved.prepend(test::readBytes(m_path));
            QCOMPARE(QFile::exists(model::earlierVersion(m_path, 1)), keep);
        }
        for (int number = 1; number <= 3; ++number)
            QVERIFY(test::readBytes(model::earlierVersion(m_path, number)) == saved[number]);
        QVERIFY(!QFile::exists(model::earlierVersion(m_path, 4)));
        QVERIFY(m_window->files().openPath(model::earlierVersion(m_path, 3)));
    }

    void whereItCannotBeSavedAnotherPathIsOffered()
    {
        openSaved();
        const QString folder = m_folder.filePath(QStringLiteral("vanishing"));
        QVERIFY(QDir().mkpath(folder));
        m_window->files().setPath(folder + QStringLiteral("/gone.hairpaint"));
        QVERIFY(QDir(folder).removeRecursively());
        changeBackground(0xFF112233U);
        BoxAnswer other(QStringLiteral("Save under another name..."));
        QVERIFY(!m_window->files().save()); // The dialog was cancelled.
        QCOMPARE(other.asked.size(), 1);
        QVERIFY2(other.asked.front().contains(QStringLiteral("gone.hairpaint")), qPrintable(other.asked.front()));
        QVERIFY(other.sawFileDialog);
        QVERIFY(session().document().modified());
    }

    void aFileThatIsGoneIsWrittenAgain()
    {
        openSaved();
        QVERIFY(QFile::remove(m_path));
        changeBackground(0xFF112233U);
        BoxAnswer answer(QStringLiteral("Cancel"));
        QVERIFY(m_window->files().save());
        QCOMPARE(answer.asked, QStringList());
        QVERIFY(model::loadProject(m_path));
    }

    void anotherWindowThatOpensItIsTold()
    {
        openSaved();
        MainWindow other(test::smallProject());
        {
            BoxAnswer stop(QStringLiteral("Cancel"));
            QVERIFY(!other.files().openPath(m_path));
            QCOMPARE(stop.asked.size(), 1);
            QVERIFY(other.files().path().isEmpty());
        }
        {
            BoxAnswer open(QStringLiteral("Open anyway"));
            QVERIFY(other.files().openPath(m_path));
            QCOMPARE(open.asked.size(), 1);
        }
        // The window that has it open may open it again.
        BoxAnswer answer(QStringLiteral("Cancel"));
        QVERIFY(m_window->files().openPath(m_path));
        QCOMPARE(answer.asked, QStringList());
        m_window.reset();
        MainWindow third(test::smallProject());
        QVERIFY(third.files().openPath(m_path));
        QCOMPARE(answer.asked, QStringList());
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestOpenFile, Widgets)
#include "test_open_file.moc"
