// Folders that can't be written, full disks, and outputs that are inputs: one line on standard error names the file,
// the code is 1, nothing is written, and what was there stays.
#include "app/headless/picture.h"
#include "model/files/project_file.h"
#include "model/formats/export_format.h"
#include "tests/app/program.h"
#include "tests/app/thin_project.h"
#include "tests/model/archive_maker.h"
#include "tests/model/sample_project.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QImage>
#include <QTemporaryDir>
#include <QtTest>

#ifdef Q_OS_UNIX
#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

#ifdef Q_OS_LINUX
void limitFiles(qint64 bytes)
{
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit most{};
    getrlimit(RLIMIT_FSIZE, &most);
    most.rlim_cur = static_cast<rlim_t>(bytes);
    setrlimit(RLIMIT_FSIZE, &most);
}

#endif

} // namespace

class TestUnwritablePaths : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    QString m_good; ///< A small project.

    [[nodiscard]] QString path(const QString& name) const { return m_folder.filePath(name); }

private Q_SLOTS:
    void initTestCase()
    {
        m_good = path(QStringLiteral("good.hairpaint"));
        QVERIFY(model::saveProject(smallProject(), m_good, {}));
    }

    void whatCantBeWrittenEndsWithOneSentence_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("named");
        const auto rows = [this](const char* name, const QString& path) {
            const QByteArray row(name);
            QTest::newRow((row + ", new").constData())
                << QStringList{QStringLiteral("new"), QStringLiteral("-o"), path + QStringLiteral(".hairpaint")}
                << path + QStringLiteral(".hairpaint");
            for (const model::ExportFormat& format : model::exportFormats()) {
                const QString output = path + QLatin1Char('.') + QLatin1StringView(format.suffix);
                QStringList arguments{QStringLiteral("export"), m_good, QStringLiteral("-o"), output};
                if (format.hasCards)
                    arguments += QStringLiteral("--cards");
                QTest::newRow((row + ", export " + format.id).constData()) << arguments << output;
            }
            QTest::newRow((row + ", render").constData())
                << QStringList{QStringLiteral("render"), m_good,
                               QStringLiteral("-o"),     path + QStringLiteral(".png"),
                               QStringLiteral("--size"), QStringLiteral("128x128")}
                << path + QStringLiteral(".png");
        };
        QStringList endings{QStringLiteral("hairpaint"), QStringLiteral("png")};
        for (const model::ExportFormat& format : model::exportFormats())
            endings += QString::fromLatin1(format.suffix);
        rows("no such folder", path(QStringLiteral("nowhere/out")));
        for (const QString& ending : endings)
            QVERIFY(QDir().mkpath(path(QStringLiteral("folder.") + ending)));
        rows("a folder", path(QStringLiteral("folder")));
#ifdef Q_OS_LINUX
        rows("a path for no one", QStringLiteral("/proc/out"));
        for (const auto& [verb, output] : {std::pair("render", "/proc/out.png"), std::pair("export", "/proc/out.hair")})
            QTest::newRow(qPrintable(QStringLiteral("a path for no one, film, %1").arg(QLatin1StringView(verb))))
                << QStringList{QLatin1StringView(verb),    m_good,
                               QStringLiteral("-o"),       QLatin1StringView(output),
                               QStringLiteral("--frames"), QStringLiteral("0-1")}
                << QStringLiteral("/proc/out.0000");
        QTest::newRow("a path for no one, maps")
            << QStringList{QStringLiteral("export"), m_good, QStringLiteral("--maps"), QStringLiteral("/proc")}
            << QStringLiteral("/proc/Scalp-density.png");
        // As root a file could be renamed over a device.
        for (const QString& ending : endings) {
            QFile::link(QStringLiteral("/dev/full"), path(QStringLiteral("device.") + ending));
            QFile::link(QStringLiteral("round.") + ending, path(QStringLiteral("round.") + ending));
            ::mkfifo(QFile::encodeName(path(QStringLiteral("pipe.") + ending)).constData(), 0600);
        }
        rows("a device", path(QStringLiteral("device")));
        rows("a pipe", path(QStringLiteral("pipe")));
        rows("a link to itself", path(QStringLiteral("round")));
        rows("a name too long", path(QString(300, QLatin1Char('n'))));
#endif
        QVERIFY(QDir().mkpath(path(QStringLiteral("film.0002.png"))));
        QTest::newRow("a film's third frame")
            << QStringList{QStringLiteral("render"),   m_good,
                           QStringLiteral("-o"),       path(QStringLiteral("film.png")),
                           QStringLiteral("--frames"), QStringLiteral("0-4"),
                           QStringLiteral("--size"),   QStringLiteral("128x128")}
            << QStringLiteral("film.0002.png");
    }

    void whatCantBeWrittenEndsWithOneSentence()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, named);
        QCOMPARE(faultOf(m_folder.path(), arguments, named), QString());
    }

