// Which strands of the 3D area's picture a brush, a line and an outline meet, against every strand looked at.
#include "head_fixture.h"
#include "sim/base/parallel.h"
#include "sim/groom/strand_curve.h"
#include "tests/support/test_program.h"
#include "view/head_area/head_camera.h"
#include "view/picking/strand_pick.h"

#include <QLineF>
#include <QTest>

#include <algorithm>
#include <set>

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

/// The ball, with hair of some centimetres all over it that has just begun to fall.
struct HairyPicture : HeadFixture
{
    explicit HairyPicture(std::uint16_t curl = 0)
    {
        fill(model::MapKind::Density, 25000);
        fill(model::MapKind::Length, 15000);
        fill(model::MapKind::Curl, curl);
        picture = std::make_shared<const view::HairPicture>(
            view::PictureSource{.frame = frame(),
                                .group = editor.state.target().group(),
                                .camera = area.camera(),
                                .size = area.size(),
                                .skin = editor.document.project().head->skin});
    }

    [[nodiscard]] std::vector<std::uint32_t> positioned() const
    {
        std::vector<std::uint32_t> slots;
        for (std::uint32_t slot = 0; slot < hair().groom->roots->count(); ++slot)
            if (hair().isPositioned(slot))
                slots.push_back(slot);
        return slots;
    }
    /// `finer` times as many segments as are drawn at least, the same number between all nodes.
    [[nodiscard]] std::vector<glm::vec3> curveWo(std::uint32_t slot, int finer = 1) const
    {
        const sim::Groom& groom = *hair().groom;
        std::vector<glm::vec3> nodes(static_cast<std::size_t>(groom.nodes)), points;
        groom.blocks().read(hair().positions, groom.frameStrand(slot), nodes);
        const int spans = groom.nodes - 1;
        const int drawn = sim::segmentsOf(groom.style(slot), groom.nodes, sim::coilsOf(groom.settings));
        sim::evaluateStrand(nodes, sim::frameTangentHd(groom, slot), groom.style(slot),
                            finer * spans * ((drawn + spans - 1) / spans), points, sim::coilsOf(groom.settings));
        return points;
    }
    [[nodiscard]] std::vector<QPointF> curve(std::uint32_t slot, int finer = 1) const
    {
        std::vector<QPointF> seen;
        for (const glm::vec3& point : curveWo(slot, finer))
            seen.push_back(view::project(area.camera(), point, QSizeF(area.size())).value_or(QPointF(1e6, 1e6)));
        return seen;
    }
    [[nodiscard]] const sim::GroupFrame& hair() const { return *picture->hair(); }

    std::shared_ptr<const view::HairPicture> picture;
};

std::vector<std::uint32_t> slotsOf(const std::vector<model::SeenStrand>& strands)
{
    std::vector<std::uint32_t> slots;
    slots.reserve(strands.size());
    for (const model::SeenStrand& strand : strands)
        slots.push_back(strand.slot);
    return slots;
}

double apart(QPointF point, QPointF from, QPointF to)
{
    const QPointF line = to - from;
    const double square = QPointF::dotProduct(line, line);
    const double along = square > 0.0 ? std::clamp(QPointF::dotProduct(point - from, line) / square, 0.0, 1.0) : 0.0;
    return QLineF(from + line * along, point).length();
}

const std::array kLine{QPointF(120.0, 150.0), QPointF(250.0, 190.0), QPointF(380.0, 150.0)};

} // namespace

