// Patches of the accessory map: each is one worn thing, in the same step of the history.
#include "model/document/gather_command.h"
#include "model/document/layer_commands.h"
#include "model/document/paint_command.h"
#include "model/document/scene_commands.h"
#include "model/files/project_file.h"
#include "tests/model/fixtures.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

#include <algorithm>
#include <random>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

constexpr std::uint16_t kPonytail = 1;
constexpr std::uint16_t kBun = 2;
constexpr std::uint16_t kBead = 6;

Project ballProject()
{
    Project project = patchProject();
    project.head = headOf(makeBallHead());
    return project;
}

/// The first layer of the accessory map with a disc of that index; 0 takes paint away.
sim::TiledRaster withDisc(const Document& document, glm::vec2 uv, float radiusUv, std::uint16_t index)
{
    const LayerAddress at = firstLayer(document, MapKind::Accessory);
    sim::TiledRaster raster = document.committed().layer(at.group, at.map, at.layer)->raster;
    const auto size = static_cast<float>(raster.size());
    for (int y = 0; y < raster.size(); ++y)
        for (int x = 0; x < raster.size(); ++x) {
            const glm::vec2 texel((static_cast<float>(x) + 0.5F) / size, 1.0F - (static_cast<float>(y) + 0.5F) / size);
            if (glm::distance(texel, uv) < radiusUv)
                raster.setTexel(x, y, {index, static_cast<std::uint16_t>(index == 0 ? 0 : 65535), 0, 0});
        }
    return raster;
}

LayerTiles tilesThatDiffer(const Document& document, const sim::TiledRaster& raster)
{
    const LayerAddress at = firstLayer(document, MapKind::Accessory);
    const sim::TiledRaster& before = document.committed().layer(at.group, at.map, at.layer)->raster;
    LayerTiles tiles;
    for (int index = 0; index < raster.tileCount(); ++index)
        if (raster.tile(index) != before.tile(index))
            tiles.emplace_back(index, raster.tile(index));
    return tiles;
}

void paintDisc(Document& document, glm::vec2 uv, float radiusUv, std::uint16_t index)
{
    const LayerTiles tiles = tilesThatDiffer(document, withDisc(document, uv, radiusUv, index));
    document.push(paintCommand(document, firstLayer(document, MapKind::Accessory), tiles, QStringLiteral("Paint")));
}

const std::vector<Worn>& wornIn(const Document& document)
{
    return document.project().worn;
}

std::uint16_t gatheredAt(const Document& document, glm::vec2 uv)
{
    const sim::MapRaster gathered = document.groomInput().groups.front().gathered;
    return gathered != nullptr ? gathered->sampleNearest(uv)[0] : std::uint16_t{0};
}

} // namespace

