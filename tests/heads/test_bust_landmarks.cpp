// The built-in heads' hair regions, named points and colliders, measured on their meshes.
#include <QFile>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <map>

#include "bust_measures.h"
#include "glb_reader.h"
#include "model/heads/built_in_heads.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

using namespace hairpaint;
using namespace Qt::StringLiterals;

namespace {

using Region = float (heads::HeadRegions::*)(const glm::vec3&) const;
constexpr std::array<Region, 3> kRegions = {&heads::HeadRegions::scalpDistance, &heads::HeadRegions::browDistance,
                                            &heads::HeadRegions::beardDistance};

const heads::HeadRow& head()
{
    QFETCH_GLOBAL(QString, name);
    return *heads::findHeadRow(name.toStdString());
}

const heads::HeadRegions& regions()
{
    return head().regions;
}

// First order: exact to a few hundredths of a millimetre this close to the surface.
float distanceTo(const sim::Ellipsoid& e, const glm::vec3& p)
{
    const glm::vec3 scaled = glm::conjugate(e.rotation) * (p - e.centreHd) / e.semiAxesM;
    const float radial = glm::length(scaled);
    return radial * (radial - 1.0F) / glm::length(scaled / e.semiAxesM);
}

float distanceToColliders(const glm::vec3& p)
{
    float nearest = 1.0F;
    for (const sim::Ellipsoid& e : head().colliders)
        nearest = std::min(nearest, distanceTo(e, p));
    return nearest;
}

} // namespace

class TestBustLandmarks : public QObject
{
    Q_OBJECT

private:
    std::map<QString, tests::GlbMesh> m_meshes;

    const tests::GlbMesh& mesh() const
    {
        QFETCH_GLOBAL(QString, name);
        return m_meshes.at(name);
    }

    // To the plane through the nearest vertex.
    float distanceToSkin(const glm::vec3& p) const
    {
        std::size_t nearest = 0;
        for (std::size_t v = 0; v < mesh().positions.size(); ++v)
            if (glm::distance(p, mesh().positions[v]) < glm::distance(p, mesh().positions[nearest]))
                nearest = v;
        return std::abs(glm::dot(p - mesh().positions[nearest], mesh().normals[nearest]));
    }

private Q_SLOTS:
    void initTestCase_data();
    void initTestCase();
    void regionsCoverTheRightSkin_data();
    void regionsCoverTheRightSkin();
    void regionsDoNotOverlap();
    void regionsAreSymmetric();
    void distancesAreMetresAlongTheSkin();
    void regionsHaveNaturalSizes_data();
    void regionsHaveNaturalSizes();
    void namedPointsLieOnTheSkin();
    void collidersFollowTheScalp();
    void collidersHoldLongHairOnTheShoulders();
    void collidersAreSymmetric();
};

