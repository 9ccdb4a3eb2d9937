// Fingers: what they leave in the maps.
#include "tests/model/head_studio.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

const QString kFingers = QStringLiteral("fingers");

/// A studio whose hair lies to the right on a patch of 20 cm in the plane z = 0.
struct Fingers : HeadStudio
{
    explicit Fingers(FingerKind kind) : HeadStudio(filledPatch(MapKind::Length, 26214))
    {
        settings.brushSizeM = 0.3F;
        settings.hardness = 1.0F;
        map = MapKind::Density;
        press(kBrush, 0.5F, 0.5F);
        release(kBrush, 0.5F, 0.5F);
        map = MapKind::Direction;
        // A comb lays all of it.
        settings.flatness = 0.8F;
        press(QStringLiteral("comb"), 0.3F, 0.5F);
        move(QStringLiteral("comb"), 0.7F, 0.5F);
        release(QStringLiteral("comb"), 0.7F, 0.5F);
        settings.brushSizeM = 0.04F;
        settings.fingers = kind;
    }
    /// Through the middle of the patch.
    void stroke()
    {
        press(kFingers, 0.4F, 0.5F);
        move(kFingers, 0.5F, 0.5F);
        move(kFingers, 0.6F, 0.5F);
    }
    void letGo() { release(kFingers, 0.6F, 0.5F); }
    [[nodiscard]] float value(MapKind kind, glm::vec3 positionHd)
    {
        return document.resolved(context().target.group, kind)->sampleScalar(skin().nearest(positionHd).uv);
    }
    [[nodiscard]] glm::vec3 lies(glm::vec3 positionHd)
    {
        const sim::SurfacePoint point = skin().nearest(positionHd);
        return sim::SkinFrame::at(point).toHd(sim::directionOf(shown()->sampleNearest(point.uv)));
    }
};

constexpr glm::vec3 kMiddle(0.0F, 0.0F, 0.0F);
constexpr glm::vec3 kAbove(0.0F, 0.008F, 0.0F);
constexpr glm::vec3 kBelow(0.0F, -0.008F, 0.0F);
constexpr glm::vec3 kOutside(0.0F, 0.03F, 0.0F);

} // namespace

