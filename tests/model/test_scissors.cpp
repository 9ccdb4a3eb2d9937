// Scissors: what a line over the picture leaves in the length map.
#include "model/document/layer_commands.h"
#include "model/tools/cutting/cut_pieces.h"
#include "sim/groom/strand_style.h"
#include "tests/model/side_view.h"
#include "tests/model/tool_studio.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <set>

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

/// A patch of 20 cm, wholly covered with hair of 12 cm that stands out toward +z.
Project hairyPatch(int mapSize, float lengthVariation)
{
    Project project = patchProject(mapSize);
    project.maxHairs = 2500;
    HairGroup& group = project.groups.front();
    group.settings.greatestLengthM = 0.15F;
    group.settings.variation.length = lengthVariation;
    const auto fill = [&group](MapKind map, std::uint16_t value) {
        sim::TiledRaster& raster = group.map(map).layers.front().raster;
        for (int index = 0; index < raster.tileCount(); ++index)
            raster.setUniform(index, {value, 65535, 0, 0});
    };
    fill(MapKind::Density, 65535);
    fill(MapKind::Length, 52428);
    fill(MapKind::Gel, 65535);
    return project;
}

struct Barber : Studio
{
    explicit Barber(int mapSize = 512, float lengthVariation = 0.0F) : Barber(hairyPatch(mapSize, lengthVariation)) {}
    explicit Barber(Project project)
        : Studio(std::move(project)), view(live.settled(document.groomInput(), 0.5)), before(shown())
    {}
    ToolContext context()
    {
        ToolContext now = Studio::context();
        now.seen = &view;
        return now;
    }
    [[nodiscard]] Tool& scissors() { return tool(ToolId::Scissors); }
    void press(QPointF at)
    {
        ToolContext now = context();
        scissors().pictureHandler()->pressPicture({.position = at}, now);
    }
    void move(QPointF at, Qt::KeyboardModifiers modifiers = {})
    {
        ToolContext now = context();
        scissors().pictureHandler()->movePicture({.position = at, .modifiers = modifiers}, now);
    }
    void release(QPointF at)
    {
        ToolContext now = context();
        scissors().pictureHandler()->releasePicture({.position = at}, now);
    }
    void cut(QPointF from, QPointF to)
    {
        press(from);
        move(from + (to - from) * 0.4);
        release(to);
    }
    [[nodiscard]] const sim::Groom& groom() const { return *view.hair()->groom; }
    /// A hair's length as the map now says, as a fraction of what it said.
    [[nodiscard]] float kept(std::uint32_t slot)
    {
        const glm::vec2 uv = groom().roots->uv[slot];
        return shown()->sampleScalar(uv) / before->sampleScalar(uv);
    }
    [[nodiscard]] std::vector<std::uint32_t> positioned() const
    {
        std::vector<std::uint32_t> slots;
        for (std::uint32_t slot = 0; slot < groom().roots->count(); ++slot)
            if (view.hair()->isPositioned(slot))
                slots.push_back(slot);
        return slots;
    }

    LiveHair live;
    SideView view;
    std::shared_ptr<const sim::TiledRaster> before; ///< The length map.
};

/// Slants across the hair of the patch's upper half.
const QPointF kFrom = SideView::seen({0.0F, 0.09F, 0.04F});
const QPointF kTo = SideView::seen({0.0F, -0.02F, 0.07F});

using Slots = std::set<std::uint32_t>;

Slots slotsOf(const std::vector<SeenStrand>& strands)
{
    Slots slots;
    for (const SeenStrand& strand : strands)
        slots.insert(strand.slot);
    return slots;
}

} // namespace

