// Drawing as the window does it: a built-in style in the wind at the size of the 3D area, every frame newly simulated.
#include "app/headless/settled_hair.h"
#include "app/styles/library.h"
#include "view/rendering/gl/gl_renderer.h"
#include "view/rendering/gl/offscreen_context.h"
#include "view/rendering/software/software_renderer.h"

#include <benchmark/benchmark.h>

#include <array>
#include <ctime>

namespace hairpaint {
namespace {

constexpr int kWidth = 612;
constexpr int kHeight = 680;

/// Arguments: the fraction of the hairs in per mille, samples a pixel, how far the eye goes round in a frame, mrad, and
/// the picture's width and height.
void drawWith(benchmark::State& state, rendering::Backend& backend)
{
    model::Project project = app::starterProject();
    rendering::Scene scene;
    scene.head = project.head->shownMesh;
    scene.headInMotion = std::shared_ptr<const sim::HeadMesh>(project.head->skin, &project.head->skin->mesh());
    app::SettledHair hair(std::move(project), 0.5);
    const auto first = hair.frame();
    hair.advance(1.0 / 30.0);
    const std::array frames{first, hair.frame()};
    const rendering::Quality quality{.detail = static_cast<float>(state.range(0)) / 1000.0F,
                                     .samples = static_cast<int>(state.range(1)),
                                     .coarseHead = true};
    const auto width = static_cast<int>(state.range(3));
    const auto height = static_cast<int>(state.range(4));
    for (const auto& frame : frames) {
        scene.hair = frame;
        backend.draw(scene, quality, width, height);
    }
    std::vector<std::uint8_t> pixels;
    std::size_t number = 0;
    const std::clock_t began = std::clock();
    for ([[maybe_unused]] auto _ : state) {
        scene.hair = frames[++number % 2];
        scene.camera.azimuthRad += static_cast<float>(state.range(2)) * 0.001F;
        backend.draw(scene, quality, width, height);
        backend.read(pixels);
    }
    // Processor time of all threads for one frame, which other programs disturb less than real time.
    state.counters["cpu_ms"] =
        1e3 * static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC / static_cast<double>(state.iterations());
    state.counters["hairs"] = static_cast<double>(backend.statistics().drawnHairs);
    state.counters["segments"] = static_cast<double>(backend.statistics().drawnSegments);
    state.counters["MB"] = static_cast<double>(backend.statistics().uploadedBytes) * 1e-6;
}

void drawStyle(benchmark::State& state)
{
    auto context = rendering::OffscreenContext::create();
    if (!context || !(*context)->makeCurrent()) {
        state.SkipWithError("no OpenGL context");
        return;
    }
    auto renderer = rendering::GlRenderer::create();
    if (!renderer) {
        state.SkipWithError(renderer.error().c_str());
        return;
    }
    drawWith(state, **renderer);
    renderer->reset();
    (*context)->doneCurrent();
}

void drawStyleInSoftware(benchmark::State& state)
{
    rendering::SoftwareRenderer renderer;
    drawWith(state, renderer);
}

void sizes(benchmark::internal::Benchmark* benchmark)
{
    benchmark->ArgNames({"permille", "samples", "turn", "width", "height"})
        ->Args({250, 1, 0, kWidth, kHeight})
        ->Args({250, 1, 10, kWidth, kHeight})
        ->Args({1000, 1, 0, kWidth, kHeight})
        ->Args({1000, 1, 10, kWidth, kHeight})
        ->Args({1000, 4, 0, kWidth, kHeight})
        ->Args({500, 1, 0, 1920, 1080})
        ->Args({1000, 1, 0, 1920, 1080})
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

BENCHMARK(drawStyle)->Name("draw_style")->Apply(sizes);
BENCHMARK(drawStyleInSoftware)->Name("draw_style_software")->Apply(sizes);

} // namespace
} // namespace hairpaint
