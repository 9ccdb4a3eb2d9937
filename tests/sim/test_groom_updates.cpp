// An update rebuilds what differs, nothing else, and leaves the bytes of a fresh build.
#include "groom_bytes.h"
#include "sim/base/deterministic.h"
#include "sim/base/parallel.h"
#include "sim/groom/direction_texel.h"
#include "sim/groom/groom.h"
#include "tests/support/test_grooms.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

GroomInput startInput()
{
    GroomInput::Group group = uniformGroup();
    group.settings.greatestDensityPerM2 = 1e5F;
    group.settings.basisHairs = 512;
    group.maps[MapSlot::Density] = uniformMap(0.6F);
    group.settings.variation = {.length = 0.1F,
                                .curl = 0.2F,
                                .width = 0.2F,
                                .crossing = 0.05F,
                                .flyaways = 0.05F,
                                .parting = 0.006F,
                                .mostShorterM = 0.01F,
                                .partGapM = 0.004F,
                                .patches = 0.5F};
    group.settings.hairline = {.softenM = 0.01F, .baby = 0.3F, .uneven = 0.5F};
    group.settings.physics.volumeRiseM = 0.03F;
    group.maps[MapSlot::Curl] = uniformMap(0.3F);
    return inputOf(std::make_shared<const Skin>(makeBallHead(48, 0.1F)), group);
}

/// A texel for one of the maps.
Texel randomTexel(const MapRule& rule, std::uint64_t hash)
{
    if (rule.sampling == MapSampling::Nearest)
        return {static_cast<std::uint16_t>(hash % 2)};
    if (rule.channels == 3)
        return {static_cast<std::uint16_t>(hash), static_cast<std::uint16_t>(hash >> 16U),
                static_cast<std::uint16_t>(hash >> 32U)};
    // Often one of the ends, where hairs come and go.
    return {static_cast<std::uint16_t>(hash % 4 == 0 ? 0 : hash % 4 == 1 ? 65535 : hash >> 40U)};
}

void verifySame(const Groom& a, const Groom& b, const QString& where)
{
    const char* difference = differenceOf(a, b);
    QVERIFY2(difference == nullptr, qPrintable(where + QStringLiteral(": ") + QLatin1StringView(difference)));
}

} // namespace

class TestGroomUpdates : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void cleanup() { setThreadCount(0); }
    void nothingChangedIsTheSameGroom();
    void aDabRebuildsTheStrandsUnderItAndNoOthers_data();
    void aDabRebuildsTheStrandsUnderItAndNoOthers();
    void aCombedDabRelaysTheStrandsThatCrossIt_data();
    void aCombedDabRelaysTheStrandsThatCrossIt();
    void aDabSharesAllOtherChunks();
    void aColourMovesNoStrand();
    void whatOnlyBasisHairsReadRebuildsNoStrand();
    void repaintingTheOldValueBringsTheOldBytesBack_data();
    void repaintingTheOldValueBringsTheOldBytesBack();
    void unchangedValuesInNewTilesRebuildNothing();
    void randomEditsEqualAFreshBuild_data();
    void randomEditsEqualAFreshBuild();
    void settingsThatLeaveTheHairsAloneShareThem();
    void settingsThatChangeTheHairsEqualAFreshBuild_data();
    void settingsThatChangeTheHairsEqualAFreshBuild();
    void groupsComeGoAndChangeOrder();
    void anyNumberOfThreadsGivesTheSameBytes_data();
    void anyNumberOfThreadsGivesTheSameBytes();
};

void TestGroomUpdates::nothingChangedIsTheSameGroom()
{
    const GroomInput input = startInput();
    GroomBuilder builder;
    const auto first = builder.update(input);
    QCOMPARE(first.rebuiltStrands, first.grooms[0]->hairCount);
    const auto second = builder.update(input);
    QVERIFY(first.grooms[0] == second.grooms[0]);
    QCOMPARE(second.rebuiltStrands, std::size_t{0});
}

void TestGroomUpdates::aDabRebuildsTheStrandsUnderItAndNoOthers_data()
{
    QTest::addColumn<MapSlot>("map");
    QTest::addColumn<float>("u");
    QTest::addColumn<float>("v");
    for (const MapRule& rule : kMapRules) {
        // A braid may change within its region, a lay wherever hairs cross it; what only basis hairs read rebuilds no
        // strand.
        if (rule.slot == MapSlot::Braid || rule.slot == MapSlot::Direction || (!rule.effect.hairs && !rule.effect.look))
            continue;
        const std::size_t map = indexOf(rule.slot);
        QTest::addRow("map %zu, inside a tile", map) << rule.slot << 0.56F << 0.56F;
        QTest::addRow("map %zu, over tiles' corners", map) << rule.slot << 0.5F << 0.625F;
        QTest::addRow("map %zu, at the border", map) << rule.slot << 0.0F << 0.5F;
    }
}

