// What panels offer beyond their buttons: menus, words on what erasing leaves, sizes of maps.
#include "panel_fixture.h"

#include "model/document/layer_commands.h"
#include "model/styles/hair_kinds.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "view/panels/hair_panel.h"
#include "view/panels/layer_list.h"
#include "view/panels/layers_panel.h"
#include "view/panels/map_row.h"
#include "view/panels/maps_panel.h"
#include "view/panels/option_bar.h"
#include "view/widgets/value_pair.h"
#include "view/widgets/value_palette.h"

#include <QContextMenuEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>

#include <algorithm>

using namespace hairpaint;
using namespace hairpaint::view;
using model::MapKind;

namespace {

QAction* actionNamed(const QMenu& menu, const QString& text)
{
    for (QAction* action : menu.actions())
        if (action->text() == text)
            return action;
    return nullptr;
}

} // namespace

class TestPanelMenus : public QObject
{
    Q_OBJECT

    /// The context menu over the first row, closed again by the action named.
    static void choose(LayersPanel& panel, const QString& text)
    {
        auto* list = panel.findChild<LayerList*>();
        const QPoint position = list->visualItemRect(list->item(0)).center();
        QContextMenuEvent asked(QContextMenuEvent::Mouse, position, list->viewport()->mapToGlobal(position));
        QApplication::sendEvent(list->viewport(), &asked);
        auto* menu = panel.findChild<QMenu*>(QStringLiteral("layerMenu"));
        QVERIFY(menu != nullptr && menu->isVisible());
        QAction* action = actionNamed(*menu, text);
        QVERIFY2(action != nullptr, qPrintable(text));
        action->trigger();
        delete menu;
    }

private Q_SLOTS:
    void layers_have_a_context_menu()
    {
        PanelFixture f;
        LayersPanel panel(f.state);
        panel.resize(280, 400);
        panel.show();
        const auto layers = [&]() -> const std::vector<model::Layer>& {
            return f.document.project().group(f.state.target().group())->map(f.state.target().map()).layers;
        };
        choose(panel, QStringLiteral("Duplicate layer"));
        QCOMPARE(layers().size(), std::size_t{2});
        choose(panel, QStringLiteral("Hide layer"));
        QVERIFY(!layers().back().visible);
        choose(panel, QStringLiteral("Lock layer"));
        QVERIFY(layers().back().locked);
        const model::Id top = layers().back().id;
        choose(panel, QStringLiteral("Move layer down"));
        QCOMPARE(layers().front().id, top);
        choose(panel, QStringLiteral("Remove layer"));
        QCOMPARE(layers().size(), std::size_t{1});
        choose(panel, QStringLiteral("Rename layer"));
        auto* name = panel.findChild<QLineEdit*>();
        QVERIFY(name != nullptr);
        name->setText(QStringLiteral("Fringe"));
        QTest::keyClick(name, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(layers().front().name, QStringLiteral("Fringe"), test::kPatienceMs);
    }

    void adding_a_group_asks_what_grows()
    {
        PanelFixture f;
        HairPanel panel(f.state);
        panel.resize(280, 900);
        panel.show();
        panel.askWhatGrows();
        auto* menu = panel.findChild<QMenu*>(QStringLiteral("whatGrows"));
        QVERIFY(menu != nullptr && menu->isVisible());
        QCOMPARE(menu->actions().constFirst()->text(), QStringLiteral("What grows?")); // Not a line without words.
        QVERIFY(!menu->actions().constFirst()->isSeparator());
        QCOMPARE(f.steps(), 0);
        actionNamed(*menu, QStringLiteral("Brows"))->trigger();
        QCOMPARE(f.steps(), 1);
        const model::HairGroup& brows = f.document.project().groups.back();
        QCOMPARE(brows.name, QStringLiteral("Brows"));
        QCOMPARE(f.state.target().group(), brows.id);
        QCOMPARE(f.state.target().map(), MapKind::Density);
        QVERIFY(brows.settings.greatestLengthM < 0.02F);
        QVERIFY(brows.settings.material.widthM < sim::GroupSettings{}.material.widthM);
    }

    void every_kind_of_hair_is_within_what_files_hold()
    {
        for (const model::HairKind& kind : model::hairKinds()) {
            sim::GroupSettings settings;
            kind.apply(settings);
            QVERIFY(settings.greatestLengthM >= 0.001F && settings.greatestLengthM <= 2.0F);
            QVERIFY(settings.greatestDensityPerM2 >= 1e4F && settings.greatestDensityPerM2 <= 4e6F);
            QVERIFY(settings.material.widthM >= 10e-6F && settings.material.widthM <= 1e-3F);
        }
    }

    void a_second_group_of_a_kind_has_a_name_of_its_own()
    {
        PanelFixture f;
        HairPanel panel(f.state);
        for (int i = 0; i < 2; ++i)
            panel.addGroup(model::hairKinds()[3]);
        const auto& groups = f.document.project().groups;
        QVERIFY(groups.back().name != groups[groups.size() - 2].name);
    }

    void a_maps_row_tells_its_size()
    {
        PanelFixture f;
        MapsPanel panel(f.state);
        panel.show();
        for (const MapRow* row : panel.findChildren<MapRow*>()) {
            QVERIFY2(row->toolTip().contains(QStringLiteral("256 x 256")), qPrintable(row->toolTip()));
            QVERIFY(row->accessibleDescription().contains(QStringLiteral("256")));
        }
    }

    void the_eraser_says_what_it_reveals()
    {
        PanelFixture f;
        OptionBar bar(f.state);
        bar.resize(1200, 40);
        bar.show();
        auto* words = bar.findChild<QLabel*>(QStringLiteral("revealed"));
        QVERIFY(!words->isVisible());
        f.state.tools().choose(model::ToolId::Eraser);
        QVERIFY(words->isVisible());
        QVERIFY2(words->text().startsWith(QStringLiteral("reveals 15")), qPrintable(words->text()));
        f.state.target().setMap(MapKind::Braid);
        QCOMPARE(words->text(), QStringLiteral("reveals None, the default"));
        f.state.target().setMap(MapKind::TipColour);
        QCOMPARE(words->text(), QStringLiteral("reveals the map Colour"));
        f.state.target().setMap(MapKind::Braid);
        f.document.push(addLayerCommand(f.document, f.state.target().group(), MapKind::Braid, QStringLiteral("Above")));
        f.state.target().setLayer(f.scalp().map(MapKind::Braid).layers.back().id);
        QCOMPARE(words->text(), QStringLiteral("reveals the layers below"));
    }

    void a_click_on_the_swatch_opens_the_picker()
    {
        PanelFixture f;
        OptionBar bar(f.state);
        bar.resize(1200, 40);
        bar.show();
        auto* pair = bar.findChild<ValuePair*>();
        QTest::mouseClick(pair, Qt::LeftButton, {}, QPoint(8, 8));
        auto* palette = pair->findChild<ValuePalette*>();
        QVERIFY(palette != nullptr && palette->isVisible() && !palette->second());
        palette->window()->close();
    }
};

HAIRPAINT_TEST(TestPanelMenus, Widgets)
#include "test_panel_menus.moc"
