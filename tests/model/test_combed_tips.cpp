// The comb over hair that hangs, far from where it grows.
#include "tests/model/side_view.h"
#include "tests/model/tool_studio.h"
#include "tests/model/worn_style.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

constexpr int kSomeHairs = 6000;

/// A style that has settled, seen from the side, and the comb.
struct Comber : Studio
{
    explicit Comber(const QString& style)
        : Studio(wearing(style, kSomeHairs)), before(live.settled(document.groomInput(), 5.0)), view(before)
    {
        map = MapKind::Direction;
        settings.brushSizeM = 0.03F;
    }
    void stroke(glm::vec3 fromHd, glm::vec3 toHd)
    {
        constexpr int kMoves = 8;
        ToolContext now = context();
        now.seen = &view;
        auto moving = std::make_shared<sim::StrandFrame>(*before);
        moving->asleep = false; // As if the wind blew.
        now.hair = std::move(moving);
        const auto event = [&](int move) {
            const glm::vec3 atHd = glm::mix(fromHd, toHd, static_cast<float>(move) / kMoves);
            ToolEvent made{.area = Area::Head};
            made.hair = OverHair{
                .position = SideView::seen(atHd), .pxPerM = static_cast<float>(SideView::kPxPerM), .positionHd = atHd};
            return made;
        };
        Tool& comb = tool(ToolId::Comb);
        comb.press(event(0), now);
        for (int move = 1; move <= kMoves; ++move)
            comb.move(event(move), now);
        comb.release(event(kMoves), now);
    }

    LiveHair live;
    std::shared_ptr<const sim::StrandFrame> before;
    SideView view;
};

} // namespace

class TestCombedTips : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void tipsThatAreCombedToOnePointDoNotFly()
    {
        Comber comber(QStringLiteral("Long straight"));
        const glm::vec3 pointHd(0.08F, -0.12F, 0.02F);
        for (const glm::vec2 offset :
             {glm::vec2(0.03F, 0.06F), glm::vec2(0.03F, -0.06F), glm::vec2(-0.05F, 0.04F), glm::vec2(-0.05F, -0.04F)})
            comber.stroke(pointHd + glm::vec3(0.0F, offset), pointHd);
        QCOMPARE(comber.document.undoStack().count(), 4);
        const auto after = comber.live.settled(comber.document.groomInput(), 8.0);
        const sim::GroupFrame& was = comber.before->groups.front();
        const sim::GroupFrame& is = after->groups.front();
        std::vector<float> risenM;
        for (std::uint32_t slot = 0; slot < was.groom->roots->count(); ++slot) {
            if (!was.isPositioned(slot))
                continue;
            const glm::vec3 wasHd = drawnPoints(was, slot).back();
            const glm::vec3 isHd = drawnPoints(is, slot).back();
            if (glm::distance(wasHd, isHd) > 1e-4F)
                risenM.push_back(isHd.y - wasHd.y);
        }
        QVERIFY2(risenM.size() > 200, qPrintable(QString::number(risenM.size())));
        std::ranges::sort(risenM);
        const float mostM = risenM[risenM.size() * 98 / 100];
        QVERIFY2(mostM < 0.12F, qPrintable(QString::number(static_cast<double>(mostM))));
    }
};

HAIRPAINT_TEST(TestCombedTips, Gui)
#include "test_combed_tips.moc"
