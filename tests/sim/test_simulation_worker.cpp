// The worker's thread: frames come by themselves, stop where nothing moves, and the newest input is what they show.
#include "sim/motion/simulation_worker.h"
#include "sim/solver/solver_layout.h"
#include "tests/support/allocation_limit.h"
#include "tests/support/await.h"
#include "tests/support/painted_ball.h"
#include "tests/support/strand_frames.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <thread>
#include <utility>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

/// Waits for a frame that fulfils the condition; null where none comes.
template<typename Condition>
std::shared_ptr<const StrandFrame> awaitFrame(SimulationWorker& worker, Condition condition)
{
    std::shared_ptr<const StrandFrame> frame;
    const bool came = awaitUntil([&] {
        frame = worker.takeFrame();
        return frame && condition(*frame);
    });
    return came ? frame : nullptr;
}

/// Waits until the callback has come so often. The frame of a call can be taken before it.
bool awaitCalls(const std::atomic<int>& calls, int count)
{
    return awaitUntil([&] { return calls >= count; });
}

bool hasHair(const StrandFrame& frame)
{
    return frame.hairCount > 0;
}

const Wind kNoWind{.enabled = false};
const Wind kSideBreeze{true, glm::vec3(3.0F, 0.0F, 0.0F), 0.5F, 0.3F};

} // namespace

class TestSimulationWorker : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void framesComeByThemselvesAndAreNumbered();
    void theLatestInputWins();
    void framesNameTheRevisionTheyShow();
    void inputWithoutEndHoldsUpNoFrames();
    void aPausedWorkerStillShowsNewInput();
    void stillHairStopsTheFramesUntilSomethingHappens();
    void newHairIsFirstSeenAtRest();
    void aFrameKeptStaysAsItWas();
    void itStopsInTheMiddleOfAnything();
    void motionKeepsItsPaceWhereFewFramesAreWanted();
    void wantOfMemoryLeavesTheLastFrameAndIsToldOnce();
    void moreHairsComeThoughNothingMoves();
};

void TestSimulationWorker::moreHairsComeThoughNothingMoves()
{
    SimulationWorker worker(nullptr);
    worker.setDetail(0.25F);
    worker.setPaused(true);
    worker.setInput(paintedBall(3000, 200));
    const auto coarse = awaitFrame(worker, hasHair);
    QVERIFY(coarse);
    QCOMPARE(frameDetail(*coarse), 0.25F);
    worker.setDetail(0.2F); // Fewer change nothing that is there.
    worker.setDetail(1.0F);
    const auto whole = awaitFrame(worker, [](const StrandFrame& frame) { return frameDetail(frame) >= 1.0F; });
    QVERIFY(whole);
    QCOMPARE(whole->number, coarse->number + 1);
    QCOMPARE(whole->simulatedSeconds, coarse->simulatedSeconds);
}

void TestSimulationWorker::framesComeByThemselvesAndAreNumbered()
{
    std::atomic<int> calls{0};
    SimulationWorker worker([&calls] { ++calls; });
    worker.setInput(paintedBall(400, 200));
    worker.setWind(kSideBreeze);
    const auto first = awaitFrame(worker, hasHair);
    QVERIFY(first);
    const auto later = awaitFrame(worker, [&](const StrandFrame& frame) { return frame.number > first->number + 3; });
    QVERIFY(later);
    QVERIFY(later->simulatedSeconds > first->simulatedSeconds);
    QVERIFY(awaitCalls(calls, static_cast<int>(later->number)));
}

void TestSimulationWorker::theLatestInputWins()
{
    SimulationWorker worker(nullptr);
    GroomInput input = paintedBall(400, 200);
    for (int i = 0; i < 20; ++i) {
        input.groups.front().maps[MapSlot::Length] = mapOfTexel(1, {static_cast<std::uint16_t>(10000 + i * 2000)});
        worker.setInput(input);
    }
    const auto shows = [&](const StrandFrame& frame) {
        return hasHair(frame) &&
               std::abs((*frame.groups.front().groom->basis)[BasisQuantity::SegmentLength].front() -
                        0.2F * 48000.0F / 65535.0F / static_cast<float>(frame.groups.front().groom->nodes - 1)) < 1e-5F;
    };
    QVERIFY(awaitFrame(worker, shows));
}

