// File dialogs begin where there is something, and no file is replaced without a question, also where the dialog was
// given its name without the ending.
#include "app/settings/file_dialogs.h"
#include "tests/app/window_fixture.h"
#include "tests/model/archive_maker.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"
#include "view/dialogs/export_hair_dialog.h"
#include "view/dialogs/export_maps_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

namespace hairpaint::app {

namespace {

/// Types names into file dialogs, one after another, and answers what is asked then.
class Saver : public QObject
{
public:
    QStringList names; ///< The dialog is cancelled once there is none left.
    bool replaces = false;
    QStringList asked;
    QString begun; ///< The folder that the last dialog began in.

    Saver() { startTimer(20); }

protected:
    void timerEvent(QTimerEvent* /*event*/) override
    {
        QWidget* waiting = QApplication::activeModalWidget();
        if (auto* files = qobject_cast<QFileDialog*>(waiting)) {
            begun = files->directory().absolutePath();
            if (names.isEmpty())
                return files->reject();
            files->findChild<QLineEdit*>()->setText(names.takeFirst());
            for (QAbstractButton* button : files->findChild<QDialogButtonBox*>()->buttons())
                if (files->findChild<QDialogButtonBox*>()->buttonRole(button) == QDialogButtonBox::AcceptRole)
                    return button->click();
        } else if (auto* choice = qobject_cast<view::ExportMapsDialog*>(waiting)) {
            choice->accept();
        } else if (auto* box = qobject_cast<QMessageBox*>(waiting)) {
            asked += box->text();
            QAbstractButton* answer = box->button(replaces ? QMessageBox::Yes : QMessageBox::No);
            (answer != nullptr ? answer : box->buttons().front())->click();
        }
    }
};

} // namespace

class TestFileDialogs : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    /// Dialogs beside the window go on to the file's with Enter.
    void trigger(const QByteArray& action)
    {
        m_window->actions().find(QLatin1StringView(action))->trigger();
        for (const QPointer<QDialog>& dialog : openDialogs(*m_window)) {
            if (auto* exported = qobject_cast<view::ExportHairDialog*>(dialog))
                Q_EMIT exported->exportWanted(); // Also of a head without hair.
            else
                QTest::keyClick(dialog, Qt::Key_Return);
            if (dialog && dialog->isVisible())
                dialog->reject();
        }
    }

private Q_SLOTS:
    void initTestCase()
    {
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        qputenv("HAIRPAINT_IMPORT", test::importProgram().toLocal8Bit());
        prepareApplication();
    }
    void cleanup() { m_window.reset(); }

    void whatIsThereIsReplacedOnlyAfterAsking_data()
    {
        QTest::addColumn<QByteArray>("action");
        QTest::addColumn<QString>("suffix");
        QTest::newRow("project") << QByteArray("file.saveAs") << QStringLiteral(".hairpaint");
        QTest::newRow("hair") << QByteArray("file.exportHair") << QStringLiteral(".hair");
        QTest::newRow("picture") << QByteArray("file.picture") << QStringLiteral(".png");
        QTest::newRow("map") << QByteArray("file.saveImage") << QStringLiteral(".png");
    }
    void whatIsThereIsReplacedOnlyAfterAsking()
    {
        QFETCH(QByteArray, action);
        QFETCH(QString, suffix);
        openWindow(test::smallProject());
        const QString bare = m_folder.filePath(QStringLiteral("taken"));
        const QString other = m_folder.filePath(QStringLiteral("other")) + suffix;
        test::writeBytes(bare + suffix, "old");
        QFile::remove(other);
        Saver saver;

        // Without the ending, with it, and then given up.
        saver.names = {bare, bare + suffix};
        trigger(action);
        QCOMPARE(saver.asked.size(), 2);
        for (const QString& question : saver.asked)
            QVERIFY2(question.contains(QStringLiteral("taken") + suffix), qPrintable(question));
        QCOMPARE(test::readBytes(bare + suffix), QByteArray("old"));

        // Another name needs no question.
        saver.names = {bare, other};
        trigger(action);
        QCOMPARE(saver.asked.size(), 3);
        QVERIFY(QFileInfo::exists(other));
        QCOMPARE(test::readBytes(bare + suffix), QByteArray("old"));

        saver.replaces = true;
        saver.names = {bare};
        trigger(action);
        QCOMPARE(saver.asked.size(), 4);
        QVERIFY(test::readBytes(bare + suffix).size() > 100);
    }

