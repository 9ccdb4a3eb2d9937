// What sits on a tie goes where the tie goes.
#include "model/document/gather_command.h"
#include "model/document/scene_commands.h"
#include "model/files/project_file.h"
#include "model/project/worn_on_ties.h"
#include "model/styles/preset.h"
#include "model/styles/style_use.h"
#include "tests/model/fixtures.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <functional>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

/// All hair of a flat patch in one ponytail, with a bow on it.
struct Tied
{
    Document document{filledPatch(MapKind::Density, 65535)};
    Id tieId = 0;
    Id bowId = 0;

    Tied()
    {
        const Id group = document.committed().groups.front().id;
        document.push(gatherCommand(document, group, wornSpec(WornKind::Ponytail), at(0.5F, 0.7F), {}));
        tieId = document.committed().worn.back().id;
        Worn bow = makeWorn(wornSpec(WornKind::Bow), at(0.5F, 0.7F), group);
        sitOn(bow, tie());
        document.push(addWornCommand(document, bow));
        bowId = std::ranges::find(document.committed().worn, WornKind::Bow, &Worn::kind)->id;
    }
    [[nodiscard]] sim::SurfacePoint at(float u, float v) { return *document.committed().head->skin->atUv({u, v}); }
    [[nodiscard]] const Worn& tie() { return *document.project().wornThing(tieId); }
    [[nodiscard]] const Worn& bow() { return *document.project().wornThing(bowId); }
    [[nodiscard]] bool hasBow() { return document.project().wornThing(bowId) != nullptr; }
    void change(Id id, const std::function<void(Worn&)>& edit)
    {
        EditSession session = document.begin({.text = QStringLiteral("Move")});
        session.preview({.aspect = Change::Aspect::Environment},
                        [&](Project& project) { edit(*project.wornThing(id)); });
        const std::vector<Worn> shown = document.project().worn;
        session.commit();
        QCOMPARE(document.committed().worn, shown);
    }
    void move(Id id, glm::vec2 uv)
    {
        change(id,
               [&](Worn& worn) { carryTo(worn, anchorPoint(worn, *document.committed().head->skin), at(uv.x, uv.y)); });
    }
    /// Whether the bow lies on the tie's ring as one that is put on now would.
    [[nodiscard]] bool sits()
    {
        Worn fresh = bow();
        sitOn(fresh, tie());
        return glm::distance(fresh.shape.centreHd, bow().shape.centreHd) < 1e-5F &&
               std::abs(glm::dot(fresh.shape.rotation, bow().shape.rotation)) > 0.99999F &&
               fresh.anchor == bow().anchor;
    }
};

} // namespace

