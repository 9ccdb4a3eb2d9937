// Hairs are where the maps say, as the maps say, and painting one spot changes nothing elsewhere.
#include "sim/base/parallel.h"
#include "sim/groom/groom.h"
#include "tests/sim/groom_reading.h"
#include "tests/sim/small_groom.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <set>

using namespace hairpaint::sim;
using namespace hairpaint::test;

class TestGroom : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void cleanup() { setThreadCount(0); }
    void hairsAreProportionalToTheDensity_data();
    void hairsAreProportionalToTheDensity();
    void hairsFollowADensityThatVaries();
    void noHairGrowsWhereDensityIsZero();
    void aCandidateIsAHairBelowItsThreshold();
    void detailThinsEvenly();
    void lengthIsBetweenShortestAndGreatest_data();
    void lengthIsBetweenShortestAndGreatest();
    void tooShortHairsCountButAreNotDrawn();
    void coloursAreTheMapsOwn();
    void restShapesStandOnTheSkinAlongTheNormal();
    void clumpDrawsTipsToTheBasisHairAndKeepsLengths();
    void basisHairsHaveStylesOfTheirOwn();
    void basisHairsAreWantedWhileADependentIsDrawn();
    void theCandidatesAreCappedInTheGroupsOrder();
    void theMemoryOfAllNodesCapsTheCandidates();
    void groupsStandOnDifferentRoots();
    void chunksWithoutHairAreNull();
    void aSkinWithoutFacesGrowsNothing();
};

void TestGroom::hairsAreProportionalToTheDensity_data()
{
    QTest::addColumn<float>("density");
    for (const float density : {0.0F, 0.01F, 0.25F, 0.5F, 0.9F, 1.0F})
        QTest::addRow("%g", static_cast<double>(density)) << density;
}

void TestGroom::hairsAreProportionalToTheDensity()
{
    QFETCH(float, density);
    GroomInput::Group group = smallGroup();
    group.maps[MapSlot::Density] = uniformMap(density);
    const auto groom = groomOf(inputOf(patch(), group));
    QCOMPARE(groom->roots->count(), std::size_t{20000});
    QVERIFY2(std::abs(static_cast<double>(groom->hairCount) - 20000.0 * static_cast<double>(density)) <= 1.0,
             qPrintable(QString::number(groom->hairCount)));
    QCOMPARE(groom->drawnCount, groom->hairCount);
}

void TestGroom::hairsFollowADensityThatVaries()
{
    GroomInput::Group group = smallGroup();
    group.maps[MapSlot::Density] = ramp();
    const auto groom = groomOf(inputOf(patch(), group));
    std::array<int, 10> counts{};
    forEachHair(*groom, [&](std::uint32_t slot, const StrandStyle&) {
        ++counts[static_cast<std::size_t>(std::min(groom->roots->uv[slot].x * 10.0F, 9.0F))];
    });
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double expected = 2000.0 * (static_cast<double>(i) + 0.5) / 10.0;
        QVERIFY2(std::abs(counts[i] - expected) < 20.0, qPrintable(QStringLiteral("%1: %2").arg(i).arg(counts[i])));
    }
}

void TestGroom::noHairGrowsWhereDensityIsZero()
{
    GroomInput::Group group = smallGroup();
    group.maps[MapSlot::Density] = withDab(uniformMap(0.0F), {0.3F, 0.6F}, 0.1F, {65535});
    const auto groom = groomOf(inputOf(patch(), group));
    QVERIFY(groom->hairCount > 500);
    forEachHair(*groom, [&](std::uint32_t slot, const StrandStyle&) {
        QVERIFY(glm::length(groom->roots->uv[slot] - glm::vec2(0.3F, 0.6F)) < 0.1F + 1.5F / 512.0F);
    });
}

void TestGroom::aCandidateIsAHairBelowItsThreshold()
{
    GroomInput::Group group = smallGroup();
    group.maps[MapSlot::Density] = ramp();
    const auto groom = groomOf(inputOf(patch(), group));
    for (std::uint32_t slot = 0; slot < groom->roots->count(); ++slot) {
        const float density = group.maps[MapSlot::Density]->sampleScalar(groom->roots->uv[slot]);
        const float threshold = groom->roots->threshold(slot);
        const StrandStyle* style = styleAt(*groom, slot);
        QCOMPARE(style != nullptr, threshold < density);
        if (style != nullptr)
            QCOMPARE(style->detail, threshold / density);
    }
}

