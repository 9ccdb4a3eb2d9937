// The comb: what a stroke over the skin leaves in the direction map.
#include "tests/model/head_studio.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

constexpr float kBallRadiusM = 0.1F;

struct Hairdresser : HeadStudio
{
    ToolId tool = ToolId::Comb;

    explicit Hairdresser(sim::HeadMesh mesh, bool builtIn = false) : HeadStudio(onMesh(std::move(mesh), builtIn))
    {
        settings = ToolSettings();
        settings.hardness = 1.0F;
        settings.pressureSize = false;
        settings.brushSizeM = 0.03F;
    }
    /// Over the head along these points.
    void stroke(const std::vector<glm::vec3>& pathHd, float pressure = 1.0F)
    {
        Tool& with = Studio::tool(tool);
        ToolContext now = context();
        with.press(eventAt(pathHd.front(), pressure), now);
        for (const glm::vec3& positionHd : pathHd)
            with.move(eventAt(positionHd, pressure), now);
        with.release(eventAt(pathHd.back(), pressure), now);
    }
};

glm::vec3 onBall(float longitude, float latitude)
{
    return kBallRadiusM * glm::vec3(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                                    std::cos(latitude) * std::cos(longitude));
}

float degreesBetween(glm::vec3 a, glm::vec3 b)
{
    return glm::degrees(std::acos(std::clamp(glm::dot(glm::normalize(a), glm::normalize(b)), -1.0F, 1.0F)));
}

} // namespace

