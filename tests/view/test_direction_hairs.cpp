// The direction map as short hairs over the head.
#include "head_fixture.h"
#include "model/document/paint_command.h"
#include "sim/groom/direction_texel.h"
#include "tests/support/await.h"
#include "tests/support/test_program.h"
#include "view/head_area/direction_hairs.h"
#include "view/head_area/head_overlay.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace hairpaint;
using namespace hairpaint::test;

class TestDirectionHairs : public QObject
{
    Q_OBJECT
private:
    /// All over the active group's layer of that map.
    static void fill(HeadFixture& f, model::MapKind map, const sim::Texel& value)
    {
        const model::HairGroup& group = f.editor.document.project().groups.front();
        const model::LayerAddress at{.group = group.id, .map = map, .layer = group.map(map).layers.front().id};
        sim::TiledRaster raster = group.map(map).layers.front().raster;
        model::LayerTiles tiles;
        for (int index = 0; index < raster.tileCount(); ++index) {
            raster.setUniform(index, value);
            tiles.emplace_back(index, raster.tile(index));
        }
        f.editor.document.push(model::paintCommand(f.editor.document, at, tiles, QStringLiteral("fill")));
    }
    static sim::Texel covered(glm::vec2 direction)
    {
        sim::Texel texel = sim::texelOfDirection(direction);
        texel[2] = 65535;
        return texel;
    }
    static const std::vector<view::HairSpine>& shown(const HeadFixture& f)
    {
        return f.area.findChild<view::HeadOverlay*>()->directions();
    }
    /// The hairs within 60 px of the middle.
    static std::vector<view::HairSpine> amid(const std::vector<view::HairSpine>& hairs)
    {
        std::vector<view::HairSpine> near;
        std::ranges::copy_if(hairs, std::back_inserter(near), [](const view::HairSpine& hair) {
            return QLineF(hair[0], QPointF(kMiddle)).length() < 60.0;
        });
        return near;
    }

private Q_SLOTS:
    void theyLieAsTheMapSaysWhileItIsTheActiveOne()
    {
        HeadFixture f;
        fill(f, model::MapKind::Direction, covered({0.9F, 0.0F}));
        f.editor.state.target().setMap(model::MapKind::Density);
        handleDueEvents();
        QVERIFY(shown(f).empty());
        f.editor.state.target().setMap(model::MapKind::Direction);
        QTRY_VERIFY_WITH_TIMEOUT(amid(shown(f)).size() > 20, kPatienceMs);
        // u grows to the right on the ball's front.
        for (const view::HairSpine& hair : amid(shown(f))) {
            QVERIFY(hair[2].x() > hair[0].x() + 6.0);
            QVERIFY(std::abs(hair[2].y() - hair[0].y()) < 8.0);
        }
        f.editor.state.options().setDirectionsShown(false);
        QTRY_VERIFY_WITH_TIMEOUT(shown(f).empty(), kPatienceMs);
    }

    void anotherMapIsLookedAtWithoutThemAndTheirOwnWithThem()
    {
        HeadFixture f;
        f.editor.state.options().setDirectionsShown(false);
        f.area.setLookedAt(model::MapKind::Direction);
        QTRY_VERIFY_WITH_TIMEOUT(!shown(f).empty(), kPatienceMs);
        f.area.setLookedAt(model::MapKind::Gel);
        QTRY_VERIFY_WITH_TIMEOUT(shown(f).empty(), kPatienceMs);
    }

