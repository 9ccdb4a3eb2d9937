// Reading `.hair`: what the format allows is read, what lies about itself is refused in a sentence.
#include "model/importing/curve_reader.h"
#include "model/importing/hair_file_reader.h"
#include "tests/model/archive_maker.h"
#include "tests/model/sample_project.h"
#include "tests/support/test_program.h"

#include <QBuffer>
#include <QTemporaryDir>
#include <QTest>

#include <cstring>
#include <limits>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

/// A file of two strands, of three and two points, with what the flags say.
QByteArray hairBytes(quint32 flags = 31, const char* text = "")
{
    QByteArray bytes(128, '\0');
    bytes.replace(0, 4, "HAIR");
    const auto put = [&bytes](qsizetype at, const auto& value) {
        std::memcpy(bytes.data() + at, &value, sizeof(value));
    };
    put(4, quint32{2});
    put(8, quint32{5});
    put(12, flags);
    put(20, 0.5F);
    put(28, 0.25F);
    put(32, 0.5F);
    put(36, 0.75F);
    std::memcpy(bytes.data() + 40, text, std::strlen(text));
    const auto add = [&bytes](const auto& value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    if ((flags & 1U) != 0) {
        add(quint16{2});
        add(quint16{1});
    }
    if ((flags & 2U) != 0)
        for (int i = 0; i < 15; ++i)
            add(static_cast<float>(i));
    for (const quint32 flag : {4U, 8U})
        if ((flags & flag) != 0)
            for (int i = 0; i < 5; ++i)
                add(static_cast<float>(1 + i));
    if ((flags & 16U) != 0)
        for (int i = 0; i < 15; ++i)
            add(static_cast<float>(i) / 15.0F);
    return bytes;
}

std::optional<ForeignCurves> read(const QByteArray& bytes)
{
    QBuffer buffer;
    buffer.setData(bytes);
    if (!buffer.open(QIODevice::ReadOnly))
        return std::nullopt;
    Checked<std::optional<ForeignCurves>> curves = readHairFile(buffer);
    return curves ? std::move(*curves) : std::nullopt;
}

QByteArray changed(QByteArray bytes, qsizetype at, const QByteArray& with)
{
    return bytes.replace(at, with.size(), with);
}

} // namespace

class TestHairReader : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

private Q_SLOTS:
    void strandsComeAsTheyStand()
    {
        const std::optional<ForeignCurves> curves = read(hairBytes());
        QVERIFY(curves && curves->groups.size() == 1);
        const ForeignStrands& strands = curves->groups.front();
        QCOMPARE(strands.count(), std::size_t{2});
        QCOMPARE(strands.strand(0).size(), std::size_t{3});
        QCOMPARE(strands.strand(1).size(), std::size_t{2});
        QVERIFY(strands.strand(1).front() == glm::vec3(9.0F, 10.0F, 11.0F));
        QCOMPARE(strands.looks[0].rootWidth, 1.0F);
        QCOMPARE(strands.looks[0].tipWidth, 3.0F);
        QCOMPARE(strands.looks[1].tipWidth, 5.0F);
        QVERIFY(glm::distance(strands.looks[1].rootColour, glm::vec3(9.0F, 10.0F, 11.0F) / 15.0F) < 1e-6F);
        QVERIFY(!curves->metresPerUnit && !curves->upAxis);
    }

    void whatIsNotThereIsAsTheHeaderSays()
    {
        const std::optional<ForeignCurves> curves = read(hairBytes(3));
        QVERIFY(curves);
        QCOMPARE(curves->groups.front().looks[1].tipWidth, 0.5F);
        QVERIFY(curves->groups.front().looks[1].tipColour == glm::vec3(0.25F, 0.5F, 0.75F));

        QByteArray even = hairBytes(2);
        even.replace(4, 4, QByteArray("\x01\0\0\0", 4));
        even.replace(16, 4, QByteArray("\x04\0\0\0", 4));
        const std::optional<ForeignCurves> one = read(even);
        QVERIFY(one);
        QCOMPARE(one->groups.front().strand(0).size(), std::size_t{5});
    }

    void ourOwnHeaderTellsTheSpace()
    {
        const std::optional<ForeignCurves> metres =
            read(hairBytes(31, "Hair Paint: metres, y up, face toward +z; root to tip"));
        QVERIFY(metres && metres->metresPerUnit == 1.0F && metres->upAxis == UpAxis::Y);
        const std::optional<ForeignCurves> unreal =
            read(hairBytes(31, "Hair Paint: centimetres, z up, face toward -y"));
        QVERIFY(unreal && unreal->metresPerUnit == 0.01F && unreal->upAxis == UpAxis::Z);
    }

    void aStrandWithAPointThatIsNoneIsLeftOut()
    {
        const float nothing = std::numeric_limits<float>::quiet_NaN();
        const QString path = m_folder.filePath(QStringLiteral("a.hair"));
        test::writeBytes(
            path, changed(hairBytes(), 132, QByteArray(reinterpret_cast<const char*>(&nothing), sizeof(nothing))));
        const Result<ForeignCurves> curves = readCurves(path);
        QVERIFY(curves);
        QCOMPARE(curves->leftOut, std::size_t{1});
        QCOMPARE(curves->groups.front().count(), std::size_t{1});
        QCOMPARE(curves->groups.front().looks.size(), std::size_t{1});
        QVERIFY(curves->groups.front().strand(0).front() == glm::vec3(9.0F, 10.0F, 11.0F));
    }

    void whatLiesIsRefused_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        const QByteArray whole = hairBytes();
        QTest::newRow("another format") << changed(whole, 0, "HAIL");
        QTest::newRow("a header alone") << whole.first(128);
        QTest::newRow("half a header") << whole.first(60);
        QTest::newRow("cut short") << whole.chopped(1);
        QTest::newRow("more strands") << changed(whole, 4, QByteArray("\xFF\xFF\xFF\xFF", 4));
        QTest::newRow("more points") << changed(whole, 8, QByteArray("\xFF\xFF\xFF\x7F", 4));
        QTest::newRow("fewer points") << changed(whole, 8, QByteArray("\x04", 1));
        QTest::newRow("no points") << changed(whole, 12, QByteArray("\x1D", 1));
        QTest::newRow("a strand of one point") << changed(whole, 130, QByteArray("\0", 1));
        QTest::newRow("segments that do not add up") << changed(hairBytes(2), 16, QByteArray("\xFF\xFF\xFF\xFF", 4));
    }
    void whatLiesIsRefused()
    {
        QFETCH(QByteArray, bytes);
        const QString path = m_folder.filePath(QStringLiteral("a.hair"));
        test::writeBytes(path, bytes);
        const Result<ForeignCurves> curves = readCurves(path);
        QVERIFY(!curves);
        QVERIFY2(test::isOneSentenceNaming(curves.error().message, path), qPrintable(curves.error().message));
    }

    void aFileOfAnotherKindIsRefused()
    {
        const QString path = m_folder.filePath(QStringLiteral("a.abc"));
        test::writeBytes(path, "Ogawa");
        const Result<ForeignCurves> curves = readCurves(path);
        QVERIFY(!curves && curves.error().message.contains(QLatin1String(".hair")));
        QVERIFY2(test::isOneSentenceNaming(curves.error().message, path), qPrintable(curves.error().message));
    }
};

HAIRPAINT_TEST(TestHairReader, Core)
#include "test_hair_reader.moc"