#ifdef Q_OS_UNIX // What Qt makes for a link on Windows is a shortcut, a file of its own.
    /// Every verb, through a link to what is not there yet: the link stays, and what it leads to is written.
    void anOutputThatIsALinkIsFollowed_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QString>("written"); // What the link's name has before its ending.
        const auto row = [](const char* name, const QStringList& arguments, const char* ending,
                            const QString& written = {}) {
            QTest::newRow(name) << arguments << QString::fromLatin1(ending) << written;
        };
        row("new", {QStringLiteral("new")}, "hairpaint");
        row("repair", {QStringLiteral("repair"), m_good}, "hairpaint");
        for (const model::ExportFormat& format : model::exportFormats())
            if (!format.isAvatar) // Avatars need other heads.
                row(format.id,
                    QStringList{QStringLiteral("export"), m_good} +
                        (format.hasCards ? QStringList{QStringLiteral("--cards")} : QStringList()),
                    format.suffix);
        const QStringList small{QStringLiteral("render"),   m_good,
                                QStringLiteral("--size"),   QStringLiteral("32x32"),
                                QStringLiteral("--settle"), QStringLiteral("0")};
        row("render", small, "png");
        row("render, linear", small, "exr");
        row("film", small + QStringList{QStringLiteral("--frames"), QStringLiteral("0-0")}, "png",
            QStringLiteral(".0000"));
    }
    void anOutputThatIsALinkIsFollowed()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, ending);
        QFETCH(QString, written);
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("there")));
        const QString aim = folder.filePath(QStringLiteral("there/aim"));
        const QString link = folder.filePath(QStringLiteral("link") + written + QLatin1Char('.') + ending);
        QVERIFY(QFile::link(aim, link));
        for (const char* run : {"nothing there yet", "a file there"}) {
            const Outcome outcome = runProgram(
                arguments + QStringList{QStringLiteral("-o"), folder.filePath(QStringLiteral("link.") + ending)});
            QCOMPARE(outcome.error, QString());
            QVERIFY2(QFileInfo(aim).size() > 0 && !QFileInfo(aim).isSymbolicLink(), run);
            QVERIFY2(QFileInfo(link).isSymbolicLink(), run);
            test::writeBytes(aim, {});
        }
    }
#endif

#ifdef Q_OS_LINUX
    /// A link of the kernel's that leads nowhere would be replaced by a file, where root is asked to.
    void standardOutputTakesNoFile()
    {
        const QString link = path(QStringLiteral("out.hairpaint"));
        QVERIFY(QFile::link(QStringLiteral("/proc/self/fd/1"), link));
        for (const bool isOpen : {true, false}) {
            const QString fault = faultOf(m_folder.path(), {QStringLiteral("new"), QStringLiteral("-o"), link},
                                          QStringLiteral("out.hairpaint"), [isOpen] {
                                              if (!isOpen)
                                                  ::close(STDOUT_FILENO);
                                          });
            QCOMPARE(fault, QString());
            QVERIFY(QFileInfo(link).isSymbolicLink());
        }
        QVERIFY(QFile::remove(link));
    }
#endif

    void aSourceIsNeverOverwritten()
    {
        const QString image = path(QStringLiteral("image.hairpaint"));
        writeBytes(image, pngOf(1, 1, 8, 2, packedZeros(4)));
        const QByteArray before = contentOf(image);
        QCOMPARE(faultOf(m_folder.path(),
                         {QStringLiteral("new"), QStringLiteral("-o"), image, QStringLiteral("--map"),
                          QStringLiteral("density=") + image},
                         QStringLiteral("image.hairpaint")),
                 QString());
        QVERIFY(contentOf(image) == before);
        const QString project = path(QStringLiteral("project.hair"));
        QVERIFY(QFile::copy(m_good, project));
        QCOMPARE(faultOf(m_folder.path(), {QStringLiteral("export"), project, QStringLiteral("-o"), project},
                         QStringLiteral("project.hair")),
                 QString());
        QVERIFY(contentOf(project) == contentOf(m_good));
    }

