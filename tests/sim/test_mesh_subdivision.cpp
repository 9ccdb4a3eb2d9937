// Meshes made finer.
#include "sim/skin/mesh_subdivision.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <set>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

double areaOf(const HeadMesh& mesh)
{
    double area = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3& a = mesh.positionsHd[t.x];
        area +=
            0.5 * static_cast<double>(glm::length(glm::cross(mesh.positionsHd[t.y] - a, mesh.positionsHd[t.z] - a)));
    }
    return area;
}

} // namespace

class TestMeshSubdivision : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void everyEdgeIsNamedOnce()
    {
        const HeadMesh patch = makePatchHead(4);
        const auto edges = edgesOf(patch);
        const std::set<std::pair<unsigned, unsigned>> distinct(edges.begin(), edges.end());
        QCOMPARE(distinct.size(), edges.size());
        QVERIFY(std::ranges::all_of(edges, [](const auto& edge) { return edge.first < edge.second; }));
        // Euler, for a disc.
        QCOMPARE(patch.positionsHd.size() - edges.size() + patch.triangles.size(), std::size_t{1});
    }

    void withoutDisplacementTheSurfaceStays()
    {
        const HeadMesh ball = makeBallHead(24);
        const auto edges = edgesOf(ball);
        const HeadMesh fine = subdivided(ball, std::vector<float>(edges.size(), 0.0F));
        QCOMPARE(fine.triangles.size(), 4 * ball.triangles.size());
        QCOMPARE(fine.positionsHd.size(), ball.positionsHd.size() + edges.size());
        QVERIFY(std::abs(areaOf(fine) / areaOf(ball) - 1.0) < 1e-5);
        QVERIFY(std::equal(ball.positionsHd.begin(), ball.positionsHd.end(), fine.positionsHd.begin()));
        QVERIFY(std::equal(ball.normalsHd.begin(), ball.normalsHd.end(), fine.normalsHd.begin()));
    }

    void displacedMiddlesLieOnTheBallAndSoDoTheirNormals()
    {
        constexpr float kRadiusM = 0.1F;
        const HeadMesh ball = makeBallHead(48, kRadiusM);
        const auto edges = edgesOf(ball);
        std::vector<float> displacements;
        displacements.reserve(edges.size());
        for (const auto& edge : edges)
            displacements.push_back(kRadiusM - glm::length(middleOf(ball, edge).positionHd));
        const HeadMesh fine = subdivided(ball, displacements);
        for (std::size_t i = ball.positionsHd.size(); i < fine.positionsHd.size(); ++i) {
            QVERIFY(std::abs(glm::length(fine.positionsHd[i]) - kRadiusM) < 1e-5F);
            QVERIFY(std::abs(glm::length(fine.normalsHd[i]) - 1.0F) < 1e-4F);
            const bool onSeam = fine.uvs[i].x < 1e-6F || fine.uvs[i].x > 1.0F - 1e-6F; // Faces on one side only.
            const bool atPole = std::abs(fine.positionsHd[i].y) > 0.98F * kRadiusM;
            if (!onSeam && !atPole)
                QVERIFY(glm::dot(fine.normalsHd[i], glm::normalize(fine.positionsHd[i])) > 0.999F);
        }
    }

    void middlesMoveInAnyDirectionAndHaveTheirOwnNormals()
    {
        const HeadMesh ball = makeBallHead(24);
        const auto edges = edgesOf(ball);
        const std::vector<float> displacements(edges.size(), 0.001F);
        std::vector<MovedMiddle> middles;
        middles.reserve(edges.size());
        for (const auto& edge : edges)
            middles.push_back({.offsetHd = 0.001F * middleOf(ball, edge).normalHd});
        const HeadMesh along = subdivided(ball, displacements);
        QVERIFY(subdivided(ball, middles).positionsHd == along.positionsHd);
        const glm::vec3 aside(0.002F, 0.0F, -0.001F);
        middles.back().offsetHd += aside;
        middles.back().normalOffset = {0.0F, 0.0F, 3.0F};
        const HeadMesh moved = subdivided(ball, middles);
        QVERIFY(glm::distance(moved.positionsHd.back(), along.positionsHd.back() + aside) < 1e-7F);
        const glm::vec3 turned = glm::normalize(middleOf(ball, edges.back()).normalHd + glm::vec3(0.0F, 0.0F, 3.0F));
        QVERIFY(glm::distance(moved.normalsHd.back(), turned) < 1e-6F);
        QVERIFY(glm::distance(moved.normalsHd.end()[-2], middleOf(ball, edges.end()[-2]).normalHd) < 1e-6F);
        QVERIFY(moved.triangles == along.triangles && moved.uvs == along.uvs);
    }
};

HAIRPAINT_TEST(TestMeshSubdivision, None)
#include "test_mesh_subdivision.moc"
