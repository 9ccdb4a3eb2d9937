// The formulas of the blend modes, by themselves and through layers.
#include "model/maps/compositor.h"
#include "tests/model/uniform_layers.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <set>

using namespace hairpaint;
using namespace hairpaint::model;

class TestBlendModes : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void everyModeFollowsItsFormula_data();
    void everyModeFollowsItsFormula();
    void everyModeHasItsOwnNames();
};

void TestBlendModes::everyModeFollowsItsFormula_data()
{
    QTest::addColumn<BlendMode>("mode");
    QTest::addColumn<double>("below");
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("expected");
    const auto row = [](BlendMode mode, double below, double value, double expected) {
        QTest::addRow("%s, %g under %g", blendRule(mode).id, below, value) << mode << below << value << expected;
    };
    row(BlendMode::Normal, 0.3, 0.8, 0.8);
    row(BlendMode::Multiply, 0.3, 0.8, 0.24);
    row(BlendMode::Screen, 0.3, 0.8, 0.86);
    row(BlendMode::Darken, 0.3, 0.8, 0.3);
    row(BlendMode::Darken, 0.8, 0.3, 0.3);
    row(BlendMode::Lighten, 0.3, 0.8, 0.8);
    row(BlendMode::Lighten, 0.8, 0.3, 0.8);
    row(BlendMode::Add, 0.3, 0.4, 0.7);
    row(BlendMode::Add, 0.7, 0.8, 1.0);
    row(BlendMode::Subtract, 0.8, 0.3, 0.5);
    row(BlendMode::Subtract, 0.3, 0.8, 0.0);
    row(BlendMode::Difference, 0.8, 0.3, 0.5);
    row(BlendMode::Difference, 0.3, 0.8, 0.5);
    row(BlendMode::Overlay, 0.3, 0.8, 0.48);
    row(BlendMode::Overlay, 0.8, 0.3, 0.72);
    row(BlendMode::HardLight, 0.3, 0.8, 0.72);
    row(BlendMode::HardLight, 0.8, 0.3, 0.48);
    row(BlendMode::SoftLight, 0.3, 0.25, 0.195);
    row(BlendMode::SoftLight, 0.49, 0.75, 0.595);
    row(BlendMode::SoftLight, 0.2, 1.0, 0.448);
    row(BlendMode::SoftLight, 0.6, 0.5, 0.6);
}

void TestBlendModes::everyModeFollowsItsFormula()
{
    QFETCH(BlendMode, mode);
    QFETCH(double, below);
    QFETCH(double, value);
    QFETCH(double, expected);
    const auto texel = [](double fraction) { return unit16(static_cast<float>(fraction)); };
    const double got = blendRule(mode).formula(texel(below), texel(value)) / 65535.0;
    QVERIFY2(std::abs(got - expected) < 3e-5, qPrintable(QString::number(got)));
    // Through a layer, for one channel and for three.
    MapStack scalars = stackOf(MapKind::Length, {{texel(below), 65535}, {texel(value), 65535}});
    scalars.layers[1].blend = mode;
    QCOMPARE(resolveTexel(scalars, 0, 0)[0], blendRule(mode).formula(texel(below), texel(value)));
    MapStack colours =
        stackOf(MapKind::Colour, {{texel(below), texel(value), 0, 65535}, {texel(value), texel(below), 65535, 65535}});
    colours.layers[1].blend = mode;
    QCOMPARE(resolveTexel(colours, 0, 0),
             (sim::Texel{blendRule(mode).formula(texel(below), texel(value)),
                         blendRule(mode).formula(texel(value), texel(below)), blendRule(mode).formula(0, 65535), 0}));
}

void TestBlendModes::everyModeHasItsOwnNames()
{
    std::set<QString> ids;
    std::set<QString> titles;
    for (const BlendRule& rule : blendRules()) {
        ids.insert(QString::fromLatin1(rule.id));
        titles.insert(rule.titleText());
    }
    QCOMPARE(ids.size(), kBlendModeCount);
    QCOMPARE(titles.size(), kBlendModeCount);
}

HAIRPAINT_TEST(TestBlendModes, Core)
#include "test_blend_modes.moc"
