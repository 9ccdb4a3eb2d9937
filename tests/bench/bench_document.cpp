// What a document costs: ticks of a layer's opacity, steps on top of a long history, and opening a large project.
#include "model/document/document.h"
#include "model/document/paint_command.h"
#include "model/files/project_file.h"
#include "sim/base/deterministic.h"

#include <QFileInfo>
#include <QTemporaryDir>

#include <benchmark/benchmark.h>

namespace {

using namespace hairpaint::model;
namespace sim = hairpaint::sim;

constexpr int kMapSize = 2048;

/// One group whose gel map holds `layers` layers painted all over.
Project paintedProject(int layers)
{
    Project project;
    project.groups.push_back(makeGroup(project, QStringLiteral("Scalp"), kMapSize));
    MapStack& gel = project.groups.front().map(MapKind::Gel);
    gel.layers.clear();
    for (int i = 0; i < layers; ++i) {
        Layer layer = makeLayer(project, mapSpec(MapKind::Gel), kMapSize, QStringLiteral("L"));
        for (int index = 0; index < layer.raster.tileCount(); ++index) {
            std::uint16_t value = 0;
            for (std::uint16_t& channel : layer.raster.writableTile(index))
                channel = value = static_cast<std::uint16_t>(value * 31 + index + i + 1);
        }
        gel.layers.push_back(std::move(layer));
    }
    return project;
}

LayerAddress topLayer(const Document& document)
{
    const HairGroup& group = document.committed().groups.front();
    return {group.id, MapKind::Gel, group.map(MapKind::Gel).layers.back().id};
}

void opacityTick(benchmark::State& state)
{
    Document document(paintedProject(static_cast<int>(state.range(0))));
    const LayerAddress at = topLayer(document);
    EditSession edit = document.begin({});
    int i = 0;
    for ([[maybe_unused]] auto step : state) {
        const float opacity = 0.2F + 0.001F * static_cast<float>(++i % 700);
        edit.preview({.aspect = Change::Aspect::LayerList, .group = at.group, .map = at.map},
                     [at, opacity](Project& project) { project.layer(at.group, at.map, at.layer)->opacity = opacity; });
    }
}

/// A step of one tile, and its undo, on top of 2,000 others.
void stepOnALongHistory(benchmark::State& state)
{
    Document document(paintedProject(1));
    const LayerAddress at = topLayer(document);
    const auto paint = [&](int i) {
        sim::TiledRaster raster = document.committed().layer(at.group, at.map, at.layer)->raster;
        const int index = i % raster.tileCount();
        raster.writableTile(index)[0] = static_cast<std::uint16_t>(i + 1);
        document.push(paintCommand(document, at, {{index, raster.tile(index)}}, QString()));
    };
    int i = 0;
    for (; i < state.range(0); ++i)
        paint(i);
    for ([[maybe_unused]] auto step : state) {
        paint(++i);
        document.undo();
    }
}

void copyProject(benchmark::State& state)
{
    const Project project = paintedProject(4);
    for ([[maybe_unused]] auto step : state) {
        Project copy = project;
        benchmark::DoNotOptimize(copy);
    }
}

/// Three colour layers of noise, which nothing can fold or pack: about 90 MB.
void openLargeProject(benchmark::State& state)
{
    constexpr int kLayers = 3;
    Project project = newProject();
    MapStack& colour = project.groups.front().map(MapKind::Colour);
    const MapSpec& spec = mapSpec(MapKind::Colour);
    colour.size = kMapSize;
    colour.layers.clear();
    std::uint64_t draw = 0;
    for (int i = 0; i < kLayers; ++i) {
        Layer layer = makeLayer(project, spec, kMapSize, QStringLiteral("L"));
        for (int index = 0; index < layer.raster.tileCount(); ++index)
            for (std::uint16_t& channel : layer.raster.writableTile(index))
                channel = static_cast<std::uint16_t>(sim::hash64(1, ++draw));
        colour.layers.push_back(std::move(layer));
    }
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("large.hairpaint"));
    if (!saveProject(project, path, {}))
        return state.SkipWithError("not saved");
    for ([[maybe_unused]] auto step : state) {
        Result<Project> opened = loadProject(path);
        if (!opened)
            return state.SkipWithError("not read");
        const Document document(std::move(*opened));
    }
    state.counters["MB"] = static_cast<double>(QFileInfo(path).size()) * 1e-6;
}

BENCHMARK(opacityTick)
    ->Name("opacity_tick")
    ->ArgName("layers")
    ->Arg(2)
    ->Arg(8)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(stepOnALongHistory)->Name("step_after_steps")->ArgName("steps")->Arg(0)->Arg(2000);
BENCHMARK(openLargeProject)->Name("open_large_project")->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(copyProject)->Name("copy_project");

} // namespace
