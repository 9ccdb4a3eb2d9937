// Hair between two styles: what is mixed, and what comes from one of them.
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/maps/compositor.h"
#include "model/project/group_schema.h"
#include "model/styles/style_mix.h"
#include "model/styles/style_use.h"
#include "sim/groom/strand_style.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

Preset style(const char* id)
{
    return *loadPreset(QStringLiteral(":/presets/%1.hairpreset").arg(QLatin1StringView(id)));
}

const HairGroup& scalp(const Project& project)
{
    return *std::ranges::find(project.groups, QStringLiteral("Scalp"), &HairGroup::name);
}

Project wearing(const char* before, const char* id, const StyleUse& use)
{
    Project project = newProject();
    applyPreset(project, style(before));
    applyPreset(project, style(id), use);
    return project;
}

float lengthM(const HairGroup& group, int x, int y)
{
    return sim::lengthOf(group.settings,
                         static_cast<float>(resolveTexel(group.map(MapKind::Length), x, y)[0]) / 65535.0F);
}

} // namespace

class TestStyleMix : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void the_ends_are_both_styles()
    {
        Project whole = wearing("bob", "long-straight", {});
        Project none = wearing("bob", "long-straight", {.fraction = 0.0});
        Project before = newProject();
        applyPreset(before, style("bob"));
        for (const MapSpec& spec : mapSpecs()) {
            const MapStack& got = scalp(none).map(spec.kind);
            const MapStack& wanted = scalp(before).map(spec.kind);
            for (int i = 0; i < 40; ++i) {
                const int x = i * 97 % got.size;
                const int y = i * 61 % got.size;
                if (!isPainted(wanted))
                    continue; // What the style paints may cover what was left bare.
                for (int channel = 0; channel < spec.valueChannels; ++channel)
                    QVERIFY2(std::abs(resolveTexel(got, x, y)[static_cast<std::size_t>(channel)] -
                                      resolveTexel(wanted, x, y)[static_cast<std::size_t>(channel)]) <= 2,
                             spec.id);
            }
        }
        QVERIFY(scalp(whole).settings == style("long-straight").groups.front().settings);
    }

    void lengths_are_mixed_as_lengths_whatever_the_ranges_are_data()
    {
        QTest::addColumn<double>("fraction");
        for (const double fraction : {0.25, 0.5, 0.8})
            QTest::newRow(qPrintable(QString::number(fraction))) << fraction;
    }
    void lengths_are_mixed_as_lengths_whatever_the_ranges_are()
    {
        QFETCH(double, fraction);
        const Project bob = wearing("bob", "bob", {});
        const Project straight = wearing("bob", "long-straight", {});
        const Project mixed = wearing("bob", "long-straight", {.fraction = fraction});
        QVERIFY(scalp(bob).settings.greatestLengthM != scalp(straight).settings.greatestLengthM);
        for (int i = 0; i < 200; ++i) {
            const int x = i * 97 % 512;
            const int y = i * 61 % 512;
            const float wantedM =
                std::lerp(lengthM(scalp(bob), x, y), lengthM(scalp(straight), x, y), static_cast<float>(fraction));
            QVERIFY(std::abs(lengthM(scalp(mixed), x, y) - wantedM) < 2e-5F);
        }
    }

    void ties_and_braids_come_with_a_half()
    {
        const Preset tied = style("high-ponytail");
        const Project less = wearing("long-straight", "high-ponytail", {.fraction = 0.4});
        const Project more = wearing("long-straight", "high-ponytail", {.fraction = 0.6});
        const auto wornIn = [](const Project& project) {
            return std::ranges::count(project.worn, scalp(project).id, &Worn::group);
        };
        QVERIFY(!tied.worn.empty());
        QCOMPARE(wornIn(less), 0);
        QCOMPARE(wornIn(more), static_cast<std::ptrdiff_t>(tied.worn.size()));
        QVERIFY(resolveStack(scalp(more).map(MapKind::Accessory)) ==
                resolveStack(tied.groups.front().map(MapKind::Accessory)));
        QVERIFY(!(resolveStack(scalp(less).map(MapKind::Accessory)) ==
                  resolveStack(tied.groups.front().map(MapKind::Accessory))));
    }

    void only_its_colour_at_a_share_leaves_the_cut()
    {
        const Project before = wearing("bob", "bob", {});
        const Project mixed = wearing("bob", "split-dye", {.part = StylePart::Colour, .fraction = 0.5});
        QVERIFY(scalp(mixed).settings.greatestLengthM == scalp(before).settings.greatestLengthM);
        for (const MapKind kind : {MapKind::Length, MapKind::Density, MapKind::Direction})
            QVERIFY(resolveStack(scalp(mixed).map(kind)) == resolveStack(scalp(before).map(kind)));
        QVERIFY(!(resolveStack(scalp(mixed).map(MapKind::Colour)) == resolveStack(scalp(before).map(MapKind::Colour))));
    }

    void every_number_lies_between()
    {
        const Project from = wearing("bob", "bob", {});
        const Project to = wearing("bob", "ringlets", {});
        const Project mixed = wearing("bob", "ringlets", {.fraction = 0.3});
        for (const GroupSetting& row : groupSchema()) {
            const double a = row.read(scalp(from).settings);
            const double b = row.read(scalp(to).settings);
            const double got = row.read(scalp(mixed).settings);
            QVERIFY2(got >= std::min(a, b) && got <= std::max(a, b), row.key);
            if (row.isSwitch() || !row.choices.empty())
                QCOMPARE(got, a);
        }
    }
};

HAIRPAINT_TEST(TestStyleMix, Core)
#include "test_style_mix.moc"
