// Long hair that is pulled by its tips: where it hangs once it has been let go.
#include "model/tools/guide_strands.h"
#include "sim/motion/simulation.h"
#include "tests/model/side_view.h"
#include "tests/model/tool_studio.h"
#include "tests/model/worn_style.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>

using namespace hairpaint;
using namespace hairpaint::test;

class TestGrabbedTips : public QObject
{
    Q_OBJECT
private:
    /// Around a root, of the first group; the head stands where it is.
    static glm::vec3 meanTipHd(const sim::GroupFrame& hair, glm::vec3 rootHd, float withinM)
    {
        glm::vec3 sum(0.0F);
        float count = 0.0F;
        for (std::uint32_t slot = 0; slot < hair.groom->roots->count(); ++slot)
            if (hair.isPositioned(slot) && glm::distance(hair.groom->roots->positionHd[slot], rootHd) < withinM) {
                sum += hair.groom->blocks().node(hair.positions, hair.groom->frameStrand(slot),
                                                 static_cast<std::size_t>(hair.groom->nodes - 1));
                count += 1.0F;
            }
        return sum / std::max(count, 1.0F);
    }

private Q_SLOTS:
    void theLockGoesWhereItsTipIsPulled_data()
    {
        QTest::addColumn<float>("up");
        QTest::addColumn<float>("forward");
        QTest::addColumn<float>("gel");
        for (float g : {0.0F,0.15F,0.3F}) {
        QTest::addRow("forward %g", double(g)) << 0.0F << 0.08F << g;
        QTest::addRow("back %g", double(g)) << 0.0F << -0.08F << g;
        QTest::addRow("forward and up %g", double(g)) << 0.15F << 0.08F << g;}
    }
    void theLockGoesWhereItsTipIsPulled()
    {
        QFETCH(float, up);
        QFETCH(float, forward);
        QFETCH(float, gel);
        Studio studio(wearing(QStringLiteral("Long straight"), 6000));
        studio.map = MapKind::Direction;
        studio.settings.brushSizeM = 0.04F;
        studio.settings.grabGel = gel;
        LiveHair live;
        const auto before = live.settled(studio.document.groomInput());
        // Above the left ear.
        const sim::SurfacePoint root = studio.document.project().head->skin->nearest(glm::vec3(0.07F, 0.06F, 0.0F));
        const glm::vec3 tipHd = meanTipHd(before->groups.front(), root.positionHd, 0.012F);
        const float alongM = 0.9F * glm::distance(tipHd, root.positionHd);
        QVERIFY(alongM > 0.15F);
        ToolContext context = studio.context();
        context.hair = before;
        const sim::GroupFrame& hair = before->groups.front();
        const sim::RootSet& roots = *hair.groom->roots;
        std::uint32_t slot = 0;
        for (std::uint32_t other = 0; other < roots.count(); ++other)
            if (hair.isPositioned(other) && glm::distance(roots.positionHd[other], root.positionHd) <
                                                glm::distance(roots.positionHd[slot], root.positionHd))
                slot = other;
        HairEvent event{
            .hair = {.root = roots.skin->nearest(roots.positionHd[slot]), .positionHd = tipHd, .alongM = alongM},
            .targetHd = tipHd};
        HairHandler& grab = *studio.tool(ToolId::Grab).hairHandler();
        const glm::vec3 pull(0.0F, up, forward);
        grab.pressHair(event, context);
        event.targetHd = tipHd + pull;
        grab.moveHair(event, context);
        const std::vector<GuideStrand> shown = studio.tool(ToolId::Grab).guides();
        QCOMPARE(shown.size(), std::size_t{1});
        grab.releaseHair(event, context);
        QCOMPARE(studio.document.undoStack().count(), 1);
        const auto after = live.settled(studio.document.groomInput());
        const glm::vec3 wentHd = meanTipHd(after->groups.front(), root.positionHd, 0.012F) - tipHd;
        const float part = glm::dot(wentHd, pull) / glm::dot(pull, pull);
        qInfo("%s", qPrintable(QStringLiteral("%1 %2 %3 cm, %4").arg(wentHd.x*100).arg(wentHd.y*100).arg(wentHd.z*100).arg(part)));
        QVERIFY2(part > 0.5F, qPrintable(QStringLiteral("%1 %2 %3 cm, %4 of it")
                                             .arg(wentHd.x * 100.0F)
                                             .arg(wentHd.y * 100.0F)
                                             .arg(wentHd.z * 100.0F)
                                             .arg(part)));
        studio.document.undo();
        const auto undone = live.settled(studio.document.groomInput());
        QVERIFY(glm::distance(meanTipHd(undone->groups.front(), root.positionHd, 0.012F), tipHd) < 0.03F);
    }
};

HAIRPAINT_TEST(TestGrabbedTips, Gui)
#include "test_grabbed_tips.moc"
