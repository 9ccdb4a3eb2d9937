// Motion that shows is told from motion that does not.
#include "tests/support/test_program.h"
#include "view/head/stillness.h"

#include <QTest>

using namespace hairpaint;

namespace {

std::shared_ptr<sim::StrandFrame> frameOf(std::shared_ptr<const sim::Groom> groom, float shiftM)
{
    auto frame = std::make_shared<sim::StrandFrame>();
    frame->groups.push_back({.groom = std::move(groom), .positions = {}});
    frame->groups.front().positions.assign(std::size_t{4096} * 3 * sim::kLanes, shiftM);
    return frame;
}

} // namespace

class TestStillness : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aPixelIsTheLimit_data()
    {
        QTest::addColumn<double>("px");
        QTest::addColumn<bool>("moves");
        QTest::newRow("nothing") << 0.0 << false;
        QTest::newRow("half a pixel") << 0.5 << false;
        QTest::newRow("two pixels") << 2.0 << true;
    }
    void aPixelIsTheLimit()
    {
        QFETCH(double, px);
        QFETCH(bool, moves);
        const rendering::Camera camera;
        const QSize area(600, 500);
        const double metresPerPx =
            2.0 * static_cast<double>(camera.distanceM * std::tan(camera.fieldOfViewRad / 2.0F)) / area.height();
        auto groom = std::make_shared<sim::Groom>();
        groom->visible = true;
        view::Stillness stillness;
        QVERIFY(stillness.moved(frameOf(groom, 0.0F), camera, area)); // The first.
        const auto shift = static_cast<float>(px * metresPerPx / std::sqrt(3.0));
        QCOMPARE(stillness.moved(frameOf(groom, shift), camera, area), moves);
    }

    void aSlowDriftIsNoticed()
    {
        const rendering::Camera camera;
        auto groom = std::make_shared<sim::Groom>();
        groom->visible = true;
        view::Stillness stillness;
        QVERIFY(stillness.moved(frameOf(groom, 0.0F), camera, {600, 500}));
        int noticed = 0;
        for (int i = 1; i <= 100; ++i)
            noticed += stillness.moved(frameOf(groom, 5e-5F * static_cast<float>(i)), camera, {600, 500}) ? 1 : 0;
        QVERIFY(noticed >= 3 && noticed < 50);
    }

    void oneTipThatMovesIsEnough()
    {
        auto groom = std::make_shared<sim::Groom>();
        groom->visible = true;
        const auto before = frameOf(groom, 0.0F);
        const auto after = frameOf(groom, 0.0F);
        // The last of eight nodes of one block in nine.
        for (std::size_t block = 0; block < 512; block += 9)
            after->groups.front().positions[(block * 8 + 7) * 3 * sim::kLanes] = 0.05F;
        view::Stillness stillness;
        QVERIFY(stillness.moved(before, {}, {600, 500}));
        QVERIFY(stillness.moved(after, {}, {600, 500}));
    }

    void anotherGroomOrPoseIsAnotherPicture()
    {
        auto groom = std::make_shared<sim::Groom>();
        view::Stillness stillness;
        const auto first = frameOf(groom, 0.0F);
        QVERIFY(stillness.moved(first, {}, {600, 500}));
        QVERIFY(!stillness.moved(first, {}, {600, 500}));
        QVERIFY(stillness.moved(frameOf(std::make_shared<sim::Groom>(), 0.0F), {}, {600, 500}));
        const auto turned = frameOf(groom, 0.0F);
        turned->pose.positionWo.x = 0.01F;
        QVERIFY(stillness.moved(turned, {}, {600, 500}));
    }
};

HAIRPAINT_TEST(TestStillness, None)
#include "test_stillness.moc"
