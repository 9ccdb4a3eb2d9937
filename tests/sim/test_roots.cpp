// Roots are an even cover at every density, and stay where they are when more are added.
#include "sim/base/deterministic.h"
#include "sim/base/parallel.h"
#include "sim/groom/roots.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <tuple>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

constexpr std::uint64_t kSeed = 5;

/// Greatest difference, over boxes with a corner at the origin, between the fraction of points in a box and its area.
double starDiscrepancy(const std::vector<glm::vec2>& points)
{
    constexpr int kSteps = 64;
    std::vector<double> counts((kSteps + 1) * (kSteps + 1), 0.0);
    for (const glm::vec2& p : points) {
        const auto x = static_cast<std::size_t>(std::min(p.x * kSteps, kSteps - 1.0F));
        const auto y = static_cast<std::size_t>(std::min(p.y * kSteps, kSteps - 1.0F));
        counts[(y + 1) * (kSteps + 1) + x + 1] += 1.0;
    }
    double worst = 0.0;
    for (std::size_t y = 1; y <= kSteps; ++y) {
        for (std::size_t x = 1; x <= kSteps; ++x) {
            const std::size_t at = y * (kSteps + 1) + x;
            counts[at] += counts[at - 1] + counts[at - kSteps - 1] - counts[at - kSteps - 2];
            const double area = static_cast<double>(x * y) / (kSteps * kSteps);
            worst = std::max(worst, std::abs(counts[at] / static_cast<double>(points.size()) - area));
        }
    }
    return worst;
}

template<typename T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.size() == b.size() &&
           std::equal(reinterpret_cast<const char*>(a.data()), reinterpret_cast<const char*>(a.data() + a.size()),
                      reinterpret_cast<const char*>(b.data()));
}

bool sameRoots(const RootSet& a, const RootSet& b)
{
    return sameBytes(a.rankOfSlot, b.rankOfSlot) && sameBytes(a.slotOfRank, b.slotOfRank) &&
           sameBytes(a.face, b.face) && sameBytes(a.uv, b.uv) && sameBytes(a.positionHd, b.positionHd) &&
           sameBytes(a.normalHd, b.normalHd) && sameBytes(a.tangentHd, b.tangentHd) &&
           sameBytes(a.neighbours, b.neighbours) && sameBytes(a.weights, b.weights) &&
           sameBytes(a.basisSlot, b.basisSlot);
}

} // namespace

class TestRoots : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void cleanup() { setThreadCount(0); }
    void everyPrefixIsMoreEvenThanRandom_data();
    void everyPrefixIsMoreEvenThanRandom();
    void rootsFollowTheAreaOfTheFaces();
    void rootsFillTheInsideOfAFaceEvenly();
    void ranksAndSlotsAreInverse();
    void aChunkIsAPatchOfSkinWhoseRanksRise();
    void raisingTheCountOnlyAppends();
    void anotherSeedGivesOtherRoots();
    void anyNumberOfThreadsGivesTheSameBytes_data();
    void anyNumberOfThreadsGivesTheSameBytes();
    void basisHairsAreTheFirstRanksAndFollowThemselves();
    void weightsSumToOneAndNeighboursAreTheNearest_data();
    void weightsSumToOneAndNeighboursAreTheNearest();
    void weightsChangeSmoothlyAlongTheSkin();
    void hairsFollowBasisHairsOfTheirOwnSide();
    void rootsOnOneSpotFindTheirNeighboursInTime();
    void smallAndEmptySetsAreAllowed_data();
    void smallAndEmptySetsAreAllowed();
};

void TestRoots::everyPrefixIsMoreEvenThanRandom_data()
{
    QTest::addColumn<int>("segments");
    QTest::addColumn<double>("fraction");
    for (const int segments : {1, 40, 160}) {
        for (const double fraction : {0.01, 0.1, 0.37, 1.0})
            QTest::addRow("%d faces, %g %%", 2 * segments * segments, fraction * 100.0) << segments << fraction;
    }
}

