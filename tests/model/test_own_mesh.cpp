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

#include <QImage>
#include <QTemporaryDir>
#include <QUndoStack>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <string>
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

const sim::HeadMesh& meshOf(const BroughtMesh& brought)
{
    return *brought.own->surfaces.front().part.mesh;
}

const sim::HeadMesh& meshOf(const Worn& worn)
{
    return *worn.ownMesh.own->surfaces.front().part.mesh;
}

bool isNear(const glm::vec3& a, const glm::vec3& b)
{
    return glm::distance(a, b) < 1e-4F;
}

/// Three eggs in a row, along x: red; with a texture that is blue on one half and holed on the other; red again.
RiggedMesh threeEggs()
{
    RiggedMesh mesh;
    for (int i = 0; i < 3; ++i) {
        const RiggedMesh one = egg(0.01F);
        const auto first = static_cast<std::uint32_t>(mesh.positionsHd.size());
        for (std::size_t v = 0; v < one.positionsHd.size(); ++v) {
            mesh.positionsHd.push_back(one.positionsHd[v] + glm::vec3(0.03F * static_cast<float>(i), 0.0F, 0.0F));
            mesh.normalsHd.push_back(one.normalsHd[v]);
            mesh.uvs.push_back(one.uvs[v]);
        }
        for (const glm::uvec3& triangle : one.triangles)
            mesh.triangles.push_back(triangle + first);
        mesh.parts.push_back(one.parts.front());
        mesh.parts.back().name = "egg " + std::to_string(i);
    }
    mesh.parts[1].colour = glm::vec3(0.5F);
    mesh.parts[1].texture = 1;
    mesh.parts[1].alpha = PartAlpha::Mask;
    mesh.textures.resize(2); // The first is nobody's.
    for (MeshTexture& texture : mesh.textures)
        texture = {.width = 2, .height = 1, .rgba = {0, 0, 255, 255, 9, 8, 7, 0}};
    return mesh;
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
            least = glm::min(least, meshOf(one).positionsHd[i]);
            greatest = glm::max(greatest, meshOf(one).positionsHd[i]);
            QVERIFY(isNear(glm::normalize(meshOf(one).normalsHd[i] / one.semiAxesM), mesh.normalsHd[i]));
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
        QVERIFY(meshOf(turned).triangles == meshOf(right).triangles);
        QVERIFY(meshOf(turned).normalsHd == meshOf(right).normalsHd);
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

    /// Parts of one material become one; the others keep theirs, in files as well.
    void itKeepsItsMaterials()
    {
        const RiggedMesh source = threeEggs();
        const BroughtMesh one = brought(source);
        QCOMPARE(one.colour, qRgb(255, 255, 255));
        QCOMPARE(one.own->surfaces.size(), std::size_t{2});
        const HeadPart& red = one.own->surfaces[0].part;
        const HeadPart& textured = one.own->surfaces[1].part;
        QCOMPARE(red.mesh->triangles.size(), 2 * egg().triangles.size());
        QCOMPARE(textured.mesh->triangles.size(), egg().triangles.size());
        QVERIFY(red.texture == nullptr && red.colour == glm::vec3(1.0F, 0.0F, 0.0F));
        QVERIFY(textured.texture != nullptr && textured.colour == glm::vec3(0.5F));
        QVERIFY(*textured.texture == source.textures[1] && textured.alpha == PartAlpha::Mask);
        QVERIFY(textured.mesh->uvs == egg().uvs);
        for (const glm::vec3& position : textured.mesh->positionsHd)
            QVERIFY(std::abs(position.x) < 0.26F); // Between the others.

        Project project = test::makeSampleProject();
        Worn worn = wornFrom(one, {}, project.groups.front().id);
        worn.id = project.takeId();
        worn.colour = qRgb(250, 240, 230);
        insertWorn(project.worn, worn);
        QVERIFY(saveProject(project, path("three.hairpaint"), {}));
        const Result<Project> read = loadProject(path("three.hairpaint"));
        QVERIFY(read && read->worn == project.worn);
        QVERIFY(*wornSurfaces(eggOf(read->worn), nullptr)[1].texture == source.textures[1]);
        QVERIFY(saveProject(*read, path("again.hairpaint"), {}));
        QCOMPARE(test::readBytes(path("again.hairpaint")), test::readBytes(path("three.hairpaint")));
        worn.mirrored = true;
        const std::vector<HeadPart> mirrored = wornSurfaces(worn, nullptr);
        QCOMPARE(mirrored.size(), surfaceCount(worn));
        QCOMPARE(mirrored[0].mesh->positionsHd[5].x, -red.mesh->positionsHd[5].x);
    }

    /// One material without texture is the thing's colour, as in older files.
    void aMeshOfOneColourHasNoMaterialOfItsOwn()
    {
        const BroughtMesh one = brought(egg());
        QCOMPARE(one.own->surfaces.size(), std::size_t{1});
        QVERIFY(one.own->surfaces.front().part.colour == glm::vec3(1.0F));
        QVERIFY(!one.own->glb.contains("materials"));
    }

    void itsTexturesAreMadeSmallerUntilTheyFit()
    {
        RiggedMesh mesh = threeEggs();
        MeshTexture& large = mesh.textures[1];
        large = {.width = 4096, .height = 2048, .rgba = std::vector<std::uint8_t>(std::size_t{4096} * 2048 * 4, 77)};
        const BroughtMesh one = brought(mesh);
        const MeshTexture& kept = *one.own->surfaces[1].part.texture;
        QCOMPARE(kept.width, 2048U);
        QCOMPARE(kept.height, 1024U);
        QVERIFY(std::ranges::all_of(kept.rgba, [](std::uint8_t value) { return value == 77; }));
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
        QVERIFY(meshOf(egg).triangles == meshOf(eggOf(project.worn)).triangles);
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
                               one.shape.rotation *
                                   (wornSurfaces(one, nullptr).front().mesh->positionsHd[i] * one.shape.semiAxesM);
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

    void itsMaterialsGoOutWithTheHair()
    {
        Worn worn = wornFrom(brought(threeEggs()), {}, 0);
        worn.id = 5;
        const auto frame = test::frameOf({test::hairGroup(1, 20'000, 65535, 0)});
        const auto written = [&](const char* name, const char* target) {
            const Result<void> done = exportHair(frame,
                                                 {.format = findExportFormat(path(name)),
                                                  .target = findExportTarget(QLatin1StringView(target)),
                                                  .curves = test::allOf(*frame),
                                                  .worn = {worn}},
                                                 path(name));
            return done ? test::readBytes(path(name)) : QByteArray();
        };
        const QJsonObject json = test::jsonOf(written("parts.glb", "any"));
        const QJsonArray meshes = json[QLatin1String("meshes")].toArray();
        QCOMPARE(meshes.last()[QLatin1String("name")].toString(), QStringLiteral("Worn mesh 5 part 2"));
        const auto materialOf = [&](const QJsonValue& mesh) {
            return json[QLatin1String("materials")]
                       [mesh[QLatin1String("primitives")][0][QLatin1String("material")].toInt()];
        };
        const QJsonValue red = materialOf(meshes[meshes.size() - 2])[QLatin1String("pbrMetallicRoughness")];
        QVERIFY(red[QLatin1String("baseColorFactor")][0].toDouble() > 0.999);
        QCOMPARE(red[QLatin1String("baseColorFactor")][1].toDouble(), 0.0);
        QVERIFY(red[QLatin1String("baseColorTexture")].isUndefined());
        const QJsonValue textured = materialOf(meshes.last());
        QCOMPARE(textured[QLatin1String("alphaMode")].toString(), QStringLiteral("MASK"));
        QVERIFY(textured[QLatin1String("doubleSided")].toBool());
        const QJsonValue texture =
            json[QLatin1String("textures")][textured[QLatin1String("pbrMetallicRoughness")]
                                                    [QLatin1String("baseColorTexture")][QLatin1String("index")]
                                                        .toInt(-1)];
        const QJsonValue image = json[QLatin1String("images")][texture[QLatin1String("source")].toInt(-1)];
        const QJsonValue view = json[QLatin1String("bufferViews")][image[QLatin1String("bufferView")].toInt(-1)];
        const QByteArray file = test::readBytes(path("parts.glb"));
        const qsizetype bin = file.size() - json[QLatin1String("buffers")][0][QLatin1String("byteLength")].toInteger();
        const QImage shown = QImage::fromData(file.mid(bin + view[QLatin1String("byteOffset")].toInteger(),
                                                       view[QLatin1String("byteLength")].toInteger()));
        QCOMPARE(shown.size(), QSize(2, 1));
        QCOMPARE(shown.pixel(0, 0), qRgba(0, 0, 255, 255));
        QCOMPARE(qAlpha(shown.pixel(1, 0)), 0);

        QVERIFY(written("parts.obj", "any").contains("o Worn_mesh_5_part_2\n"));
        const QByteArray materials = test::readBytes(path("parts.mtl"));
        QVERIFY(materials.contains("newmtl Worn_mesh_5_part_1\nKd 1 0 0\n"));
        QVERIFY(materials.contains("map_Kd parts-worn-1.png\n") && materials.contains("map_d parts-worn-1.png\n"));
        QCOMPARE(QImage(path("parts-worn-1.png")).pixel(0, 0), qRgba(0, 0, 255, 255));
        // Vertices have one colour for a texture: its mean where it is seen, here half of a blue.
        QVERIFY(test::readBytes(path("parts.obj")).contains(" 0 0 0.737"));

        const QByteArray usd = written("parts.usda", "any");
        QVERIFY(usd.contains("asset inputs:file = @@@./parts-worn-1.png@@@"));
        QVERIFY(usd.contains("float inputs:opacityThreshold = 0.5"));
        QVERIFY(usd.contains("diffuseColor.connect = </Hair/Worn_mesh_5_part_2/Material/Picture.outputs:rgb>"));
        QVERIFY(usd.contains("color3f inputs:diffuseColor = (1,0,0)"));
        const QByteArray packed = written("parts.usdz", "any");
        const std::vector<test::EntrySpan> entries = test::spansOf(packed);
        QCOMPARE(entries.size(), std::size_t{2});
        QCOMPARE(entries[0].name, QStringLiteral("hair.usda"));
        QCOMPARE(entries[1].name, QStringLiteral("hair-worn-1.png"));
        const qsizetype png = packed.indexOf("\x89PNG");
        QCOMPARE(png % 64, qsizetype{0});
        QCOMPARE(QImage::fromData(packed.mid(png)).size(), QSize(2, 1));
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
