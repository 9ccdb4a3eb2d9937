// Ellipsoids fitted to a mesh follow its skin from inside.
#include "sim/skin/ellipsoid.h"
#include "sim/solver/collider_set.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

/// The ball, stretched, turned about x, shifted; open at the bottom where asked for.
HeadMesh stretchedBall(glm::vec3 stretch, float halfAngleTangent, glm::vec3 shift, bool open)
{
    HeadMesh mesh = makeBallHead(64, 0.1F);
    glm::quat turn(1.0F, halfAngleTangent, 0.0F, 0.0F);
    turn = glm::normalize(turn);
    for (std::size_t i = 0; i < mesh.positionsHd.size(); ++i) {
        mesh.positionsHd[i] = turn * (mesh.positionsHd[i] * stretch) + shift;
        mesh.normalsHd[i] = turn * glm::normalize(mesh.normalsHd[i] / stretch);
    }
    if (open)
        std::erase_if(mesh.triangles, [&](const glm::uvec3& t) { return mesh.positionsHd[t.x].y < shift.y - 0.085F; });
    return mesh;
}

/// Adds a copy of another mesh.
void append(HeadMesh& mesh, const HeadMesh& other)
{
    const auto first = static_cast<std::uint32_t>(mesh.positionsHd.size());
    mesh.positionsHd.insert(mesh.positionsHd.end(), other.positionsHd.begin(), other.positionsHd.end());
    mesh.normalsHd.insert(mesh.normalsHd.end(), other.normalsHd.begin(), other.normalsHd.end());
    mesh.uvs.insert(mesh.uvs.end(), other.uvs.begin(), other.uvs.end());
    for (const glm::uvec3& t : other.triangles)
        mesh.triangles.push_back(t + first);
}

/// How far a point lies from the nearest of the ellipsoids' surfaces, to first order; negative inside their union.
float distanceTo(const ColliderSet& set, glm::vec3 p)
{
    float least = 1e9F;
    for (int i = 0; i < set.count; ++i) {
        const Collider& c = set.items[static_cast<std::size_t>(i)];
        least = std::min(least, (std::sqrt(c.radius2(p)) - 1.0F) * c.meanAxisM);
    }
    return least;
}

} // namespace

class TestEllipsoid : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fittedEllipsoidsFollowTheSkin_data();
    void fittedEllipsoidsFollowTheSkin();
    void twoBallsGetTwoEllipsoids();
    void aMeshWithoutAnInsideGetsNone();
    void aNodeInsideIsPushedToTheSurface();
    void anEllipsoidOfNonsenseIsLeftOut();
};

void TestEllipsoid::fittedEllipsoidsFollowTheSkin_data()
{
    QTest::addColumn<glm::vec3>("stretch");
    QTest::addColumn<float>("turn");
    QTest::addColumn<glm::vec3>("shift");
    QTest::addColumn<bool>("open");
    QTest::newRow("a ball") << glm::vec3(1.0F) << 0.0F << glm::vec3(0.0F) << false;
    QTest::newRow("a ball elsewhere") << glm::vec3(1.0F) << 0.0F << glm::vec3(0.4F, 1.6F, -0.2F) << false;
    QTest::newRow("an elongated head") << glm::vec3(0.75F, 1.15F, 0.95F) << 0.0F << glm::vec3(0.0F) << false;
    QTest::newRow("a nodding head") << glm::vec3(0.75F, 1.3F, 0.95F) << 0.25F << glm::vec3(0.0F) << false;
    QTest::newRow("open at the base") << glm::vec3(1.0F) << 0.0F << glm::vec3(0.0F) << true;
}

void TestEllipsoid::fittedEllipsoidsFollowTheSkin()
{
    QFETCH(glm::vec3, stretch);
    QFETCH(float, turn);
    QFETCH(glm::vec3, shift);
    QFETCH(bool, open);
    const HeadMesh mesh = stretchedBall(stretch, turn, shift, open);
    const std::vector<Ellipsoid> fitted = fitEllipsoids(mesh, 4);
    QVERIFY(!fitted.empty());
    QVERIFY(fitted.size() <= 4);
    const ColliderSet set = prepareColliders(fitted);
    float worst = 0.0F;
    for (const glm::vec3& p : mesh.positionsHd) {
        if (!open || p.y > -0.05F)
            worst = std::max(worst, std::abs(distanceTo(set, p)));
    }
    QVERIFY2(worst < 0.005F, qPrintable(QString::number(worst)));
}

void TestEllipsoid::twoBallsGetTwoEllipsoids()
{
    HeadMesh mesh = stretchedBall(glm::vec3(1.0F), 0.0F, glm::vec3(0.0F, 0.15F, 0.0F), false);
    append(mesh, stretchedBall(glm::vec3(0.7F), 0.0F, glm::vec3(0.0F, -0.15F, 0.0F), false));
    const std::vector<Ellipsoid> fitted = fitEllipsoids(mesh, 2);
    QCOMPARE(fitted.size(), std::size_t{2});
    QVERIFY(glm::distance(fitted[0].centreHd, glm::vec3(0.0F, 0.15F, 0.0F)) < 0.01F);
    QVERIFY(glm::distance(fitted[1].centreHd, glm::vec3(0.0F, -0.15F, 0.0F)) < 0.01F);
    QVERIFY(std::abs(fitted[1].semiAxesM.y - 0.07F) < 0.007F);
}

void TestEllipsoid::aMeshWithoutAnInsideGetsNone()
{
    QVERIFY(fitEllipsoids(makePatchHead(), 3).empty());
    QVERIFY(fitEllipsoids(HeadMesh{}, 3).empty());
}

void TestEllipsoid::aNodeInsideIsPushedToTheSurface()
{
    const Ellipsoid e{glm::vec3(0.1F, 0.2F, 0.3F), glm::vec3(0.1F, 0.2F, 0.15F),
                      glm::normalize(glm::quat(1.0F, 0.3F, -0.2F, 0.1F))};
    const ColliderSet set = prepareColliders(std::vector{e});
    const Collider& collider = set.items[0];
    const glm::vec3 onSurface = e.centreHd + e.rotation * glm::vec3(0.0F, 0.2F, 0.0F);
    QVERIFY(std::abs(collider.radius2(onSurface) - 1.0F) < 1e-5F);
    const glm::vec3 under = e.centreHd + e.rotation * glm::vec3(0.0F, 0.195F, 0.0F);
    QVERIFY(glm::distance(collider.pushedOut(under, 1.0F), onSurface) < 1e-4F);
    const glm::vec3 outside = e.centreHd + e.rotation * glm::vec3(0.0F, 0.21F, 0.0F);
    QVERIFY(collider.pushedOut(outside, 1.0F) == outside);
}

void TestEllipsoid::anEllipsoidOfNonsenseIsLeftOut()
{
    const float nan = std::nanf("");
    const std::vector<Ellipsoid> ellipsoids{{glm::vec3(nan), glm::vec3(0.1F), glm::quat(1, 0, 0, 0)},
                                            {glm::vec3(0.0F), glm::vec3(0.1F), glm::quat(0, 0, 0, 0)},
                                            {glm::vec3(0.0F), glm::vec3(0.1F), glm::quat(1, 0, 0, 0)}};
    QCOMPARE(prepareColliders(ellipsoids).count, 1);
}

HAIRPAINT_TEST(TestEllipsoid, None)
#include "test_ellipsoid.moc"
