// What is worn: one list with ids, undone, kept in files, and read by contact.
#include "model/document/group_commands.h"
#include "model/document/scene_commands.h"
#include "model/files/head_file.h"
#include "model/files/project_file.h"
#include "model/files/project_json.h"
#include "sim/skin/mesh_openings.h"
#include "sim/solver/collider_set.h"
#include "tests/model/archive_maker.h"
#include "tests/model/fixtures.h"
#include "tests/model/sample_project.h"
#include "tests/support/foreign_heads.h"
#include "tests/support/test_program.h"

#include <QJsonDocument>
#include <QUndoStack>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <set>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

/// Made once: it is painted all over.
const Project& sample()
{
    static const Project project = test::makeSampleProject();
    return project;
}

Worn onTop(WornKind kind)
{
    sim::SurfacePoint point;
    point.positionHd = {0.0F, 0.1F, 0.0F};
    return makeWorn(wornSpec(kind), point);
}

/// Two of each kind, the last kind first.
Project wearingAll()
{
    Project project = sample();
    project.worn.clear();
    for (HairGroup& group : project.groups) // What is painted is worn, too.
        for (Layer& layer : group.map(MapKind::Accessory).layers)
            layer.raster = emptyRaster(mapSpec(MapKind::Accessory), layer.raster.size());
    for (int turn = 0; turn < 2; ++turn)
        for (std::size_t i = wornSpecs().size(); i-- > 0;) {
            Worn worn = onTop(wornSpecs()[i].kind);
            worn.id = project.takeId();
            worn.shape.rotation = glm::quat(0.5F, 0.5F, -0.5F, 0.5F);
            insertWorn(project.worn, worn);
        }
    return project;
}

QJsonObject rootOf(const QByteArray& json)
{
    return QJsonDocument::fromJson(json).object();
}

void checkBody(const sim::HeadMesh& mesh, float reach)
{
    QVERIFY(sim::openEdges(mesh).empty());
    QVERIFY(mesh.normalsHd.size() == mesh.positionsHd.size() && mesh.uvs.size() == mesh.positionsHd.size());
    for (const glm::vec3& position : mesh.positionsHd)
        QVERIFY(glm::length(position) < reach + 1e-4F);
    for (const glm::uvec3& triangle : mesh.triangles) {
        const glm::vec3& a = mesh.positionsHd[triangle.x];
        const glm::vec3 across = glm::cross(mesh.positionsHd[triangle.y] - a, mesh.positionsHd[triangle.z] - a);
        QVERIFY(glm::dot(across, mesh.normalsHd[triangle.x]) > 0.0F); // Counter-clockwise from outside.
    }
}

void forEveryKind()
{
    QTest::addColumn<WornKind>("kind");
    for (const WornSpec& spec : wornSpecs())
        QTest::newRow(spec.id) << spec.kind;
}

} // namespace

