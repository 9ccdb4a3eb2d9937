// Points of the skin are found as a search over every face would find them.
#include "sim/base/deterministic.h"
#include "sim/skin/skin.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

float skinRandom(std::uint64_t counter)
{
    return unitFloat(hash64(20, counter));
}

glm::vec3 randomVector(std::uint64_t counter)
{
    return glm::vec3(skinRandom(counter * 3), skinRandom(counter * 3 + 1), skinRandom(counter * 3 + 2)) * 2.0F - 1.0F;
}

std::array<glm::dvec3, 3> cornersOf(const HeadMesh& mesh, const glm::uvec3& t)
{
    return {glm::dvec3(mesh.positionsHd[t.x]), glm::dvec3(mesh.positionsHd[t.y]), glm::dvec3(mesh.positionsHd[t.z])};
}

/// Distance along the ray to the first face, by its plane and three side tests; infinity for a miss.
double bruteForceRay(const HeadMesh& mesh, glm::dvec3 origin, glm::dvec3 direction)
{
    double best = std::numeric_limits<double>::infinity();
    for (const glm::uvec3& t : mesh.triangles) {
        const auto c = cornersOf(mesh, t);
        const glm::dvec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
        const double along = glm::dot(normal, direction);
        if (along == 0.0)
            continue;
        const double distance = glm::dot(normal, c[0] - origin) / along;
        if (distance < 0.0 || distance > best)
            continue;
        const glm::dvec3 p = origin + direction * distance;
        bool inside = true;
        for (std::size_t i = 0; i < 3; ++i)
            inside = inside && glm::dot(normal, glm::cross(c[(i + 1) % 3] - c[i], p - c[i])) >= 0.0;
        if (inside)
            best = distance;
    }
    return best;
}

/// Distance to the nearest point: inside a face by its plane, else on an edge.
double bruteForceDistance(const HeadMesh& mesh, glm::dvec3 p)
{
    double best = std::numeric_limits<double>::infinity();
    for (const glm::uvec3& t : mesh.triangles) {
        const auto c = cornersOf(mesh, t);
        const glm::dvec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
        bool inside = glm::length(normal) > 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 edge = c[(i + 1) % 3] - c[i];
            inside = inside && glm::dot(normal, glm::cross(edge, p - c[i])) >= 0.0;
            const double squared = glm::dot(edge, edge);
            const double fraction = squared > 0.0 ? std::clamp(glm::dot(p - c[i], edge) / squared, 0.0, 1.0) : 0.0;
            best = std::min(best, glm::length(p - c[i] - edge * fraction));
        }
        if (inside)
            best = std::min(best, std::abs(glm::dot(normal, p - c[0])) / glm::length(normal));
    }
    return best;
}

} // namespace

class TestSkin : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void areaIsTheSumOfTheFaces();
    void picksTheFirstFaceOnTheRay_data();
    void picksTheFirstFaceOnTheRay();
    void raysThroughEdgesAndCornersHit();
    void findsTheNearestPoint();
    void uvLeadsThereAndBack_data();
    void uvLeadsThereAndBack();
    void uvOffTheIslandsFindsNothing();
    void overlappingIslandsGiveTheLowestFace();
    void framesAreOrthonormalAndFollowUv();
    void derivativesMeasureTheMap();
    void mirroringTwiceComesBack();
    void mirroringFindsNothingWhereTheOtherSideIsMissing();
    void strangeUvsCostNoMemoryAndNoCrash();
    void aMeshWithoutFacesIsAllowed();
    void buildingStopsWhereItIsAskedAndLeavesNothing();
};

void TestSkin::areaIsTheSumOfTheFaces()
{
    const Skin patch(makePatchHead(16, 0.2F));
    QVERIFY(std::abs(patch.areaM2() - 0.04) < 1e-7);
    QVERIFY(std::abs(patch.faceAreaM2(5) - 0.04F / 512.0F) < 1e-9F);
    const Skin ball(makeBallHead(96, 0.1F));
    QVERIFY(std::abs(ball.areaM2() - 4.0 * 3.14159265 * 0.01) < 0.004 * 0.1257);
}

void TestSkin::picksTheFirstFaceOnTheRay_data()
{
    QTest::addColumn<bool>("fromOutside");
    QTest::newRow("from outside") << true;
    QTest::newRow("from inside") << false;
}

void TestSkin::picksTheFirstFaceOnTheRay()
{
    QFETCH(bool, fromOutside);
    const Skin skin(makeBallHead(24));
    int hits = 0;
    for (std::uint64_t i = 0; i < 400; ++i) {
        const glm::vec3 origin = randomVector(i) * (fromOutside ? 0.5F : 0.05F);
        const glm::vec3 direction =
            glm::normalize(randomVector(i + 1000) * 0.13F - (fromOutside ? origin : glm::vec3(0)));
        const double expected = bruteForceRay(skin.mesh(), origin, direction);
        const auto hit = skin.pick({origin, direction});
        QCOMPARE(hit.has_value(), std::isfinite(expected));
        if (!hit)
            continue;
        ++hits;
        QVERIFY(std::abs(glm::length(glm::dvec3(hit->positionHd - origin)) - expected) < 1e-6);
        QVERIFY(glm::all(glm::greaterThanEqual(hit->barycentric, glm::vec3(0.0F))));
    }
    QVERIFY2(hits > 100, qPrintable(QString::number(hits)));
}