class TestComb : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void hairLiesAlongTheStroke_data()
    {
        QTest::addColumn<float>("from");
        QTest::addColumn<float>("to");
        QTest::addColumn<float>("rise");
        QTest::newRow("over the face to the left") << -0.5F << 0.5F << 0.0F;
        QTest::newRow("to the right") << 0.5F << -0.5F << 0.0F;
        QTest::newRow("slanting up") << -0.4F << 0.4F << 0.6F;
        QTest::newRow("across the seam at the back") << 2.7F << 3.6F << 0.0F;
        QTest::newRow("across the seam, slanting down") << 3.6F << 2.7F << -0.5F;
    }
    void hairLiesAlongTheStroke()
    {
        QFETCH(float, from);
        QFETCH(float, to);
        QFETCH(float, rise);
        Hairdresser comb(makeBallHead(96, kBallRadiusM));
        std::vector<glm::vec3> path;
        for (int i = 0; i <= 40; ++i) {
            const float t = static_cast<float>(i) / 40.0F;
            path.push_back(onBall(from + (to - from) * t, rise * (t - 0.5F)));
        }
        comb.stroke(path);
        for (std::size_t i = 4; i + 4 < path.size(); ++i) {
            QCOMPARE(comb.texelAt(path[i])[2], std::uint16_t{65535});
            const glm::vec3 laid = comb.directionAt(path[i]);
            const float off = degreesBetween(laid, path[i + 1] - path[i - 1]);
            QVERIFY2(off < 5.0F, qPrintable(QStringLiteral("%1 degrees off at %2").arg(off).arg(i)));
            QVERIFY(std::abs(glm::length(laid) - 0.9F) < 0.01F);
        }
        QCOMPARE(comb.document.undoStack().count(), 1);
        QCOMPARE(comb.document.undoStack().text(0), QStringLiteral("Comb on Direction"));
    }

    void aBrushWideIsCombedInTheSameDirection()
    {
        Hairdresser comb(makeBallHead(96, kBallRadiusM));
        comb.stroke({onBall(0.0F, 0.4F), onBall(0.0F, 0.1F), onBall(0.0F, -0.2F), onBall(0.0F, -0.4F)});
        for (const float beside : {-0.012F, -0.006F, 0.006F, 0.012F}) {
            const glm::vec3 positionHd = onBall(beside / kBallRadiusM, 0.0F);
            QVERIFY(degreesBetween(comb.directionAt(positionHd), {0.0F, -1.0F, 0.0F}) < 5.0F);
        }
    }

    void pressureIsFlatnessAndAClickCombsNothing()
    {
        Hairdresser comb(makePatchHead());
        comb.stroke({{0.0F, 0.0F, 0.0F}});
        QCOMPARE(comb.document.undoStack().count(), 0);
        comb.stroke({{-0.04F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}, {0.04F, 0.0F, 0.0F}}, 0.5F);
        QVERIFY(glm::distance(comb.directionAt(glm::vec3(0.0F)), glm::vec3(0.45F, 0.0F, 0.0F)) < 0.01F);
    }

    void turningBackCombsInTheOtherDirection()
    {
        Hairdresser comb(makePatchHead());
        comb.stroke({{-0.04F, 0.0F, 0.0F}, {0.05F, 0.0F, 0.0F}, {-0.05F, 0.001F, 0.0F}});
        const glm::vec3 laid = comb.directionAt(glm::vec3(0.0F));
        QVERIFY(degreesBetween(laid, {-1.0F, 0.0F, 0.0F}) < 15.0F);
        QVERIFY(glm::length(laid) > 0.85F);
    }

    void halfCombedHairTurnsAndDoesNotStandUp()
    {
        Hairdresser comb(makePatchHead());
        comb.stroke({{-0.05F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}, {0.05F, 0.0F, 0.0F}});
        comb.settings.opacity = 0.5F;
        comb.stroke({{0.0F, -0.05F, 0.0F}, {0.0F, 0.0F, 0.0F}, {0.0F, 0.05F, 0.0F}});
        const glm::vec3 laid = comb.directionAt(glm::vec3(0.0F));
        QVERIFY(degreesBetween(laid, {1.0F, 1.0F, 0.0F}) < 3.0F);
        QVERIFY(std::abs(glm::length(laid) - 0.9F) < 0.01F);
    }

    void theOtherSideIsCombedInTheMirror_data()
    {
        QTest::addColumn<ToolId>("tool");
        QTest::addColumn<bool>("builtIn");
        for (const bool builtIn : {false, true}) {
            for (const auto& [tool, name] :
                 {std::pair(ToolId::Comb, "comb"), std::pair(ToolId::Brush, "brush"), std::pair(ToolId::Shape, "shape"),
                  std::pair(ToolId::Gradient, "gradient")})
                QTest::addRow("%s, %s", name, builtIn ? "built-in" : "imported") << tool << builtIn;
        }
    }
    void theOtherSideIsCombedInTheMirror()
    {
        QFETCH(ToolId, tool);
        QFETCH(bool, builtIn);
        Hairdresser comb(makeBallHead(96, kBallRadiusM), builtIn);
        comb.mirror = true;
        comb.tool = tool;
        comb.settings.value(MapKind::Direction).direction = {0.5F, -0.6F};
        comb.settings.secondValue(MapKind::Direction).direction = {0.6F, -0.7F};
        comb.stroke({onBall(0.5F, 0.3F), onBall(0.6F, 0.0F), onBall(0.8F, -0.3F)});
        const glm::vec3 positionHd = onBall(0.6F, 0.0F);
        const glm::vec3 mirrored(-1.0F, 1.0F, 1.0F);
        const glm::vec3 own = comb.directionAt(positionHd);
        QVERIFY(glm::length(own) > 0.5F);
        QVERIFY(glm::distance(comb.directionAt(positionHd * mirrored), own * mirrored) < 0.02F);
    }

    void liftingKeepsTheDirectionAndNoiseAndSmoothingMeetInTheMiddle()
    {
        Hairdresser comb(makePatchHead());
        const std::vector<glm::vec3> path{{-0.05F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}, {0.05F, 0.0F, 0.0F}};
        comb.stroke(path);
        comb.settings.comb = CombKind::Lift;
        comb.stroke(path); // Halfway up as it comes.
        QVERIFY(glm::distance(comb.directionAt(glm::vec3(0.0F)), glm::vec3(0.45F, 0.0F, 0.0F)) < 0.01F);
        comb.settings.lift = -0.2F;
        comb.stroke(path);
        QVERIFY(glm::distance(comb.directionAt(glm::vec3(0.0F)), glm::vec3(0.56F, 0.0F, 0.0F)) < 0.01F);
        comb.settings.lift = 1.0F - 0.3F / 0.56F;
        comb.stroke(path);
        QVERIFY(glm::distance(comb.directionAt(glm::vec3(0.0F)), glm::vec3(0.3F, 0.0F, 0.0F)) < 0.01F);
        const auto roughness = [&] {
            float sum = 0.0F;
            for (int i = -20; i <= 20; ++i)
                sum += glm::distance(comb.directionAt({0.001F * static_cast<float>(i), 0.0F, 0.0F}),
                                     glm::vec3(0.3F, 0.0F, 0.0F));
            return sum / 41.0F;
        };
        QVERIFY(roughness() < 0.01F);
        comb.settings.comb = CombKind::Noise;
        comb.stroke(path);
        const float ruffled = roughness();
        QVERIFY(ruffled > 0.05F);
        comb.settings.comb = CombKind::Smooth;
        for (int pass = 0; pass < 3; ++pass)
            comb.stroke(path);
        QVERIFY(roughness() < 0.5F * ruffled);
    }

    void aWhorlTurnsClockwiseOutwardAndStandsInTheMiddle_data()
    {
        QTest::addColumn<float>("longitude");
        QTest::addColumn<float>("latitude");
        QTest::newRow("front") << 0.4F << 0.1F;
        QTest::newRow("behind the top") << 2.6F << 0.6F;
    }
    void aWhorlTurnsClockwiseOutwardAndStandsInTheMiddle()
    {
        QFETCH(float, longitude);
        QFETCH(float, latitude);
        Hairdresser comb(makeBallHead(96, kBallRadiusM));
        comb.settings.comb = CombKind::Whorl;
        comb.settings.brushSizeM = 0.04F;
        const glm::vec3 centre = onBall(longitude, latitude);
        comb.stroke({centre});
        QCOMPARE(comb.document.undoStack().count(), 1);
        QCOMPARE(comb.document.undoStack().text(0), QStringLiteral("Lay a whorl"));
        QVERIFY(glm::length(comb.directionAt(centre)) < 0.1F);
        const glm::vec3 normal = glm::normalize(centre);
        const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0.0F, 1.0F, 0.0F), normal));
        const glm::vec3 up = glm::cross(normal, right);
        for (int i = 0; i < 12; ++i) {
            const float angle = 0.5236F * static_cast<float>(i);
            const glm::vec3 outward = right * std::cos(angle) + up * std::sin(angle);
            const glm::vec3 laid = comb.directionAt(centre + outward * 0.017F);
            QVERIFY2(glm::dot(laid, outward) > 0.3F, qPrintable(QString::number(i)));
            // Whoever looks at the head from outside sees the hand of a clock go from up to the right.
            QVERIFY2(glm::dot(glm::cross(outward, laid), normal) < -0.3F, qPrintable(QString::number(i)));
            QVERIFY(glm::length(laid) > 0.7F);
            QVERIFY(glm::length(comb.directionAt(centre + outward * 0.007F)) < 0.5F);
        }
        comb.document.undo();
        QVERIFY(comb.layer().uniformValue() == (sim::Texel{32768, 32768, 0, 0}));
    }

    void theOtherSidesWhorlIsMirroredAndOneInTheMiddleIsAlone_data()
    {
        QTest::addColumn<bool>("builtIn");
        QTest::newRow("imported") << false;
        QTest::newRow("built-in") << true;
    }
    void theOtherSidesWhorlIsMirroredAndOneInTheMiddleIsAlone()
    {
        QFETCH(bool, builtIn);
        Hairdresser comb(makeBallHead(96, kBallRadiusM), builtIn);
        comb.mirror = true;
        comb.settings.comb = CombKind::Whorl;
        comb.stroke({onBall(0.6F, 0.0F)});
        const glm::vec3 mirrored(-1.0F, 1.0F, 1.0F);
        for (const glm::vec3 positionHd : {onBall(0.7F, 0.0F), onBall(0.6F, 0.1F), onBall(0.5F, -0.05F)}) {
            const glm::vec3 own = comb.directionAt(positionHd);
            QVERIFY(glm::length(own) > 0.3F);
            QVERIFY(glm::distance(comb.directionAt(positionHd * mirrored), own * mirrored) < 0.05F);
        }
        comb.document.undo();
        comb.stroke({onBall(0.02F, 0.0F)});
        const glm::vec3 above = comb.directionAt(onBall(0.02F, 0.12F));
        const glm::vec3 below = comb.directionAt(onBall(0.02F, -0.12F));
        QVERIFY(above.x > 0.3F);
        QVERIFY(below.x < -0.3F);
    }

    void aWhorlGoesWithThePointerUntilItIsLetGo()
    {
        Hairdresser comb(makePatchHead());
        comb.settings.comb = CombKind::Whorl;
        comb.stroke({{-0.05F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}, {0.05F, 0.02F, 0.0F}});
        QCOMPARE(comb.document.undoStack().count(), 1);
        QCOMPARE(comb.texelAt({-0.05F, 0.0F, 0.0F})[2], std::uint16_t{0});
        QCOMPARE(comb.texelAt({0.0F, 0.0F, 0.0F})[2], std::uint16_t{0});
        QCOMPARE(comb.texelAt({0.05F, 0.02F, 0.0F})[2], std::uint16_t{65535});
    }

    void aWhorlCanBeCalledOff()
    {
        Hairdresser comb(makePatchHead());
        comb.settings.comb = CombKind::Whorl;
        const auto tool = std::ranges::find_if(comb.tools, [](const auto& one) { return one->id() == ToolId::Comb; });
        ToolContext context = comb.context();
        const sim::SurfacePoint point = comb.skin().nearest(glm::vec3(0.0F));
        (*tool)->press({.area = Area::Head, .uv = point.uv, .point = point}, context);
        QVERIFY((*tool)->active());
        const auto shown = comb.document.resolved(context.target.group, MapKind::Direction);
        QVERIFY(shown->uniformValue() == std::nullopt);
        (*tool)->cancel(context);
        QCOMPARE(comb.document.undoStack().count(), 0);
        QVERIFY(comb.layer().uniformValue() == (sim::Texel{32768, 32768, 0, 0}));
    }

    void undoTakesItBackAndTheSelectionBoundsIt()
    {
        Hairdresser comb(makePatchHead());
        comb.selection.setRectangle(QRectF(0.0, 0.0, 0.5, 1.0));
        comb.stroke({{-0.05F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}, {0.05F, 0.0F, 0.0F}});
        QCOMPARE(comb.texelAt({0.01F, 0.0F, 0.0F})[2], std::uint16_t{0});
        QCOMPARE(comb.texelAt({-0.01F, 0.0F, 0.0F})[2], std::uint16_t{65535});
        comb.document.undo();
        QVERIFY(comb.layer().uniformValue() == (sim::Texel{32768, 32768, 0, 0}));
    }
};

HAIRPAINT_TEST(TestComb, Gui)
#include "test_comb.moc"
