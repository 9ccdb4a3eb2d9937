// The list of drawn strands holds what the detail asks for, each once, with room for its points.
#include "tests/rendering/hand_made_hair.h"
#include "tests/support/test_program.h"
#include "view/rendering/gl/hair_list.h"

#include <QtTest>

#include <set>

using namespace hairpaint;
using namespace hairpaint::testing;
using rendering::HairList;

class TestHairList : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void holdsEveryStrandBelowTheDetailOnce_data();
    void holdsEveryStrandBelowTheDetailOnce();
    void coarserListsAreTheBeginningOfFinerOnes();
    void curlsGetMorePoints();
    void batchesCoverTheListWithoutGaps();
    void undrawnStrandsAreLeftOut();

private:
    std::shared_ptr<const sim::Groom> groom(int hairs, float turns = 0.0F)
    {
        std::vector<HandMadeStrand> strands;
        for (int i = 0; i < hairs; ++i) {
            strands.push_back(straightStrand(glm::vec3(0.0F), glm::vec3(0.0F, 0.1F, 0.0F), 0xFFFFFFFFU));
            strands.back().style.turns = turns;
            strands.back().style.curlRadiusM = turns > 0.0F ? 0.01F : 0.0F;
        }
        return makeFrame(strands)->groups[0].groom;
    }
};

void TestHairList::holdsEveryStrandBelowTheDetailOnce_data()
{
    QTest::addColumn<float>("detail");
    for (const float detail : {1.0F / 64.0F, 0.1F, 0.25F, 0.3333F, 0.99F, 1.0F})
        QTest::newRow(qPrintable(QString::number(static_cast<double>(detail)))) << detail;
}

void TestHairList::holdsEveryStrandBelowTheDetailOnce()
{
    QFETCH(float, detail);
    const auto source = groom(3000);
    HairList list;
    QVERIFY(list.update(source, detail, {.ofStraightHair = 8}));
    QVERIFY(!list.update(source, detail, {.ofStraightHair = 8}));
    std::set<std::uint32_t> slots;
    for (std::size_t i = 0; i < list.strandCount(); ++i)
        QVERIFY(slots.insert(list.strands()[i].slot).second);
    for (std::uint32_t slot = 0; slot < 3000; ++slot)
        QCOMPARE(slots.count(slot) == 1,
                 source->chunks[slot / sim::kChunkSlots]->styles[slot % sim::kChunkSlots].detail < detail);
    QCOMPARE(list.segmentCount(), list.strandCount() * 8);
}

void TestHairList::coarserListsAreTheBeginningOfFinerOnes()
{
    const auto source = groom(3000);
    HairList coarse;
    HairList fine;
    QVERIFY(coarse.update(source, 0.25F, {.ofStraightHair = 8}));
    QVERIFY(fine.update(source, 1.0F, {.ofStraightHair = 8}));
    QVERIFY(coarse.strandCount() > 0);
    for (std::size_t i = 0; i < coarse.strandCount(); ++i)
        QCOMPARE(coarse.strands()[i].slot, fine.strands()[i].slot);
}

void TestHairList::curlsGetMorePoints()
{
    HairList list;
    QVERIFY(list.update(groom(10, 4.0F), 1.0F, {.ofStraightHair = 8}));
    QCOMPARE(list.segmentCount(), std::size_t{10 * 32});
    QVERIFY(list.update(groom(10, 1000.0F), 1.0F, {.ofStraightHair = 8}));
    QCOMPARE(list.segmentCount(), std::size_t{10 * 256});
}

void TestHairList::batchesCoverTheListWithoutGaps()
{
    HairList list;
    QVERIFY(list.update(groom(20000, 16.0F), 1.0F, {.ofStraightHair = 8}));
    QVERIFY(list.batches().size() > 1);
    std::uint32_t strand = 0;
    std::uint32_t point = 0;
    for (const rendering::StrandBatch& batch : list.batches()) {
        QCOMPARE(batch.firstStrand, strand);
        QCOMPARE(list.strands()[strand].firstPoint, point);
        QVERIFY(batch.pointCount <= HairList::kBatchPoints);
        strand += batch.strandCount;
        point += batch.pointCount;
    }
    QCOMPARE(std::size_t{strand}, list.strandCount());
    QCOMPARE(list.strands().back().firstPoint, point);
}

void TestHairList::undrawnStrandsAreLeftOut()
{
    const auto source = groom(1500);
    auto shorn = std::make_shared<sim::Groom>(*source);
    auto chunk = std::make_shared<sim::StrandChunk>(*shorn->chunks[0]);
    chunk->drawn.reset();
    shorn->chunks[0] = chunk;
    HairList list;
    QVERIFY(list.update(source, 1.0F, {.ofStraightHair = 8}));
    QCOMPARE(list.strandCount(), std::size_t{1500});
    QVERIFY(list.update(shorn, 1.0F, {.ofStraightHair = 8}));
    QCOMPARE(list.strandCount(), std::size_t{1500 - 1024});
}

HAIRPAINT_TEST(TestHairList, None)
#include "test_hair_list.moc"