void TestSkin::raysThroughEdgesAndCornersHit()
{
    // Cells are 1/32 m, exact in binary: every ray runs through a corner, an edge or a diagonal.
    const Skin skin(makePatchHead(8, 0.25F));
    for (int y = 1; y < 32; ++y) {
        for (int x = 1; x < 32; ++x) {
            const glm::vec3 position(static_cast<float>(x) / 128.0F - 0.125F, static_cast<float>(y) / 128.0F - 0.125F,
                                     0.0F);
            const auto hit = skin.pick({position + glm::vec3(0.0F, 0.0F, 1.0F), {0.0F, 0.0F, -1.0F}});
            QVERIFY2(hit, qPrintable(QStringLiteral("%1, %2").arg(x).arg(y)));
            QVERIFY(glm::length(hit->positionHd - position) < 1e-6F);
        }
    }
    QVERIFY(!skin.pick({{0.2F, 0.0F, 1.0F}, {0.0F, 0.0F, -1.0F}}));
}

void TestSkin::findsTheNearestPoint()
{
    const Skin skin(makeBallHead(24));
    for (std::uint64_t i = 0; i < 400; ++i) {
        const glm::vec3 position = randomVector(i) * 0.25F;
        const double found = glm::length(glm::dvec3(position - skin.nearest(position).positionHd));
        QVERIFY(std::abs(found - bruteForceDistance(skin.mesh(), position)) < 1e-6);
    }
}

void TestSkin::uvLeadsThereAndBack_data()
{
    QTest::addColumn<bool>("ball");
    QTest::newRow("patch") << false;
    QTest::newRow("ball, with a seam and pinched poles") << true;
}

void TestSkin::uvLeadsThereAndBack()
{
    QFETCH(bool, ball);
    const Skin skin(ball ? makeBallHead(48) : makePatchHead(13));
    for (std::uint64_t i = 0; i < 2000; ++i) {
        // Triangles at the poles cover half their cells only.
        const glm::vec2 uv(skinRandom(i * 2), 0.05F + 0.9F * skinRandom(i * 2 + 1));
        const auto point = skin.atUv(uv);
        QVERIFY(point);
        QVERIFY(glm::length(point->uv - uv) < 2e-6F);
        const auto again = skin.pick({point->positionHd + point->normalHd * 0.01F, -point->normalHd});
        QVERIFY(again);
        QVERIFY(glm::length(again->positionHd - point->positionHd) < 5e-4F);
    }
}

void TestSkin::uvOffTheIslandsFindsNothing()
{
    HeadMesh mesh = makePatchHead(8);
    for (glm::vec2& uv : mesh.uvs)
        uv = uv * 0.5F + 0.25F;
    const Skin skin(std::move(mesh));
    QVERIFY(skin.atUv({0.3F, 0.7F}));
    QVERIFY(!skin.atUv({0.2F, 0.5F}));
    QVERIFY(!skin.atUv({0.5F, 0.8F}));
    QVERIFY(!skin.atUv({std::nanf(""), 0.5F}));
    QVERIFY(!skin.atUv({0.5F, std::numeric_limits<float>::infinity()}));
}

void TestSkin::overlappingIslandsGiveTheLowestFace()
{
    HeadMesh mesh = makePatchHead(4);
    const HeadMesh upper = makePatchHead(4);
    const auto base = static_cast<std::uint32_t>(mesh.positionsHd.size());
    for (std::size_t i = 0; i < upper.positionsHd.size(); ++i) {
        mesh.positionsHd.push_back(upper.positionsHd[i] + glm::vec3(0.0F, 0.0F, 1.0F));
        mesh.normalsHd.push_back(upper.normalsHd[i]);
        mesh.uvs.push_back(upper.uvs[i]);
    }
    const std::size_t faces = mesh.triangles.size();
    for (std::size_t i = 0; i < faces; ++i)
        mesh.triangles.push_back(mesh.triangles[i] + base);
    const Skin skin(std::move(mesh));
    for (std::uint64_t i = 0; i < 100; ++i) {
        const auto point = skin.atUv({skinRandom(i), skinRandom(i + 500)});
        QVERIFY(point);
        QVERIFY(point->face < faces);
    }
}

void TestSkin::framesAreOrthonormalAndFollowUv()
{
    const Skin skin(makeBallHead(48));
    for (std::uint64_t i = 0; i < 500; ++i) {
        const auto point = skin.atUv({skinRandom(i), 0.1F + 0.8F * skinRandom(i + 1000)});
        QVERIFY(point);
        QVERIFY(std::abs(glm::length(point->normalHd) - 1.0F) < 1e-5F);
        QVERIFY(std::abs(glm::length(point->tangentHd) - 1.0F) < 1e-5F);
        QVERIFY(std::abs(glm::dot(point->normalHd, point->tangentHd)) < 1e-5F);
        // u runs round the y axis.
        const glm::vec3 round = glm::normalize(glm::cross(glm::vec3(0.0F, 1.0F, 0.0F), point->positionHd));
        QVERIFY(glm::dot(round, point->tangentHd) > 0.99F);
    }
}

