// A race, run under the thread sanitizer alone and expected to fail: it shows that races of a test are told of.
#include "tests/support/test_program.h"

#include <QtTest>

#include <thread>

class TestSeenRace : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void twoThreadsCountAtOnce()
    {
        volatile int count = 0;
        std::thread other([&count] { count = count + 1; });
        count = count + 1;
        other.join();
        QVERIFY(count > 0);
    }
};

HAIRPAINT_TEST(TestSeenRace, None)
#include "test_seen_race.moc"
