// The mailbox between two threads: the latest wins, nothing is lost, waiting ends.
#include "sim/base/mailbox.h"
#include "tests/support/await.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

using namespace hairpaint::sim;

namespace {

/// Goes on by a millisecond with each look at it.
struct LookedAtClock
{
    using duration = std::chrono::milliseconds;
    using rep = duration::rep;
    using period = duration::period;
    using time_point = std::chrono::time_point<LookedAtClock>;
    static constexpr bool is_steady = true;
    static inline std::atomic<rep> looks = 0;
    static time_point now() { return time_point(duration(++looks)); }
};

} // namespace

class TestMailbox : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theLatestValueWins();
    void anEmptyBoxGivesNothing();
    void editsGatherUntilTheyAreTaken();
    void itTellsWhetherSomebodyWaits();
    void aWaitingTakeWakesWhenAValueArrives();
    void aTakeUntilADeadlineGivesUp();
    void valuesFromManyThreadsAllArrive();
};

void TestMailbox::theLatestValueWins()
{
    Mailbox<int> box;
    box.put(1);
    box.put(2);
    QCOMPARE(box.take().value_or(0), 2);
    QVERIFY(!box.take());
}

void TestMailbox::anEmptyBoxGivesNothing()
{
    Mailbox<int> box;
    QVERIFY(!box.take());
}

void TestMailbox::editsGatherUntilTheyAreTaken()
{
    Mailbox<std::vector<int>> box;
    box.update([](std::vector<int>& list) { list.push_back(1); });
    box.update([](std::vector<int>& list) { list.push_back(2); });
    QCOMPARE(box.take().value(), (std::vector<int>{1, 2}));
    box.update([](std::vector<int>& list) { list.push_back(3); });
    QCOMPARE(box.take().value(), (std::vector<int>{3}));
}

void TestMailbox::itTellsWhetherSomebodyWaits()
{
    Mailbox<int> box;
    QVERIFY(!box.awaited());
    std::thread reader([&box] { (void)box.waitAndTake(); });
    QVERIFY(hairpaint::test::awaitUntil([&] { return box.awaited(); }));
    box.put(1);
    QVERIFY(!box.awaited()); // Whether it was taken yet or not.
    reader.join();
    QVERIFY(!box.awaited());
}

void TestMailbox::aWaitingTakeWakesWhenAValueArrives()
{
    Mailbox<int> box;
    std::atomic<int> got{0};
    std::thread reader([&] { got = box.waitAndTake(); });
    box.put(7);
    reader.join();
    QCOMPARE(got.load(), 7);
    QVERIFY(!box.take());
}

void TestMailbox::aTakeUntilADeadlineGivesUp()
{
    Mailbox<int> box;
    const auto now = LookedAtClock::now();
    const auto deadline = now + std::chrono::milliseconds(5);
    QVERIFY(!box.takeUntil(deadline));
    QVERIFY(LookedAtClock::now() > deadline);
    box.put(3);
    QCOMPARE(box.takeUntil(now).value_or(0), 3);
}

void TestMailbox::valuesFromManyThreadsAllArrive()
{
    constexpr int kThreads = 4;
    constexpr int kEach = 500;
    Mailbox<std::vector<int>> box;
    std::vector<std::thread> writers;
    writers.reserve(kThreads);
    for (int t = 0; t < kThreads; ++t) {
        writers.emplace_back([&box, t] {
            for (int i = 0; i < kEach; ++i)
                box.update([&](std::vector<int>& list) { list.push_back(t * kEach + i); });
        });
    }
    std::vector<int> seen(std::size_t{kThreads} * kEach, 0);
    for (std::size_t count = 0; count < seen.size();) {
        for (const int value : box.waitAndTake()) {
            ++seen[static_cast<std::size_t>(value)];
            ++count;
        }
    }
    for (std::thread& writer : writers)
        writer.join();
    QVERIFY(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }));
}

HAIRPAINT_TEST(TestMailbox, None)
#include "test_mailbox.moc"