class TestScissors : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void hairIsCutWhereTheLineCrossesItAndNoOther_data()
    {
        QTest::addColumn<int>("mapSize");
        QTest::addColumn<float>("variation");
        QTest::newRow("many texels a hair") << 1024 << 0.0F;
        QTest::newRow("few") << 256 << 0.0F;
        QTest::newRow("hairs of their own lengths") << 512 << 0.2F;
    }
    void hairIsCutWhereTheLineCrossesItAndNoOther()
    {
        QFETCH(int, mapSize);
        QFETCH(float, variation);
        Barber barber(mapSize, variation);
        barber.settings.cutThrough = true;
        const std::vector<SeenStrand> crossed = barber.view.crossing(std::array{kFrom, kTo}, true);
        QVERIFY(crossed.size() > 300);
        barber.cut(kFrom, kTo);
        const Slots cut = slotsOf(crossed);
        for (const SeenStrand& strand : crossed) {
            const float error = std::abs(barber.kept(strand.slot) - strand.fraction) * 0.12F;
            QVERIFY2(error < 0.0005F, qPrintable(QString::number(double(error))));
        }
        for (const std::uint32_t slot : barber.positioned())
            if (!cut.contains(slot))
                QCOMPARE(barber.kept(slot), 1.0F);
    }

    void whereTheMapIsTooCoarseHairThatIsNotCrossedStays()
    {
        constexpr float kLengthM = 0.12F;
        Barber barber(64, 0.3F); // Three roots on five texels.
        barber.settings.cutThrough = true;
        const std::vector<SeenStrand> crossed = barber.view.crossing(std::array{kFrom, kTo}, true);
        barber.cut(kFrom, kTo);
        const Slots cut = slotsOf(crossed);
        for (const std::uint32_t slot : barber.positioned()) {
            if (cut.contains(slot))
                continue;
            const float changeM = std::abs(1.0F - barber.kept(slot)) * kLengthM;
            QVERIFY2(changeM < 0.002F, qPrintable(QString::number(double(changeM))));
        }
        // Of what is crossed, most is cut on the line, and little stays longer.
        int exact = 0;
        int longer = 0;
        for (const SeenStrand& strand : crossed) {
            const float longerM = (barber.kept(strand.slot) - strand.fraction) * kLengthM;
            longer += longerM >= 0.005F ? 1 : 0;
            exact += std::abs(longerM) < 0.005F ? 1 : 0;
        }
        QVERIFY2(exact > static_cast<int>(crossed.size()) / 2, qPrintable(QString::number(exact)));
        QVERIFY2(longer < static_cast<int>(crossed.size()) / 20,
                 qPrintable(QStringLiteral("%1 of %2").arg(longer).arg(crossed.size())));
        // Thinning spares the hairs between.
        barber.document.undo();
        barber.settings.cutFraction = 0.5F;
        barber.cut(kFrom, kTo);
        for (const std::uint32_t slot : barber.positioned())
            if (!cut.contains(slot))
                QCOMPARE(barber.kept(slot), 1.0F);
    }

    /// Hair that is planted later is read from texels that matter little to the hair that is cut.
    void noTexelBesideACutIsMuchLessThanTheHairThereNeeds_data()
    {
        QTest::addColumn<int>("mapSize");
        QTest::newRow("three roots on five texels") << 64;
        QTest::newRow("a root on seven texels") << 128;
    }
    void noTexelBesideACutIsMuchLessThanTheHairThereNeeds()
    {
        QFETCH(int, mapSize);
        Barber barber(mapSize);
        const std::vector<SeenStrand> crossed = barber.view.crossing(std::array{kFrom, kTo}, false);
        barber.cut(kFrom, kTo);
        const float shortest = std::ranges::min_element(crossed, {}, &SeenStrand::fraction)->fraction;
        int changed = 0;
        for (int y = 0; y < mapSize; ++y)
            for (int x = 0; x < mapSize; ++x) {
                const auto was = static_cast<float>(barber.before->texel(x, y)[0]);
                const auto is = static_cast<float>(barber.shown()->texel(x, y)[0]);
                changed += is != was ? 1 : 0;
                QVERIFY2(is > 0.45F * shortest * was && is < 1.2F * was, qPrintable(QString::number(double(is / was))));
            }
        QVERIFY(changed > 500);
    }

    void tipColoursStayWhereTheyWereSeen()
    {
        constexpr float kTipFrom = 0.5F;
        constexpr float kLengthM = 0.12F;
        Project project = hairyPatch(512, 0.0F);
        HairGroup& group = project.groups.front();
        group.settings.material.tipFrom = kTipFrom;
        sim::TiledRaster& tip = group.map(MapKind::TipColour).layers.front().raster;
        for (int index = 0; index < tip.tileCount(); ++index)
            tip.setUniform(index, {65535, 0, 0, 65535});
        Barber barber(std::move(project));
        barber.settings.cutThrough = true;
        const auto starts = [&barber] {
            return barber.document.resolvedNow(barber.document.project().groups.front().id, MapKind::TipStart);
        };
        const auto before = starts();
        const std::vector<SeenStrand> crossed = barber.view.crossing(std::array{kFrom, kTo}, true);
        barber.cut(kFrom, kTo);
        const auto after = starts();
        const Slots cut = slotsOf(crossed);
        for (const SeenStrand& strand : crossed) {
            const float start = after->sampleScalar(barber.groom().roots->uv[strand.slot]);
            const float fromM = (kTipFrom + (1.0F - kTipFrom) * start) * barber.kept(strand.slot) * kLengthM;
            const float wantedM = std::min(kTipFrom, strand.fraction) * kLengthM;
            QVERIFY2(std::abs(fromM - wantedM) < 0.002F,
                     qPrintable(QStringLiteral("%1 %2").arg(double(fromM)).arg(double(wantedM))));
        }
        for (const std::uint32_t slot : barber.positioned())
            if (!cut.contains(slot))
                QCOMPARE(after->sampleScalar(barber.groom().roots->uv[slot]), 0.0F);
        QCOMPARE(barber.document.undoStack().count(), 1);
        barber.document.undo();
        QVERIFY(*starts() == *before);
    }

    void whatIsSeenWhileTheLineIsDrawnIsWhatStays()
    {
        Barber barber;
        barber.press(kFrom);
        QVERIFY(barber.scissors().active());
        QVERIFY(*barber.shown() == *barber.before);
        barber.move(kTo + QPointF(0.0, 40.0));
        const auto other = barber.shown();
        barber.move(kTo);
        const auto live = barber.shown();
        QVERIFY(*live != *barber.before);
        QVERIFY(*live != *other);
        QCOMPARE(barber.scissors().pictureHandler()->pictureLine().line, (QPolygonF{kFrom, kTo}));
        QCOMPARE(barber.document.undoStack().count(), 0);
        barber.release(kTo);
        QVERIFY(*barber.shown() == *live);
        QVERIFY(barber.scissors().pictureHandler()->pictureLine().line.isEmpty());
        QCOMPARE(barber.document.undoStack().count(), 1);
        QCOMPARE(barber.document.undoStack().undoText(), QStringLiteral("Cut hair"));
        barber.document.undo();
        QVERIFY(*barber.shown() == *barber.before);
        barber.document.redo();
        QVERIFY(*barber.shown() == *live);
    }

    void whatIsCutOffIsGivenOnceAndBeginsAtTheLine()
    {
        Barber barber;
        const std::vector<SeenStrand> crossed = barber.view.crossing(std::array{kFrom, kTo}, false);
        barber.cut(kFrom, kTo);
        const std::vector<CutPiece> pieces = barber.scissors().pictureHandler()->takeCutOff();
        QCOMPARE(pieces.size(), crossed.size());
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            QVERIFY(pieces[i].pointsWo.size() >= 2);
            QVERIFY(glm::distance(pieces[i].pointsWo.front(), crossed[i].positionHd) < 0.002F);
        }
        QVERIFY(barber.scissors().pictureHandler()->takeCutOff().empty());
        QCOMPARE(cutPieces(*barber.view.hair(), glm::quat(1.0F, 0.0F, 0.0F, 0.0F),
                           std::vector<StrandCut>(1000, {.slot = crossed.front().slot, .kept = 0.5F}), 100)
                     .size(),
                 std::size_t{100});
    }

    void escapeLeavesNoTraceAndAClickOrALineBesideHairCutsNothing()
    {
        Barber barber;
        barber.press(kFrom);
        barber.move(kTo);
        ToolContext now = barber.context();
        barber.scissors().cancel(now);
        QVERIFY(!barber.scissors().active());
        QVERIFY(*barber.shown() == *barber.before);
        barber.cut(kFrom, kFrom + QPointF(1.0, 1.0));
        const QPointF beside = SideView::seen({0.0F, 0.0F, -0.1F});
        barber.cut(beside, beside + QPointF(0.0, 50.0));
        QVERIFY(*barber.shown() == *barber.before);
        QCOMPARE(barber.document.undoStack().count(), 0);
    }

    void theFarSideIsCutThroughTheHeadOrMirrored_data()
    {
        QTest::addColumn<bool>("through");
        QTest::addColumn<bool>("mirror");
        QTest::newRow("this side alone") << false << false;
        QTest::newRow("through the head") << true << false;
        QTest::newRow("mirrored") << false << true;
    }
    void theFarSideIsCutThroughTheHeadOrMirrored()
    {
        QFETCH(bool, through);
        QFETCH(bool, mirror);
        Barber barber;
        barber.settings.cutThrough = through;
        barber.mirror = mirror;
        barber.cut(kFrom, kTo);
        int near = 0;
        int far = 0;
        int mirrored = 0;
        for (const SeenStrand& strand : barber.view.crossing(std::array{kFrom, kTo}, true)) {
            const bool isFar = barber.groom().roots->positionHd[strand.slot].x < 0.0F;
            const float kept = barber.kept(strand.slot);
            const float errorM = std::abs(kept - strand.fraction) * 0.12F;
            if (isFar && mirror) {
                // Mirrored roots are not quite opposite.
                far += errorM < 0.003F ? 1 : 0;
                ++mirrored;
            } else if (isFar && !through) {
                QCOMPARE(kept, 1.0F);
            } else {
                QVERIFY(errorM < 0.0005F);
                ++(isFar ? far : near);
            }
        }
        QVERIFY2(far >= mirrored * 9 / 10, qPrintable(QStringLiteral("%1 of %2").arg(far).arg(mirrored)));
        QVERIFY(near > 100);
        QCOMPARE(far > 100, through || mirror);
    }

    void thinningTakesItsFractionAndTheSameHairsEachTime()
    {
        Barber barber(1024);
        barber.settings.cutFraction = 0.4F;
        const std::vector<SeenStrand> crossed = barber.view.crossing(std::array{kFrom, kTo}, false);
        const auto taken = [&] {
            Slots slots;
            for (const SeenStrand& strand : crossed)
                if (barber.kept(strand.slot) < 1.0F)
                    slots.insert(strand.slot);
            return slots;
        };
        barber.cut(kFrom, kTo);
        const Slots first = taken();
        const double fraction = static_cast<double>(first.size()) / static_cast<double>(crossed.size());
        QVERIFY2(std::abs(fraction - 0.4) < 0.06, qPrintable(QString::number(fraction)));
        barber.document.undo();
        barber.cut(kFrom, kTo);
        QVERIFY(taken() == first);
    }

    void raggedEndsLieOnBothSidesOfTheLine()
    {
        constexpr float kRaggedM = 0.01F;
        Barber barber;
        barber.settings.cutRaggedM = kRaggedM;
        const std::vector<SeenStrand> crossed = barber.view.crossing(std::array{kFrom, kTo}, false);
        barber.cut(kFrom, kTo);
        int longer = 0;
        int shorter = 0;
        for (const SeenStrand& strand : crossed) {
            const float offM = (barber.kept(strand.slot) - strand.fraction) * strand.lengthM;
            QVERIFY(std::abs(offM) < kRaggedM + 0.0005F);
            ++(offM > 0.0F ? longer : shorter);
        }
        QVERIFY(longer > shorter / 2 && shorter > longer / 2);
    }

    void whatIsInsideALassoFalls()
    {
        Barber barber;
        barber.settings.cut = CutKind::Lasso;
        const QPointF across = SideView::seen({0.0F, 0.09F, 0.3F});
        const QPointF below = SideView::seen({0.0F, -0.02F, 0.3F});
        barber.press(kFrom);
        for (const QPointF at : {across, below, kTo})
            barber.move(at);
        QVERIFY(barber.scissors().pictureHandler()->pictureLine().closed);
        barber.release(kTo);
        const std::vector<SeenStrand> inside = barber.view.inside({kFrom, across, below, kTo}, false);
        QVERIFY(inside.size() > 100);
        const Slots cut = slotsOf(inside);
        for (const SeenStrand& strand : inside)
            QVERIFY(std::abs(barber.kept(strand.slot) - strand.fraction) * 0.12F < 0.0005F);
        for (const std::uint32_t slot : barber.positioned())
            if (!cut.contains(slot))
                QCOMPARE(barber.kept(slot), 1.0F);
    }

    void aLineIsDrawnFreelyOrStraightOrAtFortyFiveDegrees()
    {
        Barber barber;
        barber.press({0.0, 0.0});
        barber.move({40.0, 100.0});
        barber.move({100.0, 7.0}, Qt::ShiftModifier);
        QPolygonF line = barber.scissors().pictureHandler()->pictureLine().line;
        QVERIFY(line.size() == 2 && line.back() == QPointF(100.0, 0.0));
        barber.move({100.0, 80.0}, Qt::ShiftModifier);
        line = barber.scissors().pictureHandler()->pictureLine().line;
        QVERIFY(std::abs(line.back().x() - 90.0) < 1e-6 && std::abs(line.back().y() - 90.0) < 1e-6);
        barber.release({100.0, 7.0});
        barber.settings.cut = CutKind::Freehand;
        barber.press({0.0, 0.0});
        for (const QPointF at : {QPointF(40.0, 100.0), QPointF(100.0, 7.0)})
            barber.move(at);
        QCOMPARE(barber.scissors().pictureHandler()->pictureLine().line,
                 (QPolygonF{QPointF(0.0, 0.0), QPointF(40.0, 100.0), QPointF(100.0, 7.0)}));
        ToolContext now = barber.context();
        barber.scissors().cancel(now);
    }

    void hairThatIsShorterAlreadyThanItIsSeenIsCutAtTheSamePoint()
    {
        Barber barber;
        const QPointF higher = QPointF(-20.0, 0.0);
        const std::vector<SeenStrand> crossed = barber.view.crossing(std::array{kFrom, kTo}, false);
        // The picture still shows hair that has not been cut.
        barber.cut(kFrom + higher, kTo + higher);
        barber.cut(kFrom, kTo);
        for (const SeenStrand& strand : crossed)
            QVERIFY(std::abs(barber.kept(strand.slot) - strand.fraction) * 0.12F < 0.0005F);
        const auto twice = barber.shown();
        barber.cut(kFrom + higher, kTo + higher);
        QVERIFY(*barber.shown() == *twice);
        QCOMPARE(barber.document.undoStack().count(), 2);
    }

    void withoutAPictureOrWithALockedLayerNothingIsCut()
    {
        Barber barber;
        ToolContext blind = barber.Studio::context();
        barber.scissors().pictureHandler()->pressPicture({.position = kFrom}, blind);
        QVERIFY(!barber.scissors().active());
        const LayerAddress at = barber.context().target;
        LayerProperties locked = propertiesOf(*barber.document.project().layer(at.group, at.map, at.layer));
        locked.locked = true;
        barber.document.push(setLayerPropertiesCommand(barber.document, at, locked, QStringLiteral("lock")));
        barber.press(kFrom);
        QVERIFY(!barber.scissors().active());
    }
};

HAIRPAINT_TEST(TestScissors, Gui)
#include "test_scissors.moc"
