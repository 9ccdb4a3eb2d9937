// Grooms, groups, head and air, brought together and stepped.
#include "sim/motion/simulation.h"

#include "sim/motion/group_dynamics.h"
#include "sim/motion/head_motion.h"
#include "sim/motion/wind_field.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>

namespace hairpaint::sim {

namespace {

constexpr int kMostStepsAtOnce = 8;
/// Fraction of a step that sums of frame times may fall short of whole steps by.
constexpr double kRounding = 1e-6;

/// Whether any hair's root lies lower than that on the head.
bool growsBelow(std::span<const std::shared_ptr<const Groom>> grooms, float heightY)
{
    return std::ranges::any_of(grooms, [heightY](const std::shared_ptr<const Groom>& groom) {
        for (std::size_t index = 0; index < groom->chunks.size(); ++index) {
            if (groom->chunks[index] == nullptr)
                continue;
            for (std::size_t local = 0; local < kChunkSlots; ++local)
                if (groom->chunks[index]->hairs[local] &&
                    groom->roots->positionHd[index * kChunkSlots + local].y < heightY)
                    return true;
        }
        return false;
    });
}

} // namespace

struct Simulation::State
{
    GroomBuilder builder;
    ColliderSet colliders;
    std::vector<std::unique_ptr<GroupDynamics>> groups;
    WindField air;
    Neck neck;
    HeadPose pose;         ///< At the present step,
    HeadPose poseBefore;   ///< the one before,
    HeadPose poseWanted;   ///< and as last set.
    double leftover = 0.0; ///< Time since the present step, s.
    double simulatedSeconds = 0.0;
    double stepMilliseconds = 0.0;
    std::size_t rebuilt = 0;
    std::uint64_t revision = 0; ///< GroomInput::revision of the last input.
    bool preview = false;       ///< GroomInput::preview of the last input.