void TestSkin::derivativesMeasureTheMap()
{
    const Skin skin(makePatchHead(7, 0.2F));
    const auto point = skin.atUv({0.3F, 0.4F});
    QVERIFY(point);
    QVERIFY(glm::length(point->dPduHd - glm::vec3(0.2F, 0.0F, 0.0F)) < 1e-5F);
    QVERIFY(glm::length(point->dPdvHd - glm::vec3(0.0F, 0.2F, 0.0F)) < 1e-5F);
}

void TestSkin::mirroringTwiceComesBack()
{
    const Skin skin(makeBallHead(48));
    for (std::uint64_t i = 0; i < 300; ++i) {
        const auto point = skin.atUv({skinRandom(i), 0.1F + 0.8F * skinRandom(i + 1000)});
        QVERIFY(point);
        const auto other = skin.mirrored(*point);
        QVERIFY(other);
        QVERIFY(std::abs(other->positionHd.x + point->positionHd.x) < 5e-4F);
        QVERIFY(std::abs(other->uv.x - (1.0F - point->uv.x)) < 0.01F);
        const auto back = skin.mirrored(*other);
        QVERIFY(back);
        QVERIFY(glm::length(back->positionHd - point->positionHd) < 5e-4F);
    }
}

void TestSkin::mirroringFindsNothingWhereTheOtherSideIsMissing()
{
    HeadMesh mesh = makePatchHead(8);
    for (glm::vec3& position : mesh.positionsHd)
        position.x += 0.06F; // From -0.04 to 0.16.
    const Skin skin(std::move(mesh));
    const SurfacePoint nearMiddle = skin.nearest({0.03F, 0.0F, 0.0F});
    const SurfacePoint far = skin.nearest({0.10F, 0.0F, 0.0F});
    QVERIFY(skin.mirrored(nearMiddle));
    QVERIFY(!skin.mirrored(far));
    QVERIFY(skin.mirrored(far, 0.07F));
}

void TestSkin::strangeUvsCostNoMemoryAndNoCrash()
{
    HeadMesh mesh = makePatchHead(64);
    for (std::size_t i = 0; i < mesh.uvs.size(); ++i)
        mesh.uvs[i] = {skinRandom(i * 2), skinRandom(i * 2 + 1)}; // Every face spans much of the map.
    mesh.uvs[3] = {std::nanf(""), 0.0F};
    mesh.uvs[4] = {3e38F, -3e38F};
    mesh.uvs[5] = {-3e38F, 3e38F};             // Further apart than any float.
    for (int corner = 0; corner < 3; ++corner) // So far that no cell has this face.
        mesh.uvs[mesh.triangles.back()[corner]] = {3e38F, 3e38F};
    const Skin skin(std::move(mesh));
    QVERIFY(skin.atUv({0.5F, 0.5F}));
    HeadMesh flat = makePatchHead(8);
    for (glm::vec2& uv : flat.uvs)
        uv = glm::vec2(0.5F);
    const Skin collapsed(std::move(flat));
    QVERIFY(!collapsed.atUv({0.5F, 0.5F}));
    QVERIFY(std::abs(glm::length(collapsed.at(0, {1.0F, 0.0F, 0.0F}).tangentHd) - 1.0F) < 1e-5F);
}

void TestSkin::aMeshWithoutFacesIsAllowed()
{
    const Skin skin{HeadMesh{}};
    QCOMPARE(skin.areaM2(), 0.0);
    QVERIFY(!skin.pick({}));
    QVERIFY(!skin.atUv({0.5F, 0.5F}));
    QVERIFY(!skin.mirrored(SurfacePoint{}));
}

void TestSkin::buildingStopsWhereItIsAskedAndLeavesNothing()
{
    const HeadMesh mesh = makeBallHead(192); // 36,864 faces
    int asked = 0;
    const auto whole = Skin::make(mesh, [&asked] { return ++asked > 0; });
    QVERIFY(whole);
    QCOMPARE(whole->areaM2(), Skin(mesh).areaM2());
    QVERIFY(whole->atUv({0.5F, 0.5F}));
    QVERIFY2(asked > 40, qPrintable(QString::number(asked))); // More than once a pass over the faces.
    for (int stopAt = 1; stopAt <= asked; ++stopAt) {
        int count = 0;
        QVERIFY(!Skin::make(mesh, [&] { return ++count < stopAt; }));
        QCOMPARE(count, stopAt); // Not asked again after a refusal.
    }
    QVERIFY(Skin::make(mesh, {}));
}

HAIRPAINT_TEST(TestSkin, None)
#include "test_skin.moc"
