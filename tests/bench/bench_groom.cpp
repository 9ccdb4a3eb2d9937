// groom_build/hairs:H/varied:V: grooming H hairs from their maps, with roots and neighbours ready; varied 1: each hair
// differs in all that variation has; varied 2: and is coiled in real units, in locks of all that locks have;
// varied 3: and a third of the head is bare, with a hard edge; varied 4: towards which hair softens.
// groom_update_dab/hairs:H: bringing the groom up to date after a dab over one per cent of the head.
// memory/hairs:H: what hairs of 8 nodes take with roots, groom, basis hairs' motion and one frame; bytes_per_hair.
// groom_update_comb/hairs:H: the same after a dab of the comb, whose hairs lie across the head for up to 16 cm.
#include "bench_scene.h"

#include "sim/groom/groom.h"
#include "sim/motion/simulation.h"

#include <benchmark/benchmark.h>

#include <vector>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace {

using namespace hairpaint;

/// Every map has other tiles, so that all hairs are built again while the roots stay.
sim::GroomInput repainted(const sim::GroomInput& input, std::uint16_t length, bool partlyBare)
{
    sim::GroomInput other = input;
    sim::GroupMaps& maps = other.groups.front().maps;
    const int size = maps[sim::MapSlot::Length]->size();
    auto density = std::make_shared<sim::TiledRaster>(size, 1, sim::Texel{65535});
    for (int tile = 0; partlyBare && tile < density->tileCount(); ++tile)
        if (density->tileRect(tile).x0 * 3 < size)
            density->setUniform(tile, {0});
    maps[sim::MapSlot::Density] = std::move(density);
    maps[sim::MapSlot::Length] = std::make_shared<const sim::TiledRaster>(size, 1, sim::Texel{length});
    return other;
}

void groomBuild(benchmark::State& state)
{
    sim::GroomInput input = bench::sceneOf(static_cast<int>(state.range(0)), 8, false);
    if (state.range(1) != 0)
        input.groups.front().settings.variation = {
            .length = 0.08F, .curl = 0.12F, .width = 0.2F, .crossing = 0.08F, .flyaways = 0.012F, .grey = 0.1F};
    if (state.range(1) > 1) {
        sim::GroupSettings& settings = input.groups.front().settings;
        settings.turnsMode = sim::TurnsMode::Coils;
        settings.lengthAsCut = true;
        settings.curl.gather = 0.8F;
        settings.locks = {
            .sizeM = 0.014F, .small = 0.4F, .flatness = 0.3F, .twistsPerM = 2.0F, .ragged = 0.5F, .parting = 0.3F};
    }
    if (state.range(1) > 3) {
        input.groups.front().settings.hairline = {.softenM = 0.008F, .baby = 0.35F, .uneven = 0.5F};
        sim::VariationSettings& variation = input.groups.front().settings.variation;
        variation.parting = 0.004F;
        variation.mostShorterM = 0.015F;
        variation.partGapM = 0.003F;
        variation.patches = 0.3F;
    }
    sim::GroomBuilder builder;
    benchmark::DoNotOptimize(builder.update(input));
    std::uint16_t length = 20000;
    std::size_t rebuilt = 0;
    for ([[maybe_unused]] auto step : state) {
        static_cast<void>(step);
        state.PauseTiming();
        const sim::GroomInput next = repainted(input, ++length, state.range(1) > 2);
        state.ResumeTiming();
        const sim::GroomBuilder::Report report = builder.update(next);
        rebuilt = report.rebuiltStrands;
    }
    state.counters["rebuilt"] = static_cast<double>(rebuilt);
}

/// Each dab on the ones before it; from the beginning again before they would cover much, so that how often the
/// benchmark runs makes no difference.
template<sim::GroomInput (*after)(const sim::GroomInput&, int)>
void groomUpdate(benchmark::State& state)
{
    constexpr int kDabs = 18;
    const sim::GroomInput start = bench::sceneOf(static_cast<int>(state.range(0)), 8, false);
    sim::GroomInput input = start;
    sim::GroomBuilder builder;
    benchmark::DoNotOptimize(builder.update(input));
    int number = 0;
    std::size_t rebuilt = 0;
    for ([[maybe_unused]] auto step : state) {
        static_cast<void>(step);
        state.PauseTiming();
        if (number == kDabs) {
            number = 0;
            input = start;
            benchmark::DoNotOptimize(builder.update(input));
        }
        input = after(input, ++number);
        state.ResumeTiming();
        const sim::GroomBuilder::Report report = builder.update(input);
        rebuilt += report.rebuiltStrands;
    }
    state.counters["rebuilt"] = benchmark::Counter(static_cast<double>(rebuilt), benchmark::Counter::kAvgIterations);
}

#if defined(__GLIBC__)
std::size_t bytesInUse()
{
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

void memoryOfHair(benchmark::State& state)
{
    const sim::GroomInput input = bench::sceneOf(static_cast<int>(state.range(0)), 8, false);
    double bytes = 0.0;
    for ([[maybe_unused]] auto step : state) {
        const std::size_t before = bytesInUse();
        sim::Simulation simulation;
        simulation.setInput(input);
        sim::StrandFrame frame;
        simulation.writeFrame(frame);
        bytes = static_cast<double>(bytesInUse() - before);
    }
    state.counters["bytes_per_hair"] = bytes / static_cast<double>(state.range(0));
}

BENCHMARK(memoryOfHair)
    ->Name("memory")
    ->ArgNames({"hairs"})
    ->Arg(100000)
    ->Arg(1000000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
#endif
BENCHMARK(groomBuild)
    ->Name("groom_build")
    ->ArgNames({"hairs", "varied"})
    ->Args({100000, 0})
    ->Args({100000, 1})
    ->Args({100000, 2})
    ->Args({100000, 3})
    ->Args({100000, 4})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(groomUpdate<bench::dabbed>)
    ->Name("groom_update_dab")
    ->ArgNames({"hairs"})
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(groomUpdate<bench::combed>)
    ->Name("groom_update_comb")
    ->ArgNames({"hairs"})
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
