// The palette picks what a map is painted with, in the group's own units.
#include "panel_fixture.h"

#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "view/look/value_text.h"
#include "view/panels/option_bar.h"
#include "view/widgets/bar_slider.h"
#include "view/widgets/field_hint.h"
#include "view/widgets/melanin.h"
#include "view/widgets/swatch.h"
#include "view/widgets/value_pair.h"
#include "view/widgets/value_palette.h"

#include <QColorDialog>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>

#include <algorithm>
#include <cmath>

using namespace hairpaint;
using namespace hairpaint::view;
using model::MapKind;

class TestValues : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void the_palette_sets_the_value_painted_data()
    {
        QTest::addColumn<int>("map");
        for (const model::MapSpec& spec : model::mapSpecs())
            QTest::newRow(spec.id) << static_cast<int>(spec.kind);
    }
    void the_palette_sets_the_value_painted()
    {
        QFETCH(int, map);
        PanelFixture f;
        f.state.target().setMap(static_cast<MapKind>(map));
        ValuePalette palette(f.state);
        palette.show();
        const auto swatches = palette.findChildren<Swatch*>();
        QVERIFY(swatches.size() >= 4);
        const auto value = [&] {
            model::ToolSettings settings = f.state.tools().settings();
            return settings.value(static_cast<MapKind>(map));
        };
        QTest::mouseClick(swatches.last(), Qt::LeftButton);
        const model::PaintValue last = value();
        QTest::mouseClick(swatches.first(), Qt::LeftButton);
        QVERIFY(!(value() == last));
        QVERIFY(swatches.first()->isChecked() && !swatches.last()->isChecked());
        QTest::keyClick(&palette, Qt::Key_X);
        QTest::keyClick(&palette, Qt::Key_X);
        QVERIFY(swatches.first()->isChecked());
        QVERIFY(f.steps() == 0);
    }

    void a_click_on_a_square_asks_for_its_picker_and_the_arrow_swaps()
    {
        PanelFixture f;
        ValuePair pair(f.state);
        pair.resize(pair.sizeHint());
        pair.show();
        QSignalSpy wanted(&pair, &ValuePair::pickWanted);
        const model::ToolSettings before = f.state.tools().settings();
        QTest::mouseClick(&pair, Qt::LeftButton, {}, QPoint(8, 8));
        QTest::mouseClick(&pair, Qt::LeftButton, {}, QPoint(pair.width() - 5, pair.height() - 5));
        QCOMPARE(wanted.size(), 2);
        QVERIFY(!wanted[0][0].toBool() && wanted[1][0].toBool());
        QVERIFY(f.state.tools().settings() == before);
        QTest::mouseClick(&pair, Qt::LeftButton, {}, pair.arrowRect().center());
        QCOMPARE(wanted.size(), 2);
        const MapKind map = f.state.target().map();
        QVERIFY(f.state.tools().settings().value(map) == before.secondValue(map));
        QVERIFY(f.state.tools().settings().secondValue(map) == before.value(map));
    }

    void the_second_value_has_the_same_picker()
    {
        PanelFixture f;
        QWidget anchor;
        anchor.show();
        ValuePalette* palette = ValuePalette::openUnder(anchor, f.state, true);
        const MapKind map = f.state.target().map();
        const model::PaintValue first = f.state.tools().settings().value(map);
        QTest::mouseClick(palette->findChildren<Swatch*>().last(), Qt::LeftButton);
        QVERIFY(f.state.tools().settings().value(map) == first);
        QCOMPARE(f.state.tools().settings().secondValue(map).scalar, 1.0F);
    }

    void a_custom_colour_outlives_its_popup()
    {
        PanelFixture f;
        f.state.target().setMap(MapKind::Colour);
        QWidget anchor;
        anchor.show();
        const QPointer<ValuePalette> palette = ValuePalette::openUnder(anchor, f.state);
        QTest::mouseClick(palette->findChild<QPushButton*>(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(palette.isNull(), test::kPatienceMs);
        auto* dialog = anchor.findChild<QColorDialog*>();
        QVERIFY(dialog != nullptr);
        dialog->setCurrentColor(QColor(1, 2, 3));
        dialog->accept();
        QCOMPARE(f.state.tools().settings().value(MapKind::Colour).colour, QColor(1, 2, 3));
    }

    void a_double_click_on_a_value_leaves_what_is_painted_data()
    {
        QTest::addColumn<int>("map");
        QTest::addColumn<QString>("label");
        QTest::addColumn<bool>("inPalette");
        QTest::newRow("in the bar") << int(MapKind::Length) << QStringLiteral("Length") << false;
        QTest::newRow("of the brush") << int(MapKind::Length) << QStringLiteral("Size") << false;
        QTest::newRow("in the palette") << int(MapKind::Length) << QStringLiteral("Value") << true;
        QTest::newRow("of a direction") << int(MapKind::Direction) << QStringLiteral("Angle") << true;
        QTest::newRow("of a colour") << int(MapKind::Colour) << QStringLiteral("Melanin") << true;
    }
    void a_double_click_on_a_value_leaves_what_is_painted()
    {
        QFETCH(int, map);
        QFETCH(QString, label);
        QFETCH(bool, inPalette);
        PanelFixture f;
        f.state.target().setMap(static_cast<MapKind>(map));
        OptionBar bar(f.state);
        bar.resize(1200, 40);
        bar.show();
        ValuePalette palette(f.state);
        palette.show();
        BarSlider* slider = sliderNamed(inPalette ? static_cast<QWidget&>(palette) : bar, label);
        QVERIFY(slider != nullptr);
        const model::ToolSettings before = f.state.tools().settings();
        const double shown = slider->value();
        const QPoint there(slider->width() * 9 / 10, slider->height() / 2);
        for (const char* const typed : std::initializer_list<const char*>{"long", "", nullptr}) {
            QTest::mouseClick(slider, Qt::LeftButton, {}, there);
            QVERIFY(!(f.state.tools().settings() == before));
            QTest::mouseDClick(slider, Qt::LeftButton, {}, there);
            QVERIFY(f.state.tools().settings() == before);
            auto* editor = slider->findChild<QLineEdit*>();
            QVERIFY(editor != nullptr);
            if (typed != nullptr)
                editor->setText(QLatin1StringView(typed));
            QTest::keyClick(editor, Qt::Key_Return);
            QCOMPARE(editor->isVisible(), typed != nullptr);
            QCOMPARE(FieldHint::textAt(*slider).isEmpty(), typed == nullptr);
            QTest::keyClick(editor, Qt::Key_Escape);
            QVERIFY(f.state.tools().settings() == before);
            QCOMPARE(slider->value(), shown);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        }
        QCOMPARE(f.steps(), 0);
    }

    void bar_and_palette_show_what_was_typed_in_either()
    {
        PanelFixture f;
        f.state.target().setMap(MapKind::Length);
        OptionBar bar(f.state);
        bar.resize(1200, 40);
        bar.show();
        ValuePalette palette(f.state);
        palette.show();
        const auto type = [&](QWidget& parent, const QString& label, const QString& text) {
            BarSlider* slider = sliderNamed(parent, label);
            slider->setFocus();
            QTest::keyClick(slider, Qt::Key_Return);
            auto* editor = slider->findChild<QLineEdit*>();
            editor->setText(text);
            QTest::keyClick(editor, Qt::Key_Return);
        };
        type(bar, QStringLiteral("Length"), QStringLiteral("4mm"));
        QCOMPARE(sliderNamed(palette, QStringLiteral("Value"))->value(), 0.4);
        type(palette, QStringLiteral("Value"), QStringLiteral("3in"));
        QCOMPARE(sliderNamed(bar, QStringLiteral("Length"))->value(), 7.6);
        model::ToolSettings settings = f.state.tools().settings();
        QVERIFY(std::abs(shownValue({}, MapKind::Length, double(settings.value(MapKind::Length).scalar)) - 7.6) < 1e-5);
    }

    void a_click_that_waits_for_its_double_is_of_the_map_it_was_made_on()
    {
        PanelFixture f;
        f.state.target().setMap(MapKind::Length);
        OptionBar bar(f.state);
        bar.resize(1200, 40);
        bar.show();
        BarSlider* slider = sliderNamed(bar, QStringLiteral("Length"));
        QVERIFY(slider != nullptr);
        QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() / 4, slider->height() / 2));
        f.state.target().setMap(MapKind::Clump);
        QVERIFY(!slider->editing());
        QCOMPARE(slider->label(), QStringLiteral("Clump"));
        const auto clump =
            static_cast<double>(model::ToolSettings(f.state.tools().settings()).value(MapKind::Clump).scalar);
        QCOMPARE(slider->value(), std::round(shownValue({}, MapKind::Clump, clump)));
    }

    void the_first_values_come_back()
    {
        PanelFixture f;
        f.state.target().setMap(MapKind::Length);
        const model::ToolSettings first = f.state.tools().settings();
        swapValues(f.state);
        QVERIFY(!(f.state.tools().settings() == first));
        resetValues(f.state);
        QVERIFY(f.state.tools().settings() == first);
    }

    void hair_or_skin_is_asked_where_a_tool_knows_both()
    {
        PanelFixture f;
        OptionBar bar(f.state);
        f.state.tools().choose(model::ToolId::Comb);
        const auto isAsked = [&](model::CombKind kind) {
            model::ToolSettings settings = f.state.tools().settings();
            settings.comb = kind;
            f.state.tools().setSettings(settings);
            const QList<QToolButton*> all = bar.findChildren<QToolButton*>();
            const auto skin = std::ranges::find_if(all, [](const QToolButton* one) {
                return one->accessibleName().startsWith(QStringLiteral("On the skin"));
            });
            return skin != all.end() && (*skin)->isEnabled();
        };
        QVERIFY(isAsked(model::CombKind::Lay));
        QVERIFY(isAsked(model::CombKind::Hold));
        QVERIFY(!isAsked(model::CombKind::Whorl));
    }

    void what_is_no_colour_is_said_and_the_true_one_comes_back()
    {
        PanelFixture f;
        f.state.target().setMap(MapKind::Colour);
        ValuePalette palette(f.state);
        palette.show();
        palette.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&palette));
        auto* hex = palette.findChild<QLineEdit*>();
        QVERIFY(hex != nullptr);
        const QString painted = hex->text();
        hex->setFocus();
        hex->selectAll();
        QTest::keyClicks(hex, QStringLiteral("12"));
        QTest::keyClick(hex, Qt::Key_Return);
        QCOMPARE(hex->text(), QStringLiteral("12"));
        QVERIFY(FieldHint::textAt(*hex).startsWith(QStringLiteral("“12” is no colour")));
        QVERIFY(hex->property("refused").toBool());
        hex->clearFocus();
        QCOMPARE(hex->text(), painted);
        QVERIFY(!hex->property("refused").toBool());
    }

    void hex_colours_are_typed()
    {
        PanelFixture f;
        f.state.target().setMap(MapKind::Colour);
        ValuePalette palette(f.state);
        palette.show();
        auto* hex = palette.findChild<QLineEdit*>();
        QVERIFY(hex != nullptr);
        hex->setFocus();
        hex->selectAll();
        QTest::keyClicks(hex, QStringLiteral("B3182B"));
        QTest::keyClick(hex, Qt::Key_Return);
        model::ToolSettings settings = f.state.tools().settings();
        QCOMPARE(settings.value(MapKind::Colour).colour.name(), QStringLiteral("#b3182b"));
    }

    void natural_colours_are_set_by_their_pigment()
    {
        PanelFixture f;
        f.state.target().setMap(MapKind::Colour);
        ValuePalette palette(f.state);
        palette.show();
        const auto slider = [&](const QString& label) {
            const auto sliders = palette.findChildren<BarSlider*>();
            const auto found = std::ranges::find_if(sliders, [&](BarSlider* s) { return s->label() == label; });
            return found == sliders.end() ? nullptr : *found;
        };
        BarSlider* melanin = slider(QStringLiteral("Melanin"));
        BarSlider* redness = slider(QStringLiteral("Redness"));
        if (melanin == nullptr || redness == nullptr)
            QFAIL("There are no such sliders.");
        const auto painted = [&] {
            model::ToolSettings settings = f.state.tools().settings();
            return settings.value(MapKind::Colour).colour;
        };
        const auto clickAt = [](BarSlider& slider, double fraction) {
            QTest::mouseClick(&slider, Qt::LeftButton, {},
                              QPoint(qRound(fraction * slider.width()), slider.height() / 2));
        };
        clickAt(*redness, 0.5);
        clickAt(*melanin, 0.9);
        const QColor black = painted();
        clickAt(*melanin, 0.2);
        const QColor blond = painted();
        QVERIFY(black.lightness() < 30 && blond.lightness() > 120);
        QVERIFY(blond.red() > blond.green() && blond.green() > blond.blue());
        clickAt(*redness, 0.95);
        const double warmth = static_cast<double>(painted().red()) / painted().blue();
        QVERIFY(warmth > static_cast<double>(blond.red()) / blond.blue());
        QVERIFY(std::abs(melanin->value() - 20.0) < 3.0); // It stayed where it was put.
        QCOMPARE(f.steps(), 0);
    }

    void the_sliders_of_pigment_show_the_colour_that_is_painted()
    {
        for (int amount = 10; amount <= 90; amount += 20)
            for (int redness = 0; redness <= 100; redness += 25) {
                const Melanin put{.amount = amount / 100.0, .redness = redness / 100.0};
                const Melanin found = nearestMelanin(melaninColour(put));
                QVERIFY(std::abs(found.amount - put.amount) < 0.01 && std::abs(found.redness - put.redness) < 0.02);
            }
        for (const QRgb dyed : {0xFF2A4FB0U, 0xFFE86CA8U, 0xFF00FF00U, 0xFF000000U, 0xFFFFFFFFU}) {
            const Melanin nearest = nearestMelanin(QColor::fromRgb(dyed));
            QVERIFY(nearest.amount >= 0.0 && nearest.amount <= 1.0);
            QVERIFY(nearest.redness >= 0.0 && nearest.redness <= 1.0);
        }
    }

    void swapping_twice_gives_the_same_values()
    {
        PanelFixture f;
        const model::ToolSettings before = f.state.tools().settings();
        swapValues(f.state);
        QVERIFY(f.state.tools().settings().values != before.values);
        swapValues(f.state);
        QVERIFY(f.state.tools().settings().values == before.values);
    }

    void shown_numbers_and_map_values_are_each_others_inverse_data()
    {
        QTest::addColumn<int>("map");
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("shown");
        QTest::newRow("half the density") << int(MapKind::Density) << 0.5 << 75.0;
        QTest::newRow("half the length") << int(MapKind::Length) << 0.5 << 15.0;
        QTest::newRow("no curl") << int(MapKind::Curl) << 0.0 << 0.0;
        QTest::newRow("curl level 1") << int(MapKind::Curl) << 0.2 << 0.5;
        QTest::newRow("curl level 3") << int(MapKind::Curl) << 0.6 << 4.0;
        QTest::newRow("between levels") << int(MapKind::Curl) << 0.9 << 12.0;
        QTest::newRow("most curl") << int(MapKind::Curl) << 1.0 << 16.0;
        QTest::newRow("gel") << int(MapKind::Gel) << 0.25 << 25.0;
    }
    void shown_numbers_and_map_values_are_each_others_inverse()
    {
        QFETCH(int, map);
        QFETCH(double, value);
        QFETCH(double, shown);
        const sim::GroupSettings settings;
        const auto kind = static_cast<MapKind>(map);
        QVERIFY(std::abs(shownValue(settings, kind, value) - shown) < 1e-4);
        QVERIFY(std::abs(mapValue(settings, kind, shown) - value) < 1e-6);
    }

    void short_groups_are_measured_in_millimetres()
    {
        sim::GroupSettings brows;
        brows.greatestLengthM = 0.008F;
        QCOMPARE(valueText(brows, model::mapSpec(MapKind::Length), {.scalar = 0.5F}), QStringLiteral("4\u2009mm"));
    }
};

HAIRPAINT_TEST(TestValues, Widgets)
#include "test_values.moc"
