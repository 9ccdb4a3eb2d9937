// What tools ask of the 3D area's picture of 100,000 hairs: strands under a brush of 4 cm, across a line, and what the
// first question of a picture costs besides; and a move of a brush that colours hanging hair. Counter: strands met; CPU
// time is that of all threads.
#include "bench_scene.h"

#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/styles/style_use.h"
#include "model/tools/strokes/selection.h"
#include "model/tools/tool_list.h"
#include "sim/groom/map_slot.h"
#include "sim/motion/simulation.h"
#include "view/look/resources.h"
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
BENCHMARK(pickDisc)
    ->Name("pick/disc")
    ->ArgName("curled")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void pickLine(benchmark::State& state)
{
    const auto picture = std::make_shared<const view::HairPicture>(pictureOf(state.range(0) != 0));
    const std::array line{QPointF(250.0, 600.0), QPointF(650.0, 610.0)};
    std::size_t met = 0;
    for ([[maybe_unused]] auto _ : state)
        met = picture->crossing(line, false).size();
    state.counters["strands"] = static_cast<double>(met);
}
BENCHMARK(pickLine)
    ->Name("pick/line")
    ->ArgName("curled")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void pickPicture(benchmark::State& state)
{
    const view::PictureSource source = pictureOf(false);
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(view::HairPicture(source).hair());
}
BENCHMARK(pickPicture)->Name("pick/picture")->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

/// What a move of the brush costs while it colours long hair that hangs.
void hairStroke(benchmark::State& state)
{
    constexpr int kMoves = 12;
    view::initResources();
    model::Project project = model::newProject();
    if (const auto preset = model::loadPreset(QStringLiteral(":/presets/long-straight.hairpreset")))
        model::applyPreset(project, *preset);
    model::Document document(std::move(project));
    sim::Simulation simulation;
    simulation.setInput(document.groomInput());
    simulation.settle(1.0);
    auto frame = std::make_shared<sim::StrandFrame>();
    simulation.writeFrame(*frame);
    const model::HairGroup& group = document.project().groups.front();
    const model::LayerAddress target{group.id, model::MapKind::Colour,
                                     group.map(model::MapKind::Colour).layers.front().id};
    rendering::Camera camera;
    camera.azimuthRad = 0.6F;
    const auto picture =
        std::make_shared<const view::HairPicture>(view::PictureSource{.frame = frame,
                                                                      .group = static_cast<int>(group.id),
                                                                      .camera = camera,
                                                                      .size = kView,
                                                                      .skin = document.project().head->skin});
    model::Selection selection;
    model::ToolSettings settings;
    settings.value(model::MapKind::Colour).colour = QColor(200, 40, 40);
    model::ToolContext context{
        .document = document, .target = target, .settings = settings, .selection = selection, .seen = picture.get()};
    const float pxPerM = view::Lens(camera, QSizeF(kView)).pxPerM(0.65F);
    const auto eventAt = [&](int move) {
        model::ToolEvent event{.area = model::Area::Head};
        event.hair = model::OverHair{.position = QPointF(560.0, 420.0 + 12.0 * move), .pxPerM = pxPerM};
        return event;
    };
    const std::unique_ptr<model::Tool> tool = model::makeBrushTool();
    int move = 0;
    for ([[maybe_unused]] auto _ : state) {
        if (move % kMoves == 0) {
            state.PauseTiming();
            tool->cancel(context);
            tool->press(eventAt(0), context);
            state.ResumeTiming();
        }
        tool->move(eventAt(++move % kMoves), context);
    }
    tool->cancel(context);
    state.counters["strands"] =
        static_cast<double>(picture->under(eventAt(6).hair->position, 0.015 * static_cast<double>(pxPerM)).size());
}
BENCHMARK(hairStroke)->Name("pick/hair_stroke")->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

} // namespace
