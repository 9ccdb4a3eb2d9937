// The simulation's thread: takes what arrived, steps by the clock, publishes frames, sleeps when nothing moves.
#include "sim/motion/simulation_worker.h"

#include "sim/base/mailbox.h"
#include "sim/base/parallel.h"
#include "sim/motion/frame_pool.h"
#include "sim/motion/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <exception>
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
    std::optional<float> detail;
    std::vector<PuffRequest> puffs;
    bool reset = false;
    bool stop = false;
};

constexpr std::size_t kMostPuffs = 8;
constexpr float kLeastDetail = 1.0F / 1024.0F;
/// The simulation drops what lies behind more than a few steps, so it is advanced at least so often.
constexpr double kLongestTickSeconds = 1.0 / 30.0;
/// What hair that is all new falls before it is first seen, unless it takes longer than that.
constexpr double kFirstFallSeconds = 5.0;

} // namespace

struct SimulationWorker::State
{
    std::function<void()> onFrame;
    std::chrono::milliseconds longestFall;
    Mailbox<Requests> requests;
    Mailbox<std::shared_ptr<const StrandFrame>> frames;
    Mailbox<std::uint64_t> failed; ///< The content's revision.
    std::thread thread;

    void run();
};

namespace {

/// What the worker's thread owns.
class Runner
{
public:
    Runner(Mailbox<std::shared_ptr<const StrandFrame>>& frames, const std::function<void()>& onFrame,
           std::chrono::milliseconds longestFall)
        : m_frames(frames), m_onFrame(onFrame), m_longestFall(longestFall)
    {}

    /// Nothing will move until something arrives.
    [[nodiscard]] bool idle() const { return !m_simulation || (!m_stale && (m_paused || m_simulation->asleep())); }
    [[nodiscard]] std::uint64_t revision() const { return m_input.revision; }
    [[nodiscard]] Clock::time_point nextTick() const { return m_nextTick; }

    void apply(Requests&& requests)
    {
        if (requests.frameRate)
            m_period = std::chrono::duration<double>(1.0 / *requests.frameRate);
        if (requests.paused)
            m_paused = *requests.paused;
        if (requests.pose)
            m_pose = *requests.pose;
        if (requests.wind)
            m_wind = *requests.wind;
        const bool finer = requests.detail && *requests.detail > m_detail;
        if (requests.detail)
            m_detail = *requests.detail;
        const bool renewed = requests.input || requests.reset;
        if (requests.input)
            m_input = *std::move(requests.input);
        if (!m_simulation && !renewed)
            return; // It failed on this content before.
        if (!m_simulation) {
            m_simulation = std::make_unique<Simulation>();
            m_simulation->setPose(m_pose);
            m_simulation->setWind(m_wind);
            m_simulation->setInput(m_input);
        } else {
            if (requests.pose)
                m_simulation->setPose(m_pose);
            if (requests.input)
                m_simulation->setInput(m_input);
            if (requests.wind)
                m_simulation->setWind(m_wind);
        }
        for (const PuffRequest& puff : requests.puffs)
            m_simulation->puff(puff.centreWo, puff.velocity, puff.radiusM);
        if (requests.reset)
            m_simulation->hangAnew();
        if (requests.input && !m_wind.enabled && m_simulation->isNew())
            bringToRest();
        m_stale = m_stale || renewed || finer;
    }

    /// After a wait of any length: the clock starts anew.
    void restartClock()
    {
        m_last = Clock::now();
        m_nextTick = m_last;
        m_nextFrame = m_last;
    }

    /// Advances to now, and makes a frame where one is due.
    void tick()
    {
        const Clock::time_point now = Clock::now();
        const std::chrono::duration<double> elapsed = now - m_last;
        m_last = now;
        // Behind by more than a tick: those missed are dropped, not caught up with.
        const auto after = [now](Clock::time_point time, double seconds) {
            return std::max(time + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)),
                            now);
        };
        m_nextTick = after(m_nextTick, std::min(m_period.count(), kLongestTickSeconds));
        if (!m_paused)
            m_simulation->advance(elapsed.count());
        if (now < m_nextFrame && !m_stale && !m_simulation->asleep())
            return;
        m_nextFrame = after(m_nextFrame, m_period.count());
        const std::shared_ptr<StrandFrame> frame = m_pool.frame();
        m_simulation->writeFrame(*frame, m_detail);
        m_pool.written(*frame);
        frame->number = ++m_number;
        m_stale = false;
        m_frames.put(frame);
        if (m_onFrame)
            m_onFrame();
    }

    /// Memory ran out somewhere within: nothing of it can be relied on.
    void giveUp()
    {
        m_simulation.reset();
        m_stale = false;
    }

private:
    void bringToRest()
    {
        constexpr double kAtOnceSeconds = 0.2;
        const Clock::time_point latest = Clock::now() + m_longestFall;
        for (double fallen = 0.0; fallen < kFirstFallSeconds && Clock::now() < latest; fallen += kAtOnceSeconds)
            m_simulation->settle(kAtOnceSeconds);
    }

    Mailbox<std::shared_ptr<const StrandFrame>>& m_frames;
    const std::function<void()>& m_onFrame;
    const std::chrono::milliseconds m_longestFall;
    std::unique_ptr<Simulation> m_simulation = std::make_unique<Simulation>(); ///< Null: it failed.
    GroomInput m_input;                                                        ///< The last of each that was asked for.
    Wind m_wind;
    HeadPose m_pose;
    FramePool m_pool;
    std::chrono::duration<double> m_period{1.0 / 60.0};
    Clock::time_point m_last = Clock::now();
    Clock::time_point m_nextTick = m_last;
    Clock::time_point m_nextFrame = m_last;
    std::uint64_t m_number = 0;
    float m_detail = 1.0F;
    bool m_paused = false;
    bool m_stale = false; ///< The last frame does not show what is there now.
};

} // namespace

void SimulationWorker::State::run()
{
    const ArenaScope arena(Arena::Simulation);
    Runner runner(frames, onFrame, longestFall);
    for (;;) {
        std::optional<Requests> arrived;
        if (runner.idle()) {
            arrived = requests.waitAndTake();
            runner.restartClock();
        } else {
            arrived = requests.takeUntil(runner.nextTick());
        }
        if (arrived && arrived->stop)
            return;
        try {
            if (arrived) {
                runner.apply(*std::move(arrived));
                // A frame that is due comes also where more arrives all the time, faster than it is taken in.
                if (runner.idle() || Clock::now() < runner.nextTick())
                    continue;
            }
            runner.tick();
        } catch (const std::exception&) {
            runner.giveUp();
            failed.put(runner.revision());
            if (onFrame)
                onFrame();
        }
    }
}

SimulationWorker::SimulationWorker(std::function<void()> onFrame, std::chrono::milliseconds longestFall)
    : m_state(std::make_unique<State>())
{
    m_state->onFrame = std::move(onFrame);
    m_state->longestFall = longestFall;
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

void SimulationWorker::setDetail(float detail)
{
    m_state->requests.update([&](Requests& r) { r.detail = std::clamp(detail, kLeastDetail, 1.0F); });
}

bool SimulationWorker::resting() const
{
    return m_state->requests.awaited();
}

std::shared_ptr<const StrandFrame> SimulationWorker::takeFrame()
{
    return m_state->frames.take().value_or(nullptr);
}

std::optional<std::uint64_t> SimulationWorker::takeFailure()
{
    return m_state->failed.take();
}

} // namespace hairpaint::sim
