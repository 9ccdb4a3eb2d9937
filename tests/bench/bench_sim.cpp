// sim_step/hairs:H/nodes:N/threads:T/skin:S: one step of H basis hairs with wind, gel, three ellipsoids and two length
// iterations. body_step/body_percent:B/threads:T: one step of the 4096 basis hairs, of 8 nodes, that stand for 100,000,
// with skin and wind; B 0 is without body. dependents/hairs:H/nodes:N/threads:T/skin:S: one frame of H hairs around
// 4096 basis hairs. With skin:1 they are kept out of the skin, too.
#include "bench_scene.h"

#include "sim/base/parallel.h"
#include "sim/motion/simulation.h"

#include <benchmark/benchmark.h>

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
void bodyStep(benchmark::State& state)
{
    sim::setThreadCount(static_cast<int>(state.range(1)));
    sim::GroomInput input = withSkin(bench::sceneOf(100000, 8, false), true);
    input.groups.front().settings.physics.body = 0.01F * static_cast<float>(state.range(0));
    sim::Simulation simulation;
    simulation.setInput(input);
    simulation.setWind(kBreeze);
    simulation.settle(0.5);
    constexpr int kSteps = 2;
    while (state.KeepRunningBatch(kSteps))
        simulation.advance(kSteps * sim::kStepSeconds);
    sim::setThreadCount(0);
}

void dependents(benchmark::State& state)
{
    sim::setThreadCount(static_cast<int>(state.range(2)));
    sim::Simulation simulation;
    simulation.setInput(
        withSkin(bench::sceneOf(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), false),
                 state.range(3) != 0));
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
BENCHMARK(dependents)
    ->Name("dependents")
    ->ArgNames({"hairs", "nodes", "threads", "skin"})
    ->ArgsProduct({{100000}, {8}, {1, 2}, {0, 1}})
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();

} // namespace
