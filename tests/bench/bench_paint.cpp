// Pixels a second of one dab into a stroke buffer, in the order of places that the rival driver uses.
#include "model/tools/stroke_buffer.h"

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
    for (auto step : state) {
        const auto place = static_cast<float>(i++ % 2000);
        const Dab dab{.xTx = 1024.0F + 700.0F * std::cos(place * 0.01F),
                      .yTx = 1024.0F + 700.0F * std::sin(place * 0.013F),
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

BENCHMARK(paintDab)->Name("paint_dab")->ArgName("radius")->Arg(8)->Arg(32)->Arg(128);

} // namespace