void TestSimulationWorker::framesNameTheRevisionTheyShow()
{
    SimulationWorker worker(nullptr);
    GroomInput input = paintedBall(400, 200);
    input.revision = 7;
    worker.setInput(input);
    const auto first = awaitFrame(worker, [](const StrandFrame& frame) { return frame.revision == 7; });
    QVERIFY(first);
    QVERIFY(hasHair(*first));
    QVERIFY(!first->preview);
    const std::size_t rebuilt = first->rebuiltStrands;
    // The same hair under another name: nothing is rebuilt, yet a frame says so.
    input.revision = 8;
    input.preview = true;
    worker.setInput(input);
    const auto second = awaitFrame(worker, [](const StrandFrame& frame) { return frame.revision == 8; });
    QVERIFY(second);
    QVERIFY(second->preview);
    QCOMPARE(second->rebuiltStrands, rebuilt);
}

void TestSimulationWorker::inputWithoutEndHoldsUpNoFrames()
{
    constexpr std::size_t kHairs = 20000;
    std::atomic<bool> enough{false};
    SimulationWorker worker(nullptr);
    worker.setFrameRate(240.0);
    std::thread flood([&worker, &enough] {
        // Longer to rebuild than until the next one comes.
        std::array inputs{paintedBall(kHairs, 400), paintedBall(kHairs, 400), paintedBall(kHairs, 400)};
        inputs[1].groups.front().maps[MapSlot::Length] = mapOfTexel(1, {30000});
        inputs[2].groups.front().maps[MapSlot::Length] = mapOfTexel(1, {45000});
        for (std::size_t i = 0; !enough; ++i)
            worker.setInput(inputs.at(i % inputs.size()));
    });
    const auto first = awaitFrame(worker, hasHair);
    const auto later =
        first ? awaitFrame(worker, [&](const StrandFrame& frame) { return frame.number > first->number + 20; })
              : nullptr;
    enough = true;
    flood.join();
    QVERIFY(first);
    QVERIFY(later);
}

void TestSimulationWorker::aPausedWorkerStillShowsNewInput()
{
    SimulationWorker worker(nullptr);
    worker.setPaused(true);
    worker.setInput(paintedBall(400, 200));
    worker.setWind(kSideBreeze);
    const auto first = awaitFrame(worker, hasHair);
    QVERIFY(first);
    QCOMPARE(first->simulatedSeconds, 0.0);
    worker.setInput(paintedBall(800, 200));
    const auto second = awaitFrame(worker, [&](const StrandFrame& f) { return f.hairCount > first->hairCount; });
    QVERIFY(second);
    QCOMPARE(second->simulatedSeconds, 0.0);
    worker.setPaused(false);
    QVERIFY(awaitFrame(worker, [](const StrandFrame& frame) { return frame.simulatedSeconds > 0.0; }));
}

void TestSimulationWorker::stillHairStopsTheFramesUntilSomethingHappens()
{
    std::atomic<int> calls{0};
    SimulationWorker worker([&calls] { ++calls; });
    GroomInput input = paintedBall(100, 100);
    input.groups.front().maps[MapSlot::Gel] = mapOfTexel(1, {65535}); // nothing to settle
    worker.setInput(input);
    const auto last = awaitFrame(worker, [](const StrandFrame& frame) { return hasHair(frame) && frame.asleep; });
    QVERIFY(last);
    // One call a frame, and no frame after the one that says so.
    QVERIFY(awaitUntil([&] { return worker.resting(); }));
    QCOMPARE(calls.load(), static_cast<int>(last->number));
    QVERIFY(!worker.takeFrame());
    worker.setWind(kSideBreeze);
    QVERIFY(awaitFrame(worker, [](const StrandFrame& frame) { return !frame.asleep; }));
    QVERIFY(!worker.resting());
}

void TestSimulationWorker::newHairIsFirstSeenAtRest()
{
    SimulationWorker worker(nullptr, std::chrono::hours(1)); // However slow the machine is.
    worker.setWind(kNoWind);
    worker.setInput(paintedBall(400, 200));
    const auto first = awaitFrame(worker, hasHair);
    QVERIFY(first);
    Simulation fallen;
    fallen.setWind(kNoWind);
    fallen.setInput(paintedBall(400, 200));
    fallen.settle(20.0);
    const StrandFrame rest = frameOf(fallen);
    const Groom& groom = *rest.groups.front().groom;
    float farthestM = 0.0F;
    int hairs = 0;
    for (std::size_t slot = 0; slot < groom.chunks.size() * kChunkSlots; ++slot) {
        const std::vector<glm::vec3> seen = nodesOf(*first, slot);
        const std::vector<glm::vec3> lies = nodesOf(rest, slot);
        QCOMPARE(seen.size(), lies.size());
        for (std::size_t node = 0; node < seen.size(); ++node)
            farthestM = std::max(farthestM, glm::distance(seen[node], lies[node]));
        hairs += seen.empty() ? 0 : 1;
    }
    QVERIFY(hairs > 300);
    QVERIFY2(farthestM < 0.002F, qPrintable(QString::number(farthestM)));
}