#ifdef Q_OS_LINUX
    /// A limit on a file's size fails writes as a full disk does.
    void aFullDiskEndsWithOneSentenceAndTheOldFile_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("output");
        const QString project = path(QStringLiteral("full.hairpaint"));
        const QString styled = path(QStringLiteral("styled.hairpaint"));
        QCOMPARE(runProgram({QStringLiteral("new"), QStringLiteral("-o"), styled, QStringLiteral("--preset"),
                             QStringLiteral("Buzz cut")})
                     .code,
                 0);
        QVERIFY(thinOut(styled));
        QTest::newRow("new") << QStringList{QStringLiteral("new"), QStringLiteral("-o"), project,
                                            QStringLiteral("--preset"), QStringLiteral("Buzz cut")}
                             << project;
        for (const model::ExportFormat& format : model::exportFormats()) {
            if (format.isAvatar) // Avatars need other heads; their files are written as those of cards are.
                continue;
            const QString hair = path(QStringLiteral("full.") + QLatin1StringView(format.suffix));
            QTest::newRow(format.suffix) << QStringList{QStringLiteral("export"),  styled,
                                                        QStringLiteral("-o"),      hair,
                                                        QStringLiteral("--hairs"), QStringLiteral("5000")}
                                         << hair;
        }
    }

    void aFullDiskEndsWithOneSentenceAndTheOldFile()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, output);
        QCOMPARE(runProgram(arguments).code, 0);
        const qint64 whole = QFileInfo(output).size();
        for (const qint64 room : {qint64{20'000}, whole - 16'000, whole - 1}) {
            writeBytes(output, "old");
            QCOMPARE(faultOf(m_folder.path(), arguments, QFileInfo(output).fileName(), [room] { limitFiles(room); }),
                     QString());
            QCOMPARE(contentOf(output), QByteArray("old"));
        }
    }

    /// On a disk of 64 kB, where the system lets anyone mount one.
    void aFilmOnAFullDiskLeavesNoPictures()
    {
        const auto onSmallDisk = [this](const QString& command) {
            QProcess process;
            process.start(QStringLiteral("unshare"),
                          {QStringLiteral("--mount"), QStringLiteral("--map-root-user"), QStringLiteral("sh"),
                           QStringLiteral("-c"), QStringLiteral("mount -t tmpfs -o size=64k none \"$1\" && ") + command,
                           QStringLiteral("sh"), path(QStringLiteral("disk")), test::hairpaintProgram(), m_good});
            process.waitForFinished(-1);
            return Outcome{.code = process.exitCode(),
                           .output = QString::fromUtf8(process.readAllStandardOutput()),
                           .error = QString::fromUtf8(process.readAllStandardError())};
        };
        QVERIFY(QDir().mkpath(path(QStringLiteral("disk"))));
        if (onSmallDisk(QStringLiteral("true")).code != 0)
            return; // The pictures themselves are written to a full disk by the test below, everywhere.
        // The disk is filled up to a few bytes, so that pictures begin and do not end.
        const Outcome film = onSmallDisk(
            QStringLiteral("head -c 63000 /dev/zero > \"$1/full\"; \"$2\" render \"$3\" -o \"$1/film.png\" --size "
                           "32x32 --settle 0 --frames 0-3; code=$?; ls -A \"$1\"; exit $code"));
        QCOMPARE(film.code, 1);
        QCOMPARE(film.output, QStringLiteral("full\n"));
        QCOMPARE(film.error.count(QLatin1Char('\n')), 1);
        QVERIFY2(film.error.contains(QStringLiteral("no space left")), qPrintable(film.error));
    }

    /// In this process: software OpenGL keeps files of its own, so the whole verb can't be limited.
    void aPictureOnAFullDiskIsOneSentenceAndTheOldFile_data()
    {
        QTest::addColumn<int>("side");
        QTest::newRow("large") << 256;
        QTest::newRow("within one buffer") << 16;
    }
    void aPictureOnAFullDiskIsOneSentenceAndTheOldFile()
    {
        const QString picture = path(QStringLiteral("full.png"));
        writeBytes(picture, "old");
        QFETCH(int, side);
        QImage noise(side, side, QImage::Format_RGB32);
        for (int y = 0; y < noise.height(); ++y)
            for (int x = 0; x < noise.width(); ++x)
                noise.setPixel(x, y, static_cast<uint>(qHash(y * 256 + x)));
        rlimit before{};
        getrlimit(RLIMIT_FSIZE, &before);
        limitFiles(side == 16 ? 400 : 20'000);
        const model::Result<void> written = app::writePicture(noise, picture);
        setrlimit(RLIMIT_FSIZE, &before);
        QVERIFY(!written);
        QVERIFY2(isOneSentenceNaming(written.error().message, picture), qPrintable(written.error().message));
        QCOMPARE(contentOf(picture), QByteArray("old"));
        QVERIFY(app::writePicture(noise, picture));
    }
#endif
};

HAIRPAINT_TEST(TestUnwritablePaths, Core)
#include "test_unwritable_paths.moc"