class TestWorn : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theTableIsInOrderAndWhole()
    {
        std::set<QByteArray> ids;
        for (std::size_t i = 0; i < wornSpecs().size(); ++i) {
            const WornSpec& spec = wornSpecs()[i];
            QCOMPARE(static_cast<std::size_t>(spec.kind), i);
            QVERIFY(ids.insert(spec.id).second);
            QVERIFY(findWornSpec(QString::fromLatin1(spec.id)) == &spec);
            for (const char* text :
                 {spec.addTitle, spec.removeTitle, spec.addStep, spec.removeStep, spec.moveStep, spec.sizeStep})
                QVERIFY(!wornText(text).isEmpty());
            QVERIFY(!wornText(spec.title).isEmpty() && spec.drawn() == (spec.lookStep != nullptr));
            QVERIFY(wornText(spec.addHint).contains(QStringLiteral("%1")));
            QVERIFY(spec.leastRadiusM <= spec.radiusM && spec.radiusM <= spec.greatestRadiusM);
            QVERIFY(spec.limit > 0 && (!spec.drawn() || spec.ownArray == nullptr));
        }
        QVERIFY(findWornSpec(QStringLiteral("tiara")) == nullptr);
        std::size_t colliding = 0;
        for (const WornSpec& spec : wornSpecs())
            colliding += spec.collides ? spec.limit : 0;
        QVERIFY(colliding <= std::size_t{sim::kMaxColliders}); // Contact reads no more.
    }

    /// Renderers cull its back and scale it.
    void whatIsDrawnHasAClosedMeshInTheUnitBall()
    {
        for (const WornSpec& spec : wornSpecs()) {
            if (!spec.drawn())
                continue;
            std::vector<std::shared_ptr<const sim::HeadMesh>> meshes{spec.mesh()};
            QVERIFY(meshes.front() == spec.mesh()); // Made once, so that it is uploaded once.
            for (const WornMake& make : spec.makes)
                meshes.push_back(make.mesh());
            for (const auto& mesh : meshes)
                checkBody(*mesh, spec.reach);
        }
        // On a ball of 10 cm a band lies a little off the skin, whichever way round it is put.
        const sim::Skin skin(test::makeBallHead());
        for (const glm::vec2 uv : {glm::vec2(0.5F, 0.98F), glm::vec2(0.5F, 0.8F), glm::vec2(0.3F, 0.6F)}) {
            const Worn band = makeWorn(wornSpec(WornKind::Headband), *skin.atUv(uv));
            const std::shared_ptr<const sim::HeadMesh> mesh = wornSurfaces(band, &skin).front().mesh;
            checkBody(*mesh, wornSpec(WornKind::Headband).reach);
            for (const glm::vec3& position : mesh->positionsHd) {
                const glm::vec3 onHead = band.shape.centreHd + band.shape.rotation * (position * band.shape.semiAxesM);
                QVERIFY(glm::length(onHead) > 0.1F && glm::length(onHead) < 0.112F);
            }
        }
    }

    void itIsAddedAndRemovedByItsIdAndUndone_data() { forEveryKind(); }
    void itIsAddedAndRemovedByItsIdAndUndone()
    {
        QFETCH(WornKind, kind);
        Document document(wearingAll());
        const Project before = document.committed();
        document.push(addWornCommand(document, onTop(kind)));
        const Project after = document.committed();
        QCOMPARE(after.worn.size(), before.worn.size() + 1);
        const Worn* added = after.wornThing(before.nextId);
        QVERIFY(added != nullptr && added->kind == kind);
        QCOMPARE(after.nextId, before.nextId + 1);
        QCOMPARE(document.undoStack().text(0), wornText(wornSpec(kind).addStep));
        // The others keep their ids, whichever goes.
        document.push(removeWornCommand(document, before.worn.front().id));
        QCOMPARE(document.committed().worn.size(), before.worn.size());
        QVERIFY(*document.committed().wornThing(added->id) == *added);
        QVERIFY(document.committed().wornThing(before.worn.front().id) == nullptr);
        document.undo();
        QVERIFY(test::sameProjects(document.committed(), after));
        document.undo();
        QVERIFY(test::sameProjects(document.committed(), before));
        document.undoStack().redo();
        QVERIFY(test::sameProjects(document.committed(), after));
    }

    void noMoreThanTheLimitAreTaken_data() { forEveryKind(); }
    void noMoreThanTheLimitAreTaken()
    {
        QFETCH(WornKind, kind);
        Project project = wearingAll();
        while (countOf(project.worn, kind) < wornSpec(kind).limit) {
            Worn worn = onTop(kind);
            worn.id = project.takeId();
            insertWorn(project.worn, worn);
        }
        Document document(project);
        QCOMPARE(addWornCommand(document, onTop(kind)), nullptr);
        const Checked<QByteArray> json = projectToJson(project);
        QVERIFY(json && projectFromJson(*json));
    }

    void hairKeepsOutOfWhatCollidesAlone()
    {
        Document document(wearingAll());
        const std::vector<Worn>& all = document.project().worn;
        std::vector<sim::Ellipsoid> shapes;
        for (const Worn& one : all)
            if (wornSpec(one.kind).collides)
                shapes.push_back(one.shape);
        QVERIFY(document.groomInput().colliders == shapes);
        QVERIFY(std::ranges::is_sorted(all, {}, &Worn::kind));
    }

    void aHeadBringsItsOwnAndLeavesTheRest()
    {
        Document document(wearingAll());
        const Project before = document.committed();
        document.push(setHeadCommand(document, defaultHead(), builtInEllipsoids()));
        const Project& after = document.committed();
        QCOMPARE(shapesOfHead(after.worn), builtInEllipsoids());
        std::set<Id> ids;
        for (const Worn& one : after.worn) {
            QVERIFY(ids.insert(one.id).second && one.id < after.nextId);
            if (!wornSpec(one.kind).ofHead)
                QVERIFY(before.wornThing(one.id) != nullptr && before.wornThing(one.id)->colour == one.colour);
        }
        document.undo();
        QVERIFY(test::sameProjects(document.committed(), before));
    }

    /// From the crown and beside the ear: there it lies on the other head, as far off the skin, and back again.
    void whatHangsOnTheSkinGoesToTheOtherHead_data()
    {
        QTest::addColumn<bool>("isAnchored");
        QTest::newRow("anchored") << true;
        QTest::newRow("of a file without anchors") << false;
    }
    void whatHangsOnTheSkinGoesToTheOtherHead()
    {
        QFETCH(bool, isAnchored);
        constexpr float kNearM = 0.002F;
        Document document(newProject());
        const std::shared_ptr<const Head> head = document.committed().head;
        const test::ForeignHead smaller =
            test::bent(head->skin->mesh(), [](const glm::vec3& p) { return 0.8F * p + glm::vec3(0.0F, 0.03F, 0.0F); });
        auto made = std::make_shared<Head>();
        made->builtIn = false;
        made->skin = std::make_shared<const sim::Skin>(smaller.mesh);
        made->landmarks = *head->landmarks;
        for (glm::vec3& position : made->landmarks->positionsHd)
            position = smaller.moved(position);
        const std::shared_ptr<const Head> other = made;
        std::vector<Id> ids;
        for (const sim::HeadLandmark landmark : {sim::HeadLandmark::Crown, sim::HeadLandmark::EarLeft}) {
            ids.push_back(document.committed().nextId);
            Worn worn = makeWorn(wornSpec(WornKind::Ball), head->skin->nearest((*head->landmarks)[landmark]));
            worn.shape.rotation = glm::quat(0.5F, 0.5F, -0.5F, 0.5F);
            if (!isAnchored)
                worn.anchor.reset();
            document.push(addWornCommand(document, worn));
        }
        const Project before = document.committed();
        document.push(setHeadCommand(document, other, {}));
        const std::array marks{sim::HeadLandmark::Crown, sim::HeadLandmark::EarLeft};
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const Worn& was = *before.wornThing(ids[i]);
            const Worn& now = *document.committed().wornThing(ids[i]);
            QCOMPARE(now.shape.semiAxesM, was.shape.semiAxesM);
            QVERIFY(now.anchor.has_value());
            const sim::SurfacePoint point = other->skin->at(now.anchor->face, now.anchor->barycentric);
            QVERIFY(glm::distance(now.shape.centreHd, was.shape.centreHd) > kNearM); // The heads differ.
            if (!isAnchored)
                continue; // Beside the ear's opening another point is nearer.
            QVERIFY(glm::distance(point.positionHd, (*other->landmarks)[marks[i]]) < kNearM);
            QVERIFY(std::abs(glm::distance(now.shape.centreHd, point.positionHd) - was.shape.semiAxesM.x) < kNearM);
        }
        const Project there = document.committed();
        document.push(setHeadCommand(document, head, {}));
        for (const Id id : ids) {
            const sim::Ellipsoid& shape = document.committed().wornThing(id)->shape;
            const sim::Ellipsoid& was = before.wornThing(id)->shape;
            QVERIFY(glm::distance(shape.centreHd, was.centreHd) < kNearM);
            QVERIFY(std::abs(glm::dot(shape.rotation, was.rotation)) > 0.99F);
        }
        document.undo();
        QVERIFY(document.committed().worn == there.worn);
        document.undo();
        QVERIFY(document.committed().worn == before.worn);
    }

    void whatIsWornInAGroupsHairGoesWithIt()
    {
        Document document(newProject());
        document.push(addGroupCommand(document, QStringLiteral("Beard"), {}));
        const Id beard = document.committed().groups.back().id;
        const Id scalp = document.committed().groups.front().id;
        for (const Id group : {beard, scalp}) {
            Worn worn = onTop(WornKind::Ball);
            worn.group = group;
            document.push(addWornCommand(document, worn));
        }
        const Project before = document.committed();
        document.push(removeGroupCommand(document, beard));
        QCOMPARE(document.committed().groups.size(), std::size_t{1});
        QCOMPARE(countOf(document.committed().worn, WornKind::Ball), std::size_t{1});
        QCOMPARE(document.committed().worn.back().group, scalp);
        document.undo();
        QVERIFY(test::sameProjects(document.committed(), before));
    }

    void filesGiveItBack()
    {
        const Project project = wearingAll();
        const Checked<QByteArray> json = projectToJson(project);
        QVERIFY(json);
        const Checked<ProjectManifest> manifest = projectFromJson(*json);
        QVERIFY2(manifest, manifest ? "" : qPrintable(manifest.error().text));
        QVERIFY(manifest->project.worn == project.worn);
        QCOMPARE(manifest->project.nextId, project.nextId);
    }

    void filesGiveBackWhereItHangsAndWhatItIsOf()
    {
        Project project = sample();
        Worn worn = onTop(WornKind::Ball);
        worn.id = project.takeId();
        worn.colour = 0xFF102030;
        worn.sheen = 0.25F;
        worn.group = project.groups.front().id;
        worn.anchor = WornAnchor{.face = 7, .barycentric = {0.5F, 0.2F, 0.3F}};
        insertWorn(project.worn, worn);
        QJsonObject root = rootOf(projectToJson(project).value_or(QByteArray()));
        const auto read = [&root] { return projectFromJson(QJsonDocument(root).toJson()); };
        QVERIFY(read() && read()->project.worn == project.worn);
        const auto set = [&root](const char* key, const QJsonValue& value) {
            QJsonArray all = root.value(QLatin1String("worn")).toArray();
            QJsonObject one = all.first().toObject();
            if (value.isUndefined())
                one.remove(QLatin1String(key));
            else
                one.insert(QLatin1String(key), value);
            all.replace(0, one);
            root.insert(QStringLiteral("worn"), all);
        };
        // A group that is not there is none.
        set("group", project.nextId + 5);
        QVERIFY(read());
        QCOMPARE(read()->project.worn.back().group, 0);
        // As the first files with worn things have it.
        for (const char* key : {"group", "anchor", "sheen"})
            set(key, QJsonValue(QJsonValue::Undefined));
        QVERIFY(read());
        const Worn plain = read()->project.worn.back();
        QVERIFY(!plain.anchor && plain.group == 0 && plain.sheen == wornSpec(WornKind::Ball).sheen);
        set("anchor", QStringLiteral("ear"));
        QVERIFY(!read());
    }

    /// A program that does not know the array `worn` must not lose what stands there.
    void theVersionIsTheFirstThatSaysAllOfIt_data() { forEveryKind(); }
    void theVersionIsTheFirstThatSaysAllOfIt()
    {
        QFETCH(WornKind, kind);
        Project project = sample();
        Worn worn = onTop(kind);
        worn.id = project.takeId();
        insertWorn(project.worn, worn);
        const QJsonObject root = rootOf(projectToJson(project).value_or(QByteArray()));
        const bool plain = wornSpec(kind).ownArray != nullptr;
        QCOMPARE(root.value(QLatin1String("format_version")).toInt(), plain ? 2 : 3);
        QCOMPARE(root.contains(QLatin1String("worn")), !plain);
    }

    /// As versions 1 and 2 wrote them until ids were given.
    void ellipsoidsWithoutIdsGetThem()
    {
        const Project& project = sample();
        QJsonObject root = rootOf(projectToJson(project).value_or(QByteArray()));
        QJsonArray ellipsoids = root.value(QLatin1String("ellipsoids")).toArray();
        QCOMPARE(ellipsoids.size(), qsizetype{2});
        for (QJsonValueRef value : ellipsoids) {
            QJsonObject one = value.toObject();
            QVERIFY(one.contains(QLatin1String("id")));
            one.remove(QStringLiteral("id"));
            value = one;
        }
        root.insert(QStringLiteral("ellipsoids"), ellipsoids);
        Checked<ProjectManifest> manifest = projectFromJson(QJsonDocument(root).toJson());
        QVERIFY2(manifest, manifest ? "" : qPrintable(manifest.error().text));
        Project& read = manifest->project;
        read.head = project.head;
        QVERIFY(shapesOfHead(read.worn) == shapesOfHead(project.worn));
        QCOMPARE(read.worn.front().id, project.nextId);
        QCOMPARE(read.nextId, project.nextId + 2);
        // Once given they stay.
        const Checked<ProjectManifest> again = projectFromJson(projectToJson(read).value_or(QByteArray()));
        QVERIFY(again && again->project.worn == read.worn && again->project.nextId == read.nextId);
    }

    void aKindToComeAsksForANewerProgram()
    {
        QJsonObject root = rootOf(projectToJson(sample()).value_or(QByteArray()));
        root.insert(QStringLiteral("worn"), QJsonArray{QJsonObject{{QStringLiteral("kind"), QStringLiteral("tiara")}}});
        const Checked<ProjectManifest> manifest = projectFromJson(QJsonDocument(root).toJson());
        QVERIFY(!manifest);
        QCOMPARE(manifest.error().cure, Clause::Cure::NewerProgram);
    }
};

HAIRPAINT_TEST(TestWorn, Core)
#include "test_worn.moc"
