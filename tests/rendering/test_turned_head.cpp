// A head that turns on its neck: what the picture shows of it moves, its shoulders stay.
#include "tests/rendering/renderer_fixture.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace hairpaint;
using namespace hairpaint::testing;
using rendering::Scene;

namespace {

/// A square, 8 cm across, that faces the eye; open, so that its back is seen too.
void addSquare(sim::HeadMesh& mesh, glm::vec2 middle)
{
    const auto first = static_cast<std::uint32_t>(mesh.positionsHd.size());
    constexpr float kHalfM = 0.04F;
    for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
        mesh.positionsHd.emplace_back(middle + kHalfM * corner, 0.0F);
        mesh.normalsHd.emplace_back(0.0F, 0.0F, 1.0F);
        mesh.uvs.emplace_back(0.5F + corner.x * 0.4F, 0.5F + corner.y * 0.4F);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
}

} // namespace

class TestTurnedHead : public RendererFixture
{
    Q_OBJECT

private Q_SLOTS:
    void shouldersStay_data()
    {
        QTest::addColumn<bool>("hasShoulders");
        QTest::newRow("of a bust") << true;
        QTest::newRow("of a head without a neck") << false;
    }

    void shouldersStay()
    {
        QFETCH(bool, hasShoulders);
        auto mesh = std::make_shared<sim::HeadMesh>();
        addSquare(*mesh, {0.08F, 0.08F});  // A square of the head.
        addSquare(*mesh, {0.08F, -0.08F}); // One of a shoulder, on the same side.
        Scene scene = emptyScene();
        const Picture nothing = draw(scene);
        scene.head = mesh;
        const auto frame = makeFrame({});
        if (hasShoulders)
            frame->neck = {.headY = 0.01F, .shouldersY = -0.01F};
        // Half way about.
        frame->pose.rotation = glm::quat(0.0F, 0.0F, 1.0F, 0.0F);
        scene.hair = frame;
        const Picture picture = draw(scene);
        // A pixel is about 2.7 mm; x to the right, y up from the picture's middle.
        const auto isSeen = [&](int x, int y) { return picture.at(100 + x, 75 - y) != nothing.at(100 + x, 75 - y); };
        QVERIFY(isSeen(-30, 30)); // The head's square has gone to the other side,
        QVERIFY(!isSeen(30, 30));
        QCOMPARE(isSeen(30, -30), hasShoulders); // the shoulder's is still there.
        QCOMPARE(isSeen(-30, -30), !hasShoulders);
    }
};

HAIRPAINT_TEST(TestTurnedHead, None)
#include "test_turned_head.moc"