    /// The ending comes after one dot, as on systems that have no names with a dot at their end.
    void aDotAtTheEndIsTheEndingsOwn()
    {
        openWindow(test::smallProject());
        Saver saver;
        saver.names = {m_folder.filePath(QStringLiteral("dot."))};
        trigger("file.saveAs");
        QVERIFY(QFileInfo::exists(m_folder.filePath(QStringLiteral("dot.hairpaint"))));
    }

#ifdef Q_OS_UNIX
    void whatIsChosenIsFollowedOrRefusedAsWhatItIs()
    {
        openWindow(test::smallProject());
        const QString link = m_folder.filePath(QStringLiteral("link.hairpaint"));
        const QString aim = m_folder.filePath(QStringLiteral("aim"));
        QVERIFY(QFile::link(aim, link));
        Saver saver;
        saver.names = {link};
        trigger("file.saveAs");
        QCOMPARE(saver.asked, QStringList());
        QVERIFY(QFileInfo(link).isSymbolicLink() && QFileInfo(aim).size() > 100);

        const QString pipe = m_folder.filePath(QStringLiteral("pipe.hairpaint"));
        QCOMPARE(::mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
        saver.names = {pipe};
        trigger("file.saveAs");
        QCOMPARE(saver.asked.size(), 1);
        QVERIFY2(saver.asked.front().contains(QStringLiteral("it is a pipe")), qPrintable(saver.asked.front()));
        QVERIFY(QFile::remove(pipe) && QFile::remove(link));
    }
#endif

    void aFolderThatIsGoneIsNotProposed()
    {
        openWindow(test::smallProject());
        const QString there = QFileInfo(m_folder.path()).canonicalFilePath();
        for (const char* action : {"file.open", "file.saveAs", "file.importHead", "file.importHair", "file.exportHair",
                                   "file.picture", "file.loadImage", "file.saveImage", "file.saveImages"}) {
            Settings().setLastFolder(there + QStringLiteral("/gone/deeper"));
            Saver saver; // Cancels.
            trigger(action);
            QVERIFY2(saver.begun == there, action);
        }
    }

    void theNearestFolderIsTheUsers_data()
    {
        QTest::addColumn<QString>("wanted");
        QTest::addColumn<bool>("isFound");
        const QString folder = m_folder.path();
        QTest::newRow("there") << folder << true;
        QTest::newRow("gone") << folder + QStringLiteral("/a") << true;
        QTest::newRow("gone with those around it") << folder + QStringLiteral("/a/b/c") << true;
        QTest::newRow("a file by now") << folder + QStringLiteral("/file") << true;
        QTest::newRow("a disk that is gone") << QStringLiteral("/no-such-disk/work") << false;
        QTest::newRow("none") << QString() << false;
    }
    void theNearestFolderIsTheUsers()
    {
        QFETCH(QString, wanted);
        QFETCH(bool, isFound);
        test::writeBytes(m_folder.filePath(QStringLiteral("file")), "x");
        const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
        const QString usual = QFileInfo(documents).isDir() ? documents : QDir::homePath();
        QCOMPARE(nearestFolder(wanted), isFound ? m_folder.path() : usual);
    }

    void aDotInTheNameIsNoEnding()
    {
        openWindow(test::smallProject());
        const QString name = m_folder.filePath(QStringLiteral("take 1.2"));
        for (const auto& [action, suffix] : std::initializer_list<std::pair<const char*, const char*>>{
                 {"file.saveAs", ".hairpaint"},
                 {"file.exportHair", ".hair"},
                 {"file.picture", ".png"},
                 {"file.saveImage", ".png"},
                 {"file.uvSheet", ".pdf"},
             }) {
            const QString file = name + QLatin1StringView(suffix);
            QFile::remove(file);
            Saver saver;
            saver.names = {name};
            trigger(action);
            QVERIFY2(QFileInfo::exists(file) && !QFileInfo::exists(name), action);
        }
    }

    void anEndingOfTheSameKindIsKept()
    {
        openWindow(test::smallProject());
        for (const auto& [action, name] : std::initializer_list<std::pair<const char*, const char*>>{
                 {"file.exportHair", "other.obj"},
                 {"file.uvSheet", "sheet.svg"},
                 {"file.saveImage", "MAP.TGA"},
                 {"file.saveImage", "map.tiff"},
                 {"file.picture", "picture.exr"},
                 {"file.picture", "picture.jpeg"},
             }) {
            const QString file = m_folder.filePath(QLatin1StringView(name));
            Saver saver;
            saver.names = {file};
            trigger(action);
            QVERIFY2(QFileInfo::exists(file), name);
        }
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestFileDialogs, Widgets)
#include "test_file_dialogs.moc"
