// Only what a style is tied and braided with is taken: the rest of the hair stays, and a style without ties takes them
// off.
#include "model/files/project_file.h"
#include "model/maps/compositor.h"
#include "model/styles/style_use.h"
#include "tests/model/worn_style.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>

using namespace hairpaint;
using model::MapKind;

class TestStyleTies : public QObject
{
    Q_OBJECT
private:
    /// Things in the hair, not the shapes of the head.
    [[nodiscard]] static std::ptrdiff_t wornInHair(const model::Project& project)
    {
        return std::ranges::count_if(project.worn, [](const model::Worn& one) { return one.group != 0; });
    }
    [[nodiscard]] static sim::TiledRaster shown(const model::Project& project, MapKind kind)
    {
        return resolveStack(project.groups.front().map(kind));
    }

private Q_SLOTS:
    void ties_and_braids_come_alone_and_go_again()
    {
        const model::Preset* committed = test::builtInStyle(QStringLiteral("Two plaits"));
        const model::Preset* straight = test::builtInStyle(QStringLiteral("Long straight"));
        QVERIFY(committed != nullptr && straight != nullptr);
        model::Preset plaits = *committed;
        plaits.worn = {model::Worn{.id = 900, .kind = model::WornKind::Ponytail, .group = plaits.groups.front().id}};
        const model::Project before = test::wearing(QStringLiteral("Long straight"), 1000);
        model::Project project = before;
        model::applyPreset(project, plaits, {.part = model::StylePart::Ties});
        QCOMPARE(wornInHair(project), std::ptrdiff_t{1});
        QVERIFY(shown(project, MapKind::Braid) != shown(before, MapKind::Braid));
        for (const MapKind kind : {MapKind::Density, MapKind::Length, MapKind::Colour, MapKind::Curl})
            QVERIFY2(shown(project, kind) == shown(before, kind), model::mapSpec(kind).id);
        QCOMPARE(project.groups.front().settings.greatestLengthM, before.groups.front().settings.greatestLengthM);
        model::applyPreset(project, *straight, {.part = model::StylePart::Ties});
        QCOMPARE(wornInHair(project), std::ptrdiff_t{0});
        QVERIFY(shown(project, MapKind::Braid) == shown(before, MapKind::Braid));
        // Taking another part of the style takes nothing that is worn.
        model::applyPreset(project, plaits, {.part = model::StylePart::Cut});
        QCOMPARE(wornInHair(project), std::ptrdiff_t{0});
        QVERIFY(shown(project, MapKind::Length) ==
                shown(test::wearing(QStringLiteral("Two plaits"), 1000), MapKind::Length));
    }
};

HAIRPAINT_TEST(TestStyleTies, Gui)
#include "test_style_ties.moc"
