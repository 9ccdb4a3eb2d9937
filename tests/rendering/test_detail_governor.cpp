// The governor keeps moving pictures fast and makes still ones fine.
#include "tests/support/test_program.h"
#include "view/rendering/renderer.h"

#include <QtTest>

using namespace hairpaint::rendering;

namespace {

/// A machine on which a frame takes `baseMs` and `allMs` for all hairs, times the samples' cost.
double frameMs(const Quality& quality, double baseMs, double allMs)
{
    return (baseMs + allMs * static_cast<double>(quality.detail)) * (quality.samples >= 4 ? 2.5 : 1.0);
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
    for (int frame = 0; frame < 200; ++frame)
        governor.observe({.milliseconds = frameMs(governor.quality(), baseMs, allMs)}, 100000, false);
    const Quality& quality = governor.quality();
    const double milliseconds = frameMs(quality, baseMs, allMs);
    QVERIFY2(milliseconds < 33.0 * 1.2 || quality.detail <= 0.2F, qPrintable(QString::number(milliseconds)));
    QVERIFY2(milliseconds > 33.0 * 0.5 || (quality.detail == 1.0F && quality.samples == 4),
             qPrintable(QString::number(milliseconds)));
}

void TestDetailGovernor::stillPicturesAreRefinedAndThenRest_data()
{
    QTest::addColumn<double>("allMs");
    QTest::addColumn<bool>("reachesAll");
    QTest::newRow("GPU") << 2.0 << true;
    QTest::newRow("software") << 60.0 << true;
    QTest::newRow("slow software") << 1000.0 << false;
}

void TestDetailGovernor::stillPicturesAreRefinedAndThenRest()
{
    QFETCH(double, allMs);
    QFETCH(bool, reachesAll);
    DetailGovernor governor(33.0);
    for (int frame = 0; frame < 200; ++frame)
        governor.observe({.milliseconds = frameMs(governor.quality(), 5.0, allMs)}, 100000, false);
    const Quality moving = governor.quality();
    int frames = 0;
    double longest = 0.0;
    float detail = moving.detail;
    do {
        const double milliseconds = frameMs(governor.quality(), 5.0, allMs);
        longest = std::max(longest, milliseconds);
        governor.observe({.milliseconds = milliseconds}, 100000, true);
        QVERIFY(governor.quality().detail >= detail); // Never coarser again.
        detail = governor.quality().detail;
        ++frames;
    } while (governor.wantsRefinement() && frames < 100);
    QVERIFY(frames < 40);
    QVERIFY2(longest < 750.0, qPrintable(QString::number(longest)));
    QCOMPARE(governor.quality().samples, 4);
    QCOMPARE(governor.quality().detail == 1.0F, reachesAll);
    QVERIFY(governor.quality().detail > moving.detail || moving.detail == 1.0F);
}

void TestDetailGovernor::movingAgainGoesBackToTheDetailOfBefore()
{
    DetailGovernor governor(33.0);
    for (int frame = 0; frame < 200; ++frame)
        governor.observe({.milliseconds = frameMs(governor.quality(), 5.0, 500.0)}, 100000, false);
    const Quality moving = governor.quality();
    for (int frame = 0; frame < 20; ++frame)
        governor.observe({.milliseconds = frameMs(governor.quality(), 5.0, 500.0)}, 100000, true);
    governor.observe({.milliseconds = frameMs(governor.quality(), 5.0, 500.0)}, 100000, false);
    QCOMPARE(governor.quality().detail, moving.detail);
    QCOMPARE(governor.quality().samples, moving.samples);
}

void TestDetailGovernor::headIsCoarseOnlyWhileItMoves()
{
    // So slow that nothing else is refined: the fine head is worth a frame of its own.
    DetailGovernor governor(33.0);
    for (int frame = 0; frame < 50; ++frame)
        governor.observe({.milliseconds = 2000.0}, 100000, false);
    QVERIFY(governor.quality().coarseHead);
    governor.observe({.milliseconds = 2000.0}, 100000, true);
    QVERIFY(!governor.quality().coarseHead);
    QVERIFY(governor.wantsRefinement());
    governor.observe({.milliseconds = 2000.0}, 100000, true);
    QVERIFY(!governor.wantsRefinement());
    governor.observe({.milliseconds = 2000.0}, 100000, false);
    QVERIFY(governor.quality().coarseHead);
}

void TestDetailGovernor::detailRestsWhileTimesWaver()
{
    DetailGovernor governor(33.0);
    for (int frame = 0; frame < 200; ++frame)
        governor.observe({.milliseconds = frameMs(governor.quality(), 5.0, 300.0)}, 100000, false);
    const float detail = governor.quality().detail;
    for (int frame = 0; frame < 100; ++frame) {
        const double waver = frame % 2 == 0 ? 1.1 : 0.9;
        governor.observe({.milliseconds = frameMs(governor.quality(), 5.0, 300.0) * waver}, 100000, false);
        QCOMPARE(governor.quality().detail, detail);
    }
}

HAIRPAINT_TEST(TestDetailGovernor, None)
#include "test_detail_governor.moc"
