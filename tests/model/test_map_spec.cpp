// The table of maps and the colour scales.
#include "model/project/map_spec.h"
#include "tests/support/test_program.h"

#include <QSet>
#include <QTest>

using namespace hairpaint::model;

class TestMapSpec : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void everyMapHasItsOwnIdAndLetter();
    void defaultsAreThoseOfTheDesign_data();
    void defaultsAreThoseOfTheDesign();
    void whiteGreyAndBlackReadAsZero();
    void theScaleReadsAlongItsOwnHue_data();
    void theScaleReadsAlongItsOwnHue();
    void writingAndReadingReturnsTheValueWithinAStep();
    void braidsAreReadByTheirColours_data();
    void braidsAreReadByTheirColours();
};

void TestMapSpec::everyMapHasItsOwnIdAndLetter()
{
    QSet<QString> ids;
    QSet<QString> letters;
    int index = 0;
    for (const MapSpec& spec : mapSpecs()) {
        QCOMPARE(static_cast<int>(spec.kind), index++);
        ids.insert(QString::fromLatin1(spec.id));
        letters.insert(spec.letterText());
        QCOMPARE(findMapSpec(QString::fromLatin1(spec.id)), &spec);
        QCOMPARE(spec.palette.empty(), spec.texel != TexelKind::Index);
        QCOMPARE(spec.valueChannels, spec.texel == TexelKind::Colour ? 3 : spec.texel == TexelKind::Vector ? 2 : 1);
        QVERIFY(!spec.titleText().isEmpty());
        QVERIFY(!spec.follows || *spec.follows < spec.kind);
    }
    QCOMPARE(index, kMapKindCount);
    QCOMPARE(ids.size(), kMapKindCount);
    QCOMPARE(letters.size(), kMapKindCount);
    QCOMPARE(findMapSpec(u"sheen"), nullptr);
}

void TestMapSpec::defaultsAreThoseOfTheDesign_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<int>("value");
    QTest::newRow("no hair") << "density" << 0;
    QTest::newRow("half the length") << "length" << 32768;
    QTest::newRow("straight") << "curl" << 0;
    QTest::newRow("curls of half the greatest size") << "curl_size" << 32768;
    QTest::newRow("no braid") << "braid" << 0;
    QTest::newRow("no clump") << "clump" << 0;
    QTest::newRow("no gel") << "gel" << 0;
    QTest::newRow("no frizz") << "frizz" << 0;
    QTest::newRow("as wide as the group") << "width" << 32768;
    QTest::newRow("as glossy as the group") << "gloss" << 32768;
    QTest::newRow("upright") << "direction" << 32768;
}

void TestMapSpec::defaultsAreThoseOfTheDesign()
{
    QFETCH(QString, id);
    QFETCH(int, value);
    QCOMPARE(static_cast<int>(findMapSpec(id)->defaultValue[0]), value);
}

void TestMapSpec::whiteGreyAndBlackReadAsZero()
{
    for (const MapSpec& spec : mapSpecs())
        for (const float grey : {0.0F, 0.25F, 0.5F, 1.0F}) {
            if (spec.texel == TexelKind::Scalar)
                QCOMPARE(colourToScale(spec, grey, grey, grey), 0.0F);
            if (spec.texel == TexelKind::Index)
                QCOMPARE(static_cast<int>(colourToIndex(spec, grey, grey, grey)), 0);
        }
}

void TestMapSpec::theScaleReadsAlongItsOwnHue_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<float>("red");
    QTest::addColumn<float>("green");
    QTest::addColumn<float>("blue");
    QTest::addColumn<float>("value");
    QTest::newRow("pure green") << "density" << 0.0F << 1.0F << 0.0F << 1.0F;
    QTest::newRow("green from white") << "density" << 0.25F << 1.0F << 0.25F << 0.75F;
    QTest::newRow("green from black") << "density" << 0.0F << 0.75F << 0.0F << 0.75F;
    QTest::newRow("green less the greater other") << "density" << 0.125F << 0.75F << 0.5F << 0.25F;
    QTest::newRow("red is no green") << "density" << 1.0F << 0.0F << 0.0F << 0.0F;
    QTest::newRow("blue") << "length" << 0.5F << 0.25F << 1.0F << 0.5F;
    QTest::newRow("red") << "curl" << 1.0F << 0.25F << 0.5F << 0.5F;
    QTest::newRow("orange") << "curl_size" << 1.0F << 0.75F << 0.5F << 0.5F;
    QTest::newRow("yellow is no orange") << "curl_size" << 1.0F << 1.0F << 0.5F << 0.0F;
    QTest::newRow("yellow") << "clump" << 1.0F << 0.75F << 0.25F << 0.5F;
    QTest::newRow("cyan") << "gel" << 0.25F << 0.75F << 1.0F << 0.5F;
    QTest::newRow("violet") << "frizz" << 0.75F << 0.5F << 1.0F << 0.5F;
    QTest::newRow("magenta is no violet") << "frizz" << 1.0F << 0.5F << 1.0F << 0.0F;
    QTest::newRow("brown from white") << "width" << 0.794118F << 0.647059F << 0.5F << 0.5F;
    QTest::newRow("brown from black") << "width" << 0.294118F << 0.147059F << 0.0F << 0.5F;
    QTest::newRow("rose") << "gloss" << 1.0F << 0.5F << 0.75F << 0.5F;
    QTest::newRow("green is no cyan") << "gel" << 0.0F << 1.0F << 0.0F << 0.0F;
}