void TestGroomUpdates::aDabRebuildsTheStrandsUnderItAndNoOthers()
{
    QFETCH(MapSlot, map);
    QFETCH(float, u);
    QFETCH(float, v);
    constexpr float kRadius = 0.05F;
    constexpr float kTexel = 1.0F / 512.0F;
    GroomInput input = startInput();
    GroomBuilder builder;
    builder.setCollectSlots(true);
    const auto before = builder.update(input).grooms[0];
    auto& raster = input.groups[0].maps[map];
    raster = withDab(raster, {u, v}, kRadius, {50000, 1000, 1000});
    const auto report = builder.update(input);
    const RootSet& roots = *before->roots;

    QCOMPARE(report.rebuiltSlots.size(), report.rebuiltStrands);
    const std::set<std::uint32_t> rebuilt(report.rebuiltSlots.begin(), report.rebuiltSlots.end());
    std::size_t inside = 0;
    for (std::uint32_t slot = 0; slot < roots.count(); ++slot) {
        const float distance = glm::length(roots.uv[slot] - glm::vec2(u, v));
        if (distance > kRadius + 1.5F * kTexel)
            QVERIFY(!rebuilt.contains(slot));
        const Groom& after = *report.grooms[0];
        const auto isHair = [&](const Groom& groom) {
            const auto& chunk = groom.chunks[slot / kChunkSlots];
            return chunk && chunk->hairs[slot % kChunkSlots];
        };
        if (distance < kRadius - kTexel && (isHair(*before) || isHair(after))) {
            QVERIFY(rebuilt.contains(slot));
            ++inside;
        }
    }
    QVERIFY(inside > 10U);
}

void TestGroomUpdates::aCombedDabRelaysTheStrandsThatCrossIt_data()
{
    QTest::addColumn<float>("clump");
    QTest::addColumn<float>("lengthM");
    QTest::newRow("short") << 0.0F << 0.02F;
    QTest::newRow("long") << 0.0F << 0.20F;
    QTest::newRow("clumped") << 0.5F << 0.06F;
}

void TestGroomUpdates::aCombedDabRelaysTheStrandsThatCrossIt()
{
    QFETCH(float, clump);
    QFETCH(float, lengthM);
    constexpr float kRadius = 0.04F;
    const glm::vec2 centre(0.56F, 0.56F);
    GroomInput input = startInput();
    input.groups[0].settings.variation.partGapM = 0.0F; // Else also those to which it may be a parting.
    input.groups[0].settings.greatestLengthM = lengthM;
    input.groups[0].maps[MapSlot::Clump] = uniformMap(clump);
    input.groups[0].maps[MapSlot::Direction] = std::make_shared<TiledRaster>(512, 2, texelOfDirection({0.9F, 0.1F}));
    GroomBuilder builder;
    builder.setCollectSlots(true);
    const auto before = builder.update(input).grooms[0];
    auto& raster = input.groups[0].maps[MapSlot::Direction];
    raster = withDab(raster, centre, kRadius, texelOfDirection({0.0F, -0.8F}));
    const auto report = builder.update(input);
    verifySame(*report.grooms[0], *GroomBuilder().update(input).grooms[0], QStringLiteral("combed"));

    const std::set<std::uint32_t> rebuilt(report.rebuiltSlots.begin(), report.rebuiltSlots.end());
    const RootSet& roots = *before->roots;
    std::size_t rootedElsewhere = 0;
    for (const std::uint32_t slot : rebuilt) {
        // Some point along the hair, or along the one that it clumps to, is over the dab: a texel and a cell around it.
        const auto crosses = [&](std::span<const float> positions, std::size_t strand) {
            for (std::size_t node = 1; node < static_cast<std::size_t>(before->nodes); ++node)
                for (int part = 0; part <= 8; ++part) {
                    const glm::vec3 a = before->blocks().node(positions, strand, node - 1);
                    const glm::vec3 b = before->blocks().node(positions, strand, node);
                    const SurfacePoint under = roots.skin->nearest(a + (b - a) * (static_cast<float>(part) / 8.0F));
                    if (glm::length(under.uv - centre) < kRadius + 0.02F)
                        return true;
                }
            return false;
        };
        const StrandChunk& chunk = *before->chunks[chunkOf(slot)];
        QVERIFY(crosses(chunk.restPositions, inChunk(slot)) ||
                (clump > 0.0F && crosses(before->basis->restPositions, roots.neighbours[slot][0])));
        rootedElsewhere += glm::length(roots.uv[slot] - centre) > kRadius + 0.01F ? 1 : 0;
    }
    QVERIFY(rootedElsewhere > 0);
    QVERIFY(rebuilt.size() < before->hairCount / 4);
}