    [[nodiscard]] bool asleep() const
    {
        return pose == poseWanted && poseBefore == pose && !air.blows() &&
               std::all_of(groups.begin(), groups.end(), [](const auto& group) { return group->asleep(); });
    }
    void run(int count);
};

/// The head reaches its wanted pose with the last of the steps.
void Simulation::State::run(int count)
{
    const HeadPose start = pose;
    if (start != poseWanted || poseBefore != pose) {
        for (auto& group : groups)
            group->wake();
    }
    const auto began = std::chrono::steady_clock::now();
    for (int done = 0; done < count;) {
        std::array<StepForces, kMostStepsAtOnce> steps;
        const int batch = std::min(count - done, kMostStepsAtOnce);
        for (int i = 0; i < batch; ++i) {
            poseBefore = pose;
            pose = mixPoses(start, poseWanted, static_cast<float>(done + i + 1) / static_cast<float>(count));
            StepForces& step = steps[static_cast<std::size_t>(i)];
            step = air.nextStep(poseBefore, pose);
            step.neck = neckTurn(neck, pose);
        }
        for (auto& group : groups)
            group->step(std::span(steps).first(static_cast<std::size_t>(batch)));
        done += batch;
    }
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - began;
    stepMilliseconds = took.count() / count;
    simulatedSeconds += count * kStepSeconds;
}

Simulation::Simulation() : m_state(std::make_unique<State>()) {}

Simulation::~Simulation() = default;

void Simulation::setInput(const GroomInput& input)
{
    State& s = *m_state;
    const GroomBuilder::Report report = s.builder.update(input);
    s.rebuilt += report.rebuiltStrands;
    s.revision = input.revision;
    s.preview = input.preview;
    s.colliders = prepareColliders(input.colliders, input.distances);
    s.neck = input.neck;
    if (s.neck.hasShoulders() && growsBelow(report.grooms, s.neck.headY))
        s.neck.shouldersY = s.neck.headY;
    StepForces calm = WindField::calm(s.pose);
    calm.neck = neckTurn(s.neck, s.pose);
    std::vector<std::unique_ptr<GroupDynamics>> groups;
    groups.reserve(report.grooms.size());
    for (const std::shared_ptr<const Groom>& groom : report.grooms) {
        const auto known = std::find_if(s.groups.begin(), s.groups.end(), [&](const auto& group) {
            return group && group->groom()->groupId == groom->groupId;
        });
        groups.push_back(known != s.groups.end() ? std::move(*known) : std::make_unique<GroupDynamics>());
        groups.back()->setGroom(groom, s.colliders, calm, input.neck);
    }
    s.groups = std::move(groups);
}

void Simulation::setWind(const Wind& wind)
{
    m_state->air.setWind(wind);
}

void Simulation::setPose(const HeadPose& pose)
{
    m_state->poseWanted = sanePose(pose, m_state->poseWanted);
}

void Simulation::puff(glm::vec3 centreWo, glm::vec3 velocity, float radiusM)
{
    m_state->air.puff(centreWo, velocity, radiusM);
}

void Simulation::reset()
{
    State& s = *m_state;
    s.pose = s.poseBefore = s.poseWanted;
    s.leftover = 0.0;
    for (auto& group : s.groups)
        group->reset();
}

void Simulation::hangAnew()
{
    State& s = *m_state;
    s.pose = s.poseBefore = s.poseWanted;
    s.leftover = 0.0;
    StepForces calm = WindField::calm(s.pose);
    calm.neck = neckTurn(s.neck, s.pose);
    for (auto& group : s.groups)
        group->hangAnew(calm);
}

void Simulation::advance(double seconds)
{
    State& s = *m_state;
    if (!(seconds > 0.0) || s.asleep())
        return;
    s.leftover += std::min(seconds, 1.0);
    const int due = static_cast<int>(std::floor(s.leftover / kStepSeconds + kRounding));
    if (due == 0)
        return;
    s.run(std::min(due, kMostStepsAtOnce));
    s.leftover = due > kMostStepsAtOnce ? 0.0 : std::max(0.0, s.leftover - due * kStepSeconds);
}

void Simulation::settle(double seconds)
{
    State& s = *m_state;
    if (!(seconds > 0.0))
        return;
    const auto steps = static_cast<long>(std::floor(std::min(seconds, 3600.0) / kStepSeconds + 0.5));
    for (long done = 0; done < steps && !s.asleep(); done += kMostStepsAtOnce)
        s.run(static_cast<int>(std::min<long>(kMostStepsAtOnce, steps - done)));
    s.leftover = 0.0;
    s.poseBefore = s.pose;
}

bool Simulation::asleep() const
{
    return m_state->asleep();
}

bool Simulation::isNew() const
{
    return std::ranges::all_of(m_state->groups, [](const auto& group) { return group->isNew(); });
}

void Simulation::writeFrame(StrandFrame& frame, float detail) const
{
    const State& s = *m_state;
    // Without time left over the present step is now; otherwise now lies between the two.
    const auto fraction = static_cast<float>(std::clamp(s.leftover / kStepSeconds, 0.0, 1.0));
    const bool atPresent = s.asleep();
    const float moment = atPresent ? 1.0F : fraction;
    frame.pose = atPresent ? s.pose : mixPoses(s.poseBefore, s.pose, moment);
    frame.neck = s.neck;
    frame.groups.resize(s.groups.size());
    frame.hairCount = 0;
    frame.basisCount = 0;
    frame.limit = HairLimit::None;
    for (std::size_t i = 0; i < s.groups.size(); ++i) {
        frame.groups[i].detail = detail;
        s.groups[i]->write(frame.groups[i], moment, frame.pose, s.neck);
        const Groom& groom = *s.groups[i]->groom();
        frame.hairCount += groom.hairCount;
        frame.basisCount += groom.basisCount + (groom.tails ? groom.tails->basisCount : 0);
        if (frame.limit == HairLimit::None)
            frame.limit = groom.limit;
    }
    frame.simulatedSeconds = s.simulatedSeconds;
    frame.stepMilliseconds = s.stepMilliseconds;
    frame.asleep = s.asleep();
    frame.rebuiltStrands = s.rebuilt;
    frame.revision = s.revision;
    frame.preview = s.preview;
}

std::size_t Simulation::rebuiltStrands() const
{
    return m_state->rebuilt;
}

} // namespace hairpaint::sim
