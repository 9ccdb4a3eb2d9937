// The governor keeps moving pictures fast and makes still ones fine.
#include "tests/support/test_program.h"
#include "view/rendering/detail_governor.h"

#include <QtTest>

using namespace hairpaint::rendering;

namespace {

/// A machine on which a frame takes `baseMs` and `allMs` for all hairs, times the samples' cost.
double frameMs(const Quality& quality, double baseMs, double allMs)
{
    return (baseMs + allMs * static_cast<double>(quality.detail)) * (quality.samples >= 4 ? 2.5 : 1.0);
}

constexpr std::size_t kAllHairs = 100'000;

/// Draws `frames` frames on such a machine.
void draw(DetailGovernor& governor, bool still, double baseMs, double allMs, int frames)
{
    for (int frame = 0; frame < frames; ++frame)
        governor.observe({.milliseconds = frameMs(governor.begin(still), baseMs, allMs)}, kAllHairs);
}

} // namespace

class TestDetailGovernor : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void movingPicturesSettleNearTheWantedTime_data();
    void movingPicturesSettleNearTheWantedTime();
    void stillPicturesAreRefinedAndThenRest_data();
    void stillPicturesAreRefinedAndThenRest();
    void movingAgainGoesBackToTheDetailOfBefore();
    void headIsCoarseOnlyWhileItMoves();
    void detailRestsWhileTimesWaver();
    void wantOfMemoryMakesTheNextFrameCoarser();
    void aSlowFrameOfFewHairsIsFollowedByOneOfFewer();
};

void TestDetailGovernor::movingPicturesSettleNearTheWantedTime_data()
{
    QTest::addColumn<double>("baseMs");
    QTest::addColumn<double>("allMs");
    QTest::newRow("GPU") << 1.0 << 3.0;
    QTest::newRow("fast software") << 5.0 << 60.0;
    QTest::newRow("slow software") << 10.0 << 500.0;
    QTest::newRow("too slow") << 50.0 << 5000.0;
}

void TestDetailGovernor::movingPicturesSettleNearTheWantedTime()
{
    QFETCH(double, baseMs);
    QFETCH(double, allMs);
    DetailGovernor governor(33.0);
    draw(governor, false, baseMs, allMs, 200);
    const Quality& quality = governor.quality();
    const double milliseconds = frameMs(quality, baseMs, allMs);
    QVERIFY2(milliseconds < 33.0 * 1.2 || quality.detail <= 0.2F, qPrintable(QString::number(milliseconds)));
    QVERIFY2(milliseconds > 33.0 * 0.5 || (quality.detail == 1.0F && quality.samples == 4),
             qPrintable(QString::number(milliseconds)));
}

void TestDetailGovernor::stillPicturesAreRefinedAndThenRest_data()
{
    QTest::addColumn<double>("allMs");
    QTest::newRow("GPU") << 2.0;
    QTest::newRow("software") << 60.0;
    QTest::newRow("slow software") << 1000.0;
    QTest::newRow("software on a busy machine") << 30'000.0;
}

void TestDetailGovernor::stillPicturesAreRefinedAndThenRest()
{
    QFETCH(double, allMs);
    DetailGovernor governor(33.0);
    draw(governor, false, 5.0, allMs, 200);
    const Quality moving = governor.quality();
    QCOMPARE(governor.begin(true).detail, moving.detail); // The first still frame shows at once what there is.
    int frames = 0;
    float detail = moving.detail;
    do {
        draw(governor, true, 5.0, allMs, 1);
        QVERIFY(governor.quality().detail >= detail);        // Never coarser again.
        QVERIFY(governor.quality().detail <= detail * 2.0F); // Step by step.
        detail = governor.quality().detail;
        ++frames;
    } while (governor.wantsRefinement() && frames < 100);
    QVERIFY(frames < 12);
    const Quality& quality = governor.quality();
    QCOMPARE(quality.detail, pictureQuality().detail);
    QCOMPARE(quality.samples, pictureQuality().samples);
    QVERIFY(!quality.coarseHead);
}