void TestGroomUpdates::aDabSharesAllOtherChunks()
{
    GroomInput input = startInput();
    GroomBuilder builder;
    builder.setCollectSlots(true);
    const auto before = builder.update(input).grooms[0];
    auto& length = input.groups[0].maps[MapSlot::Length];
    length = withDab(length, {0.5F, 0.6F}, 0.04F, {50000});
    const auto report = builder.update(input);
    std::set<std::size_t> touched;
    for (const std::uint32_t slot : report.rebuiltSlots)
        touched.insert(slot / kChunkSlots);
    QVERIFY(!touched.empty());
    for (std::size_t i = 0; i < before->chunks.size(); ++i)
        QCOMPARE(before->chunks[i] == report.grooms[0]->chunks[i], !touched.contains(i));
}

void TestGroomUpdates::aColourMovesNoStrand()
{
    GroomInput input = startInput();
    input.groups[0].maps[MapSlot::Braid] = withDab(input.groups[0].maps[MapSlot::Braid], {0.4F, 0.7F}, 0.15F, {1});
    GroomBuilder builder;
    const auto before = builder.update(input).grooms[0];
    MapRaster& colour = input.groups[0].maps[MapSlot::Colour];
    colour = withDab(colour, {0.5F, 0.6F}, 0.2F, {50000, 1000, 1000});
    const auto report = builder.update(input);
    const Groom& after = *report.grooms[0];
    QVERIFY(report.rebuiltStrands > 100);
    QVERIFY(after.basis == before->basis);
    for (std::size_t i = 0; i < after.chunks.size(); ++i)
        QVERIFY(!after.chunks[i] || sameBytes(after.chunks[i]->restPositions, before->chunks[i]->restPositions));
    verifySame(after, *GroomBuilder().update(input).grooms[0], QStringLiteral("colours"));
}

void TestGroomUpdates::whatOnlyBasisHairsReadRebuildsNoStrand()
{
    GroomInput input = startInput();
    GroomBuilder builder;
    const auto before = builder.update(input).grooms[0];
    MapRaster& gel = input.groups[0].maps[MapSlot::Gel];
    gel = withDab(gel, {0.5F, 0.6F}, 0.2F, {50000});
    const auto report = builder.update(input);
    QCOMPARE(report.rebuiltStrands, std::size_t{0});
    QVERIFY(report.grooms[0]->chunks == before->chunks);
    QVERIFY((*report.grooms[0]->basis)[BasisQuantity::Gel] != (*before->basis)[BasisQuantity::Gel]);
    verifySame(*report.grooms[0], *GroomBuilder().update(input).grooms[0], QStringLiteral("gel"));
}

void TestGroomUpdates::repaintingTheOldValueBringsTheOldBytesBack_data()
{
    QTest::addColumn<MapSlot>("map");
    for (const MapRule& rule : kMapRules)
        if (rule.effect != MapEffect{})
            QTest::addRow("map %zu", indexOf(rule.slot)) << rule.slot;
}

void TestGroomUpdates::repaintingTheOldValueBringsTheOldBytesBack()
{
    QFETCH(MapSlot, map);
    GroomInput input = startInput();
    if (map == MapSlot::TipStart) // Where tips begin is looked at where they have a colour of their own.
        input.groups[0].maps[MapSlot::TipColour] =
            withDab(input.groups[0].maps[MapSlot::TipColour], {0.5F, 0.6F}, 0.2F, {65535, 0, 0});
    GroomBuilder builder;
    const auto before = builder.update(input).grooms[0];
    auto& raster = input.groups[0].maps[map];
    const Texel old = raster->texel(0, 0);
    const Texel painted = map == MapSlot::Braid ? Texel{1} : Texel{};
    raster = withDab(raster, {0.5F, 0.6F}, 0.1F, painted == old ? Texel{65535} : painted);
    const auto between = builder.update(input).grooms[0];
    QVERIFY(differenceOf(*before, *between) != nullptr);
    // The pixels stay expanded: not the old tiles, but the old values.
    raster = withDab(raster, {0.5F, 0.6F}, 0.1F, old);
    verifySame(*before, *builder.update(input).grooms[0], QStringLiteral("repainted"));
}

