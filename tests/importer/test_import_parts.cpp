// Parts of foreign characters through the real helper: names, materials, tiles, textures, and what has no layout.
#include "model/files/glb_writing.h"
#include "model/files/importer_client.h"
#include "model/files/part_selection.h"
#include "model/heads/layout_packing.h"
#include "tests/model/archive_maker.h"
#include "tests/support/character.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QImage>
#include <QTemporaryDir>
#include <QTest>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

/// An object of an OBJ: a ball; uvs moved by `tile`, or none.
QByteArray ballObject(const char* name, glm::vec3 centre, float radius, bool withUvs, std::size_t& vertices,
                      std::size_t& uvs, glm::vec2 (*layout)(glm::vec2, glm::vec3) = nullptr)
{
    const sim::HeadMesh ball = test::makeBallHead(24, radius);
    QByteArray text = QByteArray("o ") + name + "\n";
    for (const glm::vec3& p : ball.positionsHd)
        text += QStringLiteral("v %1 %2 %3\n")
                    .arg(static_cast<double>(p.x + centre.x), 0, 'f', 6)
                    .arg(static_cast<double>(p.y + centre.y), 0, 'f', 6)
                    .arg(static_cast<double>(p.z + centre.z), 0, 'f', 6)
                    .toLatin1();
    for (std::size_t i = 0; withUvs && i < ball.uvs.size(); ++i) {
        const glm::vec2 uv = layout != nullptr ? layout(ball.uvs[i], ball.positionsHd[i]) : ball.uvs[i];
        text += QStringLiteral("vt %1 %2\n")
                    .arg(static_cast<double>(uv.x), 0, 'f', 6)
                    .arg(static_cast<double>(uv.y), 0, 'f', 6)
                    .toLatin1();
    }
    for (const glm::uvec3& t : ball.triangles) {
        text += "f";
        for (int corner = 0; corner < 3; ++corner) {
            text += ' ' + QByteArray::number(qulonglong{t[corner] + vertices + 1});
            if (withUvs)
                text += '/' + QByteArray::number(qulonglong{t[corner] + uvs + 1});
        }
        text += "\n";
    }
    vertices += ball.positionsHd.size();
    uvs += withUvs ? ball.uvs.size() : 0;
    return text;
}

} // namespace

class TestImportParts : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    ImporterClient m_client{test::importProgram(), 60'000};

    [[nodiscard]] Result<RiggedMesh> read(const QString& name, const QByteArray& bytes)
    {
        test::writeBytes(m_folder.filePath(name), bytes);
        return m_client.readMesh(m_folder.filePath(name));
    }

private Q_SLOTS:
    void eyesAreSeenAndGrowNothing()
    {
        std::size_t v = 0;
        std::size_t t = 0;
        const QByteArray obj = ballObject("head", glm::vec3(0.0F), 0.12F, true, v, t) +
                               ballObject("eyeL", {0.04F, 0.0F, 0.11F}, 0.015F, true, v, t) +
                               ballObject("eyeR", {-0.04F, 0.0F, 0.11F}, 0.015F, true, v, t);
        Result<RiggedMesh> mesh = read(QStringLiteral("head_eyes.obj"), obj);
        QVERIFY(mesh);
        QCOMPARE(mesh->parts.size(), std::size_t{3});
        QCOMPARE(mesh->parts[1].name, std::string("eyeL"));
        QVERIFY(choosePartsBy(*mesh, {}, guessHead(*mesh)));
        QCOMPARE(mesh->parts[0].use, PartUse::Grows);
        QCOMPARE(mesh->parts[1].use, PartUse::Seen);
        QCOMPARE(mesh->parts[2].use, PartUse::Seen);
        const Checked<ChosenHead> head = headOfParts(*mesh, false);
        QVERIFY(head && head->remarks.isEmpty());
        QCOMPARE(head->mesh.parts.front().triangles, mesh->parts.front().triangles);
    }

    void aPartWithoutLayoutIsKeptAndToldOf()
    {
        std::size_t v = 0;
        std::size_t t = 0;
        const QByteArray obj = ballObject("face", glm::vec3(0.0F), 0.12F, true, v, t) +
                               ballObject("scalp", {0.0F, 0.05F, 0.0F}, 0.12F, false, v, t);
        Result<RiggedMesh> mesh = read(QStringLiteral("top_without_uv.obj"), obj);
        QVERIFY(mesh);
        QCOMPARE(mesh->parts.size(), std::size_t{2});
        QVERIFY(!mesh->parts[1].hasLayout);
        QVERIFY(choosePartsBy(*mesh, {}, guessHead(*mesh)));
        const Checked<ChosenHead> head = headOfParts(*mesh, false);
        QVERIFY(head);
        QCOMPARE(head->mesh.parts.size(), std::size_t{2});
        QVERIFY2(head->remarks.size() == 1 && head->remarks.first().contains(QStringLiteral("scalp")),
                 qPrintable(head->remarks.join(QLatin1Char('\n'))));
    }

