// The document is edited while its hair is made and older states of it are saved: each sees its own snapshot whole.
#include "app/background/jobs.h"
#include "app/background/map_resolving.h"
#include "model/document/document.h"
#include "model/document/layer_commands.h"
#include "model/document/paint_command.h"
#include "model/files/project_file.h"
#include "sim/motion/simulation_worker.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

namespace hairpaint::app {

namespace {

constexpr int kLongPatienceMs = 300'000;
constexpr int kMapSize = 256;

model::Project smallProject()
{
    model::Project project = model::newProject();
    project.groups.clear();
    project.groups.push_back(model::makeGroup(project, QStringLiteral("Scalp"), kMapSize));
    project.groups.front().settings.greatestDensityPerM2 = 2e4F;
    project.groups.front().settings.basisHairs = 256;
    return project;
}

model::LayerAddress densityLayer(const model::Document& document)
{
    const model::HairGroup& group = document.committed().groups.front();
    return {group.id, model::MapKind::Density, group.map(model::MapKind::Density).layers.front().id};
}

/// One tile of the density map all of `value`.
std::pair<int, sim::RasterTilePtr> painted(const model::Document& document, int index, std::uint16_t value)
{
    const model::LayerAddress at = densityLayer(document);
    sim::TiledRaster raster = document.committed().layer(at.group, at.map, at.layer)->raster;
    raster.setUniform(index, {value, 65535});
    return {index, raster.tile(index)};
}

} // namespace

class TestSnapshots : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void whatIsSavedAndGroomedIsTheStateThatWasHandedOver()
    {
        constexpr int kRounds = 12;
        QTemporaryDir folder;
        QWidget window;
        Jobs jobs(window);
        model::Document document(smallProject());
        std::atomic<int> woken = 0;
        sim::SimulationWorker worker([&woken] { ++woken; });
        std::vector<model::Project> handedOver;
        int saved = 0;
        std::uint64_t sent = 0;
        for (int round = 0; round < kRounds; ++round) {
            const model::LayerAddress at = densityLayer(document);
            const int tile = round % document.committed().layer(at.group, at.map, at.layer)->raster.tileCount();
            document.push(paintCommand(document, at,
                                       {painted(document, tile, static_cast<std::uint16_t>(60'000 + round))},
                                       QStringLiteral("Brush")));
            if (round % 3 == 2)
                document.undo();
            sim::GroomInput input = document.groomInput();
            sent = input.revision;
            worker.setInput(std::move(input));
            handedOver.push_back(document.committed());
            const QString path = folder.filePath(QStringLiteral("%1.hairpaint").arg(round));
            jobs.start<void>(
                QStringLiteral("Writing %1").arg(path),
                [project = handedOver.back(), path](const model::Progress& progress) {
                    return model::saveProject(project, path, {}, nullptr, progress);
                },
                this,
                [&saved](const model::Result<void>& result) {
                    QVERIFY(result);
                    ++saved;
                });
            // The resolved maps are looked at here while the worker reads them.
            QVERIFY(document.resolved(at.group, at.map)->texel(0, 0)[0] >= 60'000);
        }
        QTRY_COMPARE_WITH_TIMEOUT(saved, kRounds, kLongPatienceMs);
        for (int round = 0; round < kRounds; ++round) {
            const model::Result<model::Project> read =
                model::loadProject(folder.filePath(QStringLiteral("%1.hairpaint").arg(round)));
            QVERIFY(read);
            QVERIFY(read->groups == handedOver[static_cast<std::size_t>(round)].groups);
        }
        // The last state that was handed over gets its hair.
        std::shared_ptr<const sim::StrandFrame> frame;
        const auto hasNewest = [&] {
            if (auto next = worker.takeFrame())
                frame = std::move(next);
            return frame && frame->revision == sent;
        };
        QTRY_VERIFY_WITH_TIMEOUT(hasNewest(), kLongPatienceMs);
        QVERIFY(frame->hairCount > 0);
        QVERIFY(woken > 0);
    }

    void aDocumentIsPaintedWhileItsMapsAreResolved()
    {
        constexpr int kRounds = 10;
        constexpr int kLayers = 3;
        constexpr int kLargeMap = 1024;
        model::Project project = smallProject();
        model::MapStack& gel = project.groups.front().map(model::MapKind::Gel);
        gel.size = kLargeMap;
        gel.layers.clear();
        for (int i = 0; i < kLayers; ++i) {
            gel.layers.push_back(model::makeLayer(project, model::mapSpec(gel.kind), kLargeMap, QStringLiteral("L")));
            sim::TiledRaster& raster = gel.layers.back().raster;
            for (int index = 0; index < raster.tileCount(); ++index)
                raster.writableTile(index)[0] = static_cast<std::uint16_t>(index + i);
        }
        QWidget window;
        Jobs jobs(window);
        model::Document document(std::move(project));
        document.resolveIn(resolvedByJobs(jobs, &document));
        bool resolvedLater = false;
        for (int round = 0; round < kRounds; ++round) {
            const model::HairGroup& group = document.committed().groups.front();
            const model::Layer& layer = group.map(model::MapKind::Gel).layers.front();
            const model::LayerAddress at{group.id, model::MapKind::Gel, layer.id};
            model::LayerProperties properties = model::propertiesOf(layer);
            properties.opacity = 0.05F * static_cast<float>(round);
            document.push(model::setLayerPropertiesCommand(document, at, properties, QString()));
            resolvedLater = resolvedLater || document.resolving();
            sim::TiledRaster raster = document.committed().layer(at.group, at.map, at.layer)->raster;
            raster.writableTile(round)[1] = 65535;
            document.push(model::paintCommand(document, at, {{round, raster.tile(round)}}, QString()));
            if (round % 4 == 3)
                QTRY_VERIFY_WITH_TIMEOUT(!document.resolving(), kLongPatienceMs);
            if (round % 3 == 2)
                document.undo();
        }
        QVERIFY(resolvedLater);
        QTRY_VERIFY_WITH_TIMEOUT(!document.resolving(), kLongPatienceMs);
        const model::Id group = document.committed().groups.front().id;
        QVERIFY(*document.resolved(group, model::MapKind::Gel) ==
                *model::ResolvedMaps(document.committed()).map(group, model::MapKind::Gel));
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestSnapshots, Widgets)
#include "test_snapshots.moc"
