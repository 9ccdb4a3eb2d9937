// Strokes of tip colour over hair: strands are dyed from where they are touched to their tips.
#include "model/document/layer_commands.h"
#include "sim/groom/strand_look.h"
#include "tests/model/side_view.h"
#include "tests/model/tool_studio.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

/// A patch of 20 cm, covered with hair of 12 cm that stands out toward +z, seen from its side.
Project standingHair(float tipFrom)
{
    Project project = patchProject(512);
    project.maxHairs = 2000;
    HairGroup& group = project.groups.front();
    group.settings.greatestLengthM = 0.15F;
    group.settings.material.tipFrom = tipFrom;
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

struct Colourist : Studio
{
    explicit Colourist(float tipFrom = 0.0F)
        : Studio(standingHair(tipFrom)), view(live.settled(document.groomInput(), 0.5))
    {
        map = MapKind::TipColour;
        settings.brushSizeM = 0.02F;
        settings.hardness = 1.0F;
        settings.value(MapKind::TipColour).colour = QColor(255, 255, 0);
    }
    ToolContext context()
    {
        ToolContext now = Studio::context();
        now.seen = &view;
        now.mirror = mirror;
        return now;
    }
    [[nodiscard]] ToolEvent event(glm::vec3 positionHd)
    {
        return {.area = Area::Head,
                .hair = OverHair{.position = SideView::seen(positionHd),
                                 .pxPerM = static_cast<float>(SideView::kPxPerM),
                                 .positionHd = positionHd}};
    }
    void touch(std::initializer_list<glm::vec3> wayHd, ToolId id = ToolId::Brush, bool lets = true)
    {
        bool isFirst = true;
        for (const glm::vec3& positionHd : wayHd) {
            ToolContext now = context();
            isFirst ? tool(id).press(event(positionHd), now) : tool(id).move(event(positionHd), now);
            isFirst = false;
        }
        if (lets)
            letGo(*(wayHd.end() - 1), id);
    }
    void letGo(glm::vec3 positionHd, ToolId id = ToolId::Brush)
    {
        ToolContext now = context();
        tool(id).release(event(positionHd), now);
    }
    [[nodiscard]] std::shared_ptr<const sim::TiledRaster> shownMap(MapKind kind)
    {
        return document.resolvedNow(context().target.group, kind);
    }
    [[nodiscard]] std::vector<SeenStrand> under(glm::vec3 positionHd)
    {
        std::vector<SeenStrand> strands =
            view.passed(SideView::seen(positionHd), SideView::seen(positionHd), 0.01 * SideView::kPxPerM);
        std::erase_if(strands, [](const SeenStrand& one) { return one.apart > 0.6F; }); // At the rim colour is faint.
        return strands;
    }
    [[nodiscard]] sim::Texel tipOf(const SeenStrand& strand)
    {
        return shownMap(MapKind::TipColour)->sampleNearest(strand.rootUv);
    }
    [[nodiscard]] float startOf(const SeenStrand& strand)
    {
        return shownMap(MapKind::TipStart)->sampleScalar(strand.rootUv);
    }

    LiveHair live;
    SideView view;
};

const sim::Texel kYellow{65535, 65535, 0};
constexpr glm::vec3 kNear(0.0F, 0.03F, 0.05F); ///< 5 of 12 cm from the skin,
constexpr glm::vec3 kFar(0.0F, 0.03F, 0.09F);  ///< and 9.

} // namespace