class TestStrandPick : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aLineMeetsWhatItCrosses_data()
    {
        QTest::addColumn<int>("curl");
        QTest::newRow("straight") << 0;
        QTest::newRow("curled") << 30000;
    }

    void aLineMeetsWhatItCrosses()
    {
        QFETCH(int, curl);
        const HairyPicture f(static_cast<std::uint16_t>(curl));
        std::vector<std::uint32_t> expected;
        for (const std::uint32_t slot : f.positioned()) {
            const std::vector<QPointF> curve = f.curve(slot);
            bool crosses = false;
            for (std::size_t i = 1; i < curve.size(); ++i)
                for (std::size_t j = 1; j < kLine.size(); ++j)
                    crosses |= QLineF(curve[i - 1], curve[i]).intersects(QLineF(kLine[j - 1], kLine[j]), nullptr) ==
                               QLineF::BoundedIntersection;
            if (crosses)
                expected.push_back(slot);
        }
        const std::vector<model::SeenStrand> met = f.picture->crossing(kLine, true);
        QVERIFY(expected.size() > 20);
        QCOMPARE(slotsOf(met), expected);
        for (const model::SeenStrand& strand : met) {
            const QPointF at = f.area.positionOf(strand.positionHd).value_or(QPointF());
            QVERIFY(std::min(apart(at, kLine[0], kLine[1]), apart(at, kLine[1], kLine[2])) < 0.01);
            QVERIFY(strand.alongM >= 0.0F && strand.alongM <= strand.lengthM);
            QVERIFY(strand.fraction >= 0.0F && strand.fraction <= 1.0F);
            const glm::vec3 rootHd = f.hair().groom->roots->positionHd[strand.slot];
            QVERIFY(glm::distance(strand.rootHd, rootHd) < 1e-4F);
        }
    }

    void whatTheSkinHidesIsMetOnRequestAlone()
    {
        const HairyPicture f;
        const auto behind = [](const std::vector<model::SeenStrand>& strands) {
            return std::ranges::count_if(strands,
                                         [](const model::SeenStrand& one) { return one.positionHd.z < -0.02F; });
        };
        const std::array across{QPointF(200.0, 200.0), QPointF(280.0, 200.0)};
        const std::vector<model::SeenStrand> seen = f.picture->crossing(across, false);
        QVERIFY(seen.size() > 8);
        QCOMPARE(behind(seen), 0);
        QVERIFY(behind(f.picture->crossing(across, true)) > 8);
        QCOMPARE(behind(f.picture->under(QPointF(kMiddle), 40.0)), 0);
    }

    void anOutlineMeetsWhatGoesIn()
    {
        const HairyPicture f;
        const QPolygonF lasso({{300.0, 100.0}, {380.0, 120.0}, {370.0, 220.0}, {320.0, 180.0}});
        std::vector<std::uint32_t> expected;
        for (const std::uint32_t slot : f.positioned()) {
            const std::vector<QPointF> curve = f.curve(slot);
            bool goesIn = false;
            for (std::size_t i = 0; i < curve.size(); ++i) {
                goesIn |= lasso.containsPoint(curve[i], Qt::OddEvenFill);
                for (qsizetype j = 0; i > 0 && j < lasso.size(); ++j)
                    goesIn |= QLineF(curve[i - 1], curve[i])
                                  .intersects(QLineF(lasso[j], lasso[(j + 1) % lasso.size()]), nullptr) ==
                              QLineF::BoundedIntersection;
            }
            if (goesIn)
                expected.push_back(slot);
        }
        QVERIFY(expected.size() > 20);
        QCOMPARE(slotsOf(f.picture->inside(lasso, true)), expected);
    }

    void aBrushMeetsWhatIsSeenUnderIt_data() { aLineMeetsWhatItCrosses_data(); }

    /// Whatever it leaves out lies behind other hair or behind skin.
    void aBrushMeetsWhatIsSeenUnderIt()
    {
        QFETCH(int, curl);
        const HairyPicture f(static_cast<std::uint16_t>(curl));
        constexpr double kRadius = 14.0;
        constexpr int kFiner = 2; // Coarse chords cut a curl's corners by more than a pixel.
        const QPointF from(352.0, 160.0);
        const QPointF to(356.0, 190.0);
        const std::vector<model::SeenStrand> met = f.picture->passed(from, to, kRadius);
        const std::vector<std::uint32_t> slots = slotsOf(met);
        QVERIFY(std::ranges::is_sorted(slots));
        QVERIFY(met.size() > 10);
        std::set<std::uint32_t> below;
        for (const std::uint32_t slot : f.positioned()) {
            const std::vector<QPointF> curve = f.curve(slot, kFiner);
            double nearest = 1e9;
            for (std::size_t i = 1; i < curve.size(); ++i) {
                for (int part = 0; part <= 10; ++part)
                    nearest = std::min(nearest, apart(from + (to - from) * part / 10.0, curve[i - 1], curve[i]));
            }
            if (nearest <= kRadius)
                below.insert(slot);
            // The middle is looked at in steps.
            if (nearest > kRadius + 0.5)
                QVERIFY2(!std::ranges::binary_search(slots, slot), qPrintable(QString::number(nearest)));
        }
        float frontM = 1e9F;
        for (const model::SeenStrand& strand : met)
            frontM = std::min(frontM, f.area.camera().distanceM - strand.positionHd.z);
        int missed = 0;
        for (const std::uint32_t slot : below) {
            if (std::ranges::binary_search(slots, slot))
                continue;
            float depthM = 1e9F;
            for (const glm::vec3& point : f.curveWo(slot))
                depthM = std::min(depthM, f.area.camera().distanceM - point.z);
            missed += depthM < frontM + 0.004F ? 1 : 0;
        }
        QCOMPARE(missed, 0);
    }

    void answersAreTheSameForAnyNumberOfThreads()
    {
        const int before = sim::threadCount();
        std::vector<std::vector<model::SeenStrand>> answers;
        for (const int threads : {1, 2, 8}) {
            sim::setThreadCount(threads);
            const HairyPicture f(20000);
            std::vector<model::SeenStrand> all = f.picture->under({350.0, 200.0}, 30.0);
            for (const auto& more :
                 {f.picture->crossing(kLine, false), f.picture->inside(QPolygonF(QRectF(100, 100, 50, 80)), false)})
                all.insert(all.end(), more.begin(), more.end());
            answers.push_back(std::move(all));
        }
        sim::setThreadCount(before);
        for (const std::vector<model::SeenStrand>& other : answers) {
            QCOMPARE(slotsOf(other), slotsOf(answers.front()));
            for (std::size_t i = 0; i < other.size(); ++i) {
                QVERIFY(other[i].positionHd == answers.front()[i].positionHd);
                QVERIFY(other[i].rootHd == answers.front()[i].rootHd);
                QCOMPARE(other[i].alongM, answers.front()[i].alongM);
                QCOMPARE(other[i].apart, answers.front()[i].apart);
            }
        }
    }

    void thePictureIsOfTheHairThatIsShown()
    {
        HairyPicture f;
        view::PictureSource source = f.picture->source();
        const view::StrandPick pick([&source] { return source; });
        const auto held = pick.held();
        QVERIFY(!pick.crossing(kLine, true).empty());
        QCOMPARE(pick.held(), held);
        QVERIFY(!pick.under(QPointF(kMiddle), 50.0).empty());
        source.frame = movedBy(*source.frame, 1.0F);
        QVERIFY(pick.under(QPointF(kMiddle), 50.0).empty());
        QVERIFY(pick.crossing(kLine, true).empty());
        QVERIFY(!held->crossing(kLine, true).empty());
        source.frame = nullptr;
        QVERIFY(pick.hair() == nullptr);
        QVERIFY(pick.under(QPointF(kMiddle), 50.0).empty());
    }
};

HAIRPAINT_TEST(TestStrandPick, Widgets)
#include "test_strand_pick.moc"
