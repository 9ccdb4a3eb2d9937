// What stiffness, gel and coils do, against elastica and promises about rest.
#include "sim/motion/simulation.h"
#include "tests/sim/hanging_hair.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace hairpaint::sim;
using namespace hairpaint::test;

class TestStiffness : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void shortHairStandsAndLongHairHangs();
    void aCantileverBendsAsElasticaDo_data();
    void aCantileverBendsAsElasticaDo();
    void eachTenthOfGelIsStiffer();
    void loftCarriesHairNearItsRootAlone();
    void hairThatIsLaidInSharpTurnsComesToRest();
    void coilsBounceAndComeToRestAtTheirLength();
};

void TestStiffness::shortHairStandsAndLongHairHangs()
{
    const glm::vec3 root(0.1F, 0.0F, 0.0F);
    const glm::vec3 out(1.0F, 0.0F, 0.0F);
    GroupDynamics hair;
    hair.setGroom(groomOf({{root, out, 0.01F}, {root, out, 0.4F}}, 8, PhysicsSettings{}), ballCollider(),
                  WindField::calm({}));
    fall(hair, 240);
    const glm::vec3 shortOffset = nodeOf(hair, 0, 7) - root;
    const glm::vec3 longOffset = nodeOf(hair, 1, 7) - root;
    QVERIFY(shortOffset.x > 0.9F * 0.01F);
    QVERIFY(longOffset.y < -0.9F * 0.4F);
    QVERIFY2(longOffset.x < 0.1F * 0.4F, qPrintable(QString::number(longOffset.x)));
}

void TestStiffness::aCantileverBendsAsElasticaDo_data()
{
    QTest::addColumn<float>("length");
    QTest::addColumn<int>("nodes");
    QTest::newRow("2 cm") << 0.02F << 8;
    QTest::newRow("5 cm, as long as it carries itself") << 0.05F << 8;
    QTest::newRow("10 cm") << 0.10F << 8;
    QTest::newRow("10 cm, 24 nodes") << 0.10F << 24;
    QTest::newRow("20 cm") << 0.20F << 16;
}

/// Tip of a horizontal elastica under its own weight, by shooting: angle'' = -(l - s) cos(angle) / stiffness^3, 0 at
/// the root, without moment at the tip.
glm::dvec2 elasticaTip(double length, double stiffness)
{
    constexpr int kParts = 4000;
    const double step = length / kParts;
    const double cube = stiffness * stiffness * stiffness;
    const auto shoot = [&](double moment) {
        double angle = 0.0;
        glm::dvec2 position(0.0);
        for (int i = 0; i < kParts; ++i) {
            const double s = (i + 0.5) * step;
            const double middle = angle + 0.5 * step * moment;
            position += step * glm::dvec2(std::cos(middle), -std::sin(middle));
            moment -= step * (length - s) * std::cos(middle) / cube;
            angle = middle + 0.5 * step * moment;
        }
        return std::pair(moment, position);
    };
    double low = 0.0;
    double high = 0.5 * length * length / cube;
    for (int i = 0; i < 80; ++i) {
        const double middle = 0.5 * (low + high);
        (shoot(middle).first > 0.0 ? high : low) = middle;
    }
    return shoot(low).second;
}

void TestStiffness::aCantileverBendsAsElasticaDo()
{
    QFETCH(float, length);
    QFETCH(int, nodes);
    PhysicsSettings physics = barePhysics();
    physics.stiffnessM = 0.05F;
    physics.damping = 6.0F;
    GroupDynamics hair;
    hair.setGroom(groomOf({{glm::vec3(0.0F), glm::vec3(1.0F, 0.0F, 0.0F), length}}, nodes, physics), {},
                  WindField::calm({}));
    hair.reset();
    fall(hair, 1200);
    const glm::vec3 tip = nodeOf(hair, 0, nodes - 1);
    const glm::dvec2 wanted = elasticaTip(static_cast<double>(length), 0.05);
    const double apart = glm::distance(wanted, glm::dvec2(tip));
    QVERIFY2(apart < 0.04 * static_cast<double>(length),
             qPrintable(QStringLiteral("%1 %2, not %3 %4").arg(tip.x).arg(tip.y).arg(wanted.x).arg(wanted.y)));
}

void TestStiffness::eachTenthOfGelIsStiffer()
{
    float before = std::numeric_limits<float>::infinity();
    for (int tenths = 0; tenths <= 10; ++tenths) {
        PhysicsSettings physics = barePhysics();
        physics.stiffnessM = 0.05F;
        physics.damping = 3.0F;
        GroupDynamics hair;
        const float gel = static_cast<float>(tenths) / 10.0F;
        hair.setGroom(groomOf({{glm::vec3(0.0F), glm::vec3(1.0F, 0.0F, 0.0F), 0.15F, gel}}, 8, physics), {},
                      WindField::calm({}));
        hair.reset();
        fall(hair, 1200);
        const float shift = glm::distance(nodeOf(hair, 0, 7), glm::vec3(0.15F, 0.0F, 0.0F));
        QVERIFY2(shift <= 0.85F * before,
                 qPrintable(QStringLiteral("%1: %2 after %3").arg(gel).arg(shift).arg(before)));
        qInfo("gel %.1f: the tip yields by %.2f mm", static_cast<double>(gel), static_cast<double>(shift) * 1e3);
        before = shift;
    }
}

