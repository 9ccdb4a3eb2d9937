// Held hair stays where it lies.
#include "model/document/paint_command.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/styles/preset.h"
#include "model/tools/combing/hold.h"
#include "model/tools/live_edit.h"
#include "sim/groom/direction_texel.h"
#include "sim/motion/simulation.h"
#include "tests/model/fixtures.h"
#include "tests/model/side_view.h"
#include "tests/model/tool_studio.h"
#include "tests/model/worn_style.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

constexpr int kHeldHairs = 20000;

sim::StrandFrame stillFrame(sim::Simulation& simulation, double seconds)
{
    simulation.setWind({});
    constexpr double kFrameS = 1.0 / 30.0;
    for (int frames = static_cast<int>(std::ceil(seconds / kFrameS)); frames > 0; --frames)
        simulation.advance(kFrameS);
    sim::StrandFrame frame;
    simulation.writeFrame(frame);
    return frame;
}

glm::vec3 nodeOf(const sim::GroupFrame& frame, std::size_t slot, std::size_t node)
{
    return frame.groom->blocks().node(frame.positions, frame.groom->frameStrand(slot), node);
}

} // namespace

class TestHeldTips : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void hairAtRestStays_data()
    {
        QTest::addColumn<QString>("style");
        for (const char* style : {"Quiff", "Side part", "Bob", "Ringlets", "Long straight"})
            QTest::newRow(style) << QString::fromLatin1(style);
    }
    void hairAtRestStays()
    {
        QFETCH(QString, style);
        Document document(wearing(style, kHeldHairs));
        QCOMPARE(document.project().groups.front().map(MapKind::Length).layers.front().name, style);
        const Id group = document.project().groups.front().id;
        sim::Simulation simulation;
        simulation.setInput(document.groomInput());
        sim::StrandFrame before = stillFrame(simulation, 6.0);
        for (int more = 0; more < 10 && !before.asleep; ++more)
            before = stillFrame(simulation, 6.0);
        QVERIFY(before.asleep);
        const auto target = [&](MapKind map) {
            const LayerAddress at = firstLayer(document, map);
            const Layer& layer = *document.project().layer(at.group, at.map, at.layer);
            return HoldRequest::Target{
                .address = at, .layer = layer.raster, .clips = selectedTexels(Selection(), layer.raster.size())};
        };
        const HoldRequest request{.direction = target(MapKind::Direction),
                                  .gel = target(MapKind::Gel),
                                  .shownGel = document.resolvedNow(group, MapKind::Gel),
                                  .leastGel = 0.5F};
        const LyingField field(lyingHairs(before.groups.front(), before.pose, before.asleep));
        document.push(paintCommand(document, holdHair(field, request).value(), holdStepText()));
        simulation.setInput(document.groomInput());
        const sim::StrandFrame after = stillFrame(simulation, 10.0);
        std::vector<float> movedM;
        const sim::GroupFrame& was = before.groups.front();
        const sim::GroupFrame& is = after.groups.front();
        for (std::size_t slot = 0; slot < was.groom->roots->count(); ++slot) {
            if (!was.groom->isDrawn(slot) || !is.groom->isDrawn(slot))
                continue;
            float furthestM = 0.0F;
            for (std::size_t node = 0; node < static_cast<std::size_t>(was.groom->nodes); ++node)
                furthestM = std::max(furthestM, glm::distance(nodeOf(was, slot, node), nodeOf(is, slot, node)));
            movedM.push_back(furthestM);
        }
        QVERIFY(movedM.size() > 1000);
        std::ranges::sort(movedM);
        const float at = movedM[movedM.size() * 99 / 100];
        QVERIFY2(at < 0.003F, qPrintable(QStringLiteral("%1 mm").arg(at * 1000.0F)));
    }

    void hangingHairIsNotHeldAndLeavesNoStep()
    {
        Studio studio(wearing(QStringLiteral("Long straight"), kHeldHairs));
        studio.map = MapKind::Direction;
        studio.settings.comb = CombKind::Hold;
        const Head& head = *studio.document.project().head;
        sim::Simulation simulation;
        simulation.setInput(studio.document.groomInput());
        const auto frame = std::make_shared<sim::StrandFrame>(stillFrame(simulation, 6.0));
        ToolContext context = studio.context();
        context.hair = frame;
        const sim::SurfacePoint point = head.skin->nearest((*head.landmarks)[sim::HeadLandmark::Crown]);
        const ToolEvent event{.area = Area::Head, .uv = point.uv, .point = point};
        Tool& comb = studio.tool(QStringLiteral("comb"));
        comb.press(event, context);
        comb.release(event, context);
        QCOMPARE(studio.document.undoStack().count(), 0);
    }

    void theBrushHoldsTheStrandsThatItMeets()
    {
        Studio studio(wearing(QStringLiteral("Quiff"), 3000));
        studio.map = MapKind::Direction;
        studio.settings.comb = CombKind::Hold;
        studio.settings.brushSizeM = 0.02F;
        studio.settings.hardness = 1.0F;
        studio.settings.holdGel = 0.9F;
        studio.settings.opacity = 1.0F;
        sim::Simulation simulation;
        simulation.setInput(studio.document.groomInput());
        const auto frame = std::make_shared<sim::StrandFrame>(stillFrame(simulation, 6.0));
        frame->asleep = false; // As if the wind blew.
        const SideView view(frame);
        const sim::GroupFrame& hair = frame->groups.front();
        const sim::RootSet& roots = *hair.groom->roots;
        // A tip as far from its root as any.
        std::uint32_t furthest = 0;
        float furthestM = 0.0F;
        for (std::uint32_t slot = 0; slot < roots.count(); ++slot) {
            if (!hair.isPositioned(slot))
                continue;
            const float apartM = glm::distance(drawnPoints(hair, slot).back(), roots.positionHd[slot]);
            if (apartM > furthestM) {
                furthestM = apartM;
                furthest = slot;
            }
        }
        QVERIFY(furthestM > 0.04F);
        const glm::vec3 tipHd = drawnPoints(hair, furthest).back();
        const QPointF at = SideView::seen(tipHd);
        ToolContext context = studio.context();
        context.hair = frame;
        context.seen = &view;
        const auto before = studio.document.resolvedNow(context.target.group, MapKind::Gel);
        const ToolEvent event{
            .area = Area::Head,
            .hair = OverHair{.position = at, .pxPerM = static_cast<float>(SideView::kPxPerM), .positionHd = tipHd}};
        Tool& comb = studio.tool(ToolId::Comb);
        comb.press(event, context);
        comb.release(event, context);
        QCOMPARE(studio.document.undoStack().count(), 1);
        const auto after = studio.document.resolvedNow(context.target.group, MapKind::Gel);
        const std::vector<SeenStrand> met = view.passed(at, at, 0.5 * 0.02 * SideView::kPxPerM);
        QVERIFY(met.size() > 10);
        // At the hairline, where few roots are, a little less.
        QVERIFY(4 * std::ranges::count_if(met,
                                          [&](const SeenStrand& strand) {
                                              return after->sampleNearest(strand.rootUv)[0] >
                                                     before->sampleNearest(strand.rootUv)[0] + 3000;
                                          }) >
                3 * static_cast<std::ptrdiff_t>(met.size()));
        int untouched = 0;
        for (std::uint32_t slot = 0; slot < roots.count(); ++slot) {
            if (std::ranges::any_of(met, [&](const SeenStrand& strand) {
                    return glm::distance(strand.rootHd, roots.positionHd[slot]) < 0.012F;
                }))
                continue;
            QCOMPARE(after->sampleNearest(roots.uv[slot])[0], before->sampleNearest(roots.uv[slot])[0]);
            ++untouched;
        }
        QVERIFY(untouched > 500);
    }

    void theBrushHoldsWhatLiesOnTheShoulders()
    {
        Studio studio(wearing(QStringLiteral("Long straight"), kHeldHairs));
        studio.map = MapKind::Direction;
        studio.settings.comb = CombKind::Hold;
        studio.settings.brushSizeM = 0.03F;
        const Head& head = *studio.document.project().head;
        sim::Simulation simulation;
        simulation.setInput(studio.document.groomInput());
        const auto frame = std::make_shared<sim::StrandFrame>(stillFrame(simulation, 3.0));
        frame->asleep = false; // As if the wind blew.
        const std::vector<LyingHair> hairs = lyingHairs(frame->groups.front(), frame->pose);
        const std::vector<LyingHair> further = hairsFurtherOn(frame->groups.front(), frame->pose, head.distances.get());
        // Without a grid each node is searched for, and the same are found.
        QCOMPARE(hairsFurtherOn(frame->groups.front(), frame->pose, nullptr).size(), further.size());
        const LyingField roots(hairs);
        const LyingField all(hairs, further);
        const auto there = std::ranges::find_if(further, [&](const LyingHair& hair) {
            return roots.nearness(hair.uv) == 0.0F && all.nearness(hair.uv) == 1.0F && all.at(hair.uv).has_value();
        });
        QVERIFY(there != further.end());
        ToolContext context = studio.context();
        context.hair = frame;
        const ToolEvent event{.area = Area::Head, .uv = there->uv, .point = head.skin->atUv(there->uv)};
        QVERIFY(event.point.has_value());
        Tool& comb = studio.tool(QStringLiteral("comb"));
        comb.press(event, context);
        comb.release(event, context);
        const auto shown = studio.shown();
        const glm::ivec2 at(glm::vec2(there->uv.x, 1.0F - there->uv.y) * static_cast<float>(shown->size()));
        QVERIFY(glm::distance(sim::directionOf(shown->texel(at.x, at.y)), *all.at(there->uv)) < 0.1F);
    }
};

HAIRPAINT_TEST(TestHeldTips, Gui)
#include "test_held_tips.moc"