void TestRoots::everyPrefixIsMoreEvenThanRandom()
{
    QFETCH(int, segments);
    QFETCH(double, fraction);
    constexpr std::size_t kCount = 20000;
    const auto skin = std::make_shared<const Skin>(makePatchHead(segments));
    const auto roots = buildRoots(skin, kCount, 256, kSeed);
    const auto prefix = static_cast<std::size_t>(fraction * static_cast<double>(kCount));
    std::vector<glm::vec2> ours;
    std::vector<glm::vec2> random;
    for (std::uint32_t rank = 0; rank < prefix; ++rank) {
        ours.push_back(roots->uv[roots->slotOfRank[rank]]);
        random.emplace_back(unitFloat(hash64(77, rank * 2U)), unitFloat(hash64(77, rank * 2U + 1)));
    }
    const double found = starDiscrepancy(ours);
    const double reference = starDiscrepancy(random);
    QVERIFY2(found < 0.6 * reference, qPrintable(QStringLiteral("%1 against %2").arg(found).arg(reference)));
}

void TestRoots::rootsFollowTheAreaOfTheFaces()
{
    const auto skin = std::make_shared<const Skin>(makeBallHead(24));
    const auto roots = buildRoots(skin, 50000, 256, kSeed);
    std::vector<int> counts(skin->mesh().triangles.size(), 0);
    for (const std::uint32_t face : roots->face)
        ++counts[face];
    for (std::uint32_t face = 0; face < counts.size(); ++face) {
        const double expected = 50000.0 * static_cast<double>(skin->faceAreaM2(face)) / skin->areaM2();
        QVERIFY2(
            std::abs(counts[face] - expected) < 5.0,
            qPrintable(QStringLiteral("face %1: %2 roots, expected %3").arg(face).arg(counts[face]).arg(expected)));
    }
}

void TestRoots::rootsFillTheInsideOfAFaceEvenly()
{
    HeadMesh mesh;
    mesh.positionsHd = {{0.0F, 0.0F, 0.0F}, {0.1F, 0.0F, 0.0F}, {0.0F, 0.1F, 0.0F}};
    mesh.normalsHd.assign(3, {0.0F, 0.0F, 1.0F});
    mesh.uvs = {{0.0F, 0.0F}, {1.0F, 0.0F}, {0.0F, 1.0F}};
    mesh.triangles = {{0, 1, 2}};
    const auto roots = buildRoots(std::make_shared<const Skin>(std::move(mesh)), 6400, 256, kSeed);
    // 64 similar triangles: those of an 8 x 8 grid, whose cells below the diagonal hold two.
    std::array<std::array<std::array<int, 2>, 8>, 8> counts{};
    for (const glm::vec2& uv : roots->uv) {
        const glm::vec2 cell = uv * 8.0F;
        const glm::vec2 inside = cell - glm::floor(cell);
        ++counts[static_cast<std::size_t>(cell.y)][static_cast<std::size_t>(cell.x)]
                [inside.x + inside.y > 1.0F ? 1 : 0];
    }
    for (std::size_t y = 0; y < 8; ++y)
        for (std::size_t x = 0; x + y < 8; ++x)
            for (std::size_t upper = 0; upper < (x + y < 7 ? 2U : 1U); ++upper)
                QVERIFY2(std::abs(counts[y][x][upper] - 100) <= 3, qPrintable(QString::number(counts[y][x][upper])));
}

void TestRoots::ranksAndSlotsAreInverse()
{
    const auto roots = buildRoots(std::make_shared<const Skin>(makeBallHead()), 10007, 300, kSeed);
    QCOMPARE(roots->count(), std::size_t{10007});
    for (std::uint32_t rank = 0; rank < roots->count(); ++rank)
        QCOMPARE(roots->rankOfSlot[roots->slotOfRank[rank]], rank);
    QCOMPARE(roots->threshold(roots->slotOfRank[0]), 0.5F / 10007.0F);
}

