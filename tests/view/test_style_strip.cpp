// Pointing at a style shows it, leaving gives the very bytes back, clicking commits the bytes that were shown.
#include "model/document/group_commands.h"
#include "model/document/layer_commands.h"
#include "tests/support/test_program.h"
#include "tests/view/strip_fixture.h"
#include "view/panels/hair_panel.h"
#include "view/panels/layers_panel.h"

#include <QEventLoop>
#include <QPointer>
#include <QSignalSpy>

using namespace hairpaint;
using namespace hairpaint::view;
using model::MapKind;

class TestStyleStrip : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pointing_shows_and_leaving_restores()
    {
        StripFixture f;
        f.state.target().setGroup(f.document.project().groups[1].id);
        const model::Id active = f.state.target().group();
        const auto before = f.document.project().groups;
        f.enter(0);
        QVERIFY(!f.document.previewing());
        QTRY_VERIFY_WITH_TIMEOUT(f.document.previewing(), test::kPatienceMs);
        QVERIFY(!sameGroups(f.document.project().groups, before));
        QVERIFY(sameGroups(f.document.committed().groups, before));
        f.leave(0);
        QVERIFY(!f.document.previewing());
        QVERIFY(sameGroups(f.document.project().groups, before));
        QCOMPARE(f.state.target().group(), active);
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

    void the_keys_stay_with_a_style_that_is_read_again()
    {
        StripFixture f;
        f.strip.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&f.strip));
        const auto entry = [](const char* name) {
            return model::PresetEntry{.path = QLatin1String(name),
                                      .name = QLatin1String(name),
                                      .tags = {},
                                      .folder = QStringLiteral("built-in"),
                                      .picture = {}};
        };
        f.tile(1).setFocus();
        f.strip.setEntries({entry("new"), entry("bob"), entry("waves")});
        const auto* focused = qobject_cast<StyleTile*>(QApplication::focusWidget());
        QVERIFY(focused != nullptr && focused->path() == QLatin1String("waves"));
        f.strip.setEntries({entry("bob")}); // It has been deleted.
        QVERIFY(f.strip.isAncestorOf(QApplication::focusWidget()));
    }

    void styles_may_be_read_again_while_one_of_them_is_being_asked()
    {
        StripFixture f;
        f.strip.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&f.strip));
        const QPointer<StyleTile> asked = &f.tile(1);
        bool isThere = false;
        connect(&f.strip, &StyleStrip::ordered, &f.strip, [&] {
            f.strip.setEntries({});
            isThere = asked != nullptr;
        });
        asked->setFocus();
        QTest::keyClick(asked, Qt::Key_I, Qt::ControlModifier);
        QVERIFY(isThere); // What it sent has not returned yet.
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(asked == nullptr);
        QCOMPARE(f.strip.findChildren<StyleTile*>().size(), qsizetype{1}); // "Save style".
    }

    void a_styles_menu_outlives_what_is_chosen_from_it()
    {
        StripFixture f;
        f.strip.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&f.strip));
        QPointer<StyleMenu> menu;
        bool isThere = false;
        connect(&f.strip, &StyleStrip::ordered, &f.strip, [&] {
            QEventLoop dialog; // As questions have.
            QTimer::singleShot(0, &dialog, &QEventLoop::quit);
            dialog.exec();
            QCoreApplication::sendPostedEvents(menu, QEvent::DeferredDelete);
            isThere = menu != nullptr;
        });
        Q_EMIT f.tile(1).menuWanted(f.tile(1).mapToGlobal(QPoint(5, 5)));
        menu = f.strip.findChild<StyleMenu*>();
        QVERIFY(menu != nullptr && menu->isVisible());
        const QList<QAction*> actions = menu->actions();
        const auto about = std::ranges::find_if(
            actions, [](const QAction* one) { return one->text().startsWith(QStringLiteral("About")); });
        QVERIFY(about != actions.end());
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(*about).center());
        QVERIFY(isThere);
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
        QCoreApplication::processEvents(); // Nor is anything being computed.
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
        LayersPanel(f.state).addLayer();
        f.state.target().setLayer(f.scalp().map(MapKind::Length).layers.front().id);
        const model::LayerAddress before = f.state.target().address();
        f.enter(0);
        QTRY_VERIFY_WITH_TIMEOUT(f.document.previewing(), test::kPatienceMs);
        QVERIFY(f.state.target().layer() != before.layer);
        if (undone)
            f.document.undo();
        else
            f.document.push(renameGroupCommand(f.document, before.group, QStringLiteral("Brows")));
        QVERIFY(!f.document.previewing());
        QCOMPARE(f.state.target().group(), before.group);
        QCOMPARE(f.state.target().layer(), before.layer);
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
        QCOMPARE(f.state.target().layer(), layers()[1].id);
        QVERIFY(hover());
        panel.moveLayer(-1);
        QCOMPARE(layers()[0].id, f.state.target().layer());
        QVERIFY(hover());
        panel.addLayer();
        QCOMPARE(layers().size(), std::size_t(3));
        QCOMPARE(f.state.target().layer(), layers()[2].id);
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

    void pointing_with_shift_held_shows_the_colour_alone()
    {
        StripFixture f;
        const auto length = f.document.resolved(f.scalp().id, MapKind::Length);
        f.enter(1);
        QTest::keyPress(&f.strip, Qt::Key_Shift);
        QTRY_VERIFY_WITH_TIMEOUT(f.document.previewing(), test::kPatienceMs);
        QCOMPARE(f.document.resolved(f.scalp().id, MapKind::Length), length);
        QTest::keyRelease(&f.strip, Qt::Key_Shift);
        QTRY_VERIFY_WITH_TIMEOUT(f.document.resolved(f.scalp().id, MapKind::Length) != length, test::kPatienceMs);
        f.leave(1);
    }

    void the_wheel_shows_none_of_what_passes_under_the_pointer()
    {
        StripFixture f;
        f.strip.resize(320, 132);
        QVERIFY(QTest::qWaitForWindowExposed(&f.strip));
        const QPoint middle = f.strip.mapToGlobal(QPoint(160, 60));
        QCursor::setPos(middle);
        QCoreApplication::processEvents();
        QVERIFY(f.pause().isActive()); // The pointer itself came onto it.
        QSignalSpy changed(&f.document, &model::Document::changed);
        for (int notch = 0; notch < 3; ++notch) {
            f.turnWheel(120);
            for (int index = 0; index < 6; ++index) // As Qt tells of pictures that move under the pointer.
                if (f.tile(index).rect().contains(f.tile(index).mapFromGlobal(middle)))
                    f.enter(index);
            QVERIFY(!f.pause().isActive());
        }
        QCursor::setPos(middle + QPoint(1, 0)); // The hand on the wheel trembles.
        QCoreApplication::processEvents();
        QVERIFY(!f.pause().isActive());
        QCOMPARE(changed.count(), 0);
        f.strip.findChild<StyleRow*>()->endScrolling();
        QVERIFY(f.pause().isActive()); // It rests there now.
        f.turnWheel(-120);
        QVERIFY(!f.pause().isActive());
        QCursor::setPos(middle + QPoint(30, 0));
        QCoreApplication::processEvents();
        QVERIFY(f.pause().isActive()); // It moves again.
        f.turnWheel(0, Qt::ScrollEnd); // A touch pad tells of the end itself.
        QVERIFY(f.pause().isActive());
        QCursor::setPos(0, 0);
        QCoreApplication::processEvents();
    }

    void the_last_tile_saves_a_style()
    {
        StripFixture f;
        QSignalSpy save(&f.strip, &StyleStrip::saveStyleRequested);
        QTest::mouseClick(f.strip.findChildren<StyleTile*>().last(), Qt::LeftButton);
        QCOMPARE(save.count(), 1);
        QCOMPARE(f.strip.paths().size(), std::size_t(6));
    }
};

HAIRPAINT_TEST(TestStyleStrip, Widgets)
#include "test_style_strip.moc"
