// Pictures of inks (CMYK) through the real helper: by their profile, else each ink takes its part of the light.
#include "model/files/importer_client.h"
#include "tests/importer/foreign_images.h"
#include "tests/model/archive_maker.h"
#include "tests/model/sample_project.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

/// A printer whose cyan alone darkens, to a lightness of a half (128 of 255), and whose black is black: a table of
/// 8-bit Lab at the sixteen corners (ICC.1:2001, "lut8Type").
QByteArray printerProfile()
{
    const auto big = [](quint32 value) {
        QByteArray bytes;
        test::put(bytes, qToBigEndian(value));
        return bytes;
    };
    QByteArray table = "mft1" + big(0) + QByteArray("\4\3\2\0", 4);
    for (int i = 0; i < 9; ++i) // The identity.
        table += big(i % 4 == 0 ? 0x10000 : 0);
    const auto line = [&table] {
        for (int i = 0; i < 256; ++i)
            table += static_cast<char>(i);
    };
    for (int ink = 0; ink < 4; ++ink)
        line();
    for (unsigned corner = 0; corner < 16; ++corner) { // Black counts fastest.
        const bool isCyan = (corner & 8U) != 0;
        const bool isBlack = (corner & 1U) != 0;
        table += static_cast<char>(isBlack ? 0 : isCyan ? 128 : 255);
        table += QByteArray("\x80\x80", 2);
    }
    for (int channel = 0; channel < 3; ++channel)
        line();
    constexpr quint32 kTable = 128 + 4 + 12;
    QByteArray profile = big(static_cast<quint32>(kTable + table.size())) + big(0) + big(0x02100000) + "prtr" + "CMYK" +
                         "Lab " + QByteArray(12, '\0') + "acsp" + QByteArray(88, '\0');
    profile.replace(68, 12, big(0xF6D6) + big(0x10000) + big(0xD32D));
    return profile + big(1) + "A2B0" + big(kTable) + big(static_cast<quint32>(table.size())) + table;
}

QByteArray jpegOf(const QByteArray& profile, bool hasAdobe)
{
    QByteArray jpeg = test::readBytes(test::dataPath(u"images/grey_of_inks.jpg"));
    if (!hasAdobe)
        jpeg.remove(2, 16);
    if (!profile.isEmpty()) {
        const QByteArray body = QByteArray("ICC_PROFILE\0\1\1", 14) + profile;
        QByteArray segment("\xFF\xE2", 2);
        test::put(segment, qToBigEndian(static_cast<quint16>(body.size() + 2)));
        jpeg.insert(2, segment + body);
    }
    return jpeg;
}

} // namespace

