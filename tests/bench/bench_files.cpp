// What saving and opening a large project costs: seven maps of three full layers of noise, which nothing can fold.
#include "model/files/encoded_layers.h"
#include "model/files/project_file.h"
#include "model/project/project.h"
#include "sim/base/deterministic.h"

#include <QFileInfo>
#include <QTemporaryDir>

#include <benchmark/benchmark.h>

#include <array>

namespace {

using namespace hairpaint::model;
namespace sim = hairpaint::sim;

constexpr int kNoiseSize = 2048;
constexpr int kNoiseLayers = 3;
constexpr std::array kNoisyMaps = {MapKind::Density, MapKind::Length, MapKind::Curl,  MapKind::CurlSize,
                                   MapKind::Clump,   MapKind::Gel,    MapKind::Colour};

const Project& noisyProject()
{
    static const Project project = [] {
        Project noisy = newProject();
        std::uint64_t draw = 0;
        for (const MapKind kind : kNoisyMaps) {
            const MapSpec& spec = mapSpec(kind);
            MapStack& stack = noisy.groups.front().map(kind);
            stack.size = kNoiseSize;
            stack.layers.clear();
            for (int i = 0; i < kNoiseLayers; ++i) {
                Layer layer = makeLayer(noisy, spec, kNoiseSize, QStringLiteral("L"));
                for (int index = 0; index < layer.raster.tileCount(); ++index)
                    for (std::uint16_t& channel : layer.raster.writableTile(index))
                        channel = static_cast<std::uint16_t>(sim::hash64(1, ++draw));
                stack.layers.push_back(std::move(layer));
            }
        }
        return noisy;
    }();
    return project;
}

void saveCold(benchmark::State& state)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("noise.hairpaint"));
    for ([[maybe_unused]] auto step : state)
        if (!saveProject(noisyProject(), path, {}))
            return state.SkipWithError("not saved");
    state.counters["MB"] = static_cast<double>(QFileInfo(path).size()) * 1e-6;
}

void saveAfterAnEdit(benchmark::State& state)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("noise.hairpaint"));
    const std::shared_ptr<EncodedLayers> known = makeEncodedLayers();
    Project project = noisyProject();
    if (!saveProject(project, path, {}, known.get()))
        return state.SkipWithError("not saved");
    int texel = 0;
    for ([[maybe_unused]] auto step : state) {
        sim::TiledRaster& raster = project.groups.front().map(MapKind::Gel).layers.front().raster;
        raster.setTexel(++texel % kNoiseSize, 7, {1, 2, 0, 0});
        if (!saveProject(project, path, {}, known.get()))
            return state.SkipWithError("not saved");
    }
}

void openNoise(benchmark::State& state)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("noise.hairpaint"));
    if (!saveProject(noisyProject(), path, {}))
        return state.SkipWithError("not saved");
    for ([[maybe_unused]] auto step : state)
        if (!loadProject(path))
            return state.SkipWithError("not read");
}

BENCHMARK(saveCold)->Name("save_noise_cold")->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(saveAfterAnEdit)
    ->Name("save_noise_after_an_edit")
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(openNoise)->Name("open_noise")->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

} // namespace
