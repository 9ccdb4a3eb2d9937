// Maps that are resolved in the background: what is shown meanwhile, and that the end is always the same.
#include "model/document/document.h"
#include "model/document/group_commands.h"
#include "model/document/layer_commands.h"
#include "model/document/paint_command.h"
#include "sim/base/deterministic.h"
#include "tests/model/fixtures.h"
#include "tests/support/allocation_limit.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <deque>
#include <new>
#include <utility>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

constexpr int kLargeMap = 2048;

/// One group whose colour map holds two layers painted all over; the other maps are empty.
Project largeProject()
{
    Project project;
    project.groups.push_back(makeGroup(project, QStringLiteral("Scalp"), kLargeMap));
    MapStack& colour = project.groups.front().map(MapKind::Colour);
    colour.layers.clear();
    for (int i = 0; i < 2; ++i) {
        Layer layer = makeLayer(project, mapSpec(MapKind::Colour), kLargeMap, QStringLiteral("L"));
        for (int index = 0; index < layer.raster.tileCount(); ++index) {
            std::span<std::uint16_t> texels = layer.raster.writableTile(index);
            for (std::size_t t = 0; t < texels.size(); ++t)
                texels[t] = static_cast<std::uint16_t>(t * 7 + static_cast<std::size_t>(index * 13 + i * 101));
        }
        colour.layers.push_back(std::move(layer));
    }
    return project;
}

/// A background whose work is done when the test says so.
class Bench
{
public:
    [[nodiscard]] MapResolver::Background background()
    {
        return [this](std::function<void()> work, std::function<void(bool)> done) {
            m_queue.emplace_back(std::move(work), std::move(done));
        };
    }
    [[nodiscard]] std::size_t waiting() const { return m_queue.size(); }
    /// The oldest; `whole`: memory is enough.
    void work(bool whole = true)
    {
        auto [work, done] = std::move(m_queue.front());
        m_queue.pop_front();
        if (whole)
            work();
        done(whole);
    }
    /// The oldest, but what follows it on the document's thread finds no memory for a tile; whether that is told.
    bool workAndRunOut()
    {
        auto [work, done] = std::move(m_queue.front());
        m_queue.pop_front();
        work();
        const AllocationLimit limit(sim::kTileTexels * sizeof(std::uint16_t));
        try {
            done(true);
        } catch (const std::bad_alloc&) {
            return true;
        }
        return false;
    }
    void workAll()
    {
        while (!m_queue.empty())
            work();
    }

private:
    std::deque<std::pair<std::function<void()>, std::function<void(bool)>>> m_queue;
};

/// Whether what a document shows is what its layers give when they are resolved from nothing.
bool showsItsContent(const Document& document)
{
    const ResolvedMaps afresh(document.project());
    for (const HairGroup& group : document.project().groups)
        for (const MapSpec& spec : mapSpecs()) {
            const auto shown = document.resolved(group.id, spec.kind);
            if (shown == nullptr || *shown != *afresh.map(group.id, spec.kind))
                return false;
        }
    return true;
}

void setOpacity(Document& document, float opacity)
{
    const LayerAddress at = firstLayer(document, MapKind::Colour);
    LayerProperties properties = propertiesOf(*document.committed().layer(at.group, at.map, at.layer));
    properties.opacity = opacity;
    document.push(setLayerPropertiesCommand(document, at, properties, QString()));
}

void paintTexel(Document& document, MapKind map, int index, std::uint16_t value)
{
    const LayerAddress at = firstLayer(document, map);
    sim::TiledRaster raster = document.committed().layer(at.group, at.map, at.layer)->raster;
    raster.writableTile(index)[0] = value;
    document.push(paintCommand(document, at, {{index, raster.tile(index)}}, QString()));
}

} // namespace

class TestMapResolver : public QObject
{
    Q_OBJECT
private:
    Bench m_bench;

private Q_SLOTS:
    void init() { m_bench = Bench(); }

    void littleWorkIsDoneAtOnce()
    {
        Document document(largeProject());
        document.resolveIn(m_bench.background());
        paintTexel(document, MapKind::Colour, 5, 1);
        QVERIFY(!document.resolving());
        QVERIFY(showsItsContent(document));
    }

    void muchIsDoneElsewhereAndToldWhenItIsThere()
    {
        Document document(largeProject());
        document.resolveIn(m_bench.background());
        const Id group = document.project().groups.front().id;
        const auto before = document.resolved(group, MapKind::Colour);
        const QSignalSpy told(&document, &Document::changed);
        setOpacity(document, 0.5F);
        QVERIFY(document.resolving());
        QCOMPARE(document.resolved(group, MapKind::Colour), before);
        const std::uint64_t revision = document.revision();
        const qsizetype changes = told.size();

        m_bench.work();
        QVERIFY(!document.resolving());
        QVERIFY(document.revision() > revision);
        QVERIFY(showsItsContent(document));
        // The tips follow the colour.
        QCOMPARE(told.size(), changes + 2);
        for (const QList<QVariant>& signal : told.sliced(changes)) {
            const auto change = signal.front().value<Change>();
            QVERIFY(change.aspect == Change::Aspect::Resolved);
            QVERIFY(change.map == MapKind::Colour || change.map == MapKind::TipColour);
            QVERIFY(!change.preview);
        }
    }

