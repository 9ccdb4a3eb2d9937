// Meshes that users bring to be worn: fitted, placed, kept, mirrored, exported.
#include "model/disk/atomic_file.h"
#include "model/document/scene_commands.h"
#include "model/files/own_mesh_file.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/formats/export_format.h"
#include "model/journal/journal_reader.h"
#include "model/journal/journal_writer.h"
#include "model/repair/project_repair.h"
#include "model/styles/preset.h"
#include "model/styles/worn_transfer.h"
#include "tests/model/archive_maker.h"
#include "tests/model/exported_hair.h"
#include "tests/model/fixtures.h"
#include "tests/model/sample_project.h"
#include "tests/support/glb_json.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QUndoStack>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

/// An egg of 2 x 3 x 4 units with its own colour.
RiggedMesh egg(float scale = 1.0F)
{
    sim::HeadMesh ball = test::makeBallHead(24, 1.0F);
    for (std::size_t i = 0; i < ball.positionsHd.size(); ++i) {
        const glm::vec3 axes(1.0F, 1.5F, 2.0F);
        ball.normalsHd[i] = glm::normalize(ball.positionsHd[i] / axes);
        ball.positionsHd[i] *= scale * axes;
    }
    RiggedMesh mesh(std::move(ball));
    mesh.parts.push_back({.name = "egg",
                          .material = {},
                          .colour = {1.0F, 0.0F, 0.0F},
                          .vertices = static_cast<std::uint32_t>(mesh.positionsHd.size()),
                          .triangles = static_cast<std::uint32_t>(mesh.triangles.size())});
    return mesh;
}

BroughtMesh brought(const RiggedMesh& mesh, const QString& name = QStringLiteral("egg"))
{
    return broughtMesh(mesh, name).value();
}

bool isNear(const glm::vec3& a, const glm::vec3& b)
{
    return glm::distance(a, b) < 1e-4F;
}

/// A sample whose group 0 wears the egg.
Project wearingEgg()
{
    Project project = test::makeSampleProject();
    sim::SurfacePoint point;
    point.positionHd = {0.03F, 0.1F, 0.02F};
    point.normalHd = {0.0F, 1.0F, 0.0F};
    Worn worn = wornFrom(brought(egg()), point, project.groups.front().id);
    worn.id = project.takeId();
    insertWorn(project.worn, worn);
    return project;
}

const Worn& eggOf(const std::vector<Worn>& all)
{
    return *std::ranges::find(all, WornKind::Mesh, &Worn::kind);
}

} // namespace

class TestOwnMesh : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QLatin1StringView(name)); }