class TestWornOnTies : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void itMovesTurnsAndGrowsWithItsTie()
    {
        Tied tied;
        QCOMPARE(tied.bow().tie, tied.tieId);
        const std::vector<Worn> before = tied.document.committed().worn;
        tied.move(tied.tieId, {0.7F, 0.4F});
        QVERIFY(glm::distance(tied.bow().shape.centreHd, tied.tie().shape.centreHd) < 0.05F);
        QVERIFY(tied.sits());
        tied.change(tied.tieId, [](Worn& tie) {
            tie.shape.rotation = glm::angleAxis(1.1F, glm::normalize(glm::vec3(1.0F, 2.0F, 3.0F))) * tie.shape.rotation;
        });
        QVERIFY(tied.sits());
        const glm::vec3 sizeM = tied.bow().shape.semiAxesM;
        tied.change(tied.tieId, [](Worn& tie) { tie.shape.semiAxesM *= 1.5F; });
        QVERIFY(tied.sits());
        QCOMPARE(tied.bow().shape.semiAxesM, sizeM);
        const std::vector<Worn> after = tied.document.committed().worn;
        for (int i = 0; i < 3; ++i)
            tied.document.undo();
        QCOMPARE(tied.document.committed().worn, before);
        for (int i = 0; i < 3; ++i)
            tied.document.redo();
        QCOMPARE(tied.document.committed().worn, after);
    }

    void aTieThatFollowsItsPatchTakesItAlong()
    {
        Document document(patchProject());
        const LayerAddress at = firstLayer(document, MapKind::Accessory);
        const auto paint = [&](int x0) {
            sim::TiledRaster raster(256, 2);
            for (int y = 100; y < 140; ++y)
                for (int x = x0; x < 140; ++x)
                    raster.setTexel(x, y, {1, 65535, 0, 0});
            LayerTiles tiles;
            for (int index = 0; index < raster.tileCount(); ++index)
                tiles.emplace_back(index, raster.tile(index));
            return tiles;
        };
        const auto push = [&](const LayerTiles& tiles) {
            EditSession session = document.begin({.text = QStringLiteral("Paint")});
            session.previewTiles(at, tiles);
            const std::vector<Worn> shown = document.project().worn;
            session.commit();
            QCOMPARE(document.committed().worn, shown);
        };
        push(paint(100));
        Worn bow = makeWorn(wornSpec(WornKind::Bow), *document.committed().head->skin->atUv({0.5F, 0.5F}), at.group);
        sitOn(bow, document.committed().worn.back());
        document.push(addWornCommand(document, bow));
        const auto placed = [&](WornKind kind) {
            return std::ranges::find(document.committed().worn, kind, &Worn::kind)->shape.centreHd;
        };
        const glm::vec3 away = placed(WornKind::Bow) - placed(WornKind::Ponytail);
        const glm::vec3 first = placed(WornKind::Ponytail);
        push(paint(40));
        QVERIFY(placed(WornKind::Ponytail).x < first.x - 0.01F);
        QVERIFY(glm::distance(placed(WornKind::Bow) - placed(WornKind::Ponytail), away) < 1e-5F);
    }

    void itIsTakenOffWithItsTieAndComesBackWithIt()
    {
        Tied tied;
        const Project before = tied.document.committed();
        const int steps = tied.document.undoStack().count();
        tied.document.push(removeWornCommand(tied.document, tied.tieId));
        QVERIFY(!tied.hasBow());
        QCOMPARE(tied.document.undoStack().count(), steps + 1);
        tied.document.undo();
        QVERIFY(sameProjects(tied.document.committed(), before));
        QVERIFY(tied.hasBow());
        // Off without its tie, it leaves the tie on.
        tied.document.push(removeWornCommand(tied.document, tied.bowId));
        QVERIFY(!tied.hasBow());
        QVERIFY(tied.document.project().wornThing(tied.tieId) != nullptr);
    }

    /// Moved a little it still goes with the tie; moved to elsewhere it does not.
    void movedByHandItStaysWhereItWasPutOnTheTie()
    {
        Tied tied;
        tied.change(tied.bowId, [](Worn& bow) { bow.shape.centreHd.x += 0.004F; });
        QCOMPARE(tied.bow().tie, tied.tieId);
        const glm::vec3 away = tied.bow().shape.centreHd - tied.tie().shape.centreHd;
        tied.move(tied.tieId, {0.6F, 0.6F});
        QVERIFY(glm::distance(tied.bow().shape.centreHd - tied.tie().shape.centreHd, away) < 1e-5F);
        tied.move(tied.bowId, {0.1F, 0.1F});
        QCOMPARE(tied.bow().tie, 0);
        const Worn left = tied.bow();
        tied.move(tied.tieId, {0.8F, 0.8F});
        QCOMPARE(tied.bow(), left);
        tied.document.push(removeWornCommand(tied.document, tied.tieId));
        QVERIFY(tied.hasBow());
    }

    void filesKeepWhatItSitsOn()
    {
        Document document(newProject());
        const Id group = document.committed().groups.front().id;
        const sim::SurfacePoint at = *document.committed().head->skin->atUv({0.5F, 0.7F});
        document.push(addWornCommand(document, makeWorn(wornSpec(WornKind::Ponytail), at, group)));
        Worn made = makeWorn(wornSpec(WornKind::Bow), at, group);
        sitOn(made, *std::ranges::find(document.committed().worn, WornKind::Ponytail, &Worn::kind));
        document.push(addWornCommand(document, made));
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("tied.hairpaint"));
        QVERIFY(saveProject(document.committed(), path, {}));
        const Result<Project> opened = loadProject(path);
        QVERIFY(opened.has_value());
        const auto bow = std::ranges::find(opened->worn, WornKind::Bow, &Worn::kind);
        const auto tie = std::ranges::find(opened->worn, WornKind::Ponytail, &Worn::kind);
        QVERIFY(bow != opened->worn.end() && tie != opened->worn.end());
        QCOMPARE(bow->tie, tie->id);
        QCOMPARE(opened->worn, document.committed().worn);
    }

    void stylesCarryWhatItSitsOn()
    {
        Tied tied;
        const Preset preset = presetFrom(tied.document.committed(), QStringLiteral("Tied"));
        const auto bow = std::ranges::find(preset.worn, WornKind::Bow, &Worn::kind);
        QVERIFY(bow != preset.worn.end());
        QCOMPARE(std::ranges::find(preset.worn, WornKind::Ponytail, &Worn::kind)->id, bow->tie);
        Project other = patchProject();
        other.nextId += 100;
        applyPreset(other, preset, {});
        const auto put = std::ranges::find(other.worn, WornKind::Bow, &Worn::kind);
        QVERIFY(put != other.worn.end());
        QCOMPARE(std::ranges::find(other.worn, WornKind::Ponytail, &Worn::kind)->id, put->tie);
    }

    void pinsCombsAndBeadsAreStuckInWhereTheyArePutOn_data()
    {
        QTest::addColumn<WornKind>("kind");
        QTest::addColumn<WornKind>("tied");
        QTest::addColumn<glm::vec3>("outAxis");
        const glm::vec3 x(1.0F, 0.0F, 0.0F);
        const glm::vec3 y(0.0F, 1.0F, 0.0F);
        QTest::newRow("a pin on a tail") << WornKind::Hairpin << WornKind::Ponytail << x;
        QTest::newRow("a pin in a bun") << WornKind::Hairpin << WornKind::Bun << x;
        QTest::newRow("a comb on a tail") << WornKind::Comb << WornKind::Ponytail << y;
        QTest::newRow("a comb in a bun") << WornKind::Comb << WornKind::Bun << y;
        QTest::newRow("a bead on a tail") << WornKind::Ball << WornKind::Ponytail << y;
        QTest::newRow("a bead on a bun") << WornKind::Ball << WornKind::Bun << y;
    }
    /// Around the hair, on the side where it is put on: that of its own axis that is outside points out there.
    void pinsCombsAndBeadsAreStuckInWhereTheyArePutOn()
    {
        QFETCH(WornKind, kind);
        QFETCH(WornKind, tied);
        QFETCH(glm::vec3, outAxis);
        sim::SurfacePoint below;
        below.positionHd = {0.0F, 0.1F, 0.0F};
        below.normalHd = glm::normalize(glm::vec3(0.3F, 0.4F, -1.0F));
        Worn tie = makeWorn(wornSpec(tied), below);
        tie.id = 3;
        const glm::quat turn = tie.shape.rotation;
        const float hairM = tied == WornKind::Bun ? tie.coilRadiusM : tie.shape.semiAxesM.x;
        for (int degrees = 0; degrees < 360; degrees += 45) {
            const float angle = glm::radians(static_cast<float>(degrees));
            const glm::vec3 side = turn * glm::vec3(std::cos(angle), std::sin(angle), 0.0F);
            sim::SurfacePoint at;
            at.positionHd = tie.shape.centreHd + 0.8F * hairM * side;
            at.normalHd = below.normalHd;
            QCOMPARE(tieBeside({tie}, wornSpec(kind), at.positionHd)->id, tie.id);
            Worn worn = makeWorn(wornSpec(kind), at);
            worn.shape.centreHd = at.positionHd;
            sitOn(worn, tie);
            QCOMPARE(worn.tie, tie.id);
            const glm::vec3 away = worn.shape.centreHd - tie.shape.centreHd;
            QVERIFY(glm::dot(glm::normalize(away), side) > 0.9999F);
            QVERIFY(glm::length(away) >= 0.999F * hairM && glm::length(away) < hairM + 0.02F);
            QVERIFY(glm::dot(worn.shape.rotation * outAxis, side) > 0.9999F);
        }
        QVERIFY(tieBeside({tie}, wornSpec(kind), tie.shape.centreHd + turn * glm::vec3(0.06F, 0.0F, 0.0F)) == nullptr);
        // Over the tie's middle, where no side is, it is where a knot would be.
        Worn middle = makeWorn(wornSpec(kind), below);
        middle.shape.centreHd = tie.shape.centreHd;
        sitOn(middle, tie);
        QVERIFY(glm::dot(turn * glm::vec3(0.0F, 1.0F, 0.0F),
                         glm::normalize(middle.shape.centreHd - tie.shape.centreHd)) > 0.9999F);
    }

    /// What is stuck in a bun stays at its rim when the bun is made larger, and where it is when the tie inside is.
    void whatIsStuckInABunGoesWithIt()
    {
        Document document(filledPatch(MapKind::Density, 65535));
        const Id group = document.committed().groups.front().id;
        const auto at = [&](float u, float v) { return *document.committed().head->skin->atUv({u, v}); };
        document.push(gatherCommand(document, group, wornSpec(WornKind::Bun), at(0.5F, 0.6F), {}));
        const Id bun = document.committed().worn.back().id;
        for (const WornKind kind : {WornKind::Ball, WornKind::Hairpin, WornKind::Bow, WornKind::Comb}) {
            Worn worn = makeWorn(wornSpec(kind), at(0.6F, 0.6F), group);
            sitOn(worn, *document.project().wornThing(bun));
            document.push(addWornCommand(document, worn));
        }
        const auto of = [&](WornKind kind) { return *std::ranges::find(document.project().worn, kind, &Worn::kind); };
        const auto awayM = [&](WornKind kind) {
            return glm::distance(of(kind).shape.centreHd, of(WornKind::Bun).shape.centreHd);
        };
        const std::vector<Worn> before = document.committed().worn;
        const auto change = [&](const std::function<void(Worn&)>& edit) {
            EditSession session = document.begin({.text = QStringLiteral("Look")});
            session.preview({.aspect = Change::Aspect::Environment},
                            [&](Project& project) { edit(*project.wornThing(bun)); });
            session.commit();
        };
        const Worn bow = of(WornKind::Bow);
        const float pinM = awayM(WornKind::Hairpin);
        change([](Worn& worn) { worn.coilRadiusM *= 1.4F; });
        for (const WornKind kind : {WornKind::Hairpin, WornKind::Comb, WornKind::Ball})
            QVERIFY(std::abs(awayM(kind) / of(WornKind::Bun).coilRadiusM - 1.2F) < 0.3F);
        QVERIFY(std::abs(awayM(WornKind::Hairpin) / pinM - 1.4F) < 1e-3F);
        QCOMPARE(of(WornKind::Bow), bow);
        const Worn pin = of(WornKind::Hairpin);
        change([](Worn& worn) { worn.shape.semiAxesM *= 1.2F; });
        QCOMPARE(of(WornKind::Hairpin), pin);
        QVERIFY(of(WornKind::Bow) != bow);
        document.undo();
        document.undo();
        QCOMPARE(document.committed().worn, before);
        document.push(removeWornCommand(document, bun));
        QVERIFY(document.committed().worn.empty());
        document.undo();
        QCOMPARE(document.committed().worn, before);
    }

    void followingAgainChangesNothing()
    {
        Tied tied;
        const std::vector<Worn> before = tied.document.committed().worn;
        tied.move(tied.tieId, {0.7F, 0.4F});
        std::vector<Worn> after = tied.document.committed().worn;
        QVERIFY(!followTies(after, before));
        QCOMPARE(after, tied.document.committed().worn);
    }
};

HAIRPAINT_TEST(TestWornOnTies, Core)
#include "test_worn_on_ties.moc"