void TestGroom::detailThinsEvenly()
{
    GroomInput::Group group = smallGroup();
    group.maps[MapSlot::Density] = halves(0.2F, 0.8F);
    const auto groom = groomOf(inputOf(patch(), group));
    for (const float detail : {0.1F, 0.5F}) {
        std::array<double, 2> all{};
        std::array<double, 2> drawn{};
        forEachHair(*groom, [&](std::uint32_t slot, const StrandStyle& style) {
            const std::size_t half = groom->roots->uv[slot].x < 0.5F ? 0 : 1;
            all[half] += 1.0;
            drawn[half] += style.detail < detail ? 1.0 : 0.0;
        });
        for (std::size_t half = 0; half < 2; ++half)
            QVERIFY(std::abs(drawn[half] / all[half] - static_cast<double>(detail)) < 0.01);
    }
}

void TestGroom::lengthIsBetweenShortestAndGreatest_data()
{
    QTest::addColumn<float>("value");
    QTest::addColumn<float>("shortestM");
    QTest::addColumn<float>("lengthM");
    QTest::newRow("full") << 1.0F << 0.0F << 0.4F;
    QTest::newRow("half") << 0.5F << 0.0F << 0.2F;
    QTest::newRow("full, with a shortest") << 1.0F << 0.1F << 0.4F;
    QTest::newRow("half, with a shortest") << 0.5F << 0.1F << 0.25F;
    QTest::newRow("nothing, with a shortest") << 0.0F << 0.1F << 0.1F;
}

void TestGroom::lengthIsBetweenShortestAndGreatest()
{
    QFETCH(float, value);
    QFETCH(float, shortestM);
    QFETCH(float, lengthM);
    GroomInput::Group group = smallGroup();
    group.settings.greatestLengthM = 0.4F;
    group.settings.shortestLengthM = shortestM;
    group.maps[MapSlot::Length] = uniformMap(value);
    const auto groom = groomOf(inputOf(patch(), group));
    forEachHair(*groom, [&](std::uint32_t slot, const StrandStyle& style) {
        QVERIFY(std::abs(style.lengthM - lengthM) < 1e-5F);
        const StrandChunk& chunk = *groom->chunks[slot / kChunkSlots];
        QVERIFY(std::abs(chunk.segmentLengths[slot % kChunkSlots] * 7.0F - lengthM) < 1e-5F);
        QVERIFY(std::abs(glm::length(restNode(*groom, slot, 7) - restNode(*groom, slot, 0)) - lengthM) < 1e-5F);
    });
}

void TestGroom::tooShortHairsCountButAreNotDrawn()
{
    GroomInput::Group group = smallGroup();
    group.maps[MapSlot::Length] = halves(0.0F, 1.0F);
    const auto groom = groomOf(inputOf(patch(), group));
    QCOMPARE(groom->hairCount, std::size_t{20000});
    QVERIFY(groom->drawnCount > 9900 && groom->drawnCount < 10100);
    std::size_t drawn = 0;
    forEachHair(*groom, [&](std::uint32_t slot, const StrandStyle& style) {
        const bool isDrawn = groom->chunks[slot / kChunkSlots]->drawn[slot % kChunkSlots];
        QCOMPARE(isDrawn, style.lengthM >= kShortestDrawnM);
        QCOMPARE(style.detail < 1.0F, isDrawn);
        drawn += isDrawn ? 1U : 0U;
    });
    QCOMPARE(groom->drawnCount, drawn);
}

void TestGroom::coloursAreTheMapsOwn()
{
    GroomInput::Group group = smallGroup();
    group.maps[MapSlot::Colour] = uniformColour({1.0F, 128.0F / 255.0F, 3.0F / 255.0F});
    group.maps[MapSlot::TipColour] = uniformColour({1.0F, 1.0F, 0.0F});
    const auto groom = groomOf(inputOf(patch(), group));
    forEachHair(*groom, [&](std::uint32_t, const StrandStyle& style) {
        QCOMPARE(style.rootColour, 0xFF0380FFU);
        QCOMPARE(style.tipColour, 0xFF00FFFFU);
        QVERIFY(style.variation >= -1.0F && style.variation <= 1.0F);
        QCOMPARE(style.width, 1.0F);
    });
}