void TestGroomUpdates::unchangedValuesInNewTilesRebuildNothing()
{
    GroomInput input = startInput();
    GroomBuilder builder;
    (void)builder.update(input);
    for (const MapRule& rule : kMapRules) {
        auto copy = std::make_shared<TiledRaster>(*input.groups[0].maps[rule.slot]);
        for (int tile = 0; tile < copy->tileCount(); ++tile)
            (void)copy->writableTile(tile);
        input.groups[0].maps[rule.slot] = std::move(copy);
    }
    QCOMPARE(builder.update(input).rebuiltStrands, std::size_t{0});
}

void TestGroomUpdates::randomEditsEqualAFreshBuild_data()
{
    QTest::addColumn<quint64>("seed");
    for (quint64 seed = 1; seed <= 5; ++seed)
        QTest::addRow("seed %llu", seed) << seed;
}

void TestGroomUpdates::randomEditsEqualAFreshBuild()
{
    QFETCH(quint64, seed);
    GroomInput input = startInput();
    GroomBuilder builder;
    std::vector<GroupMaps> history;
    for (std::uint64_t edit = 0; edit < 24; ++edit) {
        history.push_back(input.groups[0].maps);
        const auto random = [&](std::uint64_t what) { return hash64(seed, edit * 16 + what); };
        const MapRule& rule = kMapRules[random(0) % kMapRules.size()];
        MapRaster& raster = input.groups[0].maps[rule.slot];
        if (random(1) % 8 == 0) {
            raster = history[random(2) % history.size()][rule.slot]; // Undo.
        } else if (random(1) % 8 == 1) {
            auto filled = std::make_shared<TiledRaster>(*raster);
            for (int tile = 0; tile < filled->tileCount(); ++tile)
                filled->setUniform(tile, randomTexel(rule, random(3)));
            raster = std::move(filled);
        } else {
            const glm::vec2 centre(unitFloat(random(4)), unitFloat(random(5)));
            raster = withDab(raster, centre, 0.02F + 0.15F * unitFloat(random(6)), randomTexel(rule, random(3)));
        }
        const auto incremental = builder.update(input).grooms[0];
        if (edit % 3 == 2) {
            const auto fresh = GroomBuilder().update(input).grooms[0];
            verifySame(*incremental, *fresh, QStringLiteral("edit %1, map %2").arg(edit).arg(indexOf(rule.slot)));
        }
    }
}

void TestGroomUpdates::settingsThatLeaveTheHairsAloneShareThem()
{
    GroomInput input = startInput();
    GroomBuilder builder;
    const auto before = builder.update(input).grooms[0];
    input.groups[0].settings.physics.damping = 5.0F;
    input.groups[0].settings.material.shine = 0.9F;
    input.groups[0].settings.material.widthM = 1e-4F;
    input.groups[0].settings.material.colourVariation = 0.5F;
    input.groups[0].visible = false;
    const auto report = builder.update(input);
    QCOMPARE(report.rebuiltStrands, std::size_t{0});
    QVERIFY(report.grooms[0] != before);
    QVERIFY(report.grooms[0]->chunks == before->chunks);
    QVERIFY(report.grooms[0]->settings == input.groups[0].settings);
    QVERIFY(!report.grooms[0]->visible);
}

void TestGroomUpdates::settingsThatChangeTheHairsEqualAFreshBuild_data()
{
    using Change = std::function<void(GroomInput&)>;
    QTest::addColumn<Change>("change");
    const auto row = [](const char* name, const Change& change) { QTest::newRow(name) << change; };
    row("greatest density", [](GroomInput& i) { i.groups[0].settings.greatestDensityPerM2 = 3e5F; });
    row("greatest length", [](GroomInput& i) { i.groups[0].settings.greatestLengthM = 0.1F; });
    row("nodes", [](GroomInput& i) { i.groups[0].settings.nodesPerHair = 5; });
    row("basis hairs", [](GroomInput& i) { i.groups[0].settings.basisHairs = 300; });
    row("turns per length", [](GroomInput& i) { i.groups[0].settings.turnsMode = TurnsMode::PerLength; });
    row("variation", [](GroomInput& i) {
        i.groups[0].settings.variation = {
            .length = 0.2F, .curl = 0.3F, .crossing = 0.1F, .flyaways = 0.1F, .grey = 0.3F};
    });
    row("parting", [](GroomInput& i) { i.groups[0].settings.variation.parting = 0.001F; });
    row("hairline", [](GroomInput& i) { i.groups[0].settings.hairline = {.softenM = 0.005F, .baby = 0.2F}; });
    row("uneven hairline", [](GroomInput& i) { i.groups[0].settings.hairline.uneven = 0.9F; });
    row("bounded lengths", [](GroomInput& i) { i.groups[0].settings.variation.mostShorterM = 0.002F; });
    row("bare parting", [](GroomInput& i) { i.groups[0].settings.variation.partGapM = 0.009F; });
    row("patches", [](GroomInput& i) { i.groups[0].settings.variation.patches = 0.9F; });
    row("rise of the volume", [](GroomInput& i) { i.groups[0].settings.physics.volumeRiseM = 0.06F; });
    row("braid spacing", [](GroomInput& i) { i.groups[0].settings.braidSpacingM = 0.05F; });
    row("seed", [](GroomInput& i) { i.seed = 2; });
    row("limit", [](GroomInput& i) { i.maxHairs = 3000; });
    row("skin", [](GroomInput& i) { i.skin = std::make_shared<const Skin>(makeBallHead(30, 0.09F)); });
    row("size of a map", [](GroomInput& i) { i.groups[0].maps[MapSlot::Curl] = uniformMap(0.4F, 1024); });
}