class TestImageInks : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    ImporterClient m_client{test::importProgram(), 60'000};

private Q_SLOTS:
    void inksBecomeColours_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QList<int>>("expected"); // 0..255
        const auto row = [](const char* title, const QByteArray& bytes, const char* name, const QList<int>& expected) {
            QTest::newRow(title) << bytes << QString::fromLatin1(name) << expected;
        };
        const QByteArray cyan("\xFF\0\0\0", 4);
        const QByteArray mixed("\x33\x66\x99\x80", 4);
        const QByteArray cyan16("\xFF\xFF\0\0\0\0\0\0", 8);
        const test::TiffSample plain{.samples = 4, .photometric = 5, .data = cyan};
        row("TIFF", test::tiff(plain), "a.tif", {0, 255, 255});
        row("TIFF, mixed", test::tiff({.samples = 4, .photometric = 5, .data = mixed}), "a.tif", {102, 76, 51});
        row("TIFF with a profile",
            test::tiff({.samples = 4, .photometric = 5, .profile = printerProfile(), .data = cyan}), "a.tif",
            {119, 119, 119});
        row("TIFF with a profile, 16 bits",
            test::tiff({.bits = 16, .samples = 4, .photometric = 5, .profile = printerProfile(), .data = cyan16}),
            "a.tif", {119, 119, 119});
        row("TIFF with a profile, no ink",
            test::tiff({.samples = 4, .photometric = 5, .profile = printerProfile(), .data = QByteArray(4, '\0')}),
            "a.tif", {255, 255, 255});
        row("JPEG", jpegOf({}, true), "a.jpg", {128, 128, 128});
        row("JPEG with a profile", jpegOf(printerProfile(), true), "a.jpg", {185, 185, 185});
        row("JPEG that Adobe has not marked", jpegOf({}, false), "a.jpg", {0, 0, 0});
        row("JPEG with a profile that is none", jpegOf("no profile", true), "a.jpg", {128, 128, 128});
    }
    void inksBecomeColours()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, name);
        QFETCH(QList<int>, expected);
        const QString file = m_folder.filePath(name);
        test::writeBytes(file, bytes);
        const auto image = m_client.readColours(file);
        QVERIFY2(image, image ? "" : qPrintable(image.error().message));
        QCOMPARE(image->channels, 3);
        for (qsizetype i = 0; i < 3; ++i) {
            const int found = image->pixels[static_cast<std::size_t>(i)] / 257;
            QVERIFY2(std::abs(found - expected[i]) <= 3, qPrintable(QString::number(found)));
        }
    }

    void aCutJpegIsRefused_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        const QByteArray whole = jpegOf({}, true);
        QTest::newRow("in its header") << whole.first(30);
        QTest::newRow("before its picture") << whole.first(whole.indexOf("\xFF\xDA") + 16);
    }
    void aCutJpegIsRefused()
    {
        QFETCH(QByteArray, bytes);
        const QString file = m_folder.filePath(QStringLiteral("cut.jpg"));
        test::writeBytes(file, bytes);
        const auto image = m_client.readColours(file);
        QVERIFY(!image);
        QVERIFY2(test::isOneSentenceNaming(image.error().message, file), qPrintable(image.error().message));
    }

    void whereInksAreNotReadASentenceSaysSo()
    {
        QByteArray psd = test::psd(true);
        psd[25] = 4; // Its mode.
        psd[13] = 4; // Channels.
        const QString file = m_folder.filePath(QStringLiteral("inks.psd"));
        test::writeBytes(file, psd + '\x10');
        const auto image = m_client.readColours(file);
        QVERIFY(!image);
        QVERIFY2(image.error().message.contains(QStringLiteral("CMYK")), qPrintable(image.error().message));
        QVERIFY2(test::isOneSentenceNaming(image.error().message, file), qPrintable(image.error().message));
    }

    void aFormatThatIsNotReadIsNamed_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("format");
        const auto row = [](const QByteArray& start, const char* format) {
            QTest::newRow(format) << start + QByteArray(80, '\0') << QString::fromLatin1(format);
        };
        row(QByteArray("\xFF\x0A", 2), "JPEG XL");
        row(QByteArray("\xABKTX 20\xBB\r\n\x1A\n", 12), "KTX2");
        row(QByteArray("\xABKTX 11\xBB\r\n\x1A\n", 12), "KTX");
        row("gimp xcf v011", "GIMP (.xcf)");
        row("PK\x03\x04" + QByteArray(26, '\0') + "mimetypeapplication/x-krita", "Krita (.kra)");
        row("%PDF-1.7\n", "PDF");
        QTest::newRow("JPEG XL in boxes")
            << QByteArray("\0\0\0\x0CJXL \r\n\x87\n\0\0\0\x14", 16) << QStringLiteral("JPEG XL");
    }
    void aFormatThatIsNotReadIsNamed()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, format);
        const QString file = m_folder.filePath(QStringLiteral("picture.xyz"));
        test::writeBytes(file, bytes);
        const auto image = m_client.readImage(file);
        QVERIFY(!image);
        QVERIFY2(image.error().message.contains(format + QLatin1Char(',')), qPrintable(image.error().message));
        QVERIFY2(test::isOneSentenceNaming(image.error().message, file), qPrintable(image.error().message));
    }
};

HAIRPAINT_TEST(TestImageInks, Core)
#include "test_image_inks.moc"
