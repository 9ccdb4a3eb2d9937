// Parallel loops cover the whole range once, on as many threads as were asked for.
#include "sim/base/parallel.h"

#include "sim/base/per_thread.h"
#include "tests/support/await.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <atomic>
#include <mutex>
#include <new>
#include <set>
#include <thread>
#include <vector>

using namespace hairpaint::sim;

class TestParallel : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void cleanup() { setThreadCount(0); }
    void everyIndexIsVisitedOnceInRangesOfTheGrain_data();
    void everyIndexIsVisitedOnceInRangesOfTheGrain();
    void eightThreadsAreEightOnAnyMachine();
    void theCountIsKeptWithinItsRange();
    void loopsMayBeNested();
    void eachThreadHasItsOwn();
    void aLoopOfTheWindowWaitsForNoOther_data();
    void aLoopOfTheWindowWaitsForNoOther();
    void whatABodyThrowsComesOutOfTheLoop_data();
    void whatABodyThrowsComesOutOfTheLoop();
};

void TestParallel::everyIndexIsVisitedOnceInRangesOfTheGrain_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("grain");
    QTest::addColumn<int>("threads");
    QTest::newRow("nothing") << 0 << 4 << 2;
    QTest::newRow("one") << 1 << 4 << 2;
    QTest::newRow("less than the grain") << 3 << 4 << 2;
    QTest::newRow("a rest") << 1003 << 10 << 2;
    QTest::newRow("one thread") << 1003 << 10 << 1;
    QTest::newRow("eight threads") << 100000 << 1 << 8;
    QTest::newRow("grain of none") << 17 << 0 << 3;
}

void TestParallel::everyIndexIsVisitedOnceInRangesOfTheGrain()
{
    QFETCH(int, count);
    QFETCH(int, grain);
    QFETCH(int, threads);
    setThreadCount(threads);
    std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
    std::atomic<bool> tooShort{false};
    parallelFor(static_cast<std::size_t>(count), static_cast<std::size_t>(grain),
                [&](std::size_t begin, std::size_t end) {
                    if (end - begin < static_cast<std::size_t>(std::min(grain, count)))
                        tooShort = true;
                    for (std::size_t i = begin; i < end; ++i)
                        ++visits[i];
                });
    QVERIFY(!tooShort);
    for (const std::atomic<int>& visit : visits)
        QCOMPARE(visit.load(), 1);
}

void TestParallel::eightThreadsAreEightOnAnyMachine()
{
    setThreadCount(8);
    QCOMPARE(threadCount(), 8);
    std::mutex mutex;
    std::set<std::thread::id> seen;
    // A piece waits until eight threads have come, so that a quick one cannot take them all; it gives up in the end.
    std::atomic<bool> gaveUp{false};
    parallelFor(64, 1, [&](std::size_t, std::size_t) {
        const bool came = hairpaint::test::awaitUntil([&] {
            const std::lock_guard lock(mutex);
            seen.insert(std::this_thread::get_id());
            return seen.size() >= 8 || gaveUp;
        });
        gaveUp = gaveUp || !came;
    });
    QCOMPARE(seen.size(), std::size_t{8});
}

void TestParallel::theCountIsKeptWithinItsRange()
{
    setThreadCount(1000);
    QCOMPARE(threadCount(), 64);
    setThreadCount(3);
    QCOMPARE(threadCount(), 3);
    setThreadCount(0);
    QVERIFY(threadCount() >= 1);
}

void TestParallel::loopsMayBeNested()
{
    setThreadCount(4);
    std::atomic<int> total{0};
    parallelFor(20, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            parallelFor(50, 1, [&](std::size_t b, std::size_t e) { total += static_cast<int>(e - b); });
    });
    QCOMPARE(total.load(), 1000);
}

void TestParallel::aLoopOfTheWindowWaitsForNoOther_data()
{
    QTest::addColumn<int>("arena");
    QTest::newRow("simulation") << static_cast<int>(Arena::Simulation);
    QTest::newRow("background") << static_cast<int>(Arena::Background);
}

void TestParallel::aLoopOfTheWindowWaitsForNoOther()
{
    QFETCH(int, arena);
    setThreadCount(2);
    std::atomic<int> held{0};
    std::atomic<bool> letGo{false};
    std::thread other([&] {
        const ArenaScope scope(static_cast<Arena>(arena));
        parallelFor(8, 1, [&](std::size_t, std::size_t) {
            ++held;
            while (!letGo)
                std::this_thread::yield();
            // A loop within it keeps to the same arena, on whichever thread the body runs.
            parallelFor(2, 1, [](std::size_t, std::size_t) {});
        });
    });
    while (held < 2) // Every slot of that arena is taken.
        std::this_thread::yield();
    std::atomic<std::size_t> done{0};
    parallelFor(1000, 1, [&](std::size_t begin, std::size_t end) { done += end - begin; });
    const std::size_t doneMeanwhile = done;
    letGo = true;
    other.join();
    QCOMPARE(doneMeanwhile, std::size_t{1000});
}

void TestParallel::whatABodyThrowsComesOutOfTheLoop_data()
{
    QTest::addColumn<int>("threads");
    QTest::newRow("one thread") << 1;
    QTest::newRow("four threads") << 4;
}

void TestParallel::whatABodyThrowsComesOutOfTheLoop()
{
    QFETCH(int, threads);
    setThreadCount(threads);
    for (const std::size_t culprit : {std::size_t{0}, std::size_t{57}, std::size_t{99}})
        QVERIFY_THROWS_EXCEPTION(std::bad_alloc, parallelFor(100, 1, [&](std::size_t begin, std::size_t end) {
                                     if (begin <= culprit && culprit < end)
                                         throw std::bad_alloc();
                                 }));
    std::atomic<std::size_t> done{0};
    parallelFor(100, 1, [&](std::size_t begin, std::size_t end) { done += end - begin; });
    QCOMPARE(done.load(), std::size_t{100});
}

void TestParallel::eachThreadHasItsOwn()
{
    PerThread<std::vector<int>> numbers;
    numbers.here().push_back(1);
    std::thread([&numbers] {
        QVERIFY(numbers.here().empty());
        numbers.here().assign(3, 2);
        QCOMPARE(numbers.here().size(), std::size_t{3});
    }).join();
    QCOMPARE(numbers.here(), std::vector<int>{1});
}

HAIRPAINT_TEST(TestParallel, None)
#include "test_parallel.moc"
