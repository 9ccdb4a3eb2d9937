// Maps as colours: the scale that is shown lets low values be told apart, and a change costs its tiles.
#include "model/maps/map_colours.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

/// CIE lightness, 0..100.
double lightness(QRgb colour)
{
    const auto linear = [](int byte) {
        const double c = byte / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const double y = 0.2126 * linear(qRed(colour)) + 0.7152 * linear(qGreen(colour)) + 0.0722 * linear(qBlue(colour));
    return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

} // namespace

class TestMapColours : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void scalesOnPaper_data()
    {
        QTest::addColumn<MapKind>("map");
        QTest::addColumn<bool>("night");
        for (const MapSpec& spec : mapSpecs())
            for (const bool night : {false, true})
                if (spec.texel == TexelKind::Scalar)
                    QTest::addRow("%s, %s", spec.id, night ? "night" : "white") << spec.kind << night;
    }
    void scalesOnPaper()
    {
        QFETCH(MapKind, map);
        QFETCH(bool, night);
        const MapSpec& spec = mapSpec(map);
        QCOMPARE(shownColour(spec, 0, night), night ? 0xFF000000U : 0xFFFFFFFFU);
        QCOMPARE(shownFraction(spec, 0.0F), 0.0F);
        QCOMPARE(shownFraction(spec, 1.0F), 1.0F);
        if (!night)
            QCOMPARE(shownColour(spec, 65535, night), spec.scaleColour);
        double before = lightness(shownColour(spec, 0, night));
        for (int value = 3277; value <= 65535; value += 3277) {
            const double now = lightness(shownColour(spec, static_cast<std::uint16_t>(value), night));
            QVERIFY(night ? now > before : now < before);
            before = now;
        }
    }

    void sevenOfFiftyCentimetresAreNotNothing()
    {
        const MapSpec& length = mapSpec(MapKind::Length);
        const std::uint16_t seven = 65535 * 7 / 50;
        QVERIFY(lightness(shownColour(length, seven, true)) > 20.0);
        QVERIFY(lightness(shownColour(length, 0, false)) - lightness(shownColour(length, seven, false)) > 20.0);
        // The even scale that images are written in shows 7 cm as black.
        QVERIFY(lightness(scaleToColour(length, 0.14F, true)) < 5.0);
    }

    void aChangeColoursItsTilesAlone()
    {
        const MapSpec& length = mapSpec(MapKind::Length);
        const auto before = std::make_shared<sim::TiledRaster>(512, 1, sim::Texel{30000});
        before->setTexel(400, 400, {100});
        MapColours colours;
        const auto first = colours.of(before, length);
        QVERIFY(*first == *MapColours().of(before, length));
        QCOMPARE(colours.of(before, length), first);

        const auto after = std::make_shared<sim::TiledRaster>(*before);
        after->setTexel(10, 10, {65535});
        const auto second = colours.of(after, length);
        QVERIFY(*second == *MapColours().of(after, length));
        for (int index = 0; index < second->tileCount(); ++index)
            QCOMPARE(second->tile(index) == first->tile(index), index != 0);
        // Another scale or size has nothing in common with it.
        QVERIFY(*colours.of(after, mapSpec(MapKind::Density)) == *MapColours().of(after, mapSpec(MapKind::Density)));
        const auto larger = std::make_shared<sim::TiledRaster>(1024, 1, sim::Texel{5});
        QVERIFY(*colours.of(larger, length) == *MapColours().of(larger, length));
    }
};

HAIRPAINT_TEST(TestMapColours, Core)
#include "test_map_colours.moc"
