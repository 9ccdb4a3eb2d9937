// Hair held as it lies: from drawn strands to the direction map and the gel map.
#include "model/document/paint_command.h"
#include "model/tools/combing/hold.h"
#include "model/tools/live_edit.h"
#include "sim/groom/direction_texel.h"
#include "sim/motion/simulation.h"
#include "tests/model/tool_studio.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

/// A patch full of hair of 15 cm.
Project hairyPatch()
{
    Project project = filledPatch(MapKind::Density, 65535);
    project.maxHairs = 4000;
    return project;
}

/// Its hair, where every strand goes straight along `directionWo`.
std::shared_ptr<const sim::StrandFrame> leaning(const Document& document, glm::vec3 directionHd,
                                                const sim::HeadPose& pose = {})
{
    sim::Simulation simulation;
    simulation.setInput(document.groomInput());
    simulation.advance(1.0 / 60.0);
    auto frame = std::make_shared<sim::StrandFrame>();
    simulation.writeFrame(*frame);
    frame->pose = pose;
    for (sim::GroupFrame& group : frame->groups) {
        const sim::Groom& groom = *group.groom;
        for (std::size_t slot = 0; slot < groom.roots->count(); ++slot) {
            if (!groom.isDrawn(slot))
                continue;
            for (int i = 0; i < groom.nodes; ++i) {
                const glm::vec3 nodeHd =
                    groom.roots->positionHd[slot] +
                    directionHd * (0.15F * static_cast<float>(i) / static_cast<float>(groom.nodes - 1));
                groom.blocks().setNode(group.positions, groom.frameStrand(slot), static_cast<std::size_t>(i),
                                       pose.rotation * nodeHd + pose.positionWo);
            }
        }
    }
    return frame;
}

const glm::vec2 kEast(0.8F, 0.0F);

glm::vec2 directionAt(const Document& document, float u, float v)
{
    return sim::directionOf(
        document.resolved(document.project().groups.front().id, MapKind::Direction)->sampleNearest({u, v}));
}

float gelAt(const Document& document, float u, float v)
{
    return document.resolved(document.project().groups.front().id, MapKind::Gel)->sampleScalar({u, v});
}

HoldRequest requestOf(const Document& document, const Selection& selection)
{
    const auto target = [&](MapKind map) {
        const LayerAddress at = firstLayer(document, map);
        const Layer& layer = *document.project().layer(at.group, at.map, at.layer);
        return HoldRequest::Target{
            .address = at, .layer = layer.raster, .clips = selectedTexels(selection, layer.raster.size())};
    };
    return {.direction = target(MapKind::Direction),
            .gel = target(MapKind::Gel),
            .shownGel = document.resolved(document.project().groups.front().id, MapKind::Gel),
            .leastGel = 0.5F};
}

} // namespace

