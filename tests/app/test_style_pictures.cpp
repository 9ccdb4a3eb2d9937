// Pictures of styles without one: the styles' own files stay as their owner leaves them.
#include "app/styles/library.h"
#include "app/styles/style_pictures.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/project/worn.h"
#include "tests/app/picture_difference.h"
#include "tests/app/window_fixture.h"
#include "tests/support/file_faults.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QSignalSpy>

#include <optional>

#ifdef Q_OS_LINUX
#include <sys/stat.h>
#endif

namespace hairpaint::app {

namespace {

QByteArray bytesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QImage plain(QColor colour)
{
    QImage image(192, 192, QImage::Format_RGB32);
    image.fill(colour);
    return image;
}

} // namespace

class TestStylePictures : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    QWidget m_window;

    /// A style without a picture; `name` tells one from the other.
    [[nodiscard]] QString style(const char* file, const QString& name)
    {
        const QString path = m_folder.filePath(QString::fromLatin1(file));
        return model::savePreset(model::presetFrom(model::newProject(), name), path) ? path : QString();
    }

private Q_SLOTS:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void init() { QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation)).removeRecursively(); }

    void aPictureComesAndTheFileStaysAsItIs()
    {
        const QString path = style("calm.hairpreset", QStringLiteral("Calm"));
        const QByteArray before = bytesOf(path);
        Jobs jobs(m_window);
        StylePictures pictures(jobs);
        QSignalSpy made(&pictures, &StylePictures::made);
        pictures.make(path);
        QTRY_COMPARE_WITH_TIMEOUT(made.size(), 1, kPatienceMs);
        QCOMPARE(made.front().at(0).toString(), path);
        QCOMPARE(made.front().at(1).value<QImage>().size(), QSize(192, 192));
        QVERIFY(bytesOf(path) == before);
    }

    void aTieBehindTheHeadIsSeen()
    {
        const auto pictureWithTie = [](glm::vec3 towardHd) {
            model::Project project = test::smallProject();
            if (towardHd != glm::vec3(0.0F)) {
                const sim::SurfacePoint point = project.head->skin->nearest(towardHd);
                project.worn.push_back(model::makeWorn(model::wornSpec(model::WornKind::Ponytail), point, 0));
            }
            return projectPicture(project);
        };
        const QImage without = pictureWithTie(glm::vec3(0.0F));
        QVERIFY(!without.isNull());
        QVERIFY(test::meanDifference(pictureWithTie({0.0F, 0.1F, 0.2F}), without) < 1.0);
        QVERIFY(test::meanDifference(pictureWithTie({0.0F, 0.0F, -0.2F}), without) > 3.0);
    }

    void aPictureIsDrawnOnceForWhatAFileHolds()
    {
        const QString path = style("once.hairpreset", QStringLiteral("Once"));
        Jobs jobs(m_window);
        std::atomic<int> drawn = 0;
        StylePictures pictures(jobs, [&drawn](const model::Preset&, const model::Progress&) {
            ++drawn;
            return plain(Qt::red);
        });
        QSignalSpy made(&pictures, &StylePictures::made);
        pictures.make(path);
        QTRY_COMPARE_WITH_TIMEOUT(made.size(), 1, kPatienceMs);
        pictures.make(path);
        QTRY_COMPARE_WITH_TIMEOUT(made.size(), 2, kPatienceMs);
        QCOMPARE(drawn.load(), 1);
        QCOMPARE(made.back().at(1).value<QImage>().pixelColor(9, 9), QColor(Qt::red));
        QVERIFY(!style("once.hairpreset", QStringLiteral("Another")).isEmpty());
        pictures.make(path);
        QTRY_COMPARE_WITH_TIMEOUT(made.size(), 3, kPatienceMs);
        QCOMPARE(drawn.load(), 2);
    }