void TestMapSpec::theScaleReadsAlongItsOwnHue()
{
    QFETCH(QString, id);
    QFETCH(float, red);
    QFETCH(float, green);
    QFETCH(float, blue);
    QFETCH(float, value);
    QCOMPARE(colourToScale(*findMapSpec(id), red, green, blue), value);
}

void TestMapSpec::writingAndReadingReturnsTheValueWithinAStep()
{
    for (const MapSpec& spec : mapSpecs()) {
        if (spec.texel != TexelKind::Scalar)
            continue;
        for (const bool night : {false, true})
            for (int step = 0; step <= 1000; ++step) {
                const float value = static_cast<float>(step) / 1000.0F;
                const QRgb colour = scaleToColour(spec, value, night);
                const float read = colourToScale(spec, static_cast<float>(qRed(colour)) / 255.0F,
                                                 static_cast<float>(qGreen(colour)) / 255.0F,
                                                 static_cast<float>(qBlue(colour)) / 255.0F);
                // A channel that falls to one half only says as much by half as many steps.
                const bool hasHalf =
                    qRed(spec.scaleColour) % 255 + qGreen(spec.scaleColour) % 255 + qBlue(spec.scaleColour) % 255 != 0;
                const bool isDark =
                    std::max({qRed(spec.scaleColour), qGreen(spec.scaleColour), qBlue(spec.scaleColour)}) < 255;
                const float steps = !hasHalf ? 0.5F : night || isDark ? 2.1F : 1.1F;
                QVERIFY2(std::abs(read - value) <= steps / 255.0F + 1e-5F, spec.id);
            }
        QCOMPARE(scaleToColour(spec, 0.0F, false), 0xFFFFFFFFU);
        QCOMPARE(scaleToColour(spec, 0.0F, true), 0xFF000000U);
        QCOMPARE(scaleToColour(spec, 1.0F, false), spec.scaleColour);
        QCOMPARE(scaleToColour(spec, 1.0F, true), spec.scaleColour);
    }
}

void TestMapSpec::braidsAreReadByTheirColours_data()
{
    QTest::addColumn<float>("red");
    QTest::addColumn<float>("green");
    QTest::addColumn<float>("blue");
    QTest::addColumn<int>("index");
    QTest::newRow("magenta") << 1.0F << 0.0F << 1.0F << 1;
    QTest::newRow("half magenta") << 1.0F << 0.5F << 1.0F << 1;
    QTest::newRow("half magenta from black") << 0.5F << 0.0F << 0.5F << 1;
    QTest::newRow("less than half magenta") << 1.0F << 0.51F << 1.0F << 0;
    QTest::newRow("less than half magenta from black") << 0.49F << 0.0F << 0.49F << 0;
    const MapSpec& spec = mapSpec(MapKind::Braid);
    for (int i = 0; i < static_cast<int>(spec.palette.size()); ++i) {
        const QRgb colour = spec.palette[static_cast<std::size_t>(i)].colour;
        QTest::newRow(spec.palette[static_cast<std::size_t>(i)].id)
            << static_cast<float>(qRed(colour)) / 255.0F << static_cast<float>(qGreen(colour)) / 255.0F
            << static_cast<float>(qBlue(colour)) / 255.0F << i;
    }
}

void TestMapSpec::braidsAreReadByTheirColours()
{
    QFETCH(float, red);
    QFETCH(float, green);
    QFETCH(float, blue);
    QFETCH(int, index);
    QCOMPARE(static_cast<int>(colourToIndex(mapSpec(MapKind::Braid), red, green, blue)), index);
}

HAIRPAINT_TEST(TestMapSpec, None)
#include "test_map_spec.moc"
