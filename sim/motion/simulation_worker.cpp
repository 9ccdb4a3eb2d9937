// The simulation's thread: takes what arrived, steps by the clock, publishes frames, sleeps when nothing moves.
#include "sim/motion/simulation_worker.h"

#include "sim/base/mailbox.h"
#include "sim/motion/frame_pool.h"
#include "sim/motion/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace hairpaint::sim {

namespace {

using Clock = std::chrono::steady_clock;

struct PuffRequest
{
    glm::vec3 centreWo{0.0F};
    glm::vec3 velocity{0.0F};
    float radiusM = 0.0F;
};

/// What was asked for since the worker last looked.
struct Requests
{
    std::optional<GroomInput> input;
    std::optional<Wind> wind;
    std::optional<HeadPose> pose;
    std::optional<bool> paused;
    std::optional<double> frameRate;
    std::vector<PuffRequest> puffs;
    bool reset = false;
    bool stop = false;
};

constexpr std::size_t kMostPuffs = 8;

} // namespace

struct SimulationWorker::State
{
    std::function<void()> onFrame;
    Mailbox<Requests> requests;
    Mailbox<std::shared_ptr<const StrandFrame>> frames;
    std::thread thread;

    void run();
};

namespace {

/// What the worker's thread owns.
class Runner
{
public:
    Runner(Mailbox<std::shared_ptr<const StrandFrame>>& frames, const std::function<void()>& onFrame)
        : m_frames(frames), m_onFrame(onFrame)
    {}

    /// Nothing will move until something arrives.
    [[nodiscard]] bool idle() const { return !m_stale && (m_paused || m_simulation.asleep()); }
    [[nodiscard]] Clock::time_point nextFrame() const { return m_next; }

    void apply(Requests&& requests)
    {
        if (requests.frameRate)
            m_period = std::chrono::duration<double>(1.0 / *requests.frameRate);
        if (requests.paused)
            m_paused = *requests.paused;
        if (requests.pose)
            m_simulation.setPose(*requests.pose);
        if (requests.input)
            m_simulation.setInput(*requests.input);
        if (requests.wind)
            m_simulation.setWind(*requests.wind);
        for (const PuffRequest& puff : requests.puffs)
            m_simulation.puff(puff.centreWo, puff.velocity, puff.radiusM);
        if (requests.reset)
            m_simulation.reset();
        m_stale = m_stale || requests.input || requests.reset;
    }

    /// After a wait of any length: the clock starts anew.
    void restartClock()
    {
        m_last = Clock::now();
        m_next = m_last;
    }

    void frame()
    {
        const Clock::time_point now = Clock::now();
        const std::chrono::duration<double> elapsed = now - m_last;
        m_last = now;
        // Behind by more than a frame: the frames missed are dropped, not caught up with.
        m_next = std::max(m_next + std::chrono::duration_cast<Clock::duration>(m_period), now);
        if (!m_paused)
            m_simulation.advance(elapsed.count());
        const std::shared_ptr<StrandFrame> frame = m_pool.frame();
        m_simulation.writeFrame(*frame);
        frame->number = ++m_number;
        m_stale = false;
        m_frames.put(frame);
        if (m_onFrame)
            m_onFrame();
    }

private:
    Mailbox<std::shared_ptr<const StrandFrame>>& m_frames;
    const std::function<void()>& m_onFrame;
    Simulation m_simulation;
    FramePool m_pool;
    std::chrono::duration<double> m_period{1.0 / 60.0};
    Clock::time_point m_last = Clock::now();
    Clock::time_point m_next = m_last;
    std::uint64_t m_number = 0;
    bool m_paused = false;
    bool m_stale = false; ///< The last frame does not show what is there now.
};

} // namespace

void SimulationWorker::State::run()
{
    Runner runner(frames, onFrame);
    for (;;) {
        std::optional<Requests> arrived;
        if (runner.idle()) {
            arrived = requests.waitAndTake();
            runner.restartClock();
        } else {
            arrived = requests.takeUntil(runner.nextFrame());
        }
        if (arrived) {
            if (arrived->stop)
                return;
            runner.apply(*std::move(arrived));
            // A frame that is due comes also where more arrives all the time, faster than it is taken in.
            if (runner.idle() || Clock::now() < runner.nextFrame())
                continue;
        }
        runner.frame();
    }
}

SimulationWorker::SimulationWorker(std::function<void()> onFrame) : m_state(std::make_unique<State>())
{
    m_state->onFrame = std::move(onFrame);
    m_state->thread = std::thread([state = m_state.get()] { state->run(); });
}

SimulationWorker::~SimulationWorker()
{
    m_state->requests.update([](Requests& r) { r.stop = true; });
    m_state->thread.join();
}

void SimulationWorker::setInput(GroomInput input)
{
    m_state->requests.update([&](Requests& r) { r.input = std::move(input); });
}

void SimulationWorker::setWind(const Wind& wind)
{
    m_state->requests.update([&](Requests& r) { r.wind = wind; });
}

void SimulationWorker::setPose(const HeadPose& pose)
{
    m_state->requests.update([&](Requests& r) { r.pose = pose; });
}

void SimulationWorker::puff(glm::vec3 centreWo, glm::vec3 velocity, float radiusM)
{
    m_state->requests.update([&](Requests& r) {
        if (r.puffs.size() == kMostPuffs)
            r.puffs.erase(r.puffs.begin());
        r.puffs.push_back({centreWo, velocity, radiusM});
    });
}

void SimulationWorker::reset()
{
    m_state->requests.update([](Requests& r) { r.reset = true; });
}

void SimulationWorker::setPaused(bool paused)
{
    m_state->requests.update([&](Requests& r) { r.paused = paused; });
}

void SimulationWorker::setFrameRate(double framesPerSecond)
{
    if (std::isfinite(framesPerSecond))
        m_state->requests.update([&](Requests& r) { r.frameRate = std::clamp(framesPerSecond, 1.0, 240.0); });
}

std::shared_ptr<const StrandFrame> SimulationWorker::takeFrame()
{
    return m_state->frames.take().value_or(nullptr);
}

} // namespace hairpaint::sim