void TestRoots::aChunkIsAPatchOfSkinWhoseRanksRise()
{
    const auto roots = buildRoots(std::make_shared<const Skin>(makeBallHead()), 20000, 300, kSeed);
    double sum = 0.0;
    for (std::size_t first = 0; first < roots->count(); first += kChunkSlots) {
        const std::size_t end = std::min<std::size_t>(first + kChunkSlots, roots->count());
        glm::vec3 middle(0.0F);
        for (std::size_t slot = first; slot < end; ++slot)
            middle += roots->positionHd[slot] / static_cast<float>(end - first);
        for (std::size_t slot = first; slot < end; ++slot)
            sum += static_cast<double>(glm::distance(roots->positionHd[slot], middle));
        QVERIFY(std::is_sorted(roots->rankOfSlot.begin() + static_cast<std::ptrdiff_t>(first),
                               roots->rankOfSlot.begin() + static_cast<std::ptrdiff_t>(end)));
    }
    // A disc of a twentieth of the ball has a radius of 4.5 cm.
    QVERIFY2(sum / 20000.0 < 0.045, qPrintable(QString::number(sum / 20000.0)));
}

void TestRoots::raisingTheCountOnlyAppends()
{
    const auto skin = std::make_shared<const Skin>(makeBallHead());
    const auto few = buildRoots(skin, 3000, 300, kSeed);
    const auto many = buildRoots(skin, 50000, 300, kSeed);
    for (std::uint32_t rank = 0; rank < few->count(); ++rank) {
        const std::uint32_t a = few->slotOfRank[rank];
        const std::uint32_t b = many->slotOfRank[rank];
        QCOMPARE(few->face[a], many->face[b]);
        QVERIFY(few->positionHd[a] == many->positionHd[b]);
        QVERIFY(few->uv[a] == many->uv[b]);
    }
    for (std::size_t k = 0; k < few->basisSlot.size(); ++k)
        QCOMPARE(few->rankOfSlot[few->basisSlot[k]], many->rankOfSlot[many->basisSlot[k]]);
}

void TestRoots::anotherSeedGivesOtherRoots()
{
    const auto skin = std::make_shared<const Skin>(makeBallHead());
    const auto a = buildRoots(skin, 1000, 256, 1);
    const auto b = buildRoots(skin, 1000, 256, 2);
    std::size_t same = 0;
    for (std::uint32_t rank = 0; rank < 1000; ++rank)
        if (glm::length(a->positionHd[a->slotOfRank[rank]] - b->positionHd[b->slotOfRank[rank]]) < 1e-3F)
            ++same;
    QVERIFY(same < 10);
}

void TestRoots::anyNumberOfThreadsGivesTheSameBytes_data()
{
    QTest::addColumn<int>("threads");
    QTest::newRow("two") << 2;
    QTest::newRow("eight") << 8;
}

void TestRoots::anyNumberOfThreadsGivesTheSameBytes()
{
    QFETCH(int, threads);
    const auto skin = std::make_shared<const Skin>(makeBallHead());
    setThreadCount(1);
    const auto one = buildRoots(skin, 30011, 512, kSeed);
    setThreadCount(threads);
    QVERIFY(sameRoots(*one, *buildRoots(skin, 30011, 512, kSeed)));
}

void TestRoots::basisHairsAreTheFirstRanksAndFollowThemselves()
{
    const auto roots = buildRoots(std::make_shared<const Skin>(makeBallHead()), 20000, 700, kSeed);
    QCOMPARE(roots->basisSlot.size(), std::size_t{700});
    double apartM = 0.0;
    for (std::size_t k = 1; k < roots->basisSlot.size(); ++k)
        apartM += static_cast<double>(
            glm::distance(roots->positionHd[roots->basisSlot[k]], roots->positionHd[roots->basisSlot[k - 1]]));
    // Neighbours in this order are neighbours on the skin, where basis hairs stand 13 mm apart.
    QVERIFY2(apartM / 700.0 < 0.03, qPrintable(QString::number(apartM / 700.0)));
    for (std::uint32_t k = 0; k < 700; ++k) {
        const std::uint32_t slot = roots->basisSlot[k];
        QVERIFY(roots->rankOfSlot[slot] < 700);
        QCOMPARE(roots->neighbours[slot][0], k);
        QCOMPARE(roots->weights[slot][0], 1.0F);
        QVERIFY(roots->neighbours[slot][1] != k && roots->neighbours[slot][2] != k);
    }
}

