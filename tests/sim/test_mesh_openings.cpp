// Where a mesh ends, and its closing.
#include "sim/skin/mesh_openings.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace hairpaint::sim;

namespace {

/// An octahedron whose triangles share no vertex, with the four lower ones or without.
HeadMesh octahedron(bool whole)
{
    HeadMesh mesh;
    const std::array<glm::vec3, 4> round{
        {{1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -1.0F}, {-1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F}}};
    const auto add = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        const auto first = static_cast<unsigned>(mesh.positionsHd.size());
        for (const glm::vec3 p : {a, b, c}) {
            mesh.positionsHd.push_back(p);
            mesh.normalsHd.push_back(glm::normalize(p));
            mesh.uvs.emplace_back(0.5F + 0.4F * p.x, 0.5F + 0.4F * p.z);
        }
        mesh.triangles.emplace_back(first, first + 1, first + 2);
    };
    for (std::size_t i = 0; i < 4; ++i) {
        add(round[i], round[(i + 1) % 4], {0.0F, 1.0F, 0.0F});
        if (whole)
            add(round[(i + 1) % 4], round[i], {0.0F, -1.0F, 0.0F});
    }
    return mesh;
}

} // namespace

class TestMeshOpenings : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aSeamIsNoOpening()
    {
        const HeadMesh mesh = octahedron(true);
        QVERIFY(openEdges(mesh).empty());
        QCOMPARE(withOpeningsClosed(mesh).triangles.size(), mesh.triangles.size());
    }

    void anOpeningIsClosedFromOutside()
    {
        const HeadMesh open = octahedron(false);
        QCOMPARE(openEdges(open).size(), std::size_t{4});
        const HeadMesh closed = withOpeningsClosed(open);
        QVERIFY(openEdges(closed).empty());
        QCOMPARE(closed.triangles.size(), open.triangles.size() + 4);
        QCOMPARE(closed.normalsHd.size(), closed.positionsHd.size());
        QCOMPARE(closed.uvs.size(), closed.positionsHd.size());
        for (std::size_t i = open.triangles.size(); i < closed.triangles.size(); ++i) {
            const glm::uvec3 t = closed.triangles[i];
            const glm::vec3 a = closed.positionsHd[t.x];
            const glm::vec3 area = glm::cross(closed.positionsHd[t.y] - a, closed.positionsHd[t.z] - a);
            QVERIFY(area.y < 0.0F);
            for (int k = 0; k < 3; ++k) {
                QCOMPARE(closed.normalsHd[t[k]], glm::vec3(0.0F, -1.0F, 0.0F));
                QCOMPARE(closed.uvs[t[k]], closed.uvs[t.x]);
            }
        }
    }

    void everyOpeningIsClosed()
    {
        HeadMesh mesh = octahedron(true);
        mesh.triangles.erase(mesh.triangles.begin());
        mesh.triangles.pop_back();
        QCOMPARE(openEdges(mesh).size(), std::size_t{6});
        QVERIFY(openEdges(withOpeningsClosed(mesh)).empty());
    }

    void strangeMeshesAreLeftAlone()
    {
        QVERIFY(openEdges({}).empty());
        QVERIFY(withOpeningsClosed({}).triangles.empty());
        HeadMesh line = octahedron(false);
        line.positionsHd.assign(line.positionsHd.size(), glm::vec3(1.0F));
        QCOMPARE(withOpeningsClosed(line).triangles.size(), line.triangles.size());
    }
};

HAIRPAINT_TEST(TestMeshOpenings, None)
#include "test_mesh_openings.moc"
