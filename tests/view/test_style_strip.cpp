// Pointing at a style shows it, leaving gives the very bytes back, clicking commits the bytes that were shown.
#include "panel_fixture.h"

#include "model/commands/commands.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "view/panels/hair_panel.h"
#include "view/panels/layers_panel.h"
#include "view/panels/style_strip.h"
#include "view/panels/style_tile.h"

#include <QCursor>
#include <QSignalSpy>

#include <algorithm>

using namespace hairpaint;
using namespace hairpaint::view;
using model::MapKind;

namespace {

/// One group "Scalp" that differs in length and density, and a group of its own.
model::Preset makePreset(const QString& name, std::uint16_t value)
{
    model::Project project;
    project.groups.push_back(model::makeGroup(project, QStringLiteral("Scalp"), 256));
    project.groups.push_back(model::makeGroup(project, QStringLiteral("Ponytail"), 256));
    for (const MapKind kind : {MapKind::Density, MapKind::Length})
        project.groups.front().map(kind).layers.front().raster.setTexel(100, 100, {value, 65535});
    project.groups.front().settings.greatestLengthM = 0.6F;
    return model::presetFrom(project, name);
}

model::Result<model::Preset> load(const QString& path)
{
    if (path == QStringLiteral("broken"))
        return model::failure(QStringLiteral("\"broken\" can't be read."));
    return makePreset(path, path == QStringLiteral("bob") ? 40000 : 60000);
}

/// Later, on this thread: the strip is not told before it has asked.
void startLater(const QString& /*doing*/, const std::function<model::Result<model::Preset>()>& read, QObject* receiver,
                const std::function<void(model::Result<model::Preset>)>& done)
{
    QMetaObject::invokeMethod(
        receiver, [read, done] { done(read()); }, Qt::QueuedConnection);
}

bool sameGroups(const std::vector<model::HairGroup>& a, const std::vector<model::HairGroup>& b)
{
    const auto sameLayer = [](const model::Layer& x, const model::Layer& y) {
        return x.id == y.id && model::propertiesOf(x) == model::propertiesOf(y) && x.raster == y.raster;
    };
    const auto sameMap = [&](const model::MapStack& x, const model::MapStack& y) {
        return x.kind == y.kind && x.size == y.size && std::ranges::equal(x.layers, y.layers, sameLayer);
    };
    return std::ranges::equal(a, b, [&](const model::HairGroup& x, const model::HairGroup& y) {
        return x.id == y.id && x.name == y.name && x.visible == y.visible && x.settings == y.settings &&
               std::ranges::equal(x.maps, y.maps, sameMap);
    });
}

struct StripFixture : PanelFixture
{
    StyleStrip strip{state, load, startLater};

    StripFixture()
    {
        std::vector<model::PresetEntry> entries;
        for (const char* name : {"bob", "waves", "broken"})
            entries.push_back({.path = QLatin1String(name),
                               .name = QLatin1String(name),
                               .tags = {},
                               .folder = QStringLiteral("built-in"),
                               .picture = {}});
        strip.setEntries(entries);
        // Away from the real pointer, which would point at a style too.
        QCursor::setPos(0, 0);
        strip.move(200, 200);
        strip.resize(800, 132);
        strip.show();
    }
    [[nodiscard]] StyleTile& tile(int index) { return *strip.findChildren<StyleTile*>()[index]; }
    void enter(int index)
    {
        QEnterEvent event(QPointF(10, 10), QPointF(10, 10), QPointF(10, 10));
        QApplication::sendEvent(&tile(index), &event);
    }
    void leave(int index)
    {
        QEvent event(QEvent::Leave);
        QApplication::sendEvent(&tile(index), &event);
    }
};

} // namespace

