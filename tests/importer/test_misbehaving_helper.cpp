// A helper that crashes, hangs, eats memory or lies costs one sentence and nothing else.
#include "model/files/importer_client.h"
#include "tests/model/archive_maker.h"
#include "tests/model/sample_project.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

using namespace hairpaint;
using namespace hairpaint::model;

class TestMisbehavingHelper : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    QString m_file;

    static constexpr int kLongMs = 60'000;
    static constexpr int kShortMs = 200; ///< For helpers that go on for ever.
    static QString helper() { return test::fakeHelper(); }

private Q_SLOTS:
    void initTestCase()
    {
        m_file = m_folder.filePath(QStringLiteral("head or map.xyz"));
        test::writeBytes(m_file, "anything");
    }

    void aWellBehavedHelperIsBelieved()
    {
        qputenv("HAIRPAINT_FAKE_HELPER", "good");
        const auto image = ImporterClient(helper(), kLongMs).readImage(m_file);
        QVERIFY2(image, image ? "" : qPrintable(image.error().message));
        QCOMPARE(image->pixels, (std::vector<std::uint16_t>{1, 65535}));
    }

    void misbehaviourCostsOneSentence_data()
    {
        QTest::addColumn<QByteArray>("mode");
        for (const char* mode : {"abort",
                                 "silent",
                                 "exit 3",
                                 "hang",
                                 "spin",
                                 "garbage",
                                 "endless garbage",
                                 "half a header",
                                 "huge length",
                                 "long body never sent",
                                 "endless body",
                                 "bytes after the end",
                                 "two answers, then served",
                                 "a request for an answer",
                                 "unknown refusal",
                                 "another answer",
                                 "image of wrong size",
                                 "mesh with a wrong index",
                                 "mesh with NaN",
                                 "good, then abort",
                                 "good, then hang"})
            QTest::newRow(mode) << QByteArray(mode);
#if !defined(HAIRPAINT_ASAN)
        QTest::newRow("allocate") << QByteArray("allocate");
#endif
    }
    void misbehaviourCostsOneSentence()
    {
        QFETCH(QByteArray, mode);
        qputenv("HAIRPAINT_FAKE_HELPER", mode);
        const bool isEndless = mode.endsWith("hang") || mode == "spin";
        ImporterClient client(helper(), isEndless ? kShortMs : kLongMs);
        const auto image = client.readImage(m_file);
        const bool meshMode = mode.startsWith("mesh");
        QVERIFY(!image);
        QVERIFY2(test::isOneSentenceNaming(image.error().message, m_file), qPrintable(image.error().message));
        if (meshMode) {
            const auto mesh = client.readMesh(m_file);
            QVERIFY(!mesh);
            QVERIFY2(test::isOneSentenceNaming(mesh.error().message, m_file), qPrintable(mesh.error().message));
        }
    }

    void nothingIsWrittenWhereEncodingFails_data()
    {
        QTest::addColumn<QByteArray>("mode");
        for (const char* mode : {"abort", "garbage", "silent", "good"})
            QTest::newRow(mode) << QByteArray(mode);
    }
    void nothingIsWrittenWhereEncodingFails()
    {
        QFETCH(QByteArray, mode);
        qputenv("HAIRPAINT_FAKE_HELPER", mode);
        const QString path = m_folder.filePath(QStringLiteral("map.png"));
        const ForeignImage image{
            .width = 400, .height = 300, .channels = 1, .pixels = std::vector<std::uint16_t>(120'000)};
        const auto written = ImporterClient(helper(), kLongMs).writeImage(image, path);
        QVERIFY(!written);
        QVERIFY2(test::isOneSentenceNaming(written.error().message, path), qPrintable(written.error().message));
        QVERIFY(!QFile::exists(path));
    }

#ifdef Q_OS_UNIX // On Windows each serves one file.
    void whereItEndsBetweenFilesTheNextStartsAnother()
    {
        qputenv("HAIRPAINT_FAKE_HELPER", "one served, then abort");
        ImporterClient client(helper(), kLongMs);
        const ForeignImage image{.width = 2, .height = 1, .channels = 1, .pixels = {1, 2}};
        for (const bool succeeds : {true, false, true, false}) {
            const QString path =
                m_folder.filePath(succeeds ? QStringLiteral("written.png") : QStringLiteral("failed.png"));
            const auto written = client.writeImage(image, path);
            QCOMPARE(written.has_value(), succeeds);
            QCOMPARE(QFile::exists(path), succeeds);
            if (!succeeds)
                QVERIFY2(test::isOneSentenceNaming(written.error().message, path), qPrintable(written.error().message));
        }
    }
#endif

    void cancellingEndsTheHelper()
    {
        qputenv("HAIRPAINT_FAKE_HELPER", "hang");
        int asked = 0;
        const auto image =
            ImporterClient(helper(), kLongMs).readImage(m_file, [&asked](double) { return ++asked < 3; });
        QVERIFY(!image);
        QCOMPARE(asked, 3);
        QVERIFY(test::isOneSentenceNaming(image.error().message, m_file));
    }

    void aHelperThatIsNotThereCostsOneSentence()
    {
        const auto image = ImporterClient(m_folder.filePath(QStringLiteral("none"))).readImage(m_file);
        QVERIFY(!image);
        QVERIFY2(test::isOneSentenceNaming(image.error().message, m_file), qPrintable(image.error().message));
    }

    void theHelperIsTakenFromTheEnvironment()
    {
        qputenv("HAIRPAINT_FAKE_HELPER", "good");
        qputenv("HAIRPAINT_IMPORT", helper().toLocal8Bit());
        const bool read = ImporterClient(QString(), kLongMs).readImage(m_file).has_value();
        qunsetenv("HAIRPAINT_IMPORT");
        QVERIFY(read);
    }

    void whatIsNoFileNeedsNoHelper_data()
    {
        QTest::addColumn<QString>("path");
        QTest::newRow("missing") << m_folder.filePath(QStringLiteral("none.png"));
        QTest::newRow("a folder") << m_folder.path();
        test::writeBytes(m_folder.filePath(QStringLiteral("empty.png")), {});
        QTest::newRow("empty") << m_folder.filePath(QStringLiteral("empty.png"));
    }
    void whatIsNoFileNeedsNoHelper()
    {
        QFETCH(QString, path);
        qputenv("HAIRPAINT_FAKE_HELPER", "good");
        ImporterClient client(helper(), kLongMs);
        const auto image = client.readImage(path);
        const auto mesh = client.readMesh(path);
        QVERIFY(!image && !mesh);
        QVERIFY(test::isOneSentenceNaming(image.error().message, path));
        QVERIFY(test::isOneSentenceNaming(mesh.error().message, path));
    }
};

HAIRPAINT_TEST(TestMisbehavingHelper, Core)
#include "test_misbehaving_helper.moc"
