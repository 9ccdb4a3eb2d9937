// Distances to shapes that are known.
#include "sim/skin/distance_grid.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace hairpaint::sim;
using hairpaint::test::makeBallHead;

namespace {

constexpr float kRadiusM = 0.1F;

HeadMesh boxMesh(const glm::vec3& half)
{
    HeadMesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 sign((corner & 1) != 0 ? 1.0F : -1.0F, (corner & 2) != 0 ? 1.0F : -1.0F,
                             (corner & 4) != 0 ? 1.0F : -1.0F);
        mesh.positionsHd.push_back(sign * half);
        mesh.normalsHd.push_back(glm::normalize(sign));
        mesh.uvs.emplace_back(0.5F * sign + 0.5F);
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

} // namespace

class TestDistanceGrid : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void ofABallDistancesAreThoseToIt()
    {
        const auto grid = DistanceGrid::make(makeBallHead(112, kRadiusM));
        QVERIFY(grid);
        std::mt19937 random(1);
        std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
        for (int i = 0; i < 20000; ++i) {
            const glm::vec3 position = 0.12F * glm::vec3(unit(random), unit(random), unit(random));
            const auto sample = grid->at(position);
            QVERIFY(sample);
            const float distance = glm::length(position) - kRadiusM;
            const float expected = std::clamp(distance, -DistanceGrid::kReachM, DistanceGrid::kReachM);
            // Beside the cut-off the mean of nodes is a little less.
            const float tolerance = std::abs(distance) < DistanceGrid::kReachM - 0.006F ? 0.0004F : 0.002F;
            QVERIFY2(std::abs(sample->distanceM - expected) < tolerance,
                     qPrintable(QStringLiteral("%1 %2").arg(sample->distanceM).arg(expected)));
            if (std::abs(distance) < 0.015F)
                QVERIFY(glm::distance(sample->gradient, glm::normalize(position)) < 0.12F);
        }
        QVERIFY(!grid->at({0.2F, 0.0F, 0.0F}));
        QVERIFY(!grid->at({0.0F, std::numeric_limits<float>::quiet_NaN(), 0.0F}));
    }

    void anOpenedBallIsClosed_data()
    {
        QTest::addColumn<float>("belowY");
        QTest::newRow("one face is missing") << 1.0F;
        QTest::newRow("open below, as a bust") << -0.05F;
    }
    void anOpenedBallIsClosed()
    {
        QFETCH(float, belowY);
        HeadMesh ball = makeBallHead(64, kRadiusM);
        if (belowY > kRadiusM)
            ball.triangles.erase(ball.triangles.begin() + static_cast<std::ptrdiff_t>(ball.triangles.size() / 2));
        else
            std::erase_if(ball.triangles, [&](const glm::uvec3& t) { return ball.positionsHd[t.x].y < belowY; });
        const auto grid = DistanceGrid::make(ball);
        QVERIFY(grid);
        QVERIFY(grid->at(glm::vec3(0.0F))->distanceM < -0.02F);
        QVERIFY(grid->at({0.0F, 0.08F, 0.0F})->distanceM < -0.015F);
        QVERIFY(grid->at({0.0F, 0.11F, 0.0F})->distanceM > 0.008F);
        if (belowY < kRadiusM)
            QVERIFY(grid->at({0.0F, -0.08F, 0.0F})->distanceM > 0.015F);
    }

    void aThinSheetHasAnInside()
    {
        const auto grid = DistanceGrid::make(boxMesh({0.03F, 0.02F, 0.0022F})); // As an ear.
        QVERIFY(grid);
        for (int mm = -25; mm <= 25; ++mm)
            QVERIFY2(grid->at({0.001F * static_cast<float>(mm), 0.003F, 0.0F})->distanceM < -0.0003F,
                     qPrintable(QString::number(mm)));
    }

    void aLargeHeadTakesLargerCellsAndAHugeOneHasNone()
    {
        const auto grid = DistanceGrid::make(makeBallHead(24, 0.5F));
        QVERIFY(grid && grid->layout().nodeCount() <= DistanceGrid::kMostNodes);
        QVERIFY(grid->layout().cellM > DistanceGrid::kCellM);
        QVERIFY(grid->at({0.0F, 0.45F, 0.0F})->distanceM < 0.0F);
        QVERIFY(!DistanceGrid::make(makeBallHead(24, 3.0F)));
        QVERIFY(!DistanceGrid::make(makeBallHead(24, 90.0F)));
    }

    void itStopsWhereItIsToldTo()
    {
        int asked = 0;
        QVERIFY(!DistanceGrid::make(makeBallHead(48, kRadiusM), [&asked](double done) {
            ++asked;
            return done < 0.3;
        }));
        QVERIFY(asked > 2 && asked < 10);
    }

    void valuesThatDoNotFitAreRefused()
    {
        QVERIFY(!DistanceGrid::of({.cellM = 0.01F, .size = {3, 3, 3}}, std::vector<std::int8_t>(26)));
        QVERIFY(!DistanceGrid::of({.cellM = 0.0F, .size = {3, 3, 3}}, std::vector<std::int8_t>(27)));
        QVERIFY(!DistanceGrid::of({.cellM = 0.01F, .size = {1, 3, 3}}, std::vector<std::int8_t>(9)));
        QVERIFY(DistanceGrid::of({.cellM = 0.01F, .size = {3, 3, 3}}, std::vector<std::int8_t>(27)));
    }
};

HAIRPAINT_TEST(TestDistanceGrid, None)
#include "test_distance_grid.moc"
