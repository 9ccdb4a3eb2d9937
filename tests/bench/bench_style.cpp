// Drawing as the window does it: a built-in style in the wind at the size of the 3D area, every frame newly simulated.
#include "app/cli/settled_hair.h"
#include "app/library.h"
#include "view/rendering/offscreen_context.h"
#include "view/rendering/renderer.h"

#include <benchmark/benchmark.h>

#include <array>

namespace hairpaint {
namespace {

constexpr int kWidth = 612;
constexpr int kHeight = 680;

/// The fraction of the hairs in per mille, samples a pixel, and how far the eye goes round in a frame, mrad.
void drawStyle(benchmark::State& state)
{
    auto context = rendering::OffscreenContext::create();
    if (!context || !(*context)->makeCurrent()) {
        state.SkipWithError("no OpenGL context");
        return;
    }
    auto renderer = rendering::Renderer::create();
    if (!renderer) {
        state.SkipWithError(renderer.error().c_str());
        return;
    }
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
                                     .smoothSegments = 8,
                                     .coarseHead = true};
    for (const auto& frame : frames) {
        scene.hair = frame;
        (*renderer)->draw(scene, quality, kWidth, kHeight);
    }
    std::vector<std::uint8_t> pixels;
    std::size_t number = 0;
    for ([[maybe_unused]] auto _ : state) {
        scene.hair = frames[++number % 2];
        scene.camera.azimuthRad += static_cast<float>(state.range(2)) * 0.001F;
        (*renderer)->draw(scene, quality, kWidth, kHeight);
        (*renderer)->read(pixels);
    }
    state.counters["hairs"] = static_cast<double>((*renderer)->statistics().drawnHairs);
    state.counters["MB"] = static_cast<double>((*renderer)->statistics().uploadedBytes) * 1e-6;
    renderer->reset();
    (*context)->doneCurrent();
}

BENCHMARK(drawStyle)
    ->Name("draw_style")
    ->ArgNames({"permille", "samples", "turn"})
    ->Args({250, 1, 0})
    ->Args({250, 1, 10})
    ->Args({1000, 1, 0})
    ->Args({1000, 4, 0})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
} // namespace hairpaint