class TestStyleStrip : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pointing_shows_and_leaving_restores()
    {
        StripFixture f;
        f.state.setActiveGroup(f.document.project().groups[1].id);
        const model::Id active = f.state.activeGroup();
        const auto before = f.document.project().groups;
        f.enter(0);
        QVERIFY(!f.document.previewing());
        QTRY_VERIFY_WITH_TIMEOUT(f.document.previewing(), test::kPatienceMs);
        QVERIFY(!sameGroups(f.document.project().groups, before));
        QVERIFY(sameGroups(f.document.committed().groups, before));
        f.leave(0);
        QVERIFY(!f.document.previewing());
        QVERIFY(sameGroups(f.document.project().groups, before));
        QCOMPARE(f.state.activeGroup(), active);
        QCOMPARE(f.steps(), 0);
    }

    void clicking_commits_what_was_shown_as_one_step()
    {
        StripFixture f;
        const auto before = f.document.project().groups;
        f.enter(1);
        QTRY_VERIFY_WITH_TIMEOUT(f.document.previewing(), test::kPatienceMs);
        const auto shown = f.document.project().groups;
        QTest::mouseClick(&f.tile(1), Qt::LeftButton);
        QCOMPARE(f.steps(), 1);
        QVERIFY(!f.document.previewing());
        QVERIFY(sameGroups(f.document.project().groups, shown));
        f.leave(1);
        QVERIFY(sameGroups(f.document.project().groups, shown));
        f.document.undo();
        QVERIFY(sameGroups(f.document.project().groups, before));
    }

    void passing_by_quickly_shows_nothing()
    {
        StripFixture f;
        QSignalSpy changed(&f.document, &model::Document::changed);
        const auto* pause = f.strip.findChild<QTimer*>(QString(), Qt::FindDirectChildrenOnly);
        f.enter(0);
        QVERIFY(pause->isActive());
        f.leave(0);
        QVERIFY(!pause->isActive());
        QCoreApplication::processEvents(); // Nor is anything on its way.
        QCOMPARE(changed.count(), 0);
    }

    void moving_on_shows_the_next_style()
    {
        StripFixture f;
        f.enter(0);
        QTRY_VERIFY_WITH_TIMEOUT(f.document.previewing(), test::kPatienceMs);
        f.leave(0);
        f.enter(1);
        QTRY_VERIFY_WITH_TIMEOUT(f.document.previewing(), test::kPatienceMs);
        const auto layers = f.scalp().map(MapKind::Density).layers;
        QCOMPARE(layers.front().raster.texel(100, 100)[0], std::uint16_t(60000));
        f.leave(1);
    }

    void a_click_before_the_file_is_read_still_applies()
    {
        StripFixture f;
        QTest::mouseClick(&f.tile(0), Qt::LeftButton);
        QCOMPARE(f.steps(), 0); // Read in the background.
        QTRY_COMPARE_WITH_TIMEOUT(f.steps(), 1, test::kPatienceMs);
        QCOMPARE(f.scalp().settings.greatestLengthM, 0.6F);
    }

    void a_broken_style_is_reported_and_changes_nothing()
    {
        StripFixture f;
        QSignalSpy failed(&f.strip, &StyleStrip::failed);
        QTest::mouseClick(&f.tile(2), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, test::kPatienceMs);
        QCOMPARE(f.steps(), 0);
        QVERIFY(!f.document.previewing());
    }

    void somebody_elses_change_ends_the_preview_for_good()
    {
        StripFixture f;
        f.enter(0);
        QTRY_VERIFY_WITH_TIMEOUT(f.document.previewing(), test::kPatienceMs);
        f.document.push(renameGroupCommand(f.document, f.document.committed().groups[1].id, QStringLiteral("Brows")));
        QVERIFY(!f.document.previewing());
        f.leave(0);
        QCOMPARE(f.document.project().groups[1].name, QStringLiteral("Brows"));
        QCOMPARE(f.steps(), 1);
    }

    void whoever_ends_the_preview_what_was_active_is_so_again_data()
    {
        QTest::addColumn<bool>("undone");
        QTest::newRow("by a command") << false;
        QTest::newRow("by undo") << true;
    }
    void whoever_ends_the_preview_what_was_active_is_so_again()
    {
        QFETCH(bool, undone);
        StripFixture f;
        const model::HairGroup& beard = f.document.project().groups[1];
        f.state.setActiveGroup(beard.id);
        LayersPanel(f.state).addLayer();
        f.state.setActiveLayer(f.document.project().groups[1].map(MapKind::Length).layers.front().id);
        const model::LayerAddress before = f.state.target();
        f.enter(0);
        QTRY_VERIFY_WITH_TIMEOUT(f.document.previewing(), test::kPatienceMs);
        QVERIFY(f.state.activeGroup() != before.group);
        if (undone)
            f.document.undo();
        else
            f.document.push(renameGroupCommand(f.document, before.group, QStringLiteral("Brows")));
        QVERIFY(!f.document.previewing());
        QCOMPARE(f.state.activeGroup(), before.group);
        QCOMPARE(f.state.activeLayer(), before.layer);
    }

    void layer_commands_mean_the_layers_that_are_kept_data()
    {
        QTest::addColumn<int>("shown");
        for (int size : {256, 1024})
            QTest::addRow("%d texels", size) << size;
    }
    /// By key, with the pointer over a style whose maps have another size.
    void layer_commands_mean_the_layers_that_are_kept()
    {
        QFETCH(int, shown);
        StripFixture f;
        for (const MapKind kind : {MapKind::Length, MapKind::Curl})
            f.document.push(resizeMapCommand(f.document, f.scalp().id, kind, shown));
        LayersPanel panel(f.state);
        const auto layers = [&] { return f.document.committed().groups.front().map(MapKind::Length).layers; };
        const auto hover = [&] {
            f.leave(0);
            f.enter(0);
            return QTest::qWaitFor([&] { return f.document.previewing(); });
        };
        const int steps = f.steps();
        QVERIFY(hover());
        panel.duplicateLayer();
        QVERIFY(!f.document.previewing());
        QCOMPARE(layers().size(), std::size_t(2));
        QVERIFY(layers()[1].raster == layers()[0].raster);
        QCOMPARE(f.state.activeLayer(), layers()[1].id);
        QVERIFY(hover());
        panel.moveLayer(-1);
        QCOMPARE(layers()[0].id, f.state.activeLayer());
        QVERIFY(hover());
        panel.addLayer();
        QCOMPARE(layers().size(), std::size_t(3));
        QCOMPARE(f.state.activeLayer(), layers()[2].id);
        QVERIFY(hover());
        panel.removeLayer();
        QCOMPARE(layers().size(), std::size_t(2));
        QCOMPARE(f.steps(), steps + 4);
        // Each layer has the map's size.
        for (const model::Layer& layer : layers())
            QCOMPARE(layer.raster.size(), shown);
        QVERIFY(hover());
        HairPanel(f.state).removeGroup();
        QCOMPARE(f.document.committed().groups.size(), std::size_t(1));
        f.leave(0);
    }

    void a_layer_of_another_size_than_the_map_is_refused()
    {
        PanelFixture f;
        model::Layer layer = f.scalp().map(MapKind::Length).layers.front();
        layer.raster = sim::TiledRaster(512, layer.raster.channels());
        QVERIFY(insertLayerCommand(f.document, f.scalp().id, MapKind::Length, layer, 0, {}) == nullptr);
        QVERIFY(insertLayerCommand(f.document, 999, MapKind::Length, layer, 0, {}) == nullptr);
    }

    void pictures_are_asked_for_and_filled_in()
    {
        PanelFixture f;
        StyleStrip strip(f.state, load, startLater);
        QSignalSpy wanted(&strip, &StyleStrip::pictureWanted);
        strip.setEntries({{.path = QStringLiteral("bob"),
                           .name = QStringLiteral("Bob"),
                           .tags = {},
                           .folder = QStringLiteral("own"),
                           .picture = {}}});
        QTRY_COMPARE_WITH_TIMEOUT(wanted.count(), 1, test::kPatienceMs);
        QImage picture(96, 96, QImage::Format_RGB32);
        picture.fill(Qt::darkYellow);
        strip.setPicture(QStringLiteral("bob"), picture);
        QVERIFY(strip.findChildren<StyleTile*>().first()->hasPicture());
    }

    void the_last_tile_saves_a_style()
    {
        StripFixture f;
        QSignalSpy save(&f.strip, &StyleStrip::saveStyleRequested);
        QTest::mouseClick(f.strip.findChildren<StyleTile*>().last(), Qt::LeftButton);
        QCOMPARE(save.count(), 1);
        QCOMPARE(f.strip.paths().size(), std::size_t(3));
    }
};

HAIRPAINT_TEST(TestStyleStrip, Widgets)
#include "test_style_strip.moc"
