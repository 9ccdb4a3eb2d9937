// Maps as colours: what changes costs its tiles, and gives what colouring all of it would.
#include "model/map_colours.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace hairpaint;
using namespace hairpaint::model;

class TestMapColours : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aChangeColoursItsTilesAlone()
    {
        const MapSpec& length = mapSpec(MapKind::Length);
        const auto before = std::make_shared<sim::TiledRaster>(512, 1, sim::Texel{30000});
        before->setTexel(400, 400, {100});
        MapColours colours;
        const auto first = colours.of(before, length);
        QVERIFY(*first == *colouredMap(*before, length));
        QCOMPARE(colours.of(before, length), first);

        const auto after = std::make_shared<sim::TiledRaster>(*before);
        after->setTexel(10, 10, {65535});
        const auto second = colours.of(after, length);
        QVERIFY(*second == *colouredMap(*after, length));
        for (int index = 0; index < second->tileCount(); ++index)
            QCOMPARE(second->tile(index) == first->tile(index), index != 0);
        // Another scale or size has nothing in common with it.
        QVERIFY(*colours.of(after, mapSpec(MapKind::Density)) == *colouredMap(*after, mapSpec(MapKind::Density)));
        const auto larger = std::make_shared<sim::TiledRaster>(1024, 1, sim::Texel{5});
        QVERIFY(*colours.of(larger, length) == *colouredMap(*larger, length));
    }
};

HAIRPAINT_TEST(TestMapColours, Core)
#include "test_map_colours.moc"