    void whatComesMeanwhileIsNotLost()
    {
        Document document(largeProject());
        document.resolveIn(m_bench.background());
        setOpacity(document, 0.5F);
        setOpacity(document, 0.25F);
        paintTexel(document, MapKind::Length, 3, 40'000);
        document.push(renameGroupCommand(document, document.committed().groups.front().id, QStringLiteral("Crown")));
        QCOMPARE(m_bench.waiting(), 1U); // However many ticks there are.
        m_bench.workAll();
        QVERIFY(!document.resolving());
        QVERIFY(showsItsContent(document));
    }

    void aPreviewIsResolvedAndTakenBack()
    {
        Document document(largeProject());
        document.resolveIn(m_bench.background());
        const LayerAddress at = firstLayer(document, MapKind::Colour);
        EditSession edit = document.begin({.policy = EditPolicy::Drop});
        edit.preview({.aspect = Change::Aspect::LayerList, .group = at.group, .map = at.map},
                     [at](Project& project) { project.layer(at.group, at.map, at.layer)->visible = false; });
        const QSignalSpy told(&document, &Document::changed);
        m_bench.workAll();
        QVERIFY(told.front().front().value<Change>().preview);
        QVERIFY(showsItsContent(document));
        edit.drop();
        m_bench.workAll();
        QVERIFY(showsItsContent(document));
    }

    void whoeverComputesFromAMapNeedNotWaitForTheBackground()
    {
        Document document(largeProject());
        document.resolveIn(m_bench.background());
        setOpacity(document, 0.5F);
        const Id group = document.committed().groups.front().id;
        const auto map = document.resolvedNow(group, MapKind::Colour);
        QVERIFY(!document.resolving());
        QCOMPARE(document.resolved(group, MapKind::Colour), map);
        QVERIFY(showsItsContent(document));
        setOpacity(document, 0.75F);
        m_bench.work(); // The work for 0.5 ends, too late to be of use.
        QVERIFY(document.resolving());
        m_bench.work();
        QVERIFY(showsItsContent(document));
    }

    void anotherProjectIsNotOverwrittenByWhatIsUnderWay()
    {
        Document document(largeProject());
        document.resolveIn(m_bench.background());
        setOpacity(document, 0.5F);
        document.replace(patchProject());
        QVERIFY(!document.resolving());
        m_bench.work();
        QVERIFY(showsItsContent(document));
    }

    void whereTheBackgroundLacksMemoryItIsDoneHere()
    {
        Document document(largeProject());
        document.resolveIn(m_bench.background());
        setOpacity(document, 0.5F);
        m_bench.work(false);
        m_bench.workAll();
        QVERIFY(!document.resolving());
        QVERIFY(showsItsContent(document));
    }

    void whatHasComeIsToldThoughMemoryRunsOutAfterIt()
    {
        Document document(largeProject());
        document.resolveIn(m_bench.background());
        setOpacity(document, 0.5F);
        paintTexel(document, MapKind::Length, 3, 40'000); // Little, but it waits for the other.
        const QSignalSpy told(&document, &Document::changed);
        QVERIFY(m_bench.workAndRunOut());
        const auto isTold = [&told](MapKind map) {
            return std::ranges::any_of(told, [map](const QList<QVariant>& signal) {
                const auto change = signal.front().value<Change>();
                return change.aspect == Change::Aspect::Resolved && change.map == map;
            });
        };
        QVERIFY(isTold(MapKind::Colour));
        QVERIFY(!isTold(MapKind::Length));
    }

    void aGroupHasNoHairBeforeItsMapsAreThere()
    {
        Document document(patchProject());
        const Id first = document.committed().groups.front().id;
        document.resolveIn(m_bench.background());
        EditSession edit = document.begin({});
        edit.preview({.aspect = Change::Aspect::GroupList}, [](Project& project) {
            HairGroup group = largeProject().groups.front();
            group.id = project.takeId();
            project.groups.push_back(std::move(group));
        });
        QVERIFY(document.resolving());
        QCOMPARE(document.groomInput().groups.size(), 1U);
        QCOMPARE(document.groomInput().groups.front().id, first);
        m_bench.workAll();
        QCOMPARE(document.groomInput().groups.size(), 2U);
        QVERIFY(showsItsContent(document));
    }

    void theEndIsTheSameWheneverTheBackgroundGetsToIt()
    {
        Document document(largeProject());
        document.resolveIn(m_bench.background());
        std::uint64_t draw = 0;
        const auto random = [&draw](std::uint64_t count) { return sim::hash64(7, ++draw) % count; };
        for (int step = 0; step < 40; ++step) {
            switch (random(5)) {
            case 0:
                setOpacity(document, static_cast<float>(random(100)) * 0.01F);
                break;
            case 1:
                document.undo();
                break;
            case 2:
                document.redo();
                break;
            case 3:
                paintTexel(document, MapKind::Colour, static_cast<int>(random(1024)), 9);
                break;
            default:
                paintTexel(document, MapKind::Gel, static_cast<int>(random(1024)), 9);
                break;
            }
            if (m_bench.waiting() > 0 && random(2) == 0)
                m_bench.work();
        }
        m_bench.workAll();
        QVERIFY(!document.resolving());
        QVERIFY(showsItsContent(document));
    }
};

HAIRPAINT_TEST(TestMapResolver, Core)
#include "test_map_resolver.moc"
