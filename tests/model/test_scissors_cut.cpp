// Scissors on styles of the bust: where drawn hair ends once it has fallen anew.
#include "tests/model/side_view.h"
#include "tests/model/tool_studio.h"
#include "tests/model/worn_style.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>
#include <set>

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

constexpr int kSomeHairs = 6000;

} // namespace

class TestScissorsCut : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// Hair falls anew once it is shorter: coils spring up, and what lay over other hair lies a little otherwise.
    void aStraightCutIsStraight_data()
    {
        QTest::addColumn<QString>("style");
        QTest::addColumn<float>("levelM");
        QTest::addColumn<double>("mostEndsM"); ///< The distance from their median that most ends stay within.
        QTest::newRow("straight") << QStringLiteral("Long straight") << -0.09F << 0.005;
        QTest::newRow("waved") << QStringLiteral("Bob") << -0.02F << 0.005;
        QTest::newRow("ringlets") << QStringLiteral("Ringlets") << -0.05F << 0.008;
        QTest::newRow("coils") << QStringLiteral("Round afro") << 0.024F << 0.005;
    }
    void aStraightCutIsStraight()
    {
        QFETCH(QString, style);
        QFETCH(float, levelM);
        QFETCH(double, mostEndsM);
        Studio studio(wearing(style, kSomeHairs));
        LiveHair live;
        const auto before = live.settled(studio.document.groomInput());
        const SideView view(before);
        ToolContext context = studio.context();
        context.seen = &view;
        PictureHandler& hand = *studio.tool(ToolId::Scissors).pictureHandler();
        const std::array line{SideView::seen({0.0F, levelM, 0.3F}), SideView::seen({0.0F, levelM, -0.3F})};
        const std::vector<SeenStrand> crossed = view.crossing(line, false);
        QVERIFY2(crossed.size() > 15, qPrintable(QString::number(crossed.size())));
        hand.pressPicture({.position = line.front()}, context);
        hand.movePicture({.position = line.back()}, context);
        hand.releasePicture({.position = line.back()}, context);

        const auto after = live.settled(studio.document.groomInput());
        const sim::GroupFrame& was = before->groups.front();
        const sim::GroupFrame& is = after->groups.front();
        double worstM = 0.0;
        std::vector<double> endsM;
        std::set<std::uint32_t> cut;
        for (const SeenStrand& strand : crossed) {
            cut.insert(strand.slot);
            // As it lay when it was cut, it ends on the line.
            const std::vector<glm::vec3> points = drawnPoints(was, strand.slot);
            const float end = is.groom->style(strand.slot).lengthM / was.groom->style(strand.slot).lengthM *
                              static_cast<float>(points.size() - 1);
            const std::size_t segment = std::min(static_cast<std::size_t>(end), points.size() - 2);
            const glm::vec3 endHd = glm::mix(points[segment], points[segment + 1], end - static_cast<float>(segment));
            worstM = std::max(worstM, static_cast<double>(std::abs(endHd.y - levelM)));
            endsM.push_back(static_cast<double>(drawnPoints(is, strand.slot).back().y));
        }
        QVERIFY2(worstM < 0.0002, qPrintable(QString::number(worstM)));
        std::ranges::sort(endsM);
        const double medianM = endsM[endsM.size() / 2];
        QVERIFY2(std::abs(medianM - static_cast<double>(levelM)) < 0.004, qPrintable(QString::number(medianM)));
        const auto near =
            std::ranges::count_if(endsM, [&](double endM) { return std::abs(endM - medianM) < mostEndsM; });
        QVERIFY2(static_cast<double>(near) > 0.88 * static_cast<double>(endsM.size()),
                 qPrintable(QStringLiteral("%1 of %2").arg(near).arg(endsM.size())));
        for (std::uint32_t slot = 0; slot < was.groom->roots->count(); ++slot)
            if (was.isPositioned(slot) && !cut.contains(slot))
                QVERIFY(isSame(was.groom->style(slot), is.groom->style(slot)));
    }
};

HAIRPAINT_TEST(TestScissorsCut, Gui)
#include "test_scissors_cut.moc"