void TestBustLandmarks::initTestCase_data()
{
    QTest::addColumn<QString>("name");
    for (const char* name : {"bust-1", "bust-2"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void TestBustLandmarks::initTestCase()
{
    for (const QString& name : {u"bust-1"_s, u"bust-2"_s}) {
        QFile file(test::sourcePath(u"resources/heads/") + name + u".glb"_s);
        QVERIFY(file.open(QIODevice::ReadOnly));
        m_meshes[name] = tests::readGlb(file.readAll());
        QCOMPARE(m_meshes[name].error, QString());
    }
}

void TestBustLandmarks::regionsCoverTheRightSkin_data()
{
    QTest::addColumn<int>("x"); // millimetres, on the skin
    QTest::addColumn<int>("y");
    QTest::addColumn<int>("z");
    QTest::addColumn<bool>("scalp");
    QTest::addColumn<bool>("brow");
    QTest::addColumn<bool>("beard");
    QTest::newRow("crown") << 0 << 112 << -35 << true << false << false;
    QTest::newRow("back of the head") << 0 << 20 << -97 << true << false << false;
    QTest::newRow("above the ear") << 75 << 40 << -10 << true << false << false;
    QTest::newRow("sideburn") << 73 << -3 << 15 << true << false << false;
    QTest::newRow("behind the ear") << 58 << -23 << -45 << true << false << false;
    QTest::newRow("above the nape") << 0 << -50 << -80 << true << false << false;
    QTest::newRow("middle of the forehead") << 0 << 50 << 89 << false << false << false;
    QTest::newRow("temple") << 66 << 22 << 48 << false << false << false;
    QTest::newRow("ear's rim") << 82 << 2 << -21 << false << false << false;
    QTest::newRow("ear's lobe") << 72 << -41 << -6 << false << false << false;
    QTest::newRow("brow") << 28 << 29 << 91 << false << true << false;
    QTest::newRow("between the brows") << 0 << 22 << 91 << false << false << false;
    QTest::newRow("eyelid") << 32 << 0 << 81 << false << false << false;
    QTest::newRow("nose") << 0 << -37 << 110 << false << false << false;
    QTest::newRow("upper lip's skin") << 8 << -56 << 95 << false << false << true;
    QTest::newRow("lips") << 0 << -71 << 96 << false << false << false;
    QTest::newRow("chin") << 0 << -108 << 88 << false << false << true;
    QTest::newRow("jaw") << 55 << -65 << 25 << false << false << true;
    QTest::newRow("cheekbone") << 61 << -25 << 65 << false << false << false;
    QTest::newRow("neck's front") << 0 << -150 << 18 << false << false << false;
    QTest::newRow("neck's back") << 0 << -100 << -82 << false << false << false;
    QTest::newRow("shoulder") << 122 << -170 << -46 << false << false << false;
    QTest::newRow("chest") << 0 << -260 << 39 << false << false << false;
}

void TestBustLandmarks::regionsCoverTheRightSkin()
{
    QFETCH(int, x);
    QFETCH(int, y);
    QFETCH(int, z);
    const glm::vec3 wanted = 0.001F * glm::vec3(x, y, z);
    const glm::vec3 p =
        *std::min_element(mesh().positions.begin(), mesh().positions.end(), [&](const auto& a, const auto& b) {
            return glm::distance(a, wanted) < glm::distance(b, wanted);
        });
    QVERIFY2(glm::distance(p, wanted) < 0.008F,
             qPrintable(u"the point is %1 m off the skin"_s.arg(glm::distance(p, wanted))));
    QTEST(regions().scalpDistance(p) > 0.0F, "scalp");
    QTEST(regions().browDistance(p) > 0.0F, "brow");
    QTEST(regions().beardDistance(p) > 0.0F, "beard");
}

void TestBustLandmarks::regionsDoNotOverlap()
{
    for (const glm::vec3& p : mesh().positions) {
        const int inside = (regions().scalpDistance(p) > 0.0F ? 1 : 0) + (regions().browDistance(p) > 0.0F ? 1 : 0) +
                           (regions().beardDistance(p) > 0.0F ? 1 : 0);
        QVERIFY(inside <= 1);
    }
}

void TestBustLandmarks::regionsAreSymmetric()
{
    for (const glm::vec3& p : mesh().positions) {
        const glm::vec3 twin(-p.x, p.y, p.z);
        for (const Region region : kRegions)
            QCOMPARE((regions().*region)(p), (regions().*region)(twin));
    }
}

void TestBustLandmarks::distancesAreMetresAlongTheSkin()
{
    // Along an edge a distance may change by the edge's length; twice that where the skin runs away from the head's
    // middle. In the mean over the border its slope is 1.
    double change = 0.0;
    double length = 0.0;
    for (const auto& t : mesh().triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::vec3& a = mesh().positions[t[i]];
            const glm::vec3& b = mesh().positions[t[(i + 1) % 3]];
            const float here = regions().scalpDistance(a);
            const float there = regions().scalpDistance(b);
            if (std::abs(here) > 0.010F || std::abs(there) > 0.010F)
                continue;
            QVERIFY(std::abs(there - here) <= 2.0F * glm::distance(a, b) + 1.0e-4F);
            change += std::pow(static_cast<double>(there - here), 2.0);
            length += std::pow(static_cast<double>(glm::distance(a, b)), 2.0) * 0.5;
        }
    }
    const double slope = std::sqrt(change / length);
    qInfo("mean slope %.2f", slope);
    QVERIFY(slope > 0.75 && slope < 1.3);
}

void TestBustLandmarks::regionsHaveNaturalSizes_data()
{
    QTest::addColumn<int>("region");
    QTest::addColumn<double>("least"); // cm2
    QTest::addColumn<double>("most");
    QTest::newRow("scalp") << 0 << 480.0 << 700.0;
    QTest::newRow("brows") << 1 << 4.0 << 12.0;
    QTest::newRow("beard") << 2 << 130.0 << 260.0;
}

void TestBustLandmarks::regionsHaveNaturalSizes()
{
    QFETCH(int, region);
    QFETCH(double, least);
    QFETCH(double, most);
    double area = 0.0;
    for (const auto& t : mesh().triangles)
        if ((regions().*kRegions[static_cast<std::size_t>(region)])(tests::faceCentre(mesh(), t)) > 0.0F)
            area += 1.0e4 * tests::measured(mesh(), t).skinArea;
    qInfo("%.1f cm2", area);
    QVERIFY(area > least && area < most);
}

void TestBustLandmarks::namedPointsLieOnTheSkin()
{
    const sim::HeadLandmarks& marks = head().landmarks;
    for (const glm::vec3& p : marks.positionsHd)
        QVERIFY2(distanceToSkin(p) < 0.001F,
                 qPrintable(u"(%1, %2, %3) is %4 m off the skin"_s.arg(p.x).arg(p.y).arg(p.z).arg(distanceToSkin(p))));
    QVERIFY(std::abs(regions().scalpDistance(marks[sim::HeadLandmark::Hairline])) < 0.002F);
    QVERIFY(std::abs(regions().scalpDistance(marks[sim::HeadLandmark::Nape])) < 0.002F);
    for (const glm::vec3& p : mesh().positions)
        if (std::abs(p.x) < 0.02F && p.y > -0.055F)
            QVERIFY2(p.z <= marks[sim::HeadLandmark::NoseTip].z + 0.0005F, "something lies before the tip of the nose");
}

void TestBustLandmarks::collidersFollowTheScalp()
{
    float outside = 0.0F;
    float inside = 0.0F;
    for (const glm::vec3& p : mesh().positions) {
        if (regions().scalpDistance(p) <= 0.0F)
            continue;
        outside = std::max(outside, distanceToColliders(p));
        inside = std::max(inside, -distanceToColliders(p));
    }
    qInfo("scalp up to %.2f mm outside the ellipsoids, they up to %.2f mm outside the scalp",
          1000.0 * static_cast<double>(outside), 1000.0 * static_cast<double>(inside));
    QVERIFY(outside < 0.0020F);
    QVERIFY(inside < 0.0020F);
}

void TestBustLandmarks::collidersHoldLongHairOnTheShoulders()
{
    float worst = 0.0F;
    for (const glm::vec3& p : mesh().positions)
        if (p.y < -0.130F && p.y > -0.260F)
            worst = std::max(worst, std::abs(distanceToColliders(p)));
    qInfo("shoulders within %.1f mm", 1000.0 * static_cast<double>(worst));
    QVERIFY(worst < 0.012F);
}

void TestBustLandmarks::collidersAreSymmetric()
{
    for (const glm::vec3& p : mesh().positions)
        QVERIFY(std::abs(distanceToColliders(p) - distanceToColliders({-p.x, p.y, p.z})) < 1.0e-5F);
}

HAIRPAINT_TEST(TestBustLandmarks, None)
#include "test_bust_landmarks.moc"