#ifdef Q_OS_LINUX
    void aCacheThatTakesNothingCostsNoPicture_data()
    {
        QTest::addColumn<QString>("trouble");
        for (const char* trouble : {"read-only", "full", "deleted", "a file", "links", "pipes"})
            QTest::newRow(trouble) << QString::fromLatin1(trouble);
    }
    void aCacheThatTakesNothingCostsNoPicture()
    {
        QFETCH(QString, trouble);
        const QString path = style("trouble.hairpreset", QStringLiteral("Trouble"));
        const QString cache =
            QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/style-pictures");
        Jobs jobs(m_window);
        StylePictures pictures(jobs, [](const model::Preset&, const model::Progress&) { return plain(Qt::red); });
        const QSignalSpy made(&pictures, &StylePictures::made);
        pictures.make(path);
        QTRY_COMPARE_WITH_TIMEOUT(made.size(), 1, kPatienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(pictures.idle(), kPatienceMs);
        const QString cached = cache + QLatin1Char('/') + QDir(cache).entryList(QDir::Files).value(0);
        const QString precious = m_folder.filePath(QStringLiteral("precious"));
        {
            QFile file(precious);
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write("precious") == 8);
        }
        std::optional<test::FileRefusal> refusal;
        const QByteArray encoded = QFile::encodeName(cache);
        QVERIFY(QFile::remove(cached));
        if (trouble == QLatin1String("read-only"))
            refusal.emplace(encoded.constData(), test::FileRefusal::Why::ReadOnly);
        else if (trouble == QLatin1String("full"))
            refusal.emplace(encoded.constData(), test::FileRefusal::Why::Full);
        else if (trouble == QLatin1String("links"))
            QVERIFY(QFile::link(precious, cached));
        else if (trouble == QLatin1String("pipes"))
            QCOMPARE(::mkfifo(QFile::encodeName(cached).constData(), 0600), 0);
        else
            QVERIFY(QDir(cache).removeRecursively());
        if (trouble == QLatin1String("a file")) {
            QFile inTheWay(cache);
            QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        }
        pictures.make(path);
        QTRY_COMPARE_WITH_TIMEOUT(made.size(), 2, kPatienceMs);
        QCOMPARE(made.back().at(1).value<QImage>().pixelColor(9, 9), QColor(Qt::red));
        QVERIFY(bytesOf(precious) == "precious");
        QFile::remove(cache);
    }
#endif

    void theBaldHeadToo()
    {
        Jobs jobs(m_window);
        std::atomic<int> drawn = 0;
        StylePictures pictures(jobs, [&drawn](const model::Preset&, const model::Progress&) {
            ++drawn;
            return plain(Qt::gray);
        });
        const QSignalSpy made(&pictures, &StylePictures::made);
        for (int times = 1; times <= 2; ++times) {
            pictures.make(baldStylePath());
            QTRY_COMPARE_WITH_TIMEOUT(made.size(), times, kPatienceMs);
        }
        QCOMPARE(drawn.load(), 1);
    }

    void aStyleDeletedOrReplacedMeanwhileStaysSo_data()
    {
        QTest::addColumn<bool>("replaced");
        QTest::newRow("deleted") << false;
        QTest::newRow("replaced") << true;
    }
    void aStyleDeletedOrReplacedMeanwhileStaysSo()
    {
        QFETCH(bool, replaced);
        const QString path = style("gone.hairpreset", QStringLiteral("Gone"));
        const QString other = style("other.hairpreset", QStringLiteral("Other"));
        const QByteArray wanted = replaced ? bytesOf(other) : QByteArray();
        Jobs jobs(m_window);
        StylePictures pictures(jobs, [&](const model::Preset&, const model::Progress&) {
            QFile::remove(path);
            if (replaced)
                QFile::copy(other, path);
            return plain(Qt::blue);
        });
        QSignalSpy made(&pictures, &StylePictures::made);
        pictures.make(path);
        QTRY_VERIFY_WITH_TIMEOUT(pictures.idle(), kPatienceMs);
        QCOMPARE(made.size(), 0); // It shows what is there no more.
        QCOMPARE(QFile::exists(path), replaced);
        QVERIFY(bytesOf(path) == wanted);
    }

    void whatIsForgottenNeverComes()
    {
        const QString first = style("first.hairpreset", QStringLiteral("First"));
        const QString second = style("second.hairpreset", QStringLiteral("Second"));
        Jobs jobs(m_window);
        StylePictures pictures(jobs, [](const model::Preset&, const model::Progress&) { return plain(Qt::green); });
        QSignalSpy made(&pictures, &StylePictures::made);
        pictures.make(first);
        pictures.make(second);
        pictures.forget();
        pictures.make(second);
        QTRY_VERIFY_WITH_TIMEOUT(pictures.idle(), kPatienceMs);
        QCOMPARE(made.size(), 1);
        QCOMPARE(made.front().front().toString(), second);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestStylePictures, Widgets)
#include "test_style_pictures.moc"
