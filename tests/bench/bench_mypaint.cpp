// The rival of bench_paint.cpp: the same dabs by libmypaint on its own surface of 2048 x 2048, where it is installed.
#include <benchmark/benchmark.h>

extern "C" {
#include <mypaint-fixed-tiled-surface.h>
}

#include <cmath>
#include <memory>
#include <numbers>

namespace {

constexpr int kDabsAStep = 50; ///< Dabs between begin_atomic and end_atomic, which does the work.

void mypaintDab(benchmark::State& state)
{
    const auto radius = static_cast<float>(state.range(0));
    MyPaintSurface* surface = mypaint_fixed_tiled_surface_interface(mypaint_fixed_tiled_surface_new(2048, 2048));
    int i = 0;
    for ([[maybe_unused]] auto step : state) {
        if (i % kDabsAStep == 0)
            mypaint_surface_begin_atomic(surface);
        const auto t = static_cast<float>(i % 2000);
        mypaint_surface_draw_dab(surface, 1024.0F + 700.0F * std::cos(t * 0.01F),
                                 1024.0F + 700.0F * std::sin(t * 0.013F), radius, 0.2F, 0.8F, 0.1F, 1.0F, 0.8F, 0.0F,
                                 1.0F, 1.0F, 0.0F, 0.0F);
        if (++i % kDabsAStep == 0)
            mypaint_surface_end_atomic(surface, nullptr);
    }
    if (i % kDabsAStep != 0)
        mypaint_surface_end_atomic(surface, nullptr);
    mypaint_surface_unref(surface);
    const double area = std::numbers::pi * static_cast<double>(radius) * static_cast<double>(radius);
    state.counters["Mpx/s"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * area * 1e-6, benchmark::Counter::kIsRate);
}

BENCHMARK(mypaintDab)->Name("mypaint_dab")->ArgName("radius")->Arg(8)->Arg(32)->Arg(128);

} // namespace