void TestStiffness::loftCarriesHairNearItsRootAlone()
{
    const auto tipY = [](float loft, float lengthM, float gravityScale) {
        PhysicsSettings physics = barePhysics();
        physics.stiffnessM = 0.01F;
        physics.damping = 6.0F;
        physics.gravityScale = gravityScale;
        physics.loft = loft;
        GroupDynamics hair;
        hair.setGroom(groomOf({{glm::vec3(0.0F), glm::vec3(1.0F, 0.0F, 0.0F), lengthM}}, 16, physics), {},
                      WindField::calm({}));
        fall(hair, 600);
        return nodeOf(hair, 0, 15).y;
    };
    QVERIFY(tipY(0.0F, 0.05F, 0.2F) < -0.03F);
    QVERIFY2(tipY(0.8F, 0.05F, 0.2F) > -0.005F, qPrintable(QString::number(tipY(0.8F, 0.05F, 0.2F))));
    QVERIFY(tipY(0.8F, 0.05F, 0.2F) < tipY(1.0F, 0.05F, 0.2F));
    // What is far from the root hangs as it did.
    QVERIFY(tipY(0.8F, 0.3F, 1.0F) < -0.15F);
    // It yields to several times as much.
    QVERIFY2(tipY(1.0F, 0.05F, 1.0F) < -0.02F, qPrintable(QString::number(tipY(1.0F, 0.05F, 1.0F))));
}

void TestStiffness::hairThatIsLaidInSharpTurnsComesToRest()
{
    constexpr int kNodes = 12;
    constexpr float kSegmentM = 0.011F;
    const std::vector<HandStrand> strands(
        96, HandStrand{.directionHd = {0.0F, -1.0F, 0.0F}, .lengthM = kSegmentM * static_cast<float>(kNodes - 1)});
    auto groom = groomOf(strands, kNodes, PhysicsSettings{});
    auto basis = std::make_shared<BasisStyles>(*groom->basis);
    for (std::size_t i = 0; i < strands.size(); ++i) {
        // Turned by 100 degrees and back, at another two nodes and about another axis for each.
        const float turn = static_cast<float>(i) * 2.3999632F;
        const std::size_t there = 2 + i % 5;
        const std::size_t back = there + 1 + i % 4;
        const glm::vec3 along(0.6F * std::sin(turn), 0.8F, 0.6F * std::cos(turn));
        const glm::vec3 aside(std::cos(turn), 0.0F, -std::sin(turn));
        glm::vec3 position(0.0F);
        for (std::size_t node = 1; node < kNodes; ++node) {
            position += kSegmentM * (node > there && node <= back ? aside : along);
            groom->blocks().setNode(basis->restPositions, i, node, position);
        }
    }
    groom->basis = basis;
    GroupDynamics hair;
    hair.setGroom(groom, {}, WindField::calm({}));
    hair.reset();
    fall(hair, 120 * 10);
    std::vector<glm::vec3> tips;
    for (std::size_t i = 0; i < strands.size(); ++i)
        tips.push_back(nodeOf(hair, i, kNodes - 1));
    for (int k = 0; k < 30; ++k) {
        fall(hair, 2);
        for (std::size_t i = 0; i < strands.size(); ++i)
            QVERIFY2(glm::distance(tips[i], nodeOf(hair, i, kNodes - 1)) < 1e-3F, qPrintable(QString::number(i)));
    }
}

void TestStiffness::coilsBounceAndComeToRestAtTheirLength()
{
    constexpr int kNodes = 9;
    constexpr float kLengthM = 0.24F;
    constexpr float kGives = 0.06F;
    const HandStrand straight{.directionHd = {0.0F, -1.0F, 0.0F}, .lengthM = kLengthM};
    HandStrand coil = straight;
    coil.rootHd = {0.05F, 0.0F, 0.0F};
    coil.give = kGives;
    GroupDynamics hair;
    hair.setGroom(groomOf({straight, coil}, kNodes, PhysicsSettings{}), {}, WindField::calm({}));
    hair.reset();
    fall(hair, 120 * 3);
    const auto reach = [&hair](std::size_t strand) {
        return glm::distance(nodeOf(hair, strand, 0), nodeOf(hair, strand, kNodes - 1));
    };
    QVERIFY(std::abs(reach(0) / kLengthM - 1.0F) < 1e-3F);
    QVERIFY2(std::abs(reach(1) / kLengthM - 1.0F) < 2e-3F, qPrintable(QString::number(reach(1))));

    // The head drops by 3 cm within an eighth of a second and stops.
    StepForces step = WindField::calm({});
    step.toNewHead.identity = false;
    step.toNewHead.offset = {0.0F, 0.03F / 15.0F, 0.0F};
    for (int i = 0; i < 15; ++i)
        hair.step(std::span(&step, 1));
    float shortest = 1.0F;
    float longest = 0.0F;
    int turnsOfSign = 0;
    bool wasLonger = false;
    for (int i = 0; i < 120; ++i) {
        fall(hair, 1);
        QVERIFY(reach(0) / kLengthM < 1.001F);
        const float fraction = reach(1) / kLengthM - 1.0F;
        QVERIFY(std::abs(fraction) < kGives + 1e-3F || fraction < 0.0F); // a slack one is bent
        shortest = std::min(shortest, fraction);
        longest = std::max(longest, fraction);
        turnsOfSign += i > 0 && (fraction > 0.0F) != wasLonger ? 1 : 0;
        wasLonger = fraction > 0.0F;
    }
    QVERIFY2(longest > 0.015F, qPrintable(QString::number(longest)));
    QVERIFY2(turnsOfSign >= 4, qPrintable(QString::number(turnsOfSign))); // it swings
    fall(hair, 120 * 3);
    QVERIFY2(std::abs(reach(1) / kLengthM - 1.0F) < 2e-3F, qPrintable(QString::number(reach(1))));
}

HAIRPAINT_TEST(TestStiffness, None)
#include "test_stiffness.moc"
