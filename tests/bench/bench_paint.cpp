// Pixels a second of one dab into a stroke buffer, in the order of positions that the rival driver uses.
#include "model/document/document.h"
#include "model/tools/strokes/selection.h"
#include "model/tools/strokes/stroke_buffer.h"
#include "model/tools/tool.h"
#include "model/tools/tool_list.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

namespace {

using hairpaint::model::Dab;
using hairpaint::model::StrokeBuffer;

constexpr int kMapSize = 2048;

/// One dab of hardness 0.8; the counter `px/s` counts the disc's area.
void paintDab(benchmark::State& state)
{
    const auto radius = static_cast<float>(state.range(0));
    const float form = 1.0F / (radius * radius);
    StrokeBuffer buffer(kMapSize);
    const hairpaint::sim::TexelRect clip{0, 0, kMapSize, kMapSize};
    int i = 0;
    for ([[maybe_unused]] auto step : state) {
        const auto t = static_cast<float>(i++ % 2000);
        const Dab dab{.xTx = 1024.0F + 700.0F * std::cos(t * 0.01F),
                      .yTx = 1024.0F + 700.0F * std::sin(t * 0.013F),
                      .a = form,
                      .b = 0.0F,
                      .c = form,
                      .hardness = 0.8F,
                      .strength = 0.8F};
        buffer.add(dab, clip);
        if (i % 50 == 0) // A driver that paints takes what to show again at times.
            benchmark::DoNotOptimize(buffer.takeDirty());
    }
    const double area = std::numbers::pi * static_cast<double>(radius) * static_cast<double>(radius);
    state.counters["Mpx/s"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * area * 1e-6, benchmark::Counter::kIsRate);
}

/// One move event of a brush stroke on a 2048 map, with the preview's tiles, resolved.
void paintEvent(benchmark::State& state)
{
    using namespace hairpaint::model;
    Project project;
    project.groups.push_back(makeGroup(project, QStringLiteral("Scalp"), kMapSize));
    const HairGroup& group = project.groups.front();
    const LayerAddress target{group.id, MapKind::Length, group.map(MapKind::Length).layers.front().id};
    Document document(project);
    Selection selection;
    ToolSettings settings;
    // Without a head a uv unit counts as 0.5 m.
    settings.brushSizeM = static_cast<float>(state.range(0)) * 2.0F * 0.5F / kMapSize;
    const std::unique_ptr<Tool> brush = std::move(makeTools().front());
    ToolContext context{document, target, settings, selection};
    int i = 0;
    const auto event = [&i] {
        const float along = 0.01F * static_cast<float>(i++);
        return ToolEvent{.uv = {0.5F + 0.35F * std::cos(along), 0.5F + 0.35F * std::sin(1.3F * along)}};
    };
    brush->press(event(), context);
    for ([[maybe_unused]] auto step : state)
        brush->move(event(), context);
    brush->cancel(context);
}

BENCHMARK(paintEvent)->Name("paint_event")->ArgName("radius")->Arg(8)->Arg(32)->Arg(128);
BENCHMARK(paintDab)->Name("paint_dab")->ArgName("radius")->Arg(8)->Arg(32)->Arg(128);

} // namespace
