// Panels change the document by one command a change, preview while something moves, and follow undo.
#include "panel_fixture.h"

#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "view/panels/group_settings_panel.h"
#include "view/panels/hair_panel.h"
#include "view/panels/layer_list.h"
#include "view/panels/layers_panel.h"
#include "view/panels/map_row.h"
#include "view/panels/maps_panel.h"
#include "view/panels/option_bar.h"
#include "view/panels/tool_bar.h"
#include "view/panels/tool_hint.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QToolButton>

using namespace hairpaint;
using namespace hairpaint::view;
using model::MapKind;

namespace {

QToolButton* buttonNamed(const QWidget& parent, const QString& start)
{
    for (QToolButton* button : parent.findChildren<QToolButton*>())
        if (button->accessibleName().startsWith(start))
            return button;
    return nullptr;
}

QStringList namesOf(const LayerList& list)
{
    QStringList names;
    for (int row = 0; row < list.count(); ++row)
        names.append(list.item(row)->text());
    return names;
}

} // namespace

class TestPanels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void dragging_a_setting_previews_and_commits_one_command()
    {
        PanelFixture f;
        HairPanel panel(f.state);
        panel.resize(280, 900);
        panel.show();
        BarSlider* slider = sliderNamed(panel, QStringLiteral("Greatest length"));
        QVERIFY(slider != nullptr);
        const float before = f.scalp().settings.greatestLengthM;
        holdAt(*slider, 0.9);
        QVERIFY(f.document.previewing());
        const sim::GroupSettings shown = f.scalp().settings;
        QVERIFY(shown.greatestLengthM > before);
        QCOMPARE(f.document.committed().groups.front().settings.greatestLengthM, before);
        QCOMPARE(f.steps(), 0);
        letGo(*slider, QPoint(qRound(slider->width() * 0.9), 12));
        QCOMPARE(f.steps(), 1);
        QVERIFY(!f.document.previewing());
        QVERIFY(f.scalp().settings == shown);
        QVERIFY(f.document.undoStack().undoText().contains(QStringLiteral("Greatest length")));
        f.document.undo();
        QCOMPARE(f.scalp().settings.greatestLengthM, before);
        QCOMPARE(slider->value(), 30.0);
    }

    void a_slider_brought_back_leaves_no_command_and_no_preview()
    {
        PanelFixture f;
        HairPanel panel(f.state);
        panel.resize(280, 900);
        panel.show();
        BarSlider* slider = sliderNamed(panel, QStringLiteral("Gravity"));
        QVERIFY(slider != nullptr);
        holdAt(*slider, 0.9);
        dragTo(*slider, QPoint(slider->width() / 2, 12));
        letGo(*slider, QPoint(slider->width() / 2, 12));
        QCOMPARE(f.steps(), 0);
        QVERIFY(!f.document.previewing());
    }

    void escape_takes_a_dragged_setting_back()
    {
        PanelFixture f;
        HairPanel panel(f.state);
        panel.resize(280, 900);
        panel.show();
        BarSlider* slider = sliderNamed(panel, QStringLiteral("Shine"));
        QVERIFY(slider != nullptr);
        const sim::GroupSettings before = f.scalp().settings;
        holdAt(*slider, 0.9);
        QVERIFY(!(f.scalp().settings == before));
        QTest::keyClick(slider, Qt::Key_Escape);
        QVERIFY(f.scalp().settings == before);
        QCOMPARE(f.steps(), 0);
        QVERIFY(!f.document.previewing());
    }

    void every_setting_reaches_the_group_and_comes_back_by_undo()
    {
        PanelFixture f;
        HairPanel panel(f.state);
        panel.resize(280, 900);
        panel.show();
        const sim::GroupSettings before = f.scalp().settings;
        int sliders = 0;
        for (BarSlider* slider : panel.findChildren<BarSlider*>()) {
            if (!slider->isVisibleTo(&panel))
                continue;
            const sim::GroupSettings last = f.scalp().settings;
            holdAt(*slider, slider->value() > (slider->minimum() + slider->maximum()) / 2.0 ? 0.2 : 0.8);
            letGo(*slider, QPoint(1, 12));
            ++sliders;
            QVERIFY2(!(f.scalp().settings == last), qPrintable(slider->label()));
            QCOMPARE(f.steps(), sliders);
        }
        QVERIFY(sliders >= 20);
        for (int i = 0; i < sliders; ++i)
            f.document.undo();
        QVERIFY(f.scalp().settings == before);
    }

    void turns_mode_and_levels_are_commands_of_their_own()
    {
        PanelFixture f;
        HairPanel panel(f.state);
        panel.show();
        const auto boxes = panel.findChildren<QComboBox*>();
        auto* mode = *std::ranges::find_if(boxes, [](const QComboBox* box) { return box->isVisible(); });
        QTest::keyClick(mode, Qt::Key_Down);
        QVERIFY(f.scalp().settings.turnsMode == sim::TurnsMode::PerLength);
        auto* stepped = panel.findChild<GroupSettingsPanel*>()->findChild<QCheckBox*>();
        stepped->click();
        QVERIFY(f.scalp().settings.steppedTurns);
        QCOMPARE(f.steps(), 2);
        f.document.undo();
        QVERIFY(!stepped->isChecked());
    }

    void the_settings_used_most_come_first()
    {
        PanelFixture f;
        HairPanel panel(f.state);
        panel.resize(280, 3000);
        panel.show();
        std::vector<const BarSlider*> sliders;
        for (const BarSlider* slider : panel.findChildren<BarSlider*>())
            if (slider->isVisible())
                sliders.push_back(slider);
        const auto top = [&panel](const BarSlider* slider) { return slider->mapTo(&panel, QPoint()).y(); };
        std::ranges::sort(sliders, {}, top);
        QStringList labels;
        for (const BarSlider* slider : sliders)
            labels.append(slider->label());
        const QStringList wanted{QStringLiteral("Greatest length"), QStringLiteral("Greatest density"),
                                 QStringLiteral("Hair width")};
        QCOMPARE(labels.first(3), wanted);
    }

    void groups_are_added_shown_renamed_moved_and_removed()
    {
        PanelFixture f;
        HairPanel panel(f.state);
        panel.resize(280, 900);
        panel.show();
        auto* list = panel.findChild<LayerList*>();
        QCOMPARE(namesOf(*list), QStringList({QStringLiteral("Scalp"), QStringLiteral("Beard")}));
        buttonNamed(panel, QStringLiteral("Add hair group"))->click();
        panel.findChild<QMenu*>(QStringLiteral("whatGrows"))->actions().constLast()->trigger();
        QCOMPARE(list->count(), 3);
        QCOMPARE(f.state.target().group(), f.document.project().groups.back().id);
        const QRect beard = list->visualItemRect(list->item(1));
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, LayerList::eyeRect(beard).center());
        QVERIFY(!f.document.project().groups[1].visible);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, beard.center());
        QCOMPARE(f.state.target().group(), f.document.project().groups[1].id);
        QTest::mouseDClick(list->viewport(), Qt::LeftButton, {}, beard.center());
        auto* editor = list->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        editor->setText(QStringLiteral("Brows"));
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(f.document.project().groups[1].name, QStringLiteral("Brows"), test::kPatienceMs);
        QTest::keyClick(list, Qt::Key_Down, Qt::AltModifier);
        QTRY_COMPARE_WITH_TIMEOUT(f.document.project().groups[2].name, QStringLiteral("Brows"), test::kPatienceMs);
        QCOMPARE(list->currentRow(), 2);
        QTest::keyClick(list, Qt::Key_Up, Qt::AltModifier);
        QTRY_COMPARE_WITH_TIMEOUT(f.document.project().groups[1].name, QStringLiteral("Brows"), test::kPatienceMs);
        QTest::keyClick(list, Qt::Key_Delete);
        QCOMPARE(list->count(), 2);
        QCOMPARE(f.steps(), 6);
        for (int i = 0; i < 6; ++i)
            f.document.undo();
        QCOMPARE(namesOf(*list), QStringList({QStringLiteral("Scalp"), QStringLiteral("Beard")}));
        QVERIFY(f.document.project().groups[1].visible);
    }

    void layers_are_added_duplicated_moved_and_removed()
    {
        PanelFixture f;
        LayersPanel panel(f.state);
        panel.resize(280, 400);
        panel.show();
        auto* list = panel.findChild<LayerList*>();
        const QString first = list->item(0)->text();
        buttonNamed(panel, QStringLiteral("Add layer"))->click();
        QCOMPARE(list->count(), 2);
        const QString second = list->item(0)->text();
        QVERIFY(second != first);
        QCOMPARE(f.state.target().layer(), list->idAt(0));
        buttonNamed(panel, QStringLiteral("Move layer down"))->click();
        QCOMPARE(namesOf(*list), QStringList({first, second}));
        QVERIFY(!buttonNamed(panel, QStringLiteral("Move layer down"))->isEnabled());
        QTest::keyClick(list, Qt::Key_Up, Qt::AltModifier);
        QTRY_COMPARE_WITH_TIMEOUT(namesOf(*list), QStringList({second, first}), test::kPatienceMs);
        buttonNamed(panel, QStringLiteral("Duplicate layer"))->click();
        QCOMPARE(list->count(), 3);
        QCOMPARE(f.state.target().layer(), list->idAt(0));
        QTest::keyClick(list, Qt::Key_Delete);
        QCOMPARE(namesOf(*list), QStringList({second, first}));
        QCOMPARE(f.steps(), 5);
        for (int i = 0; i < 5; ++i)
            f.document.undo();
        QCOMPARE(namesOf(*list), QStringList({first}));
    }

    void dropping_a_layer_moves_it_by_one_command()
    {
        PanelFixture f;
        LayersPanel panel(f.state);
        panel.resize(280, 400);
        panel.show();
        panel.addLayer();
        panel.addLayer();
        auto* list = panel.findChild<LayerList*>();
        const QStringList before = namesOf(*list);
        list->setCurrentRow(0);
        QSignalSpy wanted(list, &LayerList::moveWanted);
        // Below the middle of the last row: to the bottom.
        QVERIFY(list->dropAt(list->visualItemRect(list->item(2)).bottomLeft() + QPoint(40, -2)));
        QTRY_COMPARE_WITH_TIMEOUT(namesOf(*list), QStringList({before[1], before[2], before[0]}), test::kPatienceMs);
        QCOMPARE(f.steps(), 3);
        f.document.undo();
        QCOMPARE(namesOf(*list), before);
        // On its own row: nothing happens.
        QVERIFY(!list->dropAt(list->visualItemRect(list->currentItem()).center()));
        QCOMPARE(wanted.count(), 1);
    }

    void the_active_layer_stays_marked_wherever_one_clicks()
    {
        PanelFixture f;
        LayersPanel panel(f.state);
        panel.resize(280, 400);
        panel.show();
        panel.addLayer();
        auto* list = panel.findChild<LayerList*>();
        const QRect active = list->visualItemRect(list->currentItem());
        const QPoint below = list->visualItemRect(list->item(1)).bottomLeft() + QPoint(60, 30);
        QVERIFY(list->itemAt(below) == nullptr);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, below);
        QVERIFY(list->currentItem() != nullptr && list->currentItem()->isSelected());
        QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::ControlModifier, active.center());
        QVERIFY(list->currentItem()->isSelected());
        QCOMPARE(f.state.target().layer(), list->idAt(0));
    }

    void eye_and_lock_are_clicked_in_the_row()
    {
        PanelFixture f;
        LayersPanel panel(f.state);
        panel.resize(280, 400);
        panel.show();
        auto* list = panel.findChild<LayerList*>();
        const QRect row = list->visualItemRect(list->item(0));
        const auto layer = [&] { return f.scalp().map(MapKind::Length).layers.front(); };
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, LayerList::eyeRect(row).center());
        QVERIFY(!layer().visible);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, LayerList::lockRect(row).center());
        QVERIFY(layer().locked);
        QVERIFY(list->item(0)->data(Qt::AccessibleTextRole).toString().contains(QStringLiteral("locked")));
        QCOMPARE(f.steps(), 2);
        f.document.undo();
        f.document.undo();
        QVERIFY(layer().visible && !layer().locked);
    }

    void a_layer_is_renamed_in_its_row()
    {
        PanelFixture f;
        LayersPanel panel(f.state);
        panel.resize(280, 400);
        panel.show();
        auto* list = panel.findChild<LayerList*>();
        list->setFocus();
        QTest::keyClick(list, Qt::Key_F2);
        auto* editor = list->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        editor->setText(QStringLiteral("Fringe"));
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(f.scalp().map(MapKind::Length).layers.front().name, QStringLiteral("Fringe"),
                                  test::kPatienceMs);
        QCOMPARE(f.steps(), 1);
    }

    void opacity_previews_and_commits_once()
    {
        PanelFixture f;
        LayersPanel panel(f.state);
        panel.resize(280, 400);
        panel.show();
        BarSlider* slider = sliderNamed(panel, QStringLiteral("Opacity"));
        const auto opacity = [&] { return f.scalp().map(MapKind::Length).layers.front().opacity; };
        const int drawn = panel.drawnThumbnails();
        QCOMPARE(drawn, 1);
        holdAt(*slider, 0.25);
        QVERIFY(f.document.previewing());
        const float shown = opacity();
        QVERIFY(shown < 0.3F);
        letGo(*slider, QPoint(slider->width() / 4, 12));
        QCOMPARE(f.steps(), 1);
        QCOMPARE(opacity(), shown);
        f.document.undo();
        QCOMPARE(opacity(), 1.0F);
        QCOMPARE(panel.drawnThumbnails(), drawn); // No texel of the layer has changed.
    }

    void an_index_map_offers_only_its_own_blend_modes()
    {
        PanelFixture f;
        LayersPanel panel(f.state);
        auto* blend = panel.findChild<QComboBox*>();
        QCOMPARE(blend->count(), static_cast<int>(model::kBlendModeCount));
        f.state.target().setMap(MapKind::Braid);
        QCOMPARE(blend->count(), 1);
        QVERIFY(!blend->isEnabled());
    }

    void maps_are_switched_by_click_and_number()
    {
        PanelFixture f;
        MapsPanel panel(f.state);
        panel.resize(280, 240);
        panel.show();
        const auto rows = panel.findChildren<MapRow*>();
        QCOMPARE(rows.size(), model::kMapKindCount);
        QVERIFY(rows[1]->isChecked());
        QTest::mouseClick(rows[2], Qt::LeftButton);
        QVERIFY(f.state.target().map() == MapKind::Curl);
        QTest::keyClick(&panel, Qt::Key_6);
        QVERIFY(f.state.target().map() == MapKind::Colour);
        QVERIFY(rows[5]->isChecked() && !rows[2]->isChecked());
        QCOMPARE(f.steps(), 0);
    }

    void a_low_window_scrolls_to_the_map_that_is_chosen()
    {
        PanelFixture f;
        MapsPanel panel(f.state);
        panel.resize(280, panel.minimumSizeHint().height());
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        const auto rows = panel.findChildren<MapRow*>();
        const auto isSeen = [](const MapRow* row) {
            return row->visibleRegion().boundingRect().height() >= MapRow::kThumbnailSide;
        };
        QVERIFY(isSeen(rows.front()) && !isSeen(rows.back()));
        rows[9]->setFocus();
        f.state.target().setMap(MapKind::Direction);
        for (int down = 0; down < 5; ++down)
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Down);
        QVERIFY(f.state.target().map() == MapKind::Accessory);
        QTRY_VERIFY(isSeen(rows.back()) && !isSeen(rows.front()));
        QTest::keyClick(&panel, Qt::Key_1);
        QTRY_VERIFY(isSeen(rows.front()));
        panel.resize(280, panel.sizeHint().height());
        QTRY_VERIFY(isSeen(rows.front()) && isSeen(rows.back()));
    }

    void tools_are_chosen_and_shown_with_their_own_options()
    {
        PanelFixture f;
        ToolBar tools(f.state);
        OptionBar options(f.state);
        tools.show();
        options.resize(1100, 40);
        options.show();
        const auto buttons = tools.findChildren<QToolButton*>();
        QCOMPARE(buttons.size(), static_cast<qsizetype>(f.state.tools().all().size()));
        for (std::size_t i = 0; i < f.state.tools().all().size(); ++i) {
            buttons[static_cast<qsizetype>(i)]->click();
            const model::Tool& tool = *f.state.tools().all()[i];
            QCOMPARE(&f.state.tools().active(), &tool);
            const auto wanted = tool.options();
            const auto has = [&wanted](const char* key) {
                return std::ranges::any_of(wanted, [key](const model::ToolOption* option) {
                    return QLatin1StringView(option->key) == QLatin1StringView(key);
                });
            };
            const bool hasSize = has("size");
            QCOMPARE(sliderNamed(options, QStringLiteral("Size"))->isVisible(), hasSize);
            const bool hasTolerance = has("fill_tolerance");
            QCOMPARE(sliderNamed(options, QStringLiteral("Tolerance"))->isVisible(), hasTolerance);
            const QString tip = buttons[static_cast<qsizetype>(i)]->toolTip();
            for (const QString& told : {tool.title(), tool.purpose(), tool.hint()})
                QVERIFY2(!told.isEmpty() && tip.contains(told.toHtmlEscaped()), qPrintable(tip));
        }
    }

    void a_tools_hint_tells_and_shows_what_it_does()
    {
        PanelFixture f;
        ToolBar tools(f.state);
        tools.resize(44, 800);
        tools.show();
        const auto ask = [&tools, &f](model::ToolId tool) {
            const auto index =
                std::ranges::find(f.state.tools().all(), tool, [](const auto& one) { return one->id(); }) -
                f.state.tools().all().begin();
            QToolButton* button = tools.findChildren<QToolButton*>().at(index);
            const QPoint middle = button->rect().center();
            QHelpEvent event(QEvent::ToolTip, middle, button->mapToGlobal(middle));
            QCoreApplication::sendEvent(button, &event);
            return button;
        };
        const auto* hint = tools.findChild<ToolHint*>();
        auto* demo = hint->findChild<ToolDemo*>();
        ask(model::ToolId::Brush);
        QVERIFY(hint->isVisible() && !demo->isVisible());
        for (const model::ToolId tool : {model::ToolId::Comb, model::ToolId::Part, model::ToolId::Grab,
                                         model::ToolId::Fingers, model::ToolId::Scissors, model::ToolId::Gradient}) {
            QToolButton* button = ask(tool);
            QVERIFY(hint->isVisible() && demo->isVisible());
            QCOMPARE(hint->findChild<QLabel*>()->text(), button->toolTip());
            auto* play = demo->findChild<QVariantAnimation*>();
            const QImage before = demo->grab().toImage();
            play->setCurrentTime(play->duration() * 7 / 8);
            QVERIFY(demo->grab().toImage() != before);
            QEvent leave(QEvent::Leave);
            QCoreApplication::sendEvent(button, &leave);
            QVERIFY(!hint->isVisible());
        }
    }

    void brush_options_change_the_settings_outside_undo()
    {
        PanelFixture f;
        OptionBar options(f.state);
        options.resize(1100, 40);
        options.show();
        BarSlider* size = sliderNamed(options, QStringLiteral("Size"));
        holdAt(*size, 1.0);
        QVERIFY(std::abs(f.state.tools().settings().brushSizeM - 0.3F) < 1e-4F);
        letGo(*size, QPoint(size->width(), 12));
        BarSlider* value = sliderNamed(options, QStringLiteral("Length"));
        QVERIFY(value != nullptr);
        holdAt(*value, 1.0);
        letGo(*value, QPoint(value->width(), 12));
        model::ToolSettings settings = f.state.tools().settings();
        QCOMPARE(settings.value(MapKind::Length).scalar, 1.0F);
        QCOMPARE(f.steps(), 0);
    }
};

HAIRPAINT_TEST(TestPanels, Widgets)
#include "test_panels.moc"