void TestGroom::restShapesStandOnTheSkinAlongTheNormal()
{
    GroomInput input = inputOf(std::make_shared<const Skin>(makeBallHead()), smallGroup());
    input.groups[0].settings.greatestDensityPerM2 = 1e5F;
    input.groups[0].settings.nodesPerHair = 12;
    const auto groom = groomOf(input);
    QCOMPARE(groom->nodes, 12);
    forEachHair(*groom, [&](std::uint32_t slot, const StrandStyle& style) {
        QVERIFY(restNode(*groom, slot, 0) == groom->roots->positionHd[slot]);
        for (int node = 1; node < 12; ++node) {
            const glm::vec3 expected =
                groom->roots->positionHd[slot] +
                groom->roots->normalHd[slot] * (style.lengthM * static_cast<float>(node) / 11.0F);
            QVERIFY(glm::length(restNode(*groom, slot, node) - expected) < 1e-6F);
        }
    });
}

void TestGroom::clumpDrawsTipsToTheBasisHairAndKeepsLengths()
{
    GroomInput::Group group = smallGroup();
    group.maps[MapSlot::Clump] = uniformMap(1.0F);
    const auto groom = groomOf(inputOf(patch(), group));
    const RootSet& roots = *groom->roots;
    forEachHair(*groom, [&](std::uint32_t slot, const StrandStyle& style) {
        QVERIFY(glm::length(restNode(*groom, slot, 0) - roots.positionHd[slot]) < 1e-7F);
        for (int node = 1; node < groom->nodes; ++node) {
            const float distance = glm::length(restNode(*groom, slot, node) - restNode(*groom, slot, node - 1));
            QVERIFY(std::abs(distance - style.lengthM / 7.0F) < 1e-6F);
        }
        const std::uint32_t basis = roots.basisSlot[roots.neighbours[slot][0]];
        const glm::vec3 tip = roots.positionHd[basis] + roots.normalHd[basis] * style.lengthM;
        const float atRoot = glm::length(roots.positionHd[slot] - roots.positionHd[basis]);
        QVERIFY(glm::length(restNode(*groom, slot, 7) - tip) <= 0.12F * atRoot + 1e-6F);
    });
}

void TestGroom::basisHairsHaveStylesOfTheirOwn()
{
    GroomInput::Group group = smallGroup();
    group.maps[MapSlot::Density] = halves(0.0F, 1.0F);
    group.maps[MapSlot::Length] = halves(0.0F, 1.0F);
    group.maps[MapSlot::Gel] = halves(0.25F, 0.75F);
    const auto groom = groomOf(inputOf(patch(), group));
    const BasisStyles& basis = *groom->basis;
    QCOMPARE(basis.blockCount(), std::size_t{16});
    int leadsAcross = 0;
    for (std::uint32_t i = 0; i < 256; ++i) {
        const glm::vec2 uv = groom->roots->uv[groom->roots->basisSlot[i]];
        if (std::abs(uv.x - 0.5F) < 0.01F)
            continue;
        // Where there is no hair, too, and never shorter than 5 mm; but as long as the hair that it is the nearest to.
        const bool left = uv.x < 0.5F;
        float rightmost = uv.x;
        for (std::size_t slot = 0; slot < groom->roots->count(); ++slot)
            if (groom->roots->neighbours[slot][0] == i)
                rightmost = std::max(rightmost, groom->roots->uv[slot].x);
        if (std::abs(rightmost - 0.5F) > 0.01F) {
            leadsAcross += left && rightmost > 0.5F ? 1 : 0;
            QVERIFY(std::abs(basis[BasisQuantity::SegmentLength][i] * 7.0F - (rightmost < 0.5F ? 0.005F : 0.3F)) <
                    1e-5F);
        }
        QVERIFY(std::abs(basis[BasisQuantity::Gel][i] - (left ? 0.25F : 0.75F)) < 1e-4F);
        QVERIFY(basis[BasisQuantity::Height][i] >= 0.0F && basis[BasisQuantity::Height][i] <= 1.0F);
        const glm::vec3 root = groom->roots->positionHd[groom->roots->basisSlot[i]];
        QCOMPARE(StrandBlocks(8).node(basis.restPositions, i, 0), root);
    }
    QVERIFY(leadsAcross > 0);
}