    void theyStandApartWhereThereIsHairOnTheSideThatIsSeen()
    {
        HeadFixture f;
        f.editor.state.target().setMap(model::MapKind::Direction);
        QTRY_VERIFY_WITH_TIMEOUT(!shown(f).empty(), kPatienceMs);
        const std::vector<view::HairSpine> all = shown(f);
        for (std::size_t i = 0; i < all.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                QVERIFY(QLineF(all[i][0], all[k][0]).length() >= 12.0);
        // A brush of 2 cm paints density in the middle: elsewhere there are no hairs any more.
        f.editor.state.target().setMap(model::MapKind::Density);
        QTest::mouseClick(&f.area, Qt::LeftButton, Qt::NoModifier, kMiddle);
        f.editor.state.target().setMap(model::MapKind::Direction);
        QTRY_VERIFY_WITH_TIMEOUT(!shown(f).empty() && shown(f).size() < all.size() / 4, kPatienceMs);
        const QPointF rim = f.area.positionOf({0.0112F, 0.0F, kBallM}).value_or(QPointF());
        for (const view::HairSpine& hair : shown(f))
            QVERIFY(QLineF(hair[0], QPointF(kMiddle)).length() < QLineF(rim, QPointF(kMiddle)).length());
    }

    void theyGoWithTheCombBeforeItIsLetGo()
    {
        HeadFixture f;
        f.editor.state.tools().choose(model::ToolId::Comb);
        QTRY_VERIFY_WITH_TIMEOUT(!shown(f).empty(), kPatienceMs);
        const auto right = [&f] {
            const std::vector<view::HairSpine> hairs = amid(shown(f));
            return std::ranges::count_if(hairs,
                                         [](const view::HairSpine& hair) { return hair[2].x() > hair[0].x() + 13.0; });
        };
        QCOMPARE(right(), 0);
        QTest::mousePress(&f.area, Qt::LeftButton, {}, kMiddle - QPoint(40, 0));
        for (int x = -35; x <= 40; x += 5)
            f.move(kMiddle + QPoint(x, 0), Qt::LeftButton, {});
        QTRY_VERIFY_WITH_TIMEOUT(right() > 3, kPatienceMs);
        QTest::keyClick(&f.area, Qt::Key_Escape);
        QTRY_COMPARE_WITH_TIMEOUT(right(), 0, kPatienceMs);
    }

    void theyFadeWhileHairIsCombedAndAfter()
    {
        HeadFixture f;
        const auto* overlay = f.area.findChild<view::HeadOverlay*>();
        f.editor.state.tools().choose(model::ToolId::Comb);
        QVERIFY(!overlay->directionsFaded());
        QTest::mousePress(&f.area, Qt::LeftButton, {}, kMiddle - QPoint(40, 0));
        for (int x = -35; x <= 40; x += 5)
            f.move(kMiddle + QPoint(x, 0), Qt::LeftButton, {});
        QVERIFY(overlay->directionsFaded());
        QTest::mouseRelease(&f.area, Qt::LeftButton, {}, kMiddle + QPoint(40, 0));
        QVERIFY(overlay->directionsFaded());
        f.editor.state.tools().choose(model::ToolId::Brush);
        QVERIFY(!overlay->directionsFaded());
        // The map itself is painted: it is what is looked at.
        f.editor.state.target().setMap(model::MapKind::Direction);
        QTest::mouseClick(&f.area, Qt::LeftButton, Qt::NoModifier, kMiddle);
        QVERIFY(!overlay->directionsFaded());
    }

    void theyGoWithTheHead()
    {
        HeadFixture f;
        f.editor.state.target().setMap(model::MapKind::Direction);
        QTRY_VERIFY_WITH_TIMEOUT(!shown(f).empty(), kPatienceMs);
        const std::vector<view::HairSpine> before = shown(f);
        auto frame = std::make_shared<sim::StrandFrame>();
        frame->pose.positionWo = {0.03F, 0.0F, 0.0F};
        f.area.setFrame(frame);
        QTRY_VERIFY_WITH_TIMEOUT(shown(f) != before, kPatienceMs);
        const auto middleX = [](const std::vector<view::HairSpine>& hairs) {
            double sum = 0.0;
            for (const view::HairSpine& hair : hairs)
                sum += hair[0].x();
            return sum / static_cast<double>(hairs.size());
        };
        QVERIFY(middleX(shown(f)) > middleX(before) + 10.0);
    }
};

HAIRPAINT_TEST(TestDirectionHairs, Widgets)
#include "test_direction_hairs.moc"
