// How far the tips of held hair go.
#include "model/document/paint_command.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/styles/preset.h"
#include "model/tools/combing/hold.h"
#include "model/tools/live_edit.h"
#include "sim/groom/direction_texel.h"
#include "sim/motion/simulation.h"
#include "tests/model/fixtures.h"
#include "tests/model/tool_studio.h"
#include "tests/model/worn_style.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <vector>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

constexpr int kHeldHairs = 20000;

sim::StrandFrame stillFrame(sim::Simulation& simulation, double seconds)
{
    simulation.setWind({});
    for (double t = 0.0; t < seconds; t += 1.0 / 30.0)
        simulation.advance(1.0 / 30.0);
    sim::StrandFrame frame;
    simulation.writeFrame(frame);
    return frame;
}

} // namespace

class TestHeldTips : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void tipsStay_data()
    {
        QTest::addColumn<QString>("style");
        QTest::addColumn<double>("part");
        QTest::newRow("short") << QStringLiteral("Quiff") << 0.99;
        QTest::newRow("as far as the chin") << QStringLiteral("Bob") << 0.85;
        // What hangs free beyond where a lay reaches keeps its direction only roughly.
        QTest::newRow("over the shoulders") << QStringLiteral("Long straight") << 0.4;
    }
    void tipsStay()
    {
        QFETCH(QString, style);
        QFETCH(double, part);
        Document document(wearing(style, kHeldHairs));
        QCOMPARE(document.project().groups.front().map(MapKind::Length).layers.front().name, style);
        const Id group = document.project().groups.front().id;
        sim::Simulation simulation;
        simulation.setInput(document.groomInput());
        const sim::StrandFrame before = stillFrame(simulation, 3.0);
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
        const LyingField field(
            lyingHairs(before.groups.front(), before.pose),
            hairsFurtherOn(before.groups.front(), before.pose, document.project().head->distances.get()));
        document.push(paintCommand(document, holdHair(field, request).value(), holdStepText()));
        simulation.setInput(document.groomInput());
        const sim::StrandFrame after = stillFrame(simulation, 10.0);
        std::vector<float> movedM;
        const auto tipOf = [](const sim::GroupFrame& frame, std::size_t slot) {
            const auto last = static_cast<std::size_t>(frame.groom->nodes - 1);
            return frame.groom->blocks().node(frame.positions, frame.groom->frameStrand(slot), last);
        };
        const sim::GroupFrame& was = before.groups.front();
        const sim::GroupFrame& is = after.groups.front();
        for (std::size_t slot = 0; slot < was.groom->roots->count(); ++slot)
            if (was.groom->isDrawn(slot) && is.groom->isDrawn(slot))
                movedM.push_back(glm::distance(tipOf(was, slot), tipOf(is, slot)));
        QVERIFY(movedM.size() > 1000);
        std::ranges::sort(movedM);
        const float at = movedM[static_cast<std::size_t>(part * static_cast<double>(movedM.size() - 1))];
        QVERIFY2(at < 0.03F, qPrintable(QStringLiteral("%1 mm").arg(at * 1000.0F)));
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