void TestGroom::basisHairsAreWantedWhileADependentIsDrawn()
{
    GroomInput::Group group = smallGroup();
    group.maps[MapSlot::Density] = withDab(uniformMap(0.0F), {0.3F, 0.6F}, 0.1F, {40000});
    const auto groom = groomOf(inputOf(patch(), group));
    std::set<std::uint32_t> followed;
    forEachHair(*groom, [&](std::uint32_t slot, const StrandStyle&) {
        for (std::size_t k = 0; k < RootSet::kNeighbours; ++k)
            if (groom->roots->weights[slot][k] > 0.0F)
                followed.insert(groom->roots->neighbours[slot][k]);
    });
    for (std::uint32_t i = 0; i < 256; ++i)
        QCOMPARE(hasLane(groom->basis->wanted, i), followed.contains(i));
    QCOMPARE(groom->basisCount, followed.size());
    QVERIFY(followed.size() > 5 && followed.size() < 40);
}

void TestGroom::theCandidatesAreCappedInTheGroupsOrder()
{
    GroomInput input = inputOf(patch(), smallGroup());
    input.groups.push_back(smallGroup());
    input.groups.push_back(smallGroup());
    input.groups[1].id = 2;
    input.groups[2].id = 3;
    input.maxHairs = 25000;
    const auto grooms = GroomBuilder().update(input).grooms;
    QCOMPARE(grooms.size(), std::size_t{3});
    QCOMPARE(grooms[0]->roots->count(), std::size_t{20000});
    QCOMPARE(grooms[1]->roots->count(), std::size_t{5000});
    QCOMPARE(grooms[2]->roots->count(), std::size_t{0});
    QCOMPARE(grooms[0]->limit, HairLimit::None);
    QCOMPARE(grooms[1]->limit, HairLimit::MaxHairs);
    QCOMPARE(grooms[2]->limit, HairLimit::MaxHairs);
}

void TestGroom::theMemoryOfAllNodesCapsTheCandidates()
{
    GroomInput::Group group = smallGroup();
    group.settings.greatestDensityPerM2 = 4e6F;
    group.settings.nodesPerHair = 32;
    GroomInput input = inputOf(patch(), group);
    for (group.id = 2; group.id <= 4; ++group.id)
        input.groups.push_back(group);
    const auto grooms = GroomBuilder().update(input).grooms;
    const std::size_t hairs = 2 * grooms[0]->roots->count() + grooms[2]->roots->count();
    QCOMPARE(grooms[1]->limit, HairLimit::None);
    QCOMPARE(grooms[2]->limit, HairLimit::Memory);
    QCOMPARE(grooms[3]->limit, HairLimit::Memory);
    QCOMPARE(grooms[3]->roots->count(), std::size_t{0});
    QCOMPARE(hairs, std::size_t{14'000'000 / 36}); // 32 nodes, and 4 for root and style
}

void TestGroom::groupsStandOnDifferentRoots()
{
    GroomInput input = inputOf(patch(), smallGroup());
    input.groups.push_back(smallGroup());
    input.groups[1].id = 2;
    const auto grooms = GroomBuilder().update(input).grooms;
    QVERIFY(grooms[0]->roots->positionHd[100] != grooms[1]->roots->positionHd[100]);
}

void TestGroom::chunksWithoutHairAreNull()
{
    GroomInput::Group group = smallGroup();
    group.maps[MapSlot::Density] = halves(0.0F, 1.0F);
    const auto groom = groomOf(inputOf(patch(), group));
    QCOMPARE(groom->chunks.size(), std::size_t{20});
    std::int32_t packed = 0;
    for (std::size_t i = 0; i < groom->chunks.size(); ++i)
        QCOMPARE(groom->packedChunk[i], groom->chunks[i] ? packed++ : -1);
    QCOMPARE(groom->packedChunks, packed);
    QVERIFY(packed >= 10 && packed < 20);
}

void TestGroom::aSkinWithoutFacesGrowsNothing()
{
    const auto groom = groomOf(inputOf(std::make_shared<const Skin>(HeadMesh{}), smallGroup()));
    QCOMPARE(groom->hairCount, std::size_t{0});
    QVERIFY(groom->basis && groom->roots);
    QCOMPARE(groom->basis->blockCount(), std::size_t{0});
}

HAIRPAINT_TEST(TestGroom, None)
#include "test_groom.moc"
