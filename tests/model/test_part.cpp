// The parting: what a curve over the skin leaves in the direction and the density map, and how it is edited.
#include "model/document/layer_commands.h"
#include "tests/model/parter.h"
#include "tests/support/test_program.h"

#include <QUndoStack>
#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

class TestPart : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theCurveRunsThroughItsPointsOverTheSkin()
    {
        Parter part(makeBallHead(96, kPartedBallM));
        const std::vector<glm::vec3> points{onPartedBall(0.9F, 0.3F), onPartedBall(0.2F, 0.6F),
                                            onPartedBall(-0.4F, 0.2F), onPartedBall(-1.4F, 0.3F)};
        for (const glm::vec3& point : points)
            part.click(point);
        QCOMPARE(part.handles().size(), qsizetype{4});
        std::vector<glm::vec3> curve;
        for (const OverlayShape& shape : part.tool.overlay()) {
            QVERIFY(!shape.closed);
            for (const QPointF& uv : shape.uvOutline)
                curve.push_back(part.skin().atUv({uv.x(), uv.y()})->positionHd);
        }
        for (const glm::vec3& point : points)
            QVERIFY(std::ranges::any_of(curve, [&](glm::vec3 one) { return glm::distance(one, point) < 0.001F; }));
        for (std::size_t i = 2; i < curve.size(); ++i) {
            QVERIFY(glm::distance(curve[i], curve[i - 1]) < 0.006F);
            const float bend =
                glm::dot(glm::normalize(curve[i] - curve[i - 1]), glm::normalize(curve[i - 1] - curve[i - 2]));
            QVERIFY2(bend > 0.85F, qPrintable(QString::number(bend)));
        }
    }

    void hairFallsToBothSides()
    {
        Parter part;
        part.partPatch();
        for (const float y : {-0.045F, -0.02F, 0.0F, 0.03F})
            for (const float x : {0.001F, 0.004F, 0.015F}) {
                QVERIFY(glm::distance(part.directionAt({x, y, 0.0F}), glm::vec3(0.9F, 0.0F, 0.0F)) < 0.02F);
                QVERIFY(glm::distance(part.directionAt({-x, y, 0.0F}), glm::vec3(-0.9F, 0.0F, 0.0F)) < 0.02F);
                QVERIFY(part.coverageAt({x, y, 0.0F}) > 0.99F);
            }
        QCOMPARE(part.coverageAt({0.042F, 0.0F, 0.0F}), 0.0F);
        const float fading = part.coverageAt({-0.032F, 0.0F, 0.0F});
        QVERIFY(fading > 0.1F && fading < 0.9F);
    }

    void pastItsEndsItFadesAndBothSidesMeet()
    {
        Parter part;
        part.partPatch();
        QVERIFY(part.coverageAt({0.01F, 0.055F, 0.0F}) > 0.95F);
        QVERIFY(part.coverageAt({0.01F, 0.07F, 0.0F}) < 0.7F);
        QCOMPARE(part.coverageAt({0.0F, 0.095F, 0.0F}), 0.0F);
        const glm::vec3 past = part.directionAt({0.01F, 0.075F, 0.0F});
        QVERIFY(past.x > 0.2F && past.y > 0.2F);
    }

    void overAHeadHairLiesDownBothSidesAndALittleBack()
    {
        Parter part(makeBallHead(128, kPartedBallM), 1024);
        for (const float angle : {0.7F, 0.2F, -0.3F})
            part.click(overTop(angle));
        for (const float side : {-1.0F, 1.0F}) {
            const glm::vec3 positionHd = kPartedBallM * glm::normalize(glm::vec3(0.15F * side, 0.97F, 0.1F));
            const glm::vec3 direction = part.directionAt(positionHd);
            QVERIFY(direction.x * side > 0.7F);
            QVERIFY(direction.z < -0.1F && direction.z > -0.45F);
            QVERIFY(std::abs(glm::length(direction) - 0.9F) < 0.02F);
        }
    }

    void theGapIsAsWideAsAskedForAndNeverThinnerThanATexel_data()
    {
        QTest::addColumn<int>("mapSize");
        QTest::addColumn<float>("gapM");
        QTest::addColumn<float>("bareM"); // To this side of the line there is no hair,
        QTest::addColumn<float>("fullM"); // from here on all of it.
        QTest::newRow("fine, on a fine map") << 2048 << 0.001F << 0.0002F << 0.0012F;
        QTest::newRow("fine, on a coarse map") << 256 << 0.001F << 0.0F << 0.0025F;
        QTest::newRow("wide") << 1024 << 0.006F << 0.0017F << 0.0045F;
        QTest::newRow("none") << 512 << 0.0F << -1.0F << 0.0F;
    }
    void theGapIsAsWideAsAskedForAndNeverThinnerThanATexel()
    {
        QFETCH(int, mapSize);
        QFETCH(float, gapM);
        QFETCH(float, bareM);
        QFETCH(float, fullM);
        Parter part(makePatchHead(), mapSize);
        part.settings.partGapM = gapM;
        part.partPatch();
        for (const float side : {-1.0F, 1.0F})
            for (const float y : {-0.04F, 0.0F, 0.025F}) {
                const float texelM = 0.2F / static_cast<float>(mapSize);
                const glm::vec3 edge(side * (fullM + texelM), y, 0.0F);
                QCOMPARE(part.densityAt(edge), 1.0F);
                if (bareM >= 0.0F)
                    QVERIFY(part.densityAt({side * bareM, y, 0.0F}) < 0.35F);
            }
        QVERIFY(gapM > 0.0F || part.densityAt(glm::vec3(0.0F)) == 1.0F);
        part.commit();
        QCOMPARE(part.document.undoStack().count(), 1);
    }

    void aGapIsASofterLineInALayerThatAdds()
    {
        Parter part;
        const LayerAddress at = firstLayer(part.document, MapKind::Density);
        LayerProperties properties = propertiesOf(*part.document.project().layer(at.group, at.map, at.layer));
        properties.blend = BlendMode::Add;
        part.document.push(setLayerPropertiesCommand(part.document, at, properties, QString()));
        part.settings.partGapM = 0.004F;
        part.partPatch();
        QCOMPARE(part.texelAt(glm::vec3(0.0F), MapKind::Density)[1], std::uint16_t{0});
        QCOMPARE(part.texelAt({0.01F, 0.0F, 0.0F}, MapKind::Density)[1], std::uint16_t{65535});
    }

    void aZigzagRunsToAndFro()
    {
        Parter part(makePatchHead(), 1024);
        const auto crossings = [&](float x) {
            int count = 0;
            float last = 0.0F;
            for (float y = -0.047F; y < 0.047F; y += 0.0005F) {
                const float side = part.directionAt({x, y, 0.0F}).x;
                count += side * last < 0.0F ? 1 : 0;
                last = side;
            }
            return count;
        };
        part.settings.partZigzagM = 0.004F;
        part.partPatch();
        QVERIFY2(std::abs(crossings(0.002F) - 16) <= 1, qPrintable(QString::number(crossings(0.002F))));
        QVERIFY(std::abs(crossings(-0.002F) - 16) <= 1);
        QCOMPARE(crossings(0.006F), 0);
        part.settings.partZigzagM = 0.0F;
        ToolContext now = part.context();
        part.tool.settingsChanged(now);
        QCOMPARE(crossings(0.002F), 0);
    }

    void escLeavesNoTrace()
    {
        Parter part;
        const Project before = part.document.committed();
        const auto density = part.document.resolved(1, MapKind::Density);
        part.partPatch();
        QVERIFY(!sameProjects(part.document.project(), before));
        QVERIFY(sameProjects(part.document.committed(), before));
        part.cancel();
        QVERIFY(!part.tool.active());
        QVERIFY(part.tool.overlay().empty());
        QVERIFY(sameProjects(part.document.project(), before));
        QCOMPARE(part.document.undoStack().count(), 0);
        part.partPatch(); // A new one, from the beginning.
        QCOMPARE(part.handles().size(), qsizetype{3});
    }

    void oneStepOverTwoMapsIsWhatWasShown()
    {
        Parter part;
        const Project before = part.document.committed();
        part.partPatch();
        const Project shown = part.document.project();
        part.commit();
        QVERIFY(!part.tool.active());
        QVERIFY(sameProjects(part.document.committed(), shown));
        QVERIFY(!sameLayers(shown.groups.front().map(MapKind::Density).layers,
                            before.groups.front().map(MapKind::Density).layers));
        QCOMPARE(part.document.undoStack().count(), 1);
        QCOMPARE(part.document.undoStack().text(0), QStringLiteral("Part"));
        part.document.undo();
        QVERIFY(sameProjects(part.document.committed(), before));
        part.document.redo();
        QVERIFY(sameProjects(part.document.committed(), shown));
    }

    void undoAndBackspaceTakeBackPointByPoint()
    {
        Parter part;
        const Project before = part.document.committed();
        part.partPatch();
        const Project three = part.document.project();
        part.drag({0.0F, 0.05F, 0.0F}, {0.02F, 0.06F, 0.0F});
        QCOMPARE(part.handles().size(), qsizetype{3});
        QVERIFY(!sameProjects(part.document.project(), three));
        part.document.undo();
        QVERIFY(sameProjects(part.document.project(), three));
        part.document.undo();
        QCOMPARE(part.handles().size(), qsizetype{2});
        QVERIFY(part.key(Qt::Key_Backspace));
        QCOMPARE(part.handles().size(), qsizetype{1});
        QVERIFY(sameProjects(part.document.project(), before));
        part.document.undo(); // Undoes the Backspace.
        QCOMPARE(part.handles().size(), qsizetype{2});
        part.document.undo();
        part.document.undo();
        QVERIFY(!part.tool.active());
        QCOMPARE(part.document.undoStack().count(), 0);
        QVERIFY(sameProjects(part.document.project(), before));
    }

    void deleteTakesThePointUnderThePointer()
    {
        Parter part;
        for (const glm::vec3 positionHd :
             {glm::vec3(0.0F, -0.05F, 0.0F), glm::vec3(0.03F, 0.0F, 0.0F), glm::vec3(0.0F, 0.05F, 0.0F)})
            part.click(positionHd);
        ToolContext now = part.context();
        part.tool.hover(part.eventAt({0.031F, 0.0F, 0.0F}), now);
        QVERIFY(part.key(Qt::Key_Delete));
        QCOMPARE(part.handles().size(), qsizetype{2});
        QVERIFY(part.directionAt({0.004F, 0.0F, 0.0F}).x > 0.85F); // Straight now.
        QVERIFY(!part.key(Qt::Key_A));
    }

    void pointsAreDraggedAndTheCurveTakesNewOnes()
    {
        Parter part;
        part.partPatch();
        part.drag({0.0F, 0.0F, 0.0F}, {0.03F, 0.0F, 0.0F});
        QCOMPARE(part.handles().size(), qsizetype{3});
        QVERIFY(part.directionAt({0.02F, 0.0F, 0.0F}).x < -0.85F);
        QVERIFY(part.directionAt({0.035F, 0.0F, 0.0F}).x > 0.85F);
        // Pressed between two points, the curve gets another one there.
        const QPolygonF outline = part.tool.overlay().front().uvOutline;
        const QPointF uv = outline[outline.size() / 4];
        const glm::vec3 positionHd = part.skin().atUv({uv.x(), uv.y()})->positionHd;
        part.drag(positionHd, positionHd + glm::vec3(-0.03F, 0.0F, 0.0F));
        QCOMPARE(part.handles().size(), qsizetype{4});
        const glm::vec2 second(part.handles()[1].x(), part.handles()[1].y());
        QVERIFY(glm::distance(second, part.skin().nearest(positionHd + glm::vec3(-0.03F, 0.0F, 0.0F)).uv) < 0.001F);
        part.document.undo(); // In one step.
        QCOMPARE(part.handles().size(), qsizetype{3});
    }

    void aDragDrawsTheCurve()
    {
        Parter part;
        part.drag({0.0F, -0.05F, 0.0F}, {0.0F, 0.05F, 0.0F});
        QVERIFY(part.handles().size() >= 4 && part.handles().size() <= 7);
        QVERIFY(part.tool.pending());
        QVERIFY(part.directionAt({0.01F, 0.0F, 0.0F}).x > 0.85F);
        part.document.undo(); // What was drawn at one go goes at once.
        QVERIFY(part.handles().size() <= 1);
    }

    void aDoubleClickKeepsIt()
    {
        Parter part;
        part.partPatch();
        part.seconds += 0.2;
        part.press({0.0F, 0.05F, 0.0F});
        QVERIFY(!part.tool.active());
        QCOMPARE(part.document.undoStack().count(), 1);
        part.partPatch();
        part.click({0.0F, 0.05F, 0.0F}); // Much later.
        QVERIFY(part.tool.active());
    }

    void aLayerThatIsLockedIsLeftAlone_data()
    {
        QTest::addColumn<MapKind>("map");
        QTest::addColumn<bool>("locked");
        QTest::newRow("direction, locked") << MapKind::Direction << true;
        QTest::newRow("direction, hidden") << MapKind::Direction << false;
        QTest::newRow("density, locked") << MapKind::Density << true;
        QTest::newRow("density, hidden") << MapKind::Density << false;
    }
    void aLayerThatIsLockedIsLeftAlone()
    {
        QFETCH(MapKind, map);
        QFETCH(bool, locked);
        Parter part;
        const LayerAddress at = firstLayer(part.document, map);
        LayerProperties properties = propertiesOf(*part.document.project().layer(at.group, at.map, at.layer));
        properties.locked = locked;
        properties.visible = locked;
        part.document.push(setLayerPropertiesCommand(part.document, at, properties, QString()));
        const sim::TiledRaster before = part.layer(map);
        part.partPatch();
        QCOMPARE(part.tool.active(), map == MapKind::Density);
        part.commit();
        QVERIFY(part.layer(map) == before);
    }

    void itIsNotDoubledInTheMirror_data()
    {
        QTest::addColumn<bool>("builtIn");
        QTest::newRow("built-in") << true;
        QTest::newRow("imported") << false;
    }
    void itIsNotDoubledInTheMirror()
    {
        QFETCH(bool, builtIn);
        const auto parted = [builtIn](bool mirror) {
            Parter part(makeBallHead(96, kPartedBallM), 512, builtIn);
            part.mirror = mirror;
            for (const float latitude : {0.2F, 0.6F, 1.0F})
                part.click(onPartedBall(0.5F, latitude));
            part.commit();
            return part.document.committed().groups;
        };
        QVERIFY(sameLayers(parted(true).front().map(MapKind::Direction).layers,
                           parted(false).front().map(MapKind::Direction).layers));
    }

    void acrossASeamItIsOneParting()
    {
        Parter part(makeBallHead(96, kPartedBallM), 1024);
        const float back = 3.14159F;
        for (const float around : {-0.4F, 0.0F, 0.4F})
            part.click(onPartedBall(back + around, 0.3F));
        for (const float around : {-0.3F, -0.1F, 0.1F, 0.3F}) {
            QVERIFY(part.directionAt(onPartedBall(back + around, 0.4F)).y > 0.5F);
            QVERIFY(part.directionAt(onPartedBall(back + around, 0.2F)).y < -0.5F);
        }
    }

    void theSelectionBoundsIt()
    {
        Parter part;
        part.selection.setRectangle(QRectF(0.0, 0.0, 1.0, 0.5));
        part.partPatch();
        QCOMPARE(part.coverageAt({0.005F, 0.01F, 0.0F}), 0.0F);
        QVERIFY(part.coverageAt({0.005F, -0.01F, 0.0F}) > 0.99F);
        QCOMPARE(part.densityAt({0.0F, 0.01F, 0.0F}), 1.0F);
        QVERIFY(part.densityAt({0.0F, -0.01F, 0.0F}) < 0.2F);
    }
};

HAIRPAINT_TEST(TestPart, Gui)
#include "test_part.moc"
