// export_hair/FORMAT: writing 100,000 hairs of some 16 points to a temporary file, the curves found and flushed to the
// disk; the rows stand as in model::exportFormats().
#include "bench_scene.h"

#include "model/formats/export_format.h"
#include "sim/motion/simulation.h"
#include "tests/model/exported_hair.h"

#include <QTemporaryDir>

#include <benchmark/benchmark.h>

namespace {

using namespace hairpaint;

constexpr int kHairs = 100'000;
constexpr int kNodes = 9; // 17 points a hair.

std::shared_ptr<const sim::StrandFrame> straightFrame()
{
    sim::GroomInput input = bench::sceneOf(kHairs, kNodes, false);
    sim::GroupMaps& maps = input.groups.front().maps;
    maps[sim::MapSlot::Curl] =
        std::make_shared<const sim::TiledRaster>(maps[sim::MapSlot::Curl]->size(), 1, sim::Texel{0});
    sim::Simulation simulation;
    simulation.setInput(input);
    auto frame = std::make_shared<sim::StrandFrame>();
    simulation.writeFrame(*frame);
    return frame;
}

void exportHair(benchmark::State& state)
{
    const model::ExportFormat& format = model::exportFormats()[static_cast<std::size_t>(state.range(0))];
    const auto frame = straightFrame();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("hair.") + QLatin1StringView(format.suffix));
    model::ExportRequest request{.format = &format, .target = &model::exportTargets().front(), .curves = {}};
    if (format.isAvatar)
        request.avatar = test::mannequinAvatar();
    request.curves.groups = {{.id = frame->groups.front().groom->groupId, .name = QStringLiteral("Scalp")}};
    for ([[maybe_unused]] auto step : state) {
        static_cast<void>(step);
        if (!model::exportHair(frame, request, path)) {
            state.SkipWithError("not written");
            return;
        }
    }
    state.SetLabel(format.id);
    state.counters["hairs"] = static_cast<double>(frame->groups.front().groom->drawnCount);
    state.counters["points"] = static_cast<double>(model::CurveSet::of(frame, request.curves)->pointCount());
}

BENCHMARK(exportHair)
    ->Name("export_hair")
    ->DenseRange(0, static_cast<std::int64_t>(model::exportFormats().size()) - 1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