private Q_SLOTS:
    void itFillsItsBoxAndKeepsItsSize_data()
    {
        QTest::addColumn<float>("scale");
        QTest::addColumn<float>("told");
        QTest::addColumn<float>("halfM");
        QTest::newRow("metres, as no file says otherwise") << 0.02F << 0.0F << 0.04F;
        QTest::newRow("told centimetres") << 3.0F << 0.01F << 0.06F;
        QTest::newRow("larger than what is worn") << 40.0F << 0.0F << 0.04F;
        QTest::newRow("too small to be seen") << 1e-6F << 1.0F << 0.04F;
    }
    void itFillsItsBoxAndKeepsItsSize()
    {
        QFETCH(float, scale);
        QFETCH(float, told);
        QFETCH(float, halfM);
        RiggedMesh mesh = egg(scale);
        for (glm::vec3& position : mesh.positionsHd)
            position += scale * glm::vec3(5.0F, -3.0F, 8.0F); // Wherever it stands.
        mesh.told.metresPerUnit = told;
        const BroughtMesh one = brought(mesh);
        QVERIFY(isNear(one.semiAxesM, halfM * glm::vec3(0.5F, 0.75F, 1.0F)));
        glm::vec3 least(9.0F);
        glm::vec3 greatest(-9.0F);
        for (std::size_t i = 0; i < mesh.positionsHd.size(); ++i) {
            least = glm::min(least, one.own->mesh->positionsHd[i]);
            greatest = glm::max(greatest, one.own->mesh->positionsHd[i]);
            QVERIFY(isNear(glm::normalize(one.own->mesh->normalsHd[i] / one.semiAxesM), mesh.normalsHd[i]));
        }
        QVERIFY(isNear(least, glm::vec3(-1.0F)) && isNear(greatest, glm::vec3(1.0F)));
        QCOMPARE(one.colour, qRgb(255, 0, 0));
        QVERIFY(!one.passable);
    }

    void whatIsUpInTheFileIsUpOnTheHead()
    {
        RiggedMesh mesh = egg(0.01F);
        mesh.told.up = ToldAxis::Z;
        QVERIFY(isNear(brought(mesh).semiAxesM, 0.01F * glm::vec3(1.0F, 2.0F, 1.5F)));
    }

    void whatIsInsideOutIsTurned()
    {
        RiggedMesh mesh = egg(0.01F);
        const BroughtMesh right = brought(mesh);
        for (glm::uvec3& triangle : mesh.triangles)
            std::swap(triangle.y, triangle.z);
        for (glm::vec3& normal : mesh.normalsHd)
            normal = -normal;
        const BroughtMesh turned = brought(mesh);
        QVERIFY(turned.own->mesh->triangles == right.own->mesh->triangles);
        QVERIFY(turned.own->mesh->normalsHd == right.own->mesh->normalsHd);
    }

    /// A plate is passable, so a hat does not throw the hair off the head; what is solid keeps hair out.
    void hairKeepsOutOfWhatIsSolid()
    {
        const BroughtMesh plate = brought(RiggedMesh(test::makePatchHead()));
        QVERIFY(plate.passable && plate.semiAxesM.z > 0.0F);
        Project project = wearingEgg();
        const auto count = [&project] { return contactShapes(project.worn).size(); };
        const std::size_t withEgg = count();
        project.worn.back().passable = true;
        QCOMPARE(count(), withEgg - 1);
    }

    void whatIsTooLargeOrNothingIsRefusedInASentence()
    {
        RiggedMesh large = egg();
        while (large.triangles.size() <= kMostOwnTriangles)
            large.triangles.insert(large.triangles.end(), large.triangles.begin(), large.triangles.begin() + 1000);
        const Checked<BroughtMesh> refused = broughtMesh(large, QStringLiteral("large"));
        QVERIFY(!refused && refused.error().text.contains(QString::number(large.triangles.size())));
        RiggedMesh line = egg();
        for (glm::vec3& position : line.positionsHd)
            position = {position.x, 0.0F, 0.0F};
        QVERIFY(!broughtMesh(line, QStringLiteral("line")));
        for (glm::vec3& position : line.positionsHd)
            position = glm::vec3(0.0F);
        QVERIFY(!broughtMesh(line, QStringLiteral("point")));
        // Nor is one taken from a file.
        QVERIFY(!ownMeshFromGlb(QStringLiteral("x"), QByteArrayLiteral("glTF")));
    }

    /// Upright on the crown; at the side it looks outward.
    void itStandsOnTheSkin()
    {
        const BroughtMesh mesh = brought(egg(0.01F));
        const auto at = [&mesh](glm::vec3 normal) {
            sim::SurfacePoint point;
            point.normalHd = normal;
            return wornFrom(mesh, point, 0);
        };
        const Worn crown = at({0.0F, 1.0F, 0.0F});
        QVERIFY(isNear(crown.shape.rotation * glm::vec3(0.0F, 0.0F, 1.0F), {0.0F, 0.0F, 1.0F}));
        QVERIFY(crown.shape.centreHd.y > 0.5F * mesh.semiAxesM.y && crown.shape.centreHd.y <= mesh.semiAxesM.y);
        for (const glm::vec3 out :
             {glm::vec3(1.0F, 0.0F, 0.0F), glm::vec3(-1.0F, 0.0F, 0.0F), glm::vec3(0.0F, 0.0F, -1.0F)}) {
            const Worn worn = at(out);
            QVERIFY(isNear(worn.shape.rotation * glm::vec3(0.0F, 0.0F, 1.0F), out));
            QVERIFY(isNear(worn.shape.rotation * glm::vec3(0.0F, 1.0F, 0.0F), {0.0F, 1.0F, 0.0F}));
        }
    }

    void filesGiveItBackOnceForAllThatWearIt()
    {
        Project project = wearingEgg();
        Worn second = eggOf(project.worn);
        second.id = project.takeId();
        second.shape.centreHd.x = -0.03F;
        second.mirrored = true;
        second.passable = true;
        insertWorn(project.worn, second);
        QVERIFY(saveProject(project, path("worn.hairpaint"), {}));
        const QByteArray bytes = test::readBytes(path("worn.hairpaint"));
        QVERIFY(bytes.contains("worn/1.glb") && !bytes.contains("worn/2.glb"));
        const Result<Project> read = loadProject(path("worn.hairpaint"));
        QVERIFY2(read, read ? "" : qPrintable(read.error().message));
        QVERIFY(read->worn == project.worn);
        const Worn& egg = eggOf(read->worn);
        QVERIFY(egg.ownMesh.isRead() && egg.ownMesh.own == read->worn.back().ownMesh.own);
        QVERIFY(egg.ownMesh.own->mesh->triangles == eggOf(project.worn).ownMesh.own->mesh->triangles);
        QVERIFY(saveProject(*read, path("again.hairpaint"), {}));
        QCOMPARE(test::readBytes(path("again.hairpaint")), bytes);
        // In a style, too.
        const Preset preset = presetFrom(project, QStringLiteral("Egg"));
        QCOMPARE(countOf(preset.worn, WornKind::Mesh), std::size_t{2});
        QVERIFY(savePreset(preset, path("worn.hairpreset")));
        const Result<Preset> style = loadPreset(path("worn.hairpreset"));
        QVERIFY(style && style->worn == preset.worn);
    }

    void aMeshThatIsMissingOrDamagedIsToldAndTheRestRepaired()
    {
        Project project = wearingEgg();
        project.head = defaultHead();
        QVERIFY(saveProject(project, path("whole.hairpaint"), {}));
        QByteArray bytes = test::readBytes(path("whole.hairpaint"));
        const std::vector<test::EntrySpan> spans = test::spansOf(bytes);
        const auto entry = std::ranges::find(spans, QStringLiteral("worn/1.glb"), &test::EntrySpan::name);
        QVERIFY(entry != spans.end());
        for (const bool isMissing : {true, false}) {
            QByteArray broken = bytes;
            if (isMissing)
                broken.replace("worn/1.glb", "worn/9.glb");
            else
                for (qsizetype at = entry->end - 40; at < entry->end; ++at)
                    broken[at] = static_cast<char>(~broken[at]);
            QVERIFY(writeFile(path("broken.hairpaint"), broken));
            const Result<Project> read = loadProject(path("broken.hairpaint"));
            QVERIFY(!read && read.error().message.contains(QStringLiteral("broken.hairpaint")));
            const Result<RepairedProject> repaired = repairProject(path("broken.hairpaint"));
            QVERIFY(repaired);
            QCOMPARE(repaired->losses.size(), 1);
            QVERIFY2(repaired->losses.front().contains(QStringLiteral("egg")), qPrintable(repaired->losses.front()));
            QCOMPARE(countOf(repaired->project.worn, WornKind::Mesh), std::size_t{0});
            QCOMPARE(repaired->project.worn.size(), project.worn.size() - 1);
        }
    }

    void theJournalBringsItBack()
    {
        const Project project = wearingEgg();
        {
            JournalWriter writer(path("journal"));
            for (int step = 0; step < 3; ++step)
                QVERIFY(writer.append({.project = project, .path = {}, .step = {}, .index = step, .count = step}));
        }
        const QByteArray bytes = test::readBytes(path("journal"));
        const auto work = readJournal(path("journal"));
        QVERIFY(work && *work);
        QCOMPARE((*work)->steps.size(), std::size_t{3});
        for (const JournalState& state : (*work)->steps)
            QVERIFY(state.project.worn == project.worn && eggOf(state.project.worn).ownMesh.isRead());
        QVERIFY(bytes.size() > eggOf(project.worn).ownMesh.own->glb.size() / 20);
    }

    void itGoesToTheOtherSideAndBack()
    {
        Document document(test::patchProject());
        const sim::Skin& skin = *document.committed().head->skin;
        for (const WornKind kind : {WornKind::Mesh, WornKind::Bow}) {
            const sim::SurfacePoint point = skin.nearest({0.05F, 0.02F, 0.0F});
            Worn worn =
                kind == WornKind::Mesh ? wornFrom(brought(egg(0.01F)), point, 0) : makeWorn(wornSpec(kind), point, 0);
            worn.shape.rotation = glm::normalize(glm::quat(0.8F, 0.1F, 0.3F, -0.2F));
            const Worn other = mirroredWorn(worn, skin);
            QVERIFY(isNear(other.shape.centreHd, worn.shape.centreHd * glm::vec3(-1.0F, 1.0F, 1.0F)));
            const glm::vec3 out = worn.shape.rotation * glm::vec3(0.0F, 0.0F, 1.0F);
            QVERIFY(isNear(other.shape.rotation * glm::vec3(0.0F, 0.0F, 1.0F), out * glm::vec3(-1.0F, 1.0F, 1.0F)));
            QCOMPARE(other.mirrored, kind == WornKind::Mesh);
            // Each point of the mesh lies where the mirror has it.
            if (kind == WornKind::Mesh)
                for (std::size_t i = 0; i < 20; ++i) {
                    const auto placed = [i](const Worn& one) {
                        return one.shape.centreHd +
                               one.shape.rotation * (wornMesh(one, nullptr)->positionsHd[i] * one.shape.semiAxesM);
                    };
                    QVERIFY(isNear(placed(other), placed(worn) * glm::vec3(-1.0F, 1.0F, 1.0F)));
                }
            const Worn back = mirroredWorn(other, skin);
            QVERIFY(isNear(back.shape.centreHd, worn.shape.centreHd) && back.mirrored == worn.mirrored);
            const Project before = document.committed();
            document.push(addWornCommand(document, other));
            document.undo();
            QVERIFY(test::sameProjects(document.committed(), before));
        }
    }

    void itGoesOutWithTheHair()
    {
        Worn worn = wornFrom(brought(egg(0.02F)), {}, 0);
        worn.id = 5;
        worn.shape.centreHd = {0.0F, 0.1F, 0.0F};
        const auto frame = test::frameOf({test::hairGroup(1, 20'000, 65535, 0)});
        const auto written = [&](const char* name) {
            const Result<void> done = exportHair(frame,
                                                 {.format = findExportFormat(path(name)),
                                                  .target = findExportTarget(QLatin1StringView("any")),
                                                  .curves = test::allOf(*frame),
                                                  .worn = {worn}},
                                                 path(name));
            return done ? test::readBytes(path(name)) : QByteArray();
        };
        const QJsonObject json = test::jsonOf(written("hair.glb"));
        const QJsonValue mesh = json[QLatin1String("meshes")].toArray().last();
        QCOMPARE(mesh[QLatin1String("name")].toString(), QStringLiteral("Worn mesh 5"));
        const QJsonValue primitive = mesh[QLatin1String("primitives")][0];
        const QJsonValue positions =
            json[QLatin1String("accessors")][primitive[QLatin1String("attributes")][QLatin1String("POSITION")].toInt()];
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY(std::abs(positions[QLatin1String("max")][axis].toDouble() -
                             static_cast<double>(worn.shape.centreHd[axis] + worn.shape.semiAxesM[axis])) < 1e-4);
        const QJsonValue material = json[QLatin1String("materials")][primitive[QLatin1String("material")].toInt()];
        QVERIFY(material[QLatin1String("doubleSided")].toBool());
        QVERIFY(written("hair.usda").contains("doubleSided = true"));
        QVERIFY(written("hair.obj").contains("o Worn_mesh_5\n"));
    }
};

HAIRPAINT_TEST(TestOwnMesh, Core)
#include "test_own_mesh.moc"