class TestBalayage : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void strandsAreDyedFromWhereTheyAreTouched_data()
    {
        QTest::addColumn<float>("tipFrom");
        QTest::newRow("tips from the root on") << 0.0F;
        QTest::newRow("tips from a quarter on") << 0.25F;
    }
    void strandsAreDyedFromWhereTheyAreTouched()
    {
        QFETCH(float, tipFrom);
        Colourist colourist(tipFrom);
        const sim::StrandMaterial& material = colourist.document.project().groups.front().settings.material;
        const std::vector<SeenStrand> strands = colourist.under(kFar);
        QVERIFY(strands.size() > 50);
        const auto colours = colourist.shownMap(MapKind::Colour);
        colourist.touch({kFar}, ToolId::Brush, false);
        const auto preview = colourist.shownMap(MapKind::TipStart);
        colourist.letGo(kFar);
        QCOMPARE(*colourist.shownMap(MapKind::TipStart), *preview);
        QCOMPARE(colourist.document.undoStack().count(), 1);
        for (const SeenStrand& strand : strands) {
            QCOMPARE(colourist.tipOf(strand), kYellow);
            const sim::TipMix mix = sim::tipMixOf(material, colourist.startOf(strand));
            // No colour above the pointer, all of it at the tip.
            QVERIFY2(mix.at(strand.firstFraction - 0.02F) == 0.0F && mix.at(strand.firstFraction + 0.05F) > 0.0F,
                     qPrintable(QString::number(double(colourist.startOf(strand)))));
            QVERIFY(mix.at(1.0F) > 0.999F);
        }
        QCOMPARE(*colourist.shownMap(MapKind::Colour), *colours);
        const std::vector<SeenStrand> others = colourist.under({0.0F, -0.03F, 0.09F});
        for (const SeenStrand& strand : others) {
            QVERIFY(colourist.tipOf(strand) != kYellow);
            QCOMPARE(colourist.startOf(strand), 0.0F);
        }
    }

    void whatTheStrokeMeetsNearestToTheRootCounts()
    {
        Colourist colourist;
        colourist.touch({kFar, kNear, kFar});
        const std::vector<SeenStrand> strands = colourist.under(kNear);
        QVERIFY(strands.size() > 50);
        for (const SeenStrand& strand : strands)
            QVERIFY(std::abs(colourist.startOf(strand) - strand.firstFraction) < 0.05F);
    }

    void anotherStrokeTakesNoColourAway()
    {
        Colourist colourist;
        colourist.touch({kNear});
        colourist.touch({kFar});
        for (const SeenStrand& strand : colourist.under(kNear))
            QVERIFY(std::abs(colourist.startOf(strand) - strand.firstFraction) < 0.05F);
    }

    void undoGivesTheBytesAndTheEraserHairAsItWas()
    {
        Colourist colourist;
        const auto tips = colourist.shownMap(MapKind::TipColour);
        const auto starts = colourist.shownMap(MapKind::TipStart);
        colourist.touch({kFar, kNear});
        QVERIFY(*colourist.shownMap(MapKind::TipColour) != *tips && *colourist.shownMap(MapKind::TipStart) != *starts);
        colourist.settings.brushSizeM = 0.03F;
        colourist.touch({kFar, kNear}, ToolId::Eraser);
        for (const SeenStrand& strand : colourist.under(kNear)) {
            QCOMPARE(colourist.tipOf(strand), tips->sampleNearest(strand.rootUv));
            QCOMPARE(colourist.startOf(strand), 0.0F);
        }
        colourist.document.undo();
        QVERIFY(*colourist.shownMap(MapKind::TipColour) != *tips);
        colourist.document.undo();
        QCOMPARE(*colourist.shownMap(MapKind::TipColour), *tips);
        QCOMPARE(*colourist.shownMap(MapKind::TipStart), *starts);
    }

    void theOtherSideIsMirrored()
    {
        Colourist colourist;
        colourist.mirror = true;
        colourist.touch({kFar});
        std::size_t mirrored = 0;
        for (const SeenStrand& strand : colourist.under(kFar)) {
            const glm::vec2 other(1.0F - strand.rootUv.x, strand.rootUv.y);
            QCOMPARE(colourist.shownMap(MapKind::TipColour)->sampleNearest(other), kYellow);
            mirrored += colourist.shownMap(MapKind::TipStart)->sampleScalar(other) > 0.5F ? 1 : 0;
        }
        QVERIFY(mirrored > 50);
    }

    void onTheSkinAndOnOtherMapsNothingBeginsElsewhere()
    {
        Colourist colourist;
        const auto starts = colourist.shownMap(MapKind::TipStart);
        colourist.press(kBrush, 0.5F, 0.5F);
        colourist.release(kBrush, 0.5F, 0.5F);
        colourist.map = MapKind::Colour;
        colourist.touch({kFar});
        QCOMPARE(*colourist.shownMap(MapKind::TipStart), *starts);
        QCOMPARE(colourist.document.undoStack().count(), 2);
    }

    void aLockedMapOfStartsStays()
    {
        Colourist colourist;
        const LayerAddress at = firstLayer(colourist.document, MapKind::TipStart);
        LayerProperties locked = propertiesOf(*colourist.document.project().layer(at.group, at.map, at.layer));
        locked.locked = true;
        colourist.document.push(setLayerPropertiesCommand(colourist.document, at, locked, QStringLiteral("Lock")));
        const auto starts = colourist.shownMap(MapKind::TipStart);
        colourist.touch({kFar});
        QCOMPARE(*colourist.shownMap(MapKind::TipStart), *starts);
        QCOMPARE(colourist.tipOf(colourist.under(kFar).front()), kYellow);
    }
};

HAIRPAINT_TEST(TestBalayage, Gui)
#include "test_balayage.moc"
