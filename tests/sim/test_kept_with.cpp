// What is made of something once, and kept as long as that lives.
#include "sim/base/kept_with.h"
#include "sim/skin/skin_band.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <memory>
#include <new>
#include <thread>
#include <vector>

using namespace hairpaint::sim;

class TestKeptWith : public QObject
{
    Q_OBJECT
private:
    using Numbers = KeptWith<int, int>;
    static std::shared_ptr<const int> doubled(int key) { return std::make_shared<const int>(2 * key); }

private Q_SLOTS:
    void eachKeyHasOneValue()
    {
        Numbers numbers;
        int made = 0;
        const auto make = [&made](int key) {
            ++made;
            return doubled(key);
        };
        const auto three = std::make_shared<const int>(3);
        const auto four = std::make_shared<const int>(4);
        const auto first = numbers.of(three, make);
        QCOMPARE(*first, 6);
        QCOMPARE(*numbers.of(four, make), 8);
        QCOMPARE(numbers.of(three, make), first);
        QCOMPARE(made, 2);
    }

    void aValueGoesWithItsKey()
    {
        Numbers numbers;
        auto gone = std::make_shared<const int>(3);
        const std::weak_ptr<const int> value = numbers.of(gone, doubled);
        QVERIFY(!value.expired());
        gone.reset();
        const auto other = std::make_shared<const int>(4);
        QCOMPARE(*numbers.of(other, doubled), 8);
        QVERIFY(value.expired());
    }

    void whatCouldNotBeMadeIsTriedAgain()
    {
        Numbers numbers;
        const auto key = std::make_shared<const int>(3);
        const auto fail = [](int) -> std::shared_ptr<const int> { throw std::bad_alloc(); };
        QVERIFY_THROWS_EXCEPTION(std::bad_alloc, (void)numbers.of(key, fail));
        QCOMPARE(*numbers.of(key, doubled), 6);
    }

    void threadsGetTheSameValue()
    {
        Numbers numbers;
        const auto key = std::make_shared<const int>(3);
        std::vector<std::shared_ptr<const int>> values(8);
        std::vector<std::thread> threads;
        threads.reserve(values.size());
        for (std::shared_ptr<const int>& value : values)
            threads.emplace_back([&] { value = numbers.of(key, doubled); });
        for (std::thread& thread : threads)
            thread.join();
        for (const std::shared_ptr<const int>& value : values)
            QCOMPARE(value, values.front());
    }

    void aSkinHasOneBand()
    {
        const auto skin = std::make_shared<const Skin>(hairpaint::test::makePatchHead(8));
        const auto band = bandOf(skin);
        QVERIFY(!band->cells().empty());
        QCOMPARE(bandOf(skin), band);
        QVERIFY(bandOf(std::make_shared<const Skin>(skin->mesh())) != band);
    }
};

HAIRPAINT_TEST(TestKeptWith, None)
#include "test_kept_with.moc"
