// What tools ask of the 3D area's picture of 100,000 hairs: strands under a brush of 4 cm, across a line, and what the
// first question of a picture costs besides. Counter: strands met.
#include "bench_scene.h"

#include "sim/groom/map_slot.h"
#include "sim/motion/simulation.h"
#include "view/picking/hair_picture.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <memory>

namespace {

using namespace hairpaint;

constexpr int kHairs = 100000;
constexpr int kNodes = 16;
constexpr QSize kView(900, 900);
constexpr QPointF kBesideFace(450.0, 560.0);

view::PictureSource pictureOf(bool curled)
{
    static std::array<view::PictureSource, 2> made;
    view::PictureSource& source = made[curled ? 1 : 0];
    if (source.frame)
        return source;
    sim::GroomInput input = bench::sceneOf(kHairs, kNodes, false);
    if (!curled)
        input.groups.front().maps[sim::MapSlot::Curl] =
            std::make_shared<const sim::TiledRaster>(64, 1, sim::Texel{0, 0, 0, 0});
    sim::Simulation simulation;
    simulation.setInput(input);
    simulation.settle(1.0);
    auto frame = std::make_shared<sim::StrandFrame>();
    simulation.writeFrame(*frame);
    source = {.frame = std::move(frame), .group = 1, .camera = {}, .size = kView, .skin = input.skin};
    source.camera.targetWo = glm::vec3(0.0F, -0.05F, 0.0F);
    return source;
}

void pickDisc(benchmark::State& state)
{
    const auto picture = std::make_shared<const view::HairPicture>(pictureOf(state.range(0) != 0));
    const double radiusPx = 0.02 * view::Lens(picture->source().camera, QSizeF(kView)).pxPerM(0.65F);
    std::size_t met = 0;
    for ([[maybe_unused]] auto _ : state)
        met = picture->under(kBesideFace, radiusPx).size();
    state.counters["strands"] = static_cast<double>(met);
}
BENCHMARK(pickDisc)->Name("pick/disc")->ArgName("curled")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

void pickLine(benchmark::State& state)
{
    const auto picture = std::make_shared<const view::HairPicture>(pictureOf(state.range(0) != 0));
    const std::array line{QPointF(250.0, 600.0), QPointF(650.0, 610.0)};
    std::size_t met = 0;
    for ([[maybe_unused]] auto _ : state)
        met = picture->crossing(line, false).size();
    state.counters["strands"] = static_cast<double>(met);
}
BENCHMARK(pickLine)->Name("pick/line")->ArgName("curled")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

void pickPicture(benchmark::State& state)
{
    const view::PictureSource source = pictureOf(false);
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(view::HairPicture(source).hair());
}
BENCHMARK(pickPicture)->Name("pick/picture")->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
