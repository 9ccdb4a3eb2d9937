// Braids grow in connected regions, and their hairs gather at the middle.
#include "sim/groom/braid_layout.h"
#include "sim/groom/braid_path.h"
#include "sim/groom/curve_constants.h"
#include "tests/sim/groom_reading.h"
#include "tests/sim/small_groom.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <map>
#include <set>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

GroomInput braidInput(std::shared_ptr<const Skin> skin)
{
    GroomInput::Group group = smallGroup();
    group.settings.basisHairs = 1024;
    return inputOf(std::move(skin), group);
}

/// Hairs by the basis hair at their braid's centre.
std::map<std::uint32_t, std::vector<std::uint32_t>> hairsByCentre(const Groom& groom)
{
    std::map<std::uint32_t, std::vector<std::uint32_t>> hairs;
    for (std::uint32_t slot = 0; slot < groom.roots->count(); ++slot) {
        const auto& chunk = groom.chunks[slot / kChunkSlots];
        if (chunk && chunk->hairs[slot % kChunkSlots] && chunk->braidCentre[slot % kChunkSlots] != kNoCentre)
            hairs[chunk->braidCentre[slot % kChunkSlots]].push_back(slot);
    }
    return hairs;
}

} // namespace

class TestBraids : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void withoutBraidsNoHairIsBraided();
    void aRegionSmallerThanTheSpacingIsOneBraidFromItsMiddle();
    void separateRegionsAreSeparateBraids();
    void aLargeRegionHasBraidsAsFarApartAsAsked();
    void allHairsOfABraidShareItsSkeleton();
    void hairsOfABraidStayOutsideTheHead();
    void wispsAndTheirRootsAreSpreadEvenly();
    void paintingElsewhereLeavesABraidAlone();
    void theLengthAtTheCentreIsTheBraids();
    void aTinyDabBetweenBasisHairsIsABraid();
    void patchesNeverMergeAcrossUnpaintedSkin_data();
    void patchesNeverMergeAcrossUnpaintedSkin();
    void bareSkinPartsAPatch();
    void aPatchIsOneAcrossASeam();
    void aFilledMapBraidsEveryHairAndNoneBeginsOnBareSkin_data();
    void aFilledMapBraidsEveryHairAndNoneBeginsOnBareSkin();
    void aBraidOfFewHairsIsThin();
    void anotherDensityThatKeepsThePatchKeepsItsRoots();
};

void TestBraids::withoutBraidsNoHairIsBraided()
{
    const auto groom = GroomBuilder().update(braidInput(patch())).grooms[0];
    QVERIFY(hairsByCentre(*groom).empty());
    QVERIFY(groom->hairCount > 0);
    for (std::uint32_t slot = 0; slot < 1000; ++slot)
        QCOMPARE(groom->style(slot).braid, BraidKind::None);
}

void TestBraids::aRegionSmallerThanTheSpacingIsOneBraidFromItsMiddle()
{
    GroomInput input = braidInput(patch());
    auto& maps = input.groups[0].maps;
    maps[MapSlot::Braid] = withDab(maps[MapSlot::Braid], {0.4F, 0.6F}, 0.25F, {1});
    const auto groom = GroomBuilder().update(input).grooms[0];
    const auto braids = hairsByCentre(*groom);
    QCOMPARE(braids.size(), std::size_t{1});
    const std::uint32_t centre = groom->roots->basisSlot[braids.begin()->first];
    QVERIFY(glm::length(groom->roots->uv[centre] - glm::vec2(0.4F, 0.6F)) < 0.06F);
    for (const std::uint32_t slot : braids.begin()->second)
        QVERIFY(glm::length(groom->roots->uv[slot] - glm::vec2(0.4F, 0.6F)) < 0.255F);
    // A circle's fraction of the patch.
    QVERIFY(std::abs(static_cast<double>(braids.begin()->second.size()) - 20000.0 * 3.14159 * 0.0625) < 100.0);
}

