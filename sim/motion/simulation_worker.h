// Runs a Simulation on its own thread in real time.
#pragma once

#include "sim/groom/groom_input.h"
#include "sim/motion/strand_frame.h"
#include "sim/motion/wind.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace hairpaint::sim {

/// Every method is called from one thread (the GUI's) and returns at once. `onFrame` is called on the worker's thread
/// after each new frame and each failure; it should only wake the GUI thread, which then calls takeFrame() and
/// takeFailure().
///
/// Where memory runs out the last frame stays the newest one, and the content is tried again when it is next set.
class SimulationWorker
{
public:
    /// `longestFall`: after so long new hair is shown as far as it has fallen, see setInput.
    explicit SimulationWorker(std::function<void()> onFrame,
                              std::chrono::milliseconds longestFall = std::chrono::milliseconds(150));
    ~SimulationWorker(); ///< Stops and joins.
    SimulationWorker(const SimulationWorker&) = delete;
    SimulationWorker& operator=(const SimulationWorker&) = delete;

    /// Latest wins. Hair of which nothing was there before is first seen at rest, or nearly, unless it is windy.
    void setInput(GroomInput input);
    void setWind(const Wind& wind);     ///< Latest wins.
    void setPose(const HeadPose& pose); ///< Latest wins.
    void puff(glm::vec3 centreWo, glm::vec3 velocity, float radiusM);
    void reset(); ///< Every strand hangs anew.
    void setPaused(bool paused);
    /// Frames a second wanted at most, 1..240; the GUI lowers it where drawing is slow. The motion keeps its pace:
    /// what is saved is the dependents of frames that nobody would see. New content comes at once all the same.
    void setFrameRate(double framesPerSecond);

    /// Which hairs have positions in frames, see GroupFrame; all unless told. More of them come at once, though nothing
    /// moves.
    void setDetail(float detail);

    /// Nothing moves and all that was asked for is done: no frame comes before something else is asked for.
    [[nodiscard]] bool resting() const;

    /// The newest frame since the last call, or null.
    [[nodiscard]] std::shared_ptr<const StrandFrame> takeFrame();
    /// The revision of the newest content that could not be made into hair, for want of memory, since the last call.
    [[nodiscard]] std::optional<std::uint64_t> takeFailure();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace hairpaint::sim