class TestPatches : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aPatchIsOneThingInOneStep()
    {
        Document document(patchProject());
        const Project before = document.committed();
        QVERIFY(document.groomInput().groups.front().gathered == nullptr);
        paintDisc(document, {0.4F, 0.6F}, 0.1F, kPonytail);
        QCOMPARE(document.undoStack().count(), 1);
        QCOMPARE(wornIn(document).size(), std::size_t{1});
        const Worn tie = wornIn(document).front();
        QVERIFY(tie.kind == WornKind::Ponytail && tie.patch && tie.group == before.groups.front().id);
        // Over the middle of the patch, and away from the skin.
        QVERIFY(glm::distance(glm::vec2(tie.shape.centreHd), glm::vec2(-0.02F, 0.02F)) < 2e-3F);
        const sim::GroomInput::Group group = document.groomInput().groups.front();
        QCOMPARE(group.ties.size(), std::size_t{1});
        QVERIFY(group.ties.front() == *tieOf(tie) && group.ties.front().directionHd.z > 0.9F);
        QCOMPARE(gatheredAt(document, {0.4F, 0.6F}), tie.patch->number);
        QCOMPARE(gatheredAt(document, {0.4F, 0.72F}), std::uint16_t{0});
        const Project after = document.committed();
        document.undo();
        QVERIFY(sameProjects(document.committed(), before));
        document.redo();
        QVERIFY(sameProjects(document.committed(), after));
        QVERIFY(document.groomInput().groups.front().ties == group.ties);
    }

    void patchesThatMeetKeepTheOlderAndPartsOfOneTheOneWithItsPoint()
    {
        Document document(patchProject());
        paintDisc(document, {0.3F, 0.5F}, 0.08F, kPonytail);
        paintDisc(document, {0.7F, 0.5F}, 0.08F, kPonytail);
        QCOMPARE(wornIn(document).size(), std::size_t{2});
        const Worn first = wornIn(document)[0];
        const Worn second = wornIn(document)[1];
        QVERIFY(first.patch->number != second.patch->number);
        paintDisc(document, {0.5F, 0.5F}, 0.15F, kPonytail);
        QCOMPARE(wornIn(document).size(), std::size_t{1});
        QCOMPARE(wornIn(document).front().id, first.id);
        QCOMPARE(gatheredAt(document, {0.7F, 0.5F}), first.patch->number);
        paintDisc(document, {0.55F, 0.5F}, 0.2F, 0);
        QCOMPARE(wornIn(document).size(), std::size_t{2});
        QCOMPARE(wornIn(document).front().id, first.id);
        QVERIFY(wornIn(document).back().id != first.id && wornIn(document).back().id != second.id);
        QCOMPARE(gatheredAt(document, {0.77F, 0.5F}), wornIn(document).back().patch->number);
        // The part that is left goes along with what was most of it, though the point is erased.
        paintDisc(document, {0.3F, 0.5F}, 0.03F, 0);
        QCOMPARE(wornIn(document).front().id, first.id);
        paintDisc(document, {0.3F, 0.5F}, 0.1F, 0);
        QCOMPARE(wornIn(document).size(), std::size_t{1});
        QVERIFY(wornIn(document).front().id != first.id);
        for (int i = 0; i < 4; ++i)
            document.undo();
        QVERIFY(wornIn(document) == (std::vector<Worn>{first, second}));
    }

    /// Another kind is another thing, whatever touches.
    void kindsDoNotJoin()
    {
        Document document(patchProject());
        paintDisc(document, {0.4F, 0.5F}, 0.1F, kPonytail);
        paintDisc(document, {0.6F, 0.5F}, 0.1F, kBun);
        paintDisc(document, {0.5F, 0.8F}, 0.05F, kBead);
        QCOMPARE(wornIn(document).size(), std::size_t{3});
        QCOMPARE(countOf(wornIn(document), WornKind::Bun), std::size_t{1});
        const sim::GroomInput::Group group = document.groomInput().groups.front();
        QCOMPARE(group.ties.size(), std::size_t{2}); // A bead ties nothing.
        QCOMPARE(gatheredAt(document, {0.5F, 0.8F}), std::uint16_t{0});
        // A patch tells how large a bead is.
        const Worn& bead = wornIn(document).front();
        QVERIFY(std::abs(bead.shape.semiAxesM.x - 0.01F) < 5e-4F);
    }

    void aPatchGoesOverASeam()
    {
        Document document(ballProject());
        paintDisc(document, {0.0F, 0.5F}, 0.08F, kPonytail);
        QCOMPARE(wornIn(document).size(), std::size_t{1});
        paintDisc(document, {1.0F, 0.5F}, 0.08F, kPonytail);
        QCOMPARE(wornIn(document).size(), std::size_t{1});
        QCOMPARE(gatheredAt(document, {0.03F, 0.5F}), gatheredAt(document, {0.97F, 0.5F}));
        // At the back, where the seam is.
        QVERIFY(wornIn(document).front().shape.centreHd.z < -0.09F);
        paintDisc(document, {1.0F, 0.8F}, 0.06F, kPonytail); // Alone, on one side of it.
        QCOMPARE(wornIn(document).size(), std::size_t{2});
    }

    /// Islands that touch in the layout and not on the skin.
    void aPatchStaysOnItsIsland()
    {
        sim::HeadMesh mesh = makePatchHead(2);
        sim::HeadMesh other = makePatchHead(2);
        const auto first = static_cast<unsigned>(mesh.positionsHd.size());
        for (glm::vec2& uv : mesh.uvs)
            uv.x *= 0.5F;
        for (std::size_t i = 0; i < other.uvs.size(); ++i) {
            mesh.positionsHd.push_back(other.positionsHd[i] + glm::vec3(0.5F, 0.0F, 0.0F));
            mesh.normalsHd.push_back(other.normalsHd[i]);
            mesh.uvs.emplace_back(0.5F + 0.5F * other.uvs[i].x, other.uvs[i].y);
        }
        for (const glm::uvec3& triangle : other.triangles)
            mesh.triangles.push_back(triangle + first);
        Project project = patchProject();
        project.head = headOf(std::move(mesh));
        Document document(std::move(project));
        paintDisc(document, {0.5F, 0.5F}, 0.1F, kPonytail);
        QCOMPARE(wornIn(document).size(), std::size_t{2});
    }

    void aThingFollowsItsPatchUntilAHandMovesIt()
    {
        Document document(patchProject());
        paintDisc(document, {0.3F, 0.5F}, 0.06F, kPonytail);
        const glm::vec3 first = wornIn(document).front().shape.centreHd;
        paintDisc(document, {0.36F, 0.5F}, 0.06F, kPonytail);
        QVERIFY(wornIn(document).front().shape.centreHd.x > first.x + 2e-3F);
        EditSession session = document.begin({.text = QStringLiteral("Move")});
        session.preview({.aspect = Change::Aspect::Environment}, [](Project& project) {
            Worn& worn = project.worn.front();
            carryTo(worn, anchorPoint(worn, *project.head->skin), *project.head->skin->atUv({0.9F, 0.9F}));
        });
        session.commit();
        const Worn moved = wornIn(document).front();
        QVERIFY(moved.patch->placedByHand && moved.shape.centreHd.x > 0.07F);
        paintDisc(document, {0.42F, 0.5F}, 0.06F, kPonytail);
        QVERIFY(wornIn(document).front() == moved);
        QCOMPARE(gatheredAt(document, {0.44F, 0.5F}), moved.patch->number);
    }

    void aThingTakenOffTakesItsPaintAlong()
    {
        Document document(patchProject());
        paintDisc(document, {0.3F, 0.5F}, 0.06F, kPonytail);
        paintDisc(document, {0.7F, 0.5F}, 0.06F, kPonytail);
        const Project before = document.committed();
        document.push(removeWornCommand(document, wornIn(document).front().id));
        QCOMPARE(wornIn(document).size(), std::size_t{1});
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Remove ponytail"));
        QCOMPARE(gatheredAt(document, {0.3F, 0.5F}), std::uint16_t{0});
        QVERIFY(document.resolved(before.groups.front().id, MapKind::Accessory)->sampleNearest({0.3F, 0.5F})[0] == 0);
        QVERIFY(wornIn(document).front() == before.worn.back());
        document.undo();
        QVERIFY(sameProjects(document.committed(), before));
    }

    void paintingBesideChangesNoTileOfIt()
    {
        Document document(patchProject(512));
        paintDisc(document, {0.2F, 0.2F}, 0.08F, kPonytail);
        const Worn tie = wornIn(document).front();
        const sim::MapRaster before = document.groomInput().groups.front().gathered;
        paintDisc(document, {0.8F, 0.8F}, 0.08F, kPonytail);
        const sim::MapRaster after = document.groomInput().groups.front().gathered;
        int differing = 0;
        for (int index = 0; index < before->tileCount(); ++index) {
            if (before->tile(index) == after->tile(index))
                continue;
            ++differing;
            QVERIFY(before->tileRect(index).x0 > 256);
        }
        QVERIFY(differing > 0 && differing <= 9);
        QVERIFY(wornIn(document).front() == tie);
        // Other maps leave it be altogether.
        const LayerAddress density = firstLayer(document, MapKind::Density);
        sim::TiledRaster raster = document.committed().layer(density.group, density.map, density.layer)->raster;
        raster.setTexel(3, 3, {65535, 65535, 0, 0});
        document.push(paintCommand(document, density, {{0, raster.tile(0)}}, QStringLiteral("Paint")));
        QVERIFY(document.groomInput().groups.front().gathered == after);
    }

    void aPreviewIsItsCommit()
    {
        Document document(patchProject());
        paintDisc(document, {0.3F, 0.5F}, 0.08F, kPonytail);
        const Project before = document.committed();
        EditSession session = document.begin({.text = QStringLiteral("Stroke")});
        for (const float radius : {0.02F, 0.05F, 0.08F})
            session.previewTiles(firstLayer(document, MapKind::Accessory),
                                 tilesThatDiffer(document, withDisc(document, {0.6F, 0.5F}, radius, kBun)));
        const Project shown = document.project();
        const sim::GroomInput input = document.groomInput();
        QCOMPARE(shown.worn.size(), std::size_t{2});
        session.commit();
        QVERIFY(sameProjects(document.committed(), shown));
        QVERIFY(document.groomInput().groups.front().ties == input.groups.front().ties);
        QVERIFY(*document.groomInput().groups.front().gathered == *input.groups.front().gathered);
        document.undo();
        QVERIFY(sameProjects(document.committed(), before));
        EditSession dropped = document.begin({.text = QStringLiteral("Stroke")});
        dropped.previewTiles(firstLayer(document, MapKind::Accessory),
                             tilesThatDiffer(document, withDisc(document, {0.5F, 0.5F}, 0.3F, 0)));
        QCOMPARE(wornIn(document).size(), std::size_t{0});
        dropped.drop();
        QVERIFY(sameProjects(document.project(), before));
        QCOMPARE(document.groomInput().groups.front().ties.size(), std::size_t{1});
    }

    /// Any discs, hidden layers, groups that go and things taken off: undone to the bytes, and the same as a document
    /// that is opened with the content.
    void randomEditsAreUndone_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 6; ++seed)
            QTest::addRow("seed %d", seed) << seed;
    }
    void randomEditsAreUndone()
    {
        QFETCH(int, seed);
        std::mt19937 random(static_cast<unsigned>(seed));
        const auto unit = [&random] { return static_cast<float>(random() % 1000) / 1000.0F; };
        Document document(seed % 2 == 0 ? ballProject() : patchProject());
        const Project first = document.committed();
        for (int step = 0; step < 25; ++step) {
            const LayerAddress at = firstLayer(document, MapKind::Accessory);
            switch (random() % 8) {
            case 0: {
                LayerProperties properties = propertiesOf(*document.committed().layer(at.group, at.map, at.layer));
                properties.visible = !properties.visible;
                document.push(setLayerPropertiesCommand(document, at, properties, QStringLiteral("Hide")));
                break;
            }
            case 1:
                if (!wornIn(document).empty())
                    document.push(removeWornCommand(document, wornIn(document)[random() % wornIn(document).size()].id));
                break;
            default:
                paintDisc(document, {unit(), unit()}, 0.02F + 0.15F * unit(), static_cast<std::uint16_t>(random() % 4));
            }
            // A document opened with it agrees.
            Document opened(document.committed());
            QVERIFY(opened.committed().worn == wornIn(document));
            const sim::GroomInput::Group a = opened.groomInput().groups.front();
            const sim::GroomInput::Group b = document.groomInput().groups.front();
            QVERIFY(a.ties == b.ties && (a.gathered == nullptr) == (b.gathered == nullptr));
            QVERIFY(a.gathered == nullptr || *a.gathered == *b.gathered);
        }
        const Project last = document.committed();
        while (document.canUndo())
            document.undo();
        QVERIFY(sameProjects(document.committed(), first));
        while (document.undoStack().canRedo())
            document.redo();
        QVERIFY(sameProjects(document.committed(), last));
    }

    void hairIsGatheredByOneClick()
    {
        Document document(filledPatch(MapKind::Density, 65535));
        const Project before = document.committed();
        const WornSpec& ponytail = wornSpec(WornKind::Ponytail);
        const Id group = before.groups.front().id;
        const auto at = [&](float u, float v) { return *before.head->skin->atUv({u, v}); };
        document.push(gatherCommand(document, group, ponytail, at(0.5F, 0.9F), {QRectF(0.0, 0.5, 1.0, 0.5)}));
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Gather hair into a ponytail"));
        QCOMPARE(wornIn(document).size(), std::size_t{1});
        const Worn tie = wornIn(document).front();
        QVERIFY(tie.patch->placedByHand &&
                glm::distance(glm::vec2(tie.shape.centreHd), glm::vec2(0.0F, 0.08F)) < 1e-4F);
        QCOMPARE(gatheredAt(document, {0.1F, 0.6F}), tie.patch->number);
        QCOMPARE(gatheredAt(document, {0.1F, 0.4F}), std::uint16_t{0});
        // The rest goes into a bun, wherever that is; a second ponytail there takes the first along.
        document.push(gatherCommand(document, group, wornSpec(WornKind::Bun), at(0.5F, 0.95F), {}));
        QCOMPARE(countOf(wornIn(document), WornKind::Bun), std::size_t{1});
        QVERIFY(gatheredAt(document, {0.1F, 0.4F}) != 0);
        document.push(gatherCommand(document, group, ponytail, at(0.7F, 0.7F), {}));
        QCOMPARE(wornIn(document).size(), std::size_t{2});
        QVERIFY(std::abs(document.project().wornThing(tie.id)->shape.centreHd.x - 0.04F) < 1e-4F);
        for (int i = 0; i < 3; ++i)
            document.undo();
        QVERIFY(sameProjects(document.committed(), before));
        Document bald(patchProject());
        QVERIFY(gatherCommand(bald, bald.project().groups.front().id, ponytail, at(0.5F, 0.5F), {}) == nullptr);
    }

    void oneClickMakesTwoTailsAndAParting_data()
    {
        QTest::addColumn<bool>("wasTied");
        QTest::newRow("loose hair") << false;
        QTest::newRow("hair in one ponytail") << true;
    }

    void oneClickMakesTwoTailsAndAParting()
    {
        QFETCH(bool, wasTied);
        Document document(filledPatch(MapKind::Density, 65535));
        const WornSpec& ponytail = wornSpec(WornKind::Ponytail);
        const Id group = document.committed().groups.front().id;
        const auto at = [&](float u, float v) { return *document.committed().head->skin->atUv({u, v}); };
        if (wasTied)
            document.push(gatherCommand(document, group, ponytail, at(0.4F, 0.5F), {}));
        const Project before = document.committed();
        document.push(gatherTwinsCommand(document, group, ponytail, at(0.8F, 0.7F), {}));
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Gather hair into twin tails"));
        QCOMPARE(wornIn(document).size(), std::size_t{2});
        const glm::vec3 one = wornIn(document).front().shape.centreHd;
        const glm::vec3 other = wornIn(document).back().shape.centreHd;
        QVERIFY(std::abs(std::abs(one.x) - 0.06F) < 1e-4F);
        QVERIFY(glm::distance(one * glm::vec3(-1.0F, 1.0F, 1.0F), other) < 1e-4F);
        const auto isNear = [](glm::vec3 tie, std::uint16_t number, const Document& of) {
            return gatheredAt(of, {tie.x < 0.0F ? 0.45F : 0.55F, 0.3F}) == number;
        };
        for (const Worn& tie : wornIn(document))
            QVERIFY(isNear(tie.shape.centreHd, tie.patch->number, document));
        // Nothing grows in the parting, which is narrow.
        const sim::MapRaster density = document.resolvedNow(group, MapKind::Density);
        QCOMPARE(density->sampleNearest({0.5F, 0.6F})[0], std::uint16_t{0});
        QCOMPARE(density->sampleNearest({0.52F, 0.6F})[0], std::uint16_t{65535});
        document.undo();
        QVERIFY(sameProjects(document.committed(), before));
        Document bald(patchProject());
        QVERIFY(gatherTwinsCommand(bald, bald.project().groups.front().id, ponytail, at(0.8F, 0.5F), {}) == nullptr);
    }

    void filesKeepPatchesAndTheirThings()
    {
        Document document(newProject());
        paintDisc(document, {0.5F, 0.5F}, 0.05F, kPonytail);
        paintDisc(document, {0.5F, 0.75F}, 0.05F, kBun);
        EditSession session = document.begin({.text = QStringLiteral("Look")});
        session.preview({.aspect = Change::Aspect::Environment}, [](Project& project) {
            Worn& worn = *std::ranges::find(project.worn, WornKind::Ponytail, &Worn::kind);
            worn.make = 3;
            worn.tightness = 0.25F;
        });
        session.commit();
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("tied.hairpaint"));
        QVERIFY(saveProject(document.committed(), path, {}));
        Result<Project> read = loadProject(path);
        QVERIFY2(read, read ? "" : qPrintable(read.error().message));
        QVERIFY(read->worn == document.committed().worn);
        Document opened(std::move(*read));
        QVERIFY(opened.committed().worn == document.committed().worn);
        QVERIFY(opened.groomInput().groups.front().ties == document.groomInput().groups.front().ties);
        QVERIFY(*opened.groomInput().groups.front().gathered == *document.groomInput().groups.front().gathered);
    }
};

HAIRPAINT_TEST(TestPatches, Core)
#include "test_patches.moc"