void TestBraids::separateRegionsAreSeparateBraids()
{
    GroomInput input = braidInput(patch());
    auto& maps = input.groups[0].maps;
    maps[MapSlot::Braid] = withDab(withDab(maps[MapSlot::Braid], {0.25F, 0.5F}, 0.15F, {1}), {0.75F, 0.5F}, 0.15F, {1});
    const auto groom = GroomBuilder().update(input).grooms[0];
    const auto braids = hairsByCentre(*groom);
    QCOMPARE(braids.size(), std::size_t{2});
    for (const auto& [centre, slots] : braids) {
        const bool left = groom->roots->uv[groom->roots->basisSlot[centre]].x < 0.5F;
        for (const std::uint32_t slot : slots)
            QCOMPARE(groom->roots->uv[slot].x < 0.5F, left);
    }
}

void TestBraids::aLargeRegionHasBraidsAsFarApartAsAsked()
{
    GroomInput input = braidInput(patch());
    input.groups[0].maps[MapSlot::Braid] = indexMap(1);
    input.groups[0].settings.braidSpacingM = 0.05F;
    const auto groom = GroomBuilder().update(input).grooms[0];
    const auto braids = hairsByCentre(*groom);
    // Circles 5 cm apart on 20 x 20 cm: 16 in a square grid, between loosely and densely packed.
    QVERIFY2(braids.size() >= 9 && braids.size() <= 25, qPrintable(QString::number(braids.size())));
    std::vector<glm::vec3> centres;
    centres.reserve(braids.size());
    for (const auto& [centre, slots] : braids)
        centres.push_back(groom->roots->positionHd[groom->roots->basisSlot[centre]]);
    for (std::size_t i = 0; i < centres.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            QVERIFY(glm::length(centres[i] - centres[j]) > 0.03F);
    // Each hair belongs to the nearest.
    for (const auto& [centre, slots] : braids) {
        for (const std::uint32_t slot : slots) {
            const glm::vec3 root = groom->roots->positionHd[slot];
            const float own = glm::length(root - groom->roots->positionHd[groom->roots->basisSlot[centre]]);
            for (const glm::vec3& other : centres)
                QVERIFY(own <= glm::length(root - other) + 1e-6F);
        }
    }
}

void TestBraids::allHairsOfABraidShareItsSkeleton()
{
    GroomInput input = braidInput(std::make_shared<const Skin>(makeBallHead(48)));
    input.groups[0].settings.greatestDensityPerM2 = 1e5F;
    auto& maps = input.groups[0].maps;
    maps[MapSlot::Braid] = withDab(maps[MapSlot::Braid], {0.4F, 0.6F}, 0.2F, {1});
    const auto groom = GroomBuilder().update(input).grooms[0];
    const auto braids = hairsByCentre(*groom);
    QVERIFY(!braids.empty());
    for (const auto& [centre, slots] : braids) {
        const std::uint32_t centreSlot = groom->roots->basisSlot[centre];
        const float centreLengthM = (*groom->basis)[BasisQuantity::SegmentLength][centre] * 7.0F;
        for (const std::uint32_t slot : slots) {
            const StrandStyle& style = groom->style(slot);
            const float aboveM = braidBeginsAboveM(BraidKind::Plait, style.braidRadiusM);
            const int gathered = static_cast<int>(std::lround(style.braidStart * 7.0F));
            QVERIFY(gathered >= 1 && gathered < 6);
            QVERIFY(restNode(*groom, slot, 0) == groom->roots->positionHd[slot]);
            for (int node = gathered; node < 8; ++node) {
                const float fraction = static_cast<float>(node - gathered) / static_cast<float>(7 - gathered);
                const glm::vec3 expected = groom->roots->positionHd[centreSlot] +
                                           groom->roots->normalHd[centreSlot] * (aboveM + centreLengthM * fraction);
                QVERIFY(glm::length(restNode(*groom, slot, node) - expected) < 1e-6F);
            }
            QVERIFY(style.lengthM >= centreLengthM);
            QCOMPARE(style.turns, 0.0F);
            QVERIFY(style.braidTurns > 1.0F);
        }
    }
}

void TestBraids::hairsOfABraidStayOutsideTheHead()
{
    GroomInput input = braidInput(std::make_shared<const Skin>(makeBallHead(96, 0.1F)));
    input.groups[0].settings.greatestDensityPerM2 = 1e5F;
    input.groups[0].settings.nodesPerHair = 16;
    auto& maps = input.groups[0].maps;
    maps[MapSlot::Braid] = withDab(maps[MapSlot::Braid], {0.5F, 0.55F}, 0.25F, {1});
    const auto groom = GroomBuilder().update(input).grooms[0];
    const auto braids = hairsByCentre(*groom);
    QVERIFY(!braids.empty());
    for (const auto& [centre, slots] : braids)
        for (const std::uint32_t slot : slots)
            for (int node = 0; node < 16; ++node)
                QVERIFY(glm::length(restNode(*groom, slot, node)) > 0.0995F);
}

void TestBraids::wispsAndTheirRootsAreSpreadEvenly()
{
    GroomInput input = braidInput(patch());
    input.groups[0].maps[MapSlot::Braid] = indexMap(1);
    const auto groom = GroomBuilder().update(input).grooms[0];
    std::array<int, 3> wisps{};
    glm::vec2 mean(0.0F);
    float meanSquare = 0.0F;
    for (std::uint32_t slot = 0; slot < groom->roots->count(); ++slot) {
        const StrandStyle& style = groom->style(slot);
        QCOMPARE(style.braid, BraidKind::Plait);
        ++wisps[style.wisp];
        const glm::vec2 offset = style.wispOffset;
        QVERIFY(glm::length(offset) <= 1.13F); // Beyond it to close the gap between three.
        mean += offset / 20000.0F;
        meanSquare += glm::dot(offset, offset) / 20000.0F;
    }
    for (const int count : wisps)
        QVERIFY(std::abs(count - 6667) < 300);
    QVERIFY(glm::length(mean) < 0.03F);
    // An evenly filled disc of that radius has about this; wisps are made of strands.
    QVERIFY(std::abs(meanSquare - 0.61F) < 0.04F);
}

void TestBraids::paintingElsewhereLeavesABraidAlone()
{
    GroomInput input = braidInput(patch());
    auto& maps = input.groups[0].maps;
    maps[MapSlot::Braid] = withDab(withDab(maps[MapSlot::Braid], {0.2F, 0.5F}, 0.12F, {1}), {0.8F, 0.5F}, 0.12F, {1});
    GroomBuilder builder;
    builder.setCollectSlots(true);
    (void)builder.update(input);
    maps[MapSlot::Braid] = withDab(maps[MapSlot::Braid], {0.9F, 0.7F}, 0.15F, {1});
    const auto report = builder.update(input);
    QVERIFY(report.rebuiltStrands > 500);
    for (const std::uint32_t slot : report.rebuiltSlots)
        QVERIFY(report.grooms[0]->roots->uv[slot].x > 0.6F);
}

void TestBraids::theLengthAtTheCentreIsTheBraids()
{
    GroomInput input = braidInput(patch());
    auto& maps = input.groups[0].maps;
    maps[MapSlot::Braid] = withDab(maps[MapSlot::Braid], {0.5F, 0.5F}, 0.3F, {1});
    GroomBuilder builder;
    const auto before = builder.update(input);
    const auto braids = hairsByCentre(*before.grooms[0]);
    QCOMPARE(braids.size(), std::size_t{1});
    // A dab on the length around the centre lengthens every hair of the braid.
    maps[MapSlot::Length] = withDab(maps[MapSlot::Length], {0.5F, 0.5F}, 0.08F, {65535});
    const auto after = builder.update(input);
    QVERIFY(after.rebuiltStrands >= braids.begin()->second.size());
    for (const std::uint32_t slot : braids.begin()->second) {
        const float grown = after.grooms[0]->style(slot).lengthM - before.grooms[0]->style(slot).lengthM;
        QVERIFY(std::abs(grown - 0.15F) < 1e-5F);
    }
}

void TestBraids::aTinyDabBetweenBasisHairsIsABraid()
{
    GroomInput input = braidInput(patch());
    const auto roots = GroomBuilder().update(input).grooms[0]->roots;
    // The candidate furthest from every basis hair, and a dab that ends before the nearest.
    std::uint32_t furthest = 0;
    float distance = 0.0F;
    for (std::uint32_t slot = 0; slot < roots->count(); ++slot) {
        const glm::vec2 nearest = roots->uv[roots->basisSlot[roots->neighbours[slot][0]]];
        if (glm::length(nearest - roots->uv[slot]) > distance) {
            distance = glm::length(nearest - roots->uv[slot]);
            furthest = slot;
        }
    }
    auto& maps = input.groups[0].maps;
    const float radius = distance - 2.0F / 512.0F;
    maps[MapSlot::Braid] = withDab(maps[MapSlot::Braid], roots->uv[furthest], radius, {1});
    const auto groom = GroomBuilder().update(input).grooms[0];
    const auto braids = hairsByCentre(*groom);
    QCOMPARE(braids.size(), std::size_t{1});
    QCOMPARE(groom->hairCount, std::size_t{20000});
    // It follows a solved hair beside it, and stands on one of its own.
    const std::uint32_t slot = braids.begin()->second.front();
    const int gathered = static_cast<int>(std::lround(groom->style(slot).braidStart * 7.0F));
    const glm::vec3 stands = restNode(*groom, slot, gathered);
    QVERIFY(glm::length(glm::vec2(stands) - glm::vec2(roots->positionHd[furthest])) <= radius * 0.2F);
}

void TestBraids::patchesNeverMergeAcrossUnpaintedSkin_data()
{
    QTest::addColumn<int>("gapTx"); // A texel is 0.4 mm; solved hairs stand 6 mm apart.
    QTest::newRow("one texel") << 1;
    QTest::newRow("2 mm") << 5;
    QTest::newRow("8 mm") << 20;
}

void TestBraids::patchesNeverMergeAcrossUnpaintedSkin()
{
    QFETCH(int, gapTx);
    constexpr int kWideTx = 24;
    GroomInput input = braidInput(patch());
    auto painted = std::make_shared<TiledRaster>(512, 1);
    for (int strip = 0; strip < 5; ++strip)
        for (int x = 0; x < kWideTx; ++x)
            for (int y = 100; y < 400; ++y)
                painted->setTexel(100 + strip * (kWideTx + gapTx) + x, y, {1});
    input.groups[0].maps[MapSlot::Braid] = painted;
    const auto groom = GroomBuilder().update(input).grooms[0];
    const auto braids = hairsByCentre(*groom);
    QCOMPARE(braids.size(), std::size_t{5});
    for (const auto& [centre, slots] : braids) {
        const auto stripOf = [&](std::uint32_t slot) {
            return (static_cast<int>(groom->roots->uv[slot].x * 512.0F) - 100) / (kWideTx + gapTx);
        };
        for (const std::uint32_t slot : slots)
            QCOMPARE(stripOf(slot), stripOf(slots.front()));
    }
}

void TestBraids::bareSkinPartsAPatch()
{
    GroomInput input = braidInput(patch());
    auto& maps = input.groups[0].maps;
    maps[MapSlot::Braid] = indexMap(1);
    auto density = std::make_shared<TiledRaster>(512, 1, Texel{65535});
    for (int y = 0; y < 512; ++y)
        for (int x = 254; x < 258; ++x)
            density->setTexel(x, y, {0});
    maps[MapSlot::Density] = density;
    const auto braids = hairsByCentre(*GroomBuilder().update(input).grooms[0]);
    QCOMPARE(braids.size(), std::size_t{2});
}

void TestBraids::aPatchIsOneAcrossASeam()
{
    GroomInput input = braidInput(std::make_shared<const Skin>(makeBallHead(48)));
    input.groups[0].settings.greatestDensityPerM2 = 1e5F;
    auto& maps = input.groups[0].maps;
    maps[MapSlot::Braid] = withDab(withDab(maps[MapSlot::Braid], {0.0F, 0.5F}, 0.08F, {1}), {1.0F, 0.5F}, 0.08F, {1});
    QCOMPARE(hairsByCentre(*GroomBuilder().update(input).grooms[0]).size(), std::size_t{1});
}

void TestBraids::aFilledMapBraidsEveryHairAndNoneBeginsOnBareSkin_data()
{
    QTest::addColumn<float>("spacingM");
    QTest::newRow("one braid") << 0.3F;
    QTest::newRow("box braids") << 0.02F;
    QTest::newRow("closer than solved hairs") << 0.006F;
}

void TestBraids::aFilledMapBraidsEveryHairAndNoneBeginsOnBareSkin()
{
    QFETCH(float, spacingM);
    GroomInput input = braidInput(std::make_shared<const Skin>(makeBallHead(48)));
    input.groups[0].settings.greatestDensityPerM2 = 2e5F;
    input.groups[0].settings.braidSpacingM = spacingM;
    auto& maps = input.groups[0].maps;
    maps[MapSlot::Braid] = indexMap(1);
    maps[MapSlot::Density] = withDab(uniformMap(0.8F), {0.5F, 0.5F}, 0.12F, {0});
    const auto groom = GroomBuilder().update(input).grooms[0];
    std::size_t loose = 0;
    std::size_t astray = 0;
    const RootSet& roots = *groom->roots;
    forEachHair(*groom, [&](std::uint32_t slot, const StrandStyle& style) {
        loose += style.braid == BraidKind::None ? 1U : 0U;
        if (style.braid == BraidKind::None)
            return;
        // Where its braid stands, on the skin.
        const int gathered = static_cast<int>(std::lround(style.braidStart * 7.0F));
        const SurfacePoint stands = roots.skin->nearest(restNode(*groom, slot, gathered));
        astray += maps[MapSlot::Density]->sampleScalar(stands.uv) > 0.0F ? 0U : 1U;
    });
    QVERIFY2(loose * 1000 <= groom->hairCount, qPrintable(QString::number(loose)));
    QCOMPARE(astray, std::size_t{0});
}

void TestBraids::aBraidOfFewHairsIsThin()
{
    GroomInput input = braidInput(patch());
    auto& maps = input.groups[0].maps;
    maps[MapSlot::Braid] = withDab(maps[MapSlot::Braid], {0.5F, 0.5F}, 0.05F, {1});
    const auto groom = GroomBuilder().update(input).grooms[0];
    const auto braids = hairsByCentre(*groom);
    QCOMPARE(braids.size(), std::size_t{1});
    const std::vector<std::uint32_t>& slots = braids.begin()->second;
    const float radiusM = groom->style(slots.front()).braidRadiusM;
    // Seen across a wisp lie about two hairs' widths of hair.
    const auto wisp = static_cast<float>(slots.size()) / 3.0F;
    const float across =
        wisp * input.groups[0].settings.material.widthM * 2.0F / (3.14159F * radiusM * kWispRadiusFraction);
    QVERIFY2(radiusM < 0.005F, qPrintable(QString::number(radiusM)));
    QVERIFY2(across > 1.5F && across < 3.0F, qPrintable(QString::number(across)));
}

void TestBraids::anotherDensityThatKeepsThePatchKeepsItsRoots()
{
    GroomInput input = braidInput(patch());
    auto& maps = input.groups[0].maps;
    maps[MapSlot::Braid] = withDab(maps[MapSlot::Braid], {0.3F, 0.5F}, 0.2F, {1});
    GroomBuilder builder;
    const auto before = builder.update(input).grooms[0];
    maps[MapSlot::Density] = withDab(maps[MapSlot::Density], {0.8F, 0.5F}, 0.1F, {20000});
    builder.setCollectSlots(true);
    const auto report = builder.update(input);
    for (const std::uint32_t slot : report.rebuiltSlots)
        QVERIFY(report.grooms[0]->style(slot).braid == BraidKind::None);
    QCOMPARE(hairsByCentre(*before), hairsByCentre(*report.grooms[0]));
}

HAIRPAINT_TEST(TestBraids, None)
#include "test_braids.moc"