class TestFingers : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void puffedHairStandsUpAndKeepsItsWay()
    {
        Fingers fingers(FingerKind::Puff);
        const glm::vec3 before = fingers.lies(kMiddle);
        QVERIFY(std::abs(before.x - 0.8F) < 0.02F);
        fingers.stroke();
        fingers.letGo();
        const glm::vec3 after = fingers.lies(kMiddle);
        QVERIFY(after.x > 0.3F && after.x < 0.55F);
        QVERIFY(std::abs(after.y) < 0.02F);
        QVERIFY(fingers.value(MapKind::Gel, kMiddle) > 0.05F);
        QCOMPARE(fingers.lies(kOutside), before);
        QCOMPARE(fingers.document.undoStack().undoText(), QStringLiteral("Puff hair"));
        // Another stroke does more.
        fingers.stroke();
        fingers.letGo();
        QVERIFY(fingers.lies(kMiddle).x < after.x - 0.1F);
    }

    void pinchedHairGathersToTheMiddle_data()
    {
        QTest::addColumn<FingerKind>("kind");
        QTest::addColumn<float>("towards");
        QTest::newRow("pinch") << FingerKind::Pinch << 1.0F;
        QTest::newRow("spread") << FingerKind::Spread << -1.0F;
    }
    void pinchedHairGathersToTheMiddle()
    {
        QFETCH(FingerKind, kind);
        QFETCH(float, towards);
        Fingers fingers(kind);
        fingers.stroke();
        fingers.letGo();
        QVERIFY(fingers.lies(kAbove).y * towards < -0.03F);
        QVERIFY(fingers.lies(kBelow).y * towards > 0.03F);
        QVERIFY(std::abs(fingers.lies(kMiddle).y) < 0.02F);
        QVERIFY(fingers.lies(kMiddle).x > 0.75F);
        const float clump = fingers.value(MapKind::Clump, kMiddle);
        QVERIFY(kind == FingerKind::Pinch ? clump > 0.45F : clump == 0.0F);
    }

    void smoothedHairIsAsItsNeighboursAre()
    {
        Fingers fingers(FingerKind::Smooth);
        const ToolSettings own = fingers.settings;
        // A dent in the length and in how it lies.
        fingers.settings.brushSizeM = 0.006F;
        fingers.map = MapKind::Length;
        fingers.settings.value(MapKind::Length).scalar = 0.1F;
        fingers.press(kBrush, 0.5F, 0.5F);
        fingers.release(kBrush, 0.5F, 0.5F);
        fingers.map = MapKind::Direction;
        fingers.settings.value(MapKind::Direction).direction = {0.0F, 0.8F};
        fingers.press(kBrush, 0.5F, 0.5F);
        fingers.release(kBrush, 0.5F, 0.5F);
        fingers.settings = own;
        const float length = fingers.value(MapKind::Length, kMiddle);
        const glm::vec3 lay = fingers.lies(kMiddle);
        QVERIFY(length < 0.15F && lay.y > 0.7F);
        fingers.stroke();
        fingers.letGo();
        QVERIFY(fingers.value(MapKind::Length, kMiddle) > length + 0.05F);
        const glm::vec3 now = fingers.lies(kMiddle);
        QVERIFY2(now.y < 0.65F, qPrintable(QStringLiteral("%1 %2").arg(now.x).arg(now.y)));
        QCOMPARE(fingers.document.undoStack().undoText(), QStringLiteral("Smooth hair"));
    }

    void thePreviewIsTheCommitAndUndoGivesTheBytes_data()
    {
        QTest::addColumn<FingerKind>("kind");
        QTest::newRow("puff") << FingerKind::Puff;
        QTest::newRow("pinch") << FingerKind::Pinch;
        QTest::newRow("spread") << FingerKind::Spread;
        QTest::newRow("smooth") << FingerKind::Smooth;
    }
    void thePreviewIsTheCommitAndUndoGivesTheBytes()
    {
        QFETCH(FingerKind, kind);
        Fingers fingers(kind);
        fingers.mirror = true;
        fingers.settings.brushSizeM = 0.03F;
        const Project before = fingers.document.committed();
        const int steps = fingers.document.undoStack().count();
        fingers.press(kFingers, 0.3F, 0.4F);
        fingers.move(kFingers, 0.4F, 0.6F, 0.5F);
        const Project shown = fingers.document.project();
        QVERIFY(!sameProjects(before, shown));
        ToolContext now = fingers.context();
        fingers.tool(kFingers).commit(now);
        QVERIFY(sameProjects(fingers.document.committed(), shown));
        QCOMPARE(fingers.document.undoStack().count(), steps + 1);
        // The other side is the first one's mirror image.
        const sim::TiledRaster& layer = fingers.layer(MapKind::Direction);
        const auto at = [&](int x, int y) { return sim::directionOf(layer.texel(x, y)); };
        for (int y = 0; y < layer.size(); y += 7)
            for (int x = 0; x < layer.size() / 2; x += 7) {
                const glm::vec2 other = at(layer.size() - 1 - x, y);
                if (kind != FingerKind::Smooth && at(x, y) != glm::vec2(0.8F, 0.0F))
                    QVERIFY(std::abs(glm::length(at(x, y)) - glm::length(other)) < 0.02F);
            }
        fingers.document.undo();
        QVERIFY(sameProjects(fingers.document.committed(), before));
        fingers.press(kFingers, 0.3F, 0.4F);
        ToolContext again = fingers.context();
        fingers.tool(kFingers).cancel(again);
        QVERIFY(sameProjects(fingers.document.project(), before));
    }

    void aPenThatPressesLessDoesLess()
    {
        float puffed[2];
        for (const int light : {0, 1}) {
            Fingers fingers(FingerKind::Puff);
            fingers.press(kFingers, 0.5F, 0.5F, light == 0 ? 1.0F : 0.3F);
            ToolContext now = fingers.context();
            fingers.tool(kFingers).commit(now);
            puffed[light] = fingers.lies(kMiddle).x;
        }
        QVERIFY(puffed[0] < puffed[1] - 0.1F && puffed[1] < 0.78F);
    }
};

HAIRPAINT_TEST(TestFingers, Gui)
#include "test_fingers.moc"
