// sim_step/hairs:H/nodes:N/threads:T/skin:S: one step of H basis hairs with wind, gel, three ellipsoids and two length
// iterations. body_step/body_percent:B/threads:T: one step of the 4096 basis hairs, of 8 nodes, that stand for 100,000,
// with skin and wind; B 0 is without body. body_share/threads:T: the same without and with half of body by turns, so
// that whatever else the machine does slows down both; share_percent is what body adds.
// dependents/hairs:H/nodes:N/threads:T/skin:S/curled:C: one frame of H hairs around 4096 basis hairs. With skin:1 they
// are kept out of the skin, too; with curled:1 they are coils of 3A, else straight.
#include "bench_scene.h"

#include "model/project/hair_types.h"
#include "sim/base/parallel.h"
#include "sim/motion/simulation.h"
#include "sim/solver/body_kernel.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

namespace {

using namespace hairpaint;

const sim::Wind kBreeze{true, glm::vec3(3.0F, 0.0F, 1.0F), 0.5F, 0.3F};

sim::GroomInput withSkin(sim::GroomInput input, bool wanted)
{
    if (wanted)
        input.distances = sim::DistanceGrid::make(input.skin->mesh());
    return input;
}

void simStep(benchmark::State& state)
{
    sim::setThreadCount(static_cast<int>(state.range(2)));
    sim::Simulation simulation;
    simulation.setInput(withSkin(
        bench::sceneOf(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), true), state.range(3) != 0));
    simulation.setWind(kBreeze);
    simulation.settle(0.5);
    // As in a program that shows 60 frames a second: two steps each time.
    constexpr int kSteps = 2;
    while (state.KeepRunningBatch(kSteps))
        simulation.advance(kSteps * sim::kStepSeconds);
    const double nodeSteps =
        static_cast<double>(state.iterations()) * static_cast<double>(state.range(0) * state.range(1));
    state.counters["ns_per_node"] =
        benchmark::Counter(nodeSteps * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    sim::setThreadCount(0);
}

/// Long hair on a head, as most who open the program see it move: all of its basis hairs, without the others.
void beginBody(sim::Simulation& simulation, float body)
{
    sim::GroomInput input = withSkin(bench::sceneOf(100000, 8, false), true);
    input.groups.front().settings.physics.body = body;
    simulation.setInput(input);
    simulation.setWind(kBreeze);
    simulation.settle(0.5);
}

void bodyStep(benchmark::State& state)
{
    sim::setThreadCount(static_cast<int>(state.range(1)));
    sim::Simulation simulation;
    beginBody(simulation, 0.01F * static_cast<float>(state.range(0)));
    constexpr int kSteps = 2;
    while (state.KeepRunningBatch(kSteps))
        simulation.advance(kSteps * sim::kStepSeconds);
    sim::setThreadCount(0);
}

void bodyShare(benchmark::State& state)
{
    using Clock = std::chrono::steady_clock;
    sim::setThreadCount(static_cast<int>(state.range(0)));
    constexpr int kSteps = 2;
    constexpr std::size_t kAdvances = sim::kStepsAGrid; // After so many, grids are made at the same ones again.
    std::array<sim::Simulation, 2> simulations;
    std::array<std::array<std::vector<double>, kAdvances>, 2> taken;
    for (std::size_t body = 0; body < simulations.size(); ++body)
        beginBody(simulations[body], body == 0 ? 0.0F : 0.5F);
    for ([[maybe_unused]] auto turn : state) {
        static_cast<void>(turn);
        for (std::size_t body = 0; body < simulations.size(); ++body)
            for (std::vector<double>& times : taken[body]) {
                const Clock::time_point begin = Clock::now();
                simulations[body].advance(kSteps * sim::kStepSeconds);
                times.push_back(std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
            }
    }
    // Others on the machine only ever add: a low time is nearest to what an advance costs.
    const auto low = [](std::array<std::vector<double>, kAdvances>& advances) {
        double sum = 0.0;
        for (std::vector<double>& times : advances) {
            const auto at = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 20);
            std::nth_element(times.begin(), at, times.end());
            sum += *at;
        }
        return sum / (kSteps * static_cast<double>(kAdvances));
    };
    const double without = low(taken[0]);
    const double with = low(taken[1]);
    state.counters["off_us"] = without;
    state.counters["on_us"] = with;
    state.counters["share_percent"] = 100.0 * (with / without - 1.0);
    sim::setThreadCount(0);
}

void dependents(benchmark::State& state)
{
    sim::setThreadCount(static_cast<int>(state.range(2)));
    sim::Simulation simulation;
    const bool curled = state.range(4) != 0;
    sim::GroomInput input = bench::sceneOf(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), false);
    sim::GroomInput::Group& group = input.groups.front();
    group.maps[sim::MapSlot::Curl] = std::make_shared<const sim::TiledRaster>(
        group.maps[sim::MapSlot::Curl]->size(), 1, sim::Texel{static_cast<std::uint16_t>(curled ? 65535 : 0)});
    model::setHairType(group.settings, model::hairType(curled ? "3A" : "1A"));
    simulation.setInput(withSkin(std::move(input), state.range(3) != 0));
    simulation.setWind(kBreeze);
    simulation.settle(0.5);
    sim::StrandFrame frame;
    for ([[maybe_unused]] auto step : state) {
        static_cast<void>(step);
        simulation.writeFrame(frame);
        benchmark::DoNotOptimize(frame.groups.front().positions.data());
    }
    const double nodes = static_cast<double>(state.iterations()) * static_cast<double>(state.range(0) * state.range(1));
    state.counters["ns_per_node"] =
        benchmark::Counter(nodes * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    sim::setThreadCount(0);
}

BENCHMARK(simStep)
    ->Name("sim_step")
    ->ArgNames({"hairs", "nodes", "threads", "skin"})
    ->ArgsProduct({{10000, 100000, 1000000}, {5}, {1, 2}, {0, 1}})
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
BENCHMARK(bodyStep)
    ->Name("body_step")
    ->ArgNames({"body_percent", "threads"})
    ->ArgsProduct({{0, 50}, {1, 2}})
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
BENCHMARK(bodyShare)
    ->Name("body_share")
    ->ArgName("threads")
    ->DenseRange(1, 2)
    ->MinTime(3.0)
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
BENCHMARK(dependents)
    ->Name("dependents")
    ->ArgNames({"hairs", "nodes", "threads", "skin", "curled"})
    ->ArgsProduct({{100000}, {8}, {1, 2}, {0, 1}, {0, 1}})
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();

} // namespace