    void tilesLieSideBySide()
    {
        std::size_t v = 0;
        std::size_t t = 0;
        // Behind x = 0 the tile at the right; the ball's columns are cut there.
        const QByteArray obj = ballObject("head", glm::vec3(0.0F), 0.12F, true, v, t,
                                          [](glm::vec2 uv, glm::vec3 /*at*/) { return glm::vec2(uv.x * 2.0F, uv.y); });
        Result<RiggedMesh> mesh = read(QStringLiteral("udim.obj"), obj);
        QVERIFY(mesh);
        QCOMPARE(mesh->parts.size(), std::size_t{2});
        QCOMPARE(mesh->parts[1].tile + mesh->parts[0].tile, glm::ivec2(1, 0));
        QVERIFY(choosePartsBy(*mesh, {}, guessHead(*mesh)));
        QVERIFY(mesh->parts[0].use == PartUse::Grows && mesh->parts[1].use == PartUse::Grows);
        const Checked<ChosenHead> head = headOfParts(*mesh, false);
        QVERIFY(head);
        QVERIFY(overlapOf(head->mesh).fraction < kNotableOverlap);
        QVERIFY2(head->remarks.join(QLatin1Char(' ')).contains(QStringLiteral("1002")),
                 qPrintable(head->remarks.join(QLatin1Char('\n'))));
    }

    void texturesAndColoursComeAlong()
    {
        Result<RiggedMesh> mesh = read(QStringLiteral("character.glb"), glbFromMesh(test::makeCharacter()));
        QVERIFY(mesh);
        QCOMPARE(mesh->parts.size(), std::size_t{6});
        QCOMPARE(mesh->parts[0].name, std::string("Body"));
        QCOMPARE(mesh->parts[0].material, std::string("Cotton"));
        QCOMPARE(mesh->textures, test::makeCharacter().textures);
        QCOMPARE(mesh->parts[2].texture, mesh->parts[3].texture);
        QVERIFY(glm::distance(mesh->parts[4].colour, glm::vec3(0.2F, 0.1F, 0.05F)) < 1e-6F);
        QCOMPARE(mesh->skeleton.joints.size(), test::kMannequin.size());
    }

    void aTextureBesideAnObjIsShown()
    {
        QImage image(8, 4, QImage::Format_RGB888);
        image.fill(QColor(10, 200, 30));
        QVERIFY(image.save(m_folder.filePath(QStringLiteral("skin.png"))));
        test::writeBytes(m_folder.filePath(QStringLiteral("head.mtl")),
                         "newmtl Skin\nKd 1 1 1\nmap_Kd C:\\\\work\\\\skin.png\n");
        std::size_t v = 0;
        std::size_t t = 0;
        QByteArray obj = ballObject("head", glm::vec3(0.0F), 0.12F, true, v, t);
        obj.prepend("mtllib head.mtl\n");
        obj.replace("\nf ", "\nusemtl Skin\nf ");
        const Result<RiggedMesh> mesh = read(QStringLiteral("textured.obj"), obj);
        QVERIFY(mesh);
        QCOMPARE(mesh->textures.size(), std::size_t{1});
        QCOMPARE(mesh->textures.front().width, 8U);
        QCOMPARE(mesh->textures.front().height, 4U);
        QCOMPARE(mesh->textures.front().rgba[1], std::uint8_t{200});
        QCOMPARE(mesh->parts.front().material, std::string("Skin"));
    }

    void aLargeTextureIsHalvedUntilItFits()
    {
        RiggedMesh character = test::makeCharacter();
        character.textures[0] = {.width = 5000, .height = 8, .rgba = std::vector<std::uint8_t>(160'000, 255)};
        const Result<RiggedMesh> mesh = read(QStringLiteral("large.glb"), glbFromMesh(character));
        QVERIFY(mesh);
        QCOMPARE(mesh->textures.front().width, 2500U);
        QCOMPARE(mesh->textures.front().height, 4U);
        QVERIFY(!mesh->parts.back().hasLayout); // All its uvs are one.
    }
};

HAIRPAINT_TEST(TestImportParts, Core)
#include "test_import_parts.moc"
