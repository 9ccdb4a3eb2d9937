// ties_dab/hairs:H: bringing the groom of a head whose hair is all in one ponytail up to date after a dab over one per
// cent of the head that lets hair go, or gathers it again.
// ties_drag/hairs:H: a frame while its tie is dragged: groom, two steps of motion, positions.
// ties_frame/hairs:H/tied:T: a frame in wind, with all hair in the ponytail or none.
#include "bench_scene.h"

#include "sim/motion/simulation.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>

namespace {

using namespace hairpaint;

sim::GroomInput ponytailOf(int hairs)
{
    sim::GroomInput input = bench::sceneOf(hairs, 8, false);
    input.distances = sim::DistanceGrid::make(input.skin->mesh());
    sim::GroomInput::Group& group = input.groups.front();
    const sim::SurfacePoint foot = input.skin->nearest({0.0F, 0.2F, -0.25F});
    group.ties.push_back({.number = 1,
                          .pointHd = foot.positionHd + foot.normalHd * 0.01F,
                          .directionHd = glm::normalize(glm::vec3(0.0F, 0.3F, -1.0F))});
    group.gathered = std::make_shared<const sim::TiledRaster>(1024, 1, sim::Texel{1});
    return input;
}

void tiesDab(benchmark::State& state)
{
    sim::GroomInput input = ponytailOf(static_cast<int>(state.range(0)));
    sim::GroomBuilder builder;
    benchmark::DoNotOptimize(builder.update(input));
    sim::MapRaster& gathered = input.groups.front().gathered;
    std::uint16_t number = 0;
    std::size_t rebuilt = 0;
    for ([[maybe_unused]] auto step : state) {
        state.PauseTiming();
        auto painted = std::make_shared<sim::TiledRaster>(*gathered);
        for (int y = 300; y < 400; ++y)
            for (int x = 500; x < 600; ++x)
                painted->setTexel(x, y, {number});
        gathered = painted;
        number = number == 0 ? 1 : 0;
        state.ResumeTiming();
        rebuilt += builder.update(input).rebuiltStrands;
    }
    state.counters["rebuilt"] = benchmark::Counter(static_cast<double>(rebuilt), benchmark::Counter::kAvgIterations);
}

void tiesDrag(benchmark::State& state)
{
    sim::GroomInput input = ponytailOf(static_cast<int>(state.range(0)));
    sim::Simulation simulation;
    simulation.setInput(input);
    simulation.settle(1.0);
    sim::StrandFrame frame;
    float stepM = 0.001F;
    int count = 0;
    for ([[maybe_unused]] auto step : state) {
        if (++count % 20 == 0)
            stepM = -stepM;
        input.groups.front().ties.front().pointHd.x += stepM;
        simulation.setInput(input);
        simulation.advance(1.0 / 60.0);
        simulation.writeFrame(frame);
    }
}

void tiesFrame(benchmark::State& state)
{
    sim::GroomInput input = ponytailOf(static_cast<int>(state.range(0)));
    if (state.range(1) == 0)
        input.groups.front().ties.clear();
    sim::Simulation simulation;
    simulation.setInput(input);
    simulation.setWind({.velocity = {2.0F, 0.0F, 1.0F}});
    sim::StrandFrame frame;
    for ([[maybe_unused]] auto step : state) {
        simulation.advance(1.0 / 60.0);
        simulation.writeFrame(frame);
    }
}

BENCHMARK(tiesDab)->Name("ties_dab")->ArgNames({"hairs"})->Arg(60000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(tiesDrag)->Name("ties_drag")->ArgNames({"hairs"})->Arg(60000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(tiesFrame)
    ->Name("ties_frame")
    ->ArgNames({"hairs", "tied"})
    ->Args({60000, 0})
    ->Args({60000, 1})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