void TestRoots::weightsSumToOneAndNeighboursAreTheNearest_data()
{
    QTest::addColumn<bool>("ball");
    QTest::addColumn<int>("basis");
    QTest::addColumn<int>("step"); // Every one is looked at, but where there are many to compare it with.
    QTest::newRow("flat") << false << 256 << 1;
    QTest::newRow("ball") << true << 256 << 1;
    QTest::newRow("ball, most are basis hairs") << true << 4000 << 7;
}

void TestRoots::weightsSumToOneAndNeighboursAreTheNearest()
{
    QFETCH(bool, ball);
    QFETCH(int, basis);
    QFETCH(int, step);
    const auto roots = buildRoots(std::make_shared<const Skin>(ball ? makeBallHead() : makePatchHead()), 5000,
                                  static_cast<std::size_t>(basis), kSeed);
    // Normals agree on a flat patch, and differ as positions do on a ball: nearest is nearest in space, but for what
    // facets turn the ball's.
    const float toleranceM = ball ? 2e-4F : 1e-7F;
    for (std::uint32_t slot = 0; slot < roots->count(); slot += static_cast<std::uint32_t>(step)) {
        const auto& weights = roots->weights[slot];
        QVERIFY(std::abs(weights[0] + weights[1] + weights[2] - 1.0F) < 1e-5F);
        QVERIFY(weights[0] >= weights[1] && weights[1] >= weights[2] && weights[2] >= 0.0F);
        std::vector<float> distances;
        distances.reserve(roots->basisSlot.size());
        for (const std::uint32_t other : roots->basisSlot)
            distances.push_back(glm::length(roots->positionHd[other] - roots->positionHd[slot]));
        std::nth_element(distances.begin(), distances.begin() + 2, distances.end());
        for (const std::uint32_t neighbour : roots->neighbours[slot]) {
            const glm::vec3 other = roots->positionHd[roots->basisSlot[neighbour]];
            QVERIFY(glm::length(other - roots->positionHd[slot]) <= distances[2] + toleranceM);
        }
    }
}

void TestRoots::weightsChangeSmoothlyAlongTheSkin()
{
    const auto roots = buildRoots(std::make_shared<const Skin>(makePatchHead(16, 0.2F)), 100000, 256, kSeed);
    // Follow the position that the weighted basis roots stand for: between near roots it may not jump.
    const auto mean = [&](std::uint32_t slot) {
        glm::vec3 sum(0.0F);
        for (std::size_t k = 0; k < 3; ++k)
            sum += roots->positionHd[roots->basisSlot[roots->neighbours[slot][k]]] * roots->weights[slot][k];
        return sum;
    };
    // Roots of one small cell follow each other.
    constexpr float kNearM = 2e-4F;
    std::vector<std::uint32_t> slots(roots->count());
    std::iota(slots.begin(), slots.end(), 0U);
    std::ranges::sort(slots, {}, [&](std::uint32_t slot) {
        const glm::vec3 cell = glm::floor(roots->positionHd[slot] / kNearM);
        return std::tuple(cell.x, cell.y, cell.z);
    });
    std::size_t pairs = 0;
    for (std::size_t i = 1; i < slots.size(); ++i) {
        const std::uint32_t a = slots[i - 1];
        const std::uint32_t b = slots[i];
        if (glm::distance(roots->positionHd[a], roots->positionHd[b]) > kNearM || roots->rankOfSlot[a] < 256 ||
            roots->rankOfSlot[b] < 256)
            continue;
        ++pairs;
        // Spacing of basis hairs: 12 mm. A swap of neighbours with weights that do not vanish jumps by millimetres.
        QVERIFY2(glm::distance(mean(a), mean(b)) < 2.5e-3F,
                 qPrintable(QString::number(static_cast<double>(glm::distance(mean(a), mean(b))))));
    }
    QVERIFY(pairs > 1000);
}