void TestSimulationWorker::aFrameKeptStaysAsItWas()
{
    SimulationWorker worker(nullptr);
    worker.setInput(paintedBall(400, 200));
    worker.setWind(kSideBreeze);
    const auto kept = awaitFrame(worker, hasHair);
    QVERIFY(kept);
    const std::vector<float> positions = kept->groups.front().positions;
    const std::uint64_t number = kept->number;
    // More frames than the pool has: none of them may be written into the one that is kept.
    QVERIFY(awaitFrame(worker, [&](const StrandFrame& frame) { return frame.number > number + 8; }));
    QCOMPARE(kept->number, number);
    QVERIFY(kept->groups.front().positions == positions);
}

void TestSimulationWorker::itStopsInTheMiddleOfAnything()
{
    std::shared_ptr<const StrandFrame> survivor;
    for (int i = 0; i < 20; ++i) {
        SimulationWorker worker(nullptr);
        worker.setFrameRate(240.0);
        worker.setInput(paintedBall(300, 100));
        worker.setWind(kSideBreeze);
        worker.puff(glm::vec3(0.0F), glm::vec3(1.0F), 0.1F);
        worker.setPose({glm::quat(1.0F, 0.0F, 0.0F, 0.0F), glm::vec3(0.01F * static_cast<float>(i))});
        if (i % 3 == 0)
            worker.reset();
        if (i % 2 == 0)
            survivor = awaitFrame(worker, hasHair);
    }
    QVERIFY(survivor); // a frame outlives its worker
    QVERIFY(!survivor->groups.empty());
}

void TestSimulationWorker::motionKeepsItsPaceWhereFewFramesAreWanted()
{
    SimulationWorker worker(nullptr);
    worker.setFrameRate(2.0);
    worker.setInput(paintedBall(400, 200));
    worker.setWind(kSideBreeze);
    double shown = 0.0;
    std::uint64_t number = 0;
    // More time between two frames that follow each other than one advance of the simulation covers.
    const auto far = awaitFrame(worker, [&](const StrandFrame& frame) {
        const bool next = frame.number == number + 1;
        const double passed = frame.simulatedSeconds - std::exchange(shown, frame.simulatedSeconds);
        number = frame.number;
        return next && hasHair(frame) && passed > 12.0 * kStepSeconds;
    });
    QVERIFY(far);
    // New content is not kept waiting.
    worker.setInput(paintedBall(800, 200));
    QVERIFY(awaitFrame(worker, [&](const StrandFrame& frame) { return frame.hairCount > far->hairCount; }));
}

void TestSimulationWorker::wantOfMemoryLeavesTheLastFrameAndIsToldOnce()
{
    std::atomic<int> calls{0};
    SimulationWorker worker([&calls] { ++calls; });
    GroomInput small = paintedBall(400, 200);
    small.groups.front().maps[MapSlot::Gel] = mapOfTexel(1, {65535});
    worker.setInput(small);
    const auto kept = awaitFrame(worker, [](const StrandFrame& frame) { return hasHair(frame) && frame.asleep; });
    QVERIFY(kept);
    QVERIFY(!worker.takeFailure());
    const int callsBefore = static_cast<int>(kept->number);
    QVERIFY(awaitCalls(calls, callsBefore));
    GroomInput large = paintedBall(200'000, 2'000);
    large.revision = 7;
    {
        const AllocationLimit limit(std::size_t{1} << 18U);
        worker.setInput(large);
        QVERIFY(awaitCalls(calls, callsBefore + 1));
        QCOMPARE(worker.takeFailure().value_or(0), std::uint64_t{7});
        QVERIFY(!worker.takeFailure());
        QVERIFY(!worker.takeFrame());
        QVERIFY(hasHair(*kept));
        // What can't be made is not tried again for the wind's sake, but for new content's.
        worker.setWind(kSideBreeze);
        worker.setInput(large);
        QVERIFY(awaitCalls(calls, callsBefore + 2));
        QCOMPARE(calls.load(), callsBefore + 2);
        QVERIFY(worker.takeFailure());
    }
    // It goes on with what fits, in the wind of meanwhile.
    worker.setInput(paintedBall(800, 200));
    QVERIFY(awaitFrame(worker, [&](const StrandFrame& f) { return f.hairCount > kept->hairCount && !f.asleep; }));
    QVERIFY(!worker.takeFailure());
}

HAIRPAINT_TEST(TestSimulationWorker, None)
#include "test_simulation_worker.moc"
