// A bow that sits on a tie goes where the tie goes.
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
