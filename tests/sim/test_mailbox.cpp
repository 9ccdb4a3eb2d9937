// The mailbox between two threads: the latest wins, nothing is lost, waiting ends.
#include "sim/base/mailbox.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

using namespace hairpaint::sim;

class TestMailbox : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theLatestValueWins();
    void anEmptyBoxGivesNothing();
    void editsGatherUntilTheyAreTaken();
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
    const auto now = std::chrono::steady_clock::now();
    QVERIFY(!box.takeUntil(now + std::chrono::milliseconds(5)));
    QVERIFY(std::chrono::steady_clock::now() - now >= std::chrono::milliseconds(5));
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
