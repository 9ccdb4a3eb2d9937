// A strand's length, turns and radius are read back from the points that equation 1 gives.
#include "model/importing/strand_shape.h"
#include "sim/groom/strand_curve.h"
#include "tests/support/test_program.h"

#include <glm/gtc/constants.hpp>

#include <QTest>

#include <cmath>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

/// A strand of that style along an arc of `bendM` (0: straight), as it is drawn and exported.
std::vector<glm::vec3> strandOf(float lengthM, float turns, float radiusM, float phase, float bendM)
{
    constexpr int kNodes = 12;
    std::vector<glm::vec3> skeleton;
    for (int i = 0; i < kNodes; ++i) {
        const float along = lengthM * static_cast<float>(i) / static_cast<float>(kNodes - 1);
        skeleton.push_back(
            bendM > 0.0F ? glm::vec3(bendM * (1.0F - std::cos(along / bendM)), 0.0F, bendM * std::sin(along / bendM))
                         : glm::vec3(0.0F, 0.0F, along));
    }
    sim::StrandStyle style;
    style.lengthM = lengthM;
    style.turns = turns;
    style.curlRadiusM = radiusM;
    style.phase = phase;
    std::vector<glm::vec3> points;
    sim::evaluateStrand(skeleton, {1.0F, 0.0F, 0.0F}, style, sim::segmentsOf(style, kNodes), points);
    return points;
}

} // namespace

class TestStrandShape : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aCoilIsFound_data()
    {
        QTest::addColumn<float>("lengthM");
        QTest::addColumn<float>("turns");
        QTest::addColumn<float>("radiusM");
        QTest::addColumn<float>("bendM");
        QTest::newRow("waves") << 0.3F << 2.0F << 0.009F << 0.0F;
        QTest::newRow("ringlet") << 0.15F << 5.2F << 0.009F << 0.0F;
        QTest::newRow("bent ringlet") << 0.15F << 5.2F << 0.009F << 0.1F;
        QTest::newRow("as wide as its turns are apart") << 0.06F << 12.1F << 0.00496F << 0.0F;
        QTest::newRow("the same over a head") << 0.06F << 12.1F << 0.00496F << 0.09F;
        QTest::newRow("fine") << 0.2F << 16.0F << 0.003F << 0.1F;
    }
    void aCoilIsFound()
    {
        QFETCH(float, lengthM);
        QFETCH(float, turns);
        QFETCH(float, radiusM);
        QFETCH(float, bendM);
        StrandScratch scratch;
        StrandShape mean;
        constexpr int kPhases = 8;
        for (int i = 0; i < kPhases; ++i) {
            const float phase = glm::two_pi<float>() * static_cast<float>(i) / kPhases;
            const StrandShape shape = measureStrand(strandOf(lengthM, turns, radiusM, phase, bendM), scratch);
            // Where it ends in its turn makes one strand seem longer than the other.
            QVERIFY(std::abs(shape.lengthM - lengthM) < 0.12F * lengthM);
            QVERIFY(std::abs(shape.turns - turns) < 0.12F * turns);
            mean.lengthM += shape.lengthM / kPhases;
            mean.turns += shape.turns / kPhases;
            mean.radiusM += shape.radiusM / kPhases;
        }
        QVERIFY2(std::abs(mean.lengthM - lengthM) < 0.03F * lengthM, qPrintable(QString::number(mean.lengthM)));
        QVERIFY2(std::abs(mean.turns - turns) < 0.03F * turns, qPrintable(QString::number(mean.turns)));
        QVERIFY2(std::abs(mean.radiusM - radiusM) < 0.07F * radiusM, qPrintable(QString::number(mean.radiusM)));
    }

    void whatIsStraightOrMerelyBentHasNoCoil_data()
    {
        QTest::addColumn<float>("lengthM");
        QTest::addColumn<float>("bendM");
        QTest::newRow("straight") << 0.3F << 0.0F;
        QTest::newRow("over a head") << 0.3F << 0.1F;
        QTest::newRow("round and round") << 0.5F << 0.1F;
        QTest::newRow("stubble") << 0.003F << 0.0F;
    }
    void whatIsStraightOrMerelyBentHasNoCoil()
    {
        QFETCH(float, lengthM);
        QFETCH(float, bendM);
        StrandScratch scratch;
        const StrandShape shape = measureStrand(strandOf(lengthM, 0.0F, 0.0F, 0.0F, bendM), scratch);
        QCOMPARE(shape.turns, 0.0F);
        QVERIFY(std::abs(shape.lengthM - lengthM) < 0.01F * lengthM);
        QVERIFY(scratch.axisHd.size() >= 2);
    }

    void twoPointsAreAStrand()
    {
        StrandScratch scratch;
        const std::vector<glm::vec3> points = {{0.0F, 0.0F, 0.0F}, {0.0F, 0.2F, 0.0F}};
        QCOMPARE(measureStrand(points, scratch).lengthM, 0.2F);
        const std::vector<glm::vec3> onePoint(5, glm::vec3(1.0F));
        QCOMPARE(measureStrand(onePoint, scratch).lengthM, 0.0F);
    }
};

HAIRPAINT_TEST(TestStrandShape, None)
#include "test_strand_shape.moc"