void TestDetailGovernor::movingAgainGoesBackToTheDetailOfBefore()
{
    DetailGovernor governor(33.0);
    draw(governor, false, 5.0, 500.0, 200);
    const Quality moving = governor.quality();
    draw(governor, true, 5.0, 500.0, 20);
    // The very next frame already: a fine one would hold up the hand.
    const Quality& next = governor.begin(false);
    QCOMPARE(next.detail, moving.detail);
    QCOMPARE(next.samples, moving.samples);
}

void TestDetailGovernor::headIsCoarseOnlyWhileItMoves()
{
    DetailGovernor governor(33.0);
    draw(governor, false, 2000.0, 0.0, 50);
    QVERIFY(governor.quality().coarseHead);
    draw(governor, true, 2000.0, 0.0, 1);
    QVERIFY(!governor.quality().coarseHead);
    QVERIFY(governor.wantsRefinement());
    QVERIFY(governor.begin(false).coarseHead);
}

void TestDetailGovernor::detailRestsWhileTimesWaver()
{
    DetailGovernor governor(33.0);
    draw(governor, false, 5.0, 300.0, 200);
    const float detail = governor.quality().detail;
    for (int frame = 0; frame < 100; ++frame) {
        const double waver = frame % 2 == 0 ? 1.1 : 0.9;
        governor.observe({.milliseconds = frameMs(governor.begin(false), 5.0, 300.0) * waver}, kAllHairs);
        QCOMPARE(governor.quality().detail, detail);
    }
}

/// Where the renderer draws a fifth of the hairs however many it is asked for, since more could not be told apart.
void TestDetailGovernor::aSlowFrameOfFewHairsIsFollowedByOneOfFewer()
{
    DetailGovernor governor(33.0);
    const auto drawn = [](const Quality& quality) {
        return static_cast<std::size_t>(static_cast<double>(kAllHairs) * std::min(0.2, double{quality.detail}));
    };
    for (int frame = 0; frame < 100; ++frame)
        governor.observe({.drawnHairs = drawn(governor.begin(false)), .milliseconds = 10.0}, kAllHairs);
    QCOMPARE(governor.quality().detail, 1.0F);
    for (int frame = 0; frame < 6; ++frame) // The first ones take the samples back.
        governor.observe({.drawnHairs = drawn(governor.begin(false)), .milliseconds = 60.0}, kAllHairs);
    QVERIFY(drawn(governor.quality()) < drawn({.detail = 1.0F}));
}

void TestDetailGovernor::wantOfMemoryMakesTheNextFrameCoarser()
{
    DetailGovernor governor(33.0);
    draw(governor, false, 1.0, 3.0, 200);
    const Quality moving = governor.quality();
    governor.observe({.milliseconds = 4.0, .complete = false}, kAllHairs);
    QVERIFY(governor.begin(false).samples < moving.samples || governor.begin(false).detail < moving.detail);

    // A still one goes back to what was drawn whole, shows that once more, and rests.
    draw(governor, false, 5.0, 500.0, 200);
    draw(governor, true, 5.0, 500.0, 2);
    const Quality whole = governor.quality();
    draw(governor, true, 5.0, 500.0, 1);
    QVERIFY(governor.quality().detail > whole.detail);
    governor.observe({.milliseconds = 4.0, .complete = false}, kAllHairs);
    QVERIFY(governor.wantsRefinement());
    QCOMPARE(governor.begin(true).detail, whole.detail);
    draw(governor, true, 5.0, 500.0, 1);
    QVERIFY(!governor.wantsRefinement());
    QCOMPARE(governor.quality().detail, whole.detail);
    // Not even that: no frame follows another without end.
    governor.observe({.milliseconds = 4.0, .complete = false}, kAllHairs);
    QVERIFY(!governor.wantsRefinement());
    draw(governor, false, 5.0, 500.0, 1);
    draw(governor, true, 5.0, 500.0, 1);
    QVERIFY(governor.wantsRefinement());
}

HAIRPAINT_TEST(TestDetailGovernor, None)
#include "test_detail_governor.moc"
