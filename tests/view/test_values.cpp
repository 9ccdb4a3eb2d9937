// The palette picks what a map is painted with, in the group's own units.
#include "panel_fixture.h"

#include "tests/support/test_program.h"
#include "view/widgets/swatch.h"
#include "view/widgets/value_pair.h"
#include "view/widgets/value_palette.h"
#include "view/widgets/value_text.h"

#include <QLineEdit>

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
        f.state.setActiveMap(static_cast<MapKind>(map));
        ValuePalette palette(f.state);
        palette.show();
        const auto swatches = palette.findChildren<Swatch*>();
        QVERIFY(swatches.size() >= 4);
        const auto value = [&] {
            model::ToolSettings settings = f.state.toolSettings();
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

    void hex_colours_are_typed()
    {
        PanelFixture f;
        f.state.setActiveMap(MapKind::Colour);
        ValuePalette palette(f.state);
        palette.show();
        auto* hex = palette.findChild<QLineEdit*>();
        QVERIFY(hex != nullptr);
        hex->setFocus();
        hex->setText(QStringLiteral("B3182B"));
        QTest::keyClick(hex, Qt::Key_Return);
        model::ToolSettings settings = f.state.toolSettings();
        QCOMPARE(settings.value(MapKind::Colour).colour.name(), QStringLiteral("#b3182b"));
    }

    void swapping_twice_gives_the_same_values()
    {
        PanelFixture f;
        const model::ToolSettings before = f.state.toolSettings();
        swapValues(f.state);
        QVERIFY(f.state.toolSettings().values != before.values);
        swapValues(f.state);
        QVERIFY(f.state.toolSettings().values == before.values);
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
