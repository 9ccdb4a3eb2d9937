// Frames go round with their memory, and hold nothing alive while they wait.
#include "sim/motion/frame_pool.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace hairpaint::sim;

class TestFramePool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aFrameThatIsLetGoKeepsItsMemoryAndNoGroom();
    void framesOfMoreHairThanThereIsAreForgotten();
    void framesOutliveThePool();
};

void TestFramePool::aFrameThatIsLetGoKeepsItsMemoryAndNoGroom()
{
    FramePool pool;
    std::shared_ptr<StrandFrame> frame = pool.frame();
    auto groom = std::make_shared<const Groom>();
    const std::weak_ptr<const Groom> kept = groom;
    frame->groups.push_back({.groom = std::move(groom), .positions = std::vector<float>(1000, 1.0F)});
    const StrandFrame* address = frame.get();
    const float* memory = frame->groups.front().positions.data();
    QVERIFY(!kept.expired());
    frame.reset();
    QVERIFY(kept.expired());
    frame = pool.frame();
    QCOMPARE(frame.get(), address);
    QCOMPARE(frame->groups.front().positions.data(), memory);
    QVERIFY(frame->groups.front().positions.capacity() >= 1000);
}

void TestFramePool::framesOfMoreHairThanThereIsAreForgotten()
{
    const auto write = [](StrandFrame& frame, std::size_t floats) {
        frame.groups.resize(1);
        frame.groups.front().positions.resize(floats);
    };
    FramePool pool;
    std::shared_ptr<StrandFrame> waiting = pool.frame();
    write(*waiting, 100'000);
    std::shared_ptr<StrandFrame> shown = pool.frame();
    write(*shown, 100'000);
    pool.written(*shown);
    waiting.reset();
    {
        const std::shared_ptr<StrandFrame> fewer = pool.frame();
        QVERIFY(fewer->groups.front().positions.capacity() >= 100'000); // As large as those before, until it is known.
        write(*fewer, 1000);
        pool.written(*fewer);
        QVERIFY(fewer->groups.front().positions.capacity() <= 2000);
    }
    shown.reset(); // Somebody held it for longer.
    for (int i = 0; i < 3; ++i) {
        const std::shared_ptr<StrandFrame> next = pool.frame();
        QVERIFY(next->groups.empty() || next->groups.front().positions.capacity() <= 2000);
    }
}

void TestFramePool::framesOutliveThePool()
{
    auto pool = std::make_unique<FramePool>();
    std::shared_ptr<StrandFrame> frame = pool->frame();
    pool.reset();
    frame->groups.resize(1);
    frame.reset();
}

HAIRPAINT_TEST(TestFramePool, None)
#include "test_frame_pool.moc"