void TestRoots::hairsFollowBasisHairsOfTheirOwnSide()
{
    // An ear: two sheets 4 mm apart, back to back, while basis hairs stand 12 mm apart.
    HeadMesh mesh = makePatchHead(16, 0.2F);
    const HeadMesh front = mesh;
    const auto base = static_cast<std::uint32_t>(mesh.positionsHd.size());
    for (std::size_t i = 0; i < front.positionsHd.size(); ++i) {
        mesh.positionsHd.push_back(front.positionsHd[i] - glm::vec3(0.0F, 0.0F, 0.004F));
        mesh.normalsHd.emplace_back(0.0F, 0.0F, -1.0F);
        mesh.uvs.push_back(front.uvs[i]);
    }
    for (const glm::uvec3& t : front.triangles)
        mesh.triangles.emplace_back(t.x + base, t.z + base, t.y + base);
    const auto roots = buildRoots(std::make_shared<const Skin>(std::move(mesh)), 20000, 512, kSeed);
    for (std::uint32_t slot = 0; slot < roots->count(); ++slot)
        for (const std::uint32_t neighbour : roots->neighbours[slot])
            QVERIFY(glm::dot(roots->normalHd[roots->basisSlot[neighbour]], roots->normalHd[slot]) > 0.0F);
}

/// Where equal positions are searched one by one this takes hours.
void TestRoots::rootsOnOneSpotFindTheirNeighboursInTime()
{
    const float far = 1e6F; // Floats are 1/16 apart here.
    HeadMesh mesh;
    mesh.positionsHd = {{far, far, far}, {far + 0.0625F, far, far}, {far, far + 0.0625F, far}};
    mesh.normalsHd.assign(3, {0.0F, 0.0F, 1.0F});
    mesh.uvs = {{0.0F, 0.0F}, {1.0F, 0.0F}, {0.0F, 1.0F}};
    mesh.triangles = {{0, 1, 2}};
    const auto roots = buildRoots(std::make_shared<const Skin>(std::move(mesh)), 1'500'000, 1'000'000, kSeed);
    QCOMPARE(roots->basisSlot.size(), std::size_t{1'000'000});
    for (std::size_t slot = 0; slot < roots->count(); slot += 997) {
        float sum = 0.0F;
        for (std::size_t k = 0; k < RootSet::kNeighbours; ++k) {
            QVERIFY(roots->neighbours[slot][k] < roots->basisSlot.size());
            sum += roots->weights[slot][k];
        }
        QVERIFY(std::abs(sum - 1.0F) < 1e-5F);
    }
}

void TestRoots::smallAndEmptySetsAreAllowed_data()
{
    QTest::addColumn<bool>("faces");
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("basis");
    QTest::addColumn<int>("expected");
    QTest::newRow("no faces") << false << 100 << 10 << 0;
    QTest::newRow("no candidates") << true << 0 << 256 << 0;
    QTest::newRow("one") << true << 1 << 256 << 1;
    QTest::newRow("two of two") << true << 2 << 2 << 2;
    QTest::newRow("three, one basis hair") << true << 3 << 1 << 3;
    QTest::newRow("fewer than the basis hairs") << true << 100 << 256 << 100;
}

void TestRoots::smallAndEmptySetsAreAllowed()
{
    QFETCH(bool, faces);
    QFETCH(int, count);
    QFETCH(int, basis);
    QFETCH(int, expected);
    const auto roots = buildRoots(std::make_shared<const Skin>(faces ? makePatchHead() : HeadMesh{}),
                                  static_cast<std::size_t>(count), static_cast<std::size_t>(basis), kSeed);
    QCOMPARE(roots->count(), static_cast<std::size_t>(expected));
    QCOMPARE(roots->basisSlot.size(), static_cast<std::size_t>(std::min(expected, basis)));
    for (std::size_t slot = 0; slot < roots->count(); ++slot) {
        for (const std::uint32_t neighbour : roots->neighbours[slot])
            QVERIFY(neighbour < roots->basisSlot.size());
        const auto& weights = roots->weights[slot];
        QVERIFY(std::abs(weights[0] + weights[1] + weights[2] - 1.0F) < 1e-5F);
    }
}

HAIRPAINT_TEST(TestRoots, None)
#include "test_roots.moc"