void TestGroomUpdates::settingsThatChangeTheHairsEqualAFreshBuild()
{
    QFETCH(std::function<void(GroomInput&)>, change);
    GroomInput input = startInput();
    auto& maps = input.groups[0].maps;
    maps[MapSlot::Braid] = withDab(maps[MapSlot::Braid], {0.4F, 0.7F}, 0.15F, {1});
    maps[MapSlot::Curl] = withDab(maps[MapSlot::Curl], {0.6F, 0.6F}, 0.2F, {40000});
    GroomBuilder builder;
    const auto before = builder.update(input).grooms[0];
    change(input);
    const auto after = builder.update(input).grooms[0];
    QVERIFY(differenceOf(*before, *after) != nullptr);
    verifySame(*after, *GroomBuilder().update(input).grooms[0], QStringLiteral("after"));
}

void TestGroomUpdates::groupsComeGoAndChangeOrder()
{
    GroomInput input = startInput();
    GroomInput::Group brow = input.groups[0];
    brow.id = 7;
    brow.settings.greatestLengthM = 0.01F;
    GroomBuilder builder;
    const auto scalp = builder.update(input).grooms[0];
    input.groups.push_back(brow);
    auto report = builder.update(input);
    QCOMPARE(report.grooms.size(), std::size_t{2});
    QVERIFY(report.grooms[0] == scalp);
    const auto browGroom = report.grooms[1];
    QCOMPARE(browGroom->groupId, 7);
    QCOMPARE(report.rebuiltStrands, browGroom->hairCount);
    std::swap(input.groups[0], input.groups[1]);
    report = builder.update(input);
    QVERIFY(report.grooms[0] == browGroom && report.grooms[1] == scalp);
    input.groups.erase(input.groups.begin());
    report = builder.update(input);
    QCOMPARE(report.grooms.size(), std::size_t{1});
    QVERIFY(report.grooms[0] == scalp);
}

void TestGroomUpdates::anyNumberOfThreadsGivesTheSameBytes_data()
{
    QTest::addColumn<int>("threads");
    QTest::newRow("two") << 2;
    QTest::newRow("eight") << 8;
}

void TestGroomUpdates::anyNumberOfThreadsGivesTheSameBytes()
{
    QFETCH(int, threads);
    const auto run = [](int count) {
        setThreadCount(count);
        GroomInput input = startInput();
        GroomBuilder builder;
        std::vector<std::shared_ptr<const Groom>> grooms{builder.update(input).grooms[0]};
        auto& maps = input.groups[0].maps;
        maps[MapSlot::Braid] = withDab(maps[MapSlot::Braid], {0.4F, 0.7F}, 0.15F, {1});
        maps[MapSlot::Clump] = withDab(maps[MapSlot::Clump], {0.5F, 0.5F}, 0.3F, {40000});
        grooms.push_back(builder.update(input).grooms[0]);
        maps[MapSlot::Length] = withDab(maps[MapSlot::Length], {0.45F, 0.65F}, 0.1F, {60000});
        grooms.push_back(builder.update(input).grooms[0]);
        return grooms;
    };
    const auto one = run(1);
    const auto many = run(threads);
    for (std::size_t i = 0; i < one.size(); ++i)
        verifySame(*one[i], *many[i], QStringLiteral("update %1").arg(i));
}

HAIRPAINT_TEST(TestGroomUpdates, None)
#include "test_groom_updates.moc"