class TestHold : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theFieldIsWhatHairsNearSay()
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<float> coordinate(0.2F, 0.8F);
        std::vector<LyingHair> hairs;
        for (int i = 0; i < 3000; ++i) {
            const glm::vec2 uv(coordinate(random), coordinate(random));
            // Lies to the left in one half and stands to the right in the other.
            hairs.push_back({.uv = uv, .direction = uv.x < 0.5F ? glm::vec2(-0.9F, 0.0F) : glm::vec2(0.3F, 0.0F)});
        }
        const LyingField field(hairs);
        for (int i = 0; i < 500; ++i) {
            const glm::vec2 uv(coordinate(random), coordinate(random));
            const std::optional<glm::vec2> direction = field.at(uv);
            QVERIFY(direction.has_value());
            if (std::abs(uv.x - 0.5F) > 0.05F)
                QVERIFY(glm::distance(*direction, uv.x < 0.5F ? glm::vec2(-0.9F, 0.0F) : glm::vec2(0.3F, 0.0F)) <
                        0.05F);
        }
        QVERIFY(!field.at({0.02F, 0.5F}));
        QVERIFY(!field.at({0.5F, 0.98F}));
        QVERIFY(!LyingField({}).at({0.5F, 0.5F}));
    }

    void turningHairIsAsFlatAsItIs()
    {
        std::vector<LyingHair> hairs;
        for (int i = 0; i < 4000; ++i)
            hairs.push_back(
                {.uv = {0.5F, 0.5F}, .direction = i % 2 == 0 ? glm::vec2(0.9F, 0.0F) : glm::vec2(0.0F, 0.9F)});
        const std::optional<glm::vec2> direction = LyingField(hairs).at({0.5F, 0.5F});
        QVERIFY(direction && std::abs(glm::length(*direction) - 0.9F) < 0.01F);
        QVERIFY(std::abs(direction->x - direction->y) < 0.01F);
    }

    void strandsTellHowTheyLieHoweverTheHeadStands_data()
    {
        QTest::addColumn<float>("turned");
        QTest::newRow("upright") << 0.0F;
        QTest::newRow("turned") << 0.8F;
    }
    void strandsTellHowTheyLieHoweverTheHeadStands()
    {
        QFETCH(float, turned);
        const Document document(hairyPatch());
        const sim::HeadPose pose{.rotation = glm::angleAxis(turned, glm::vec3(0.0F, 1.0F, 0.0F)),
                                 .positionWo = {0.01F, 0.02F, 0.03F}};
        const auto frame = leaning(document, {0.8F, 0.0F, 0.6F}, pose);
        const std::vector<LyingHair> hairs = lyingHairs(frame->groups.front(), pose);
        QVERIFY(hairs.size() > 500);
        QCOMPARE(hairs.size(), frame->groups.front().groom->drawnCount);
        for (const LyingHair& hair : hairs)
            QVERIFY(glm::distance(hair.direction, kEast) < 0.01F);
        QVERIFY(lyingHairs({}, {}).empty());
    }

    void heldHairIsPaintedEverywhereWithAtLeastThatGel()
    {
        Document document(hairyPatch());
        const LayerAddress gel = firstLayer(document, MapKind::Gel);
        sim::TiledRaster strong = document.project().layer(gel.group, gel.map, gel.layer)->raster;
        strong.setUniform(0, {60000, 65535, 0, 0});
        document.push(paintCommand(document, gel, {{0, strong.tile(0)}}, QStringLiteral("gel")));
        const auto frame = leaning(document, {0.8F, 0.0F, 0.6F});
        const std::vector<LyingHair> hairs = lyingHairs(frame->groups.front(), frame->pose);
        const auto edits = holdHair(LyingField(hairs), requestOf(document, Selection()));
        QVERIFY(edits.has_value());
        document.push(paintCommand(document, *edits, holdStepText()));
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Hold as it lies"));
        for (float v = 0.02F; v < 1.0F; v += 0.06F)
            for (float u = 0.02F; u < 1.0F; u += 0.06F) {
                QVERIFY(glm::distance(directionAt(document, u, v), kEast) < 0.01F);
                const float wanted = u < 0.24F && v > 0.76F ? 60000.0F / 65535.0F : 0.5F; // Tile 0: the upper left.
                if (std::abs(u - 0.25F) > 0.01F && std::abs(v - 0.75F) > 0.01F)
                    QVERIFY(std::abs(gelAt(document, u, v) - wanted) < 0.01F || (u > 0.24F && u < 0.26F));
            }
        document.undo();
        QCOMPARE(directionAt(document, 0.5F, 0.5F), glm::vec2(0.0F));
        QCOMPARE(gelAt(document, 0.5F, 0.5F), 0.0F);
        QVERIFY(gelAt(document, 0.1F, 0.9F) > 0.9F);
    }

    void theSelectionBoundsItAndItCanBeStopped()
    {
        Document document(hairyPatch());
        const auto frame = leaning(document, {0.8F, 0.0F, 0.6F});
        const LyingField field(lyingHairs(frame->groups.front(), frame->pose));
        Selection selection;
        selection.setRectangle(QRectF(0.0, 0.0, 0.55, 1.0));
        const HoldRequest request = requestOf(document, selection);
        QVERIFY(!holdHair(field, request, [](double) { return false; }));
        document.push(paintCommand(document, holdHair(field, request).value(), holdStepText()));
        QVERIFY(glm::distance(directionAt(document, 0.5F, 0.5F), kEast) < 0.01F);
        QVERIFY(gelAt(document, 0.5F, 0.5F) > 0.49F);
        QCOMPARE(directionAt(document, 0.6F, 0.5F), glm::vec2(0.0F));
        QCOMPARE(gelAt(document, 0.6F, 0.5F), 0.0F);
    }

    void theBrushHoldsWhatLiesUnderIt()
    {
        Studio studio(hairyPatch());
        studio.map = MapKind::Direction;
        studio.settings.comb = CombKind::Hold;
        studio.settings.hardness = 1.0F;
        studio.settings.brushSizeM = 0.04F;
        const auto frame = leaning(studio.document, {0.8F, 0.0F, 0.6F});
        const QString comb = QStringLiteral("comb");
        Tool& tool = studio.tool(comb);
        const auto send = [&](void (Tool::*event)(const ToolEvent&, ToolContext&), float u) {
            ToolContext context = studio.context();
            context.hair = frame;
            (tool.*event)(paintEvent(studio.document, u, 0.5F), context);
        };
        studio.press(comb, 0.3F, 0.5F); // Without hair there is nothing to hold.
        QVERIFY(!tool.active());
        send(&Tool::press, 0.3F);
        send(&Tool::move, 0.5F);
        QVERIFY(tool.active());
        QVERIFY(glm::distance(directionAt(studio.document, 0.4F, 0.5F), kEast) < 0.01F);
        QVERIFY(gelAt(studio.document, 0.4F, 0.5F) > 0.49F);
        QCOMPARE(studio.document.undoStack().count(), 0);
        send(&Tool::release, 0.5F);
        QCOMPARE(studio.document.undoStack().count(), 1);
        QCOMPARE(studio.document.undoStack().undoText(), QStringLiteral("Hold as it lies"));
        for (const float beside : {0.15F, 0.65F, 0.9F}) {
            QCOMPARE(directionAt(studio.document, beside, 0.5F), glm::vec2(0.0F));
            QCOMPARE(gelAt(studio.document, beside, 0.5F), 0.0F);
        }
        studio.document.undo();
        QCOMPARE(directionAt(studio.document, 0.4F, 0.5F), glm::vec2(0.0F));
        QCOMPARE(gelAt(studio.document, 0.4F, 0.5F), 0.0F);
        send(&Tool::press, 0.3F);
        ToolContext context = studio.context();
        tool.cancel(context);
        QCOMPARE(studio.document.undoStack().count(), 1); // The one undone.
        QCOMPARE(gelAt(studio.document, 0.3F, 0.5F), 0.0F);
    }
};

HAIRPAINT_TEST(TestHold, Gui)
#include "test_hold.moc"
