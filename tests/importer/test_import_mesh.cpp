// Foreign meshes through the real helper, and the joining of triangles on its own.
#include "app/importer/mesh_builder.h"
#include "model/files/glb_writing.h"
#include "model/files/head_file.h"
#include "model/files/importer_client.h"
#include "tests/model/archive_maker.h"
#include "tests/model/sample_project.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <limits>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

const QByteArray kQuad = "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\n"
                         "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

/// The same square as JSON glTF with its buffer inside, under a node that moves and mirrors it.
QByteArray gltfQuad(const QByteArray& matrix, bool withUvs)
{
    QByteArray bin;
    const auto add = [&bin](std::initializer_list<float> values) {
        for (const float value : values)
            bin.append(reinterpret_cast<const char*>(&value), 4);
    };
    add({0, 0, 0, 2, 0, 0, 2, 3, 0, 0, 3, 0});
    add({0, 1, 1, 1, 1, 0, 0, 0}); // v down
    for (const quint16 index : std::initializer_list<quint16>{0, 1, 2, 0, 2, 3})
        bin.append(reinterpret_cast<const char*>(&index), 2);
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"matrix":)" + matrix +
           R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0)" +
           (withUvs ? QByteArray(R"(,"TEXCOORD_0":1)") : QByteArray()) +
           R"(},"indices":2}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3",)"
           R"("min":[0,0,0],"max":[2,3,0]},{"bufferView":1,"componentType":5126,"count":4,"type":"VEC2"},)"
           R"({"bufferView":2,"componentType":5123,"count":6,"type":"SCALAR"}],"bufferViews":[)"
           R"({"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":32},)"
           R"({"buffer":0,"byteOffset":80,"byteLength":12}],"buffers":[{"byteLength":92,"uri":)"
           R"("data:application/octet-stream;base64,)" +
           bin.toBase64() + R"("}]})";
}

double areaOf(const sim::HeadMesh& mesh)
{
    double area = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positionsHd[t.x]);
        area +=
            0.5 * glm::length(glm::cross(glm::dvec3(mesh.positionsHd[t.y]) - a, glm::dvec3(mesh.positionsHd[t.z]) - a));
    }
    return area;
}

/// The position at a uv's vertex.
glm::vec3 positionAtUv(const sim::HeadMesh& mesh, glm::vec2 uv)
{
    for (std::size_t i = 0; i < mesh.uvs.size(); ++i)
        if (glm::distance(mesh.uvs[i], uv) < 1e-5F)
            return mesh.positionsHd[i];
    return glm::vec3(-999.0F);
}

} // namespace

class TestImportMesh : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    ImporterClient m_client{test::importProgram(), 60'000};

    [[nodiscard]] QString written(const QString& name, const QByteArray& bytes) const
    {
        const QString path = m_folder.filePath(name);
        test::writeBytes(path, bytes);
        return path;
    }

private Q_SLOTS:
    void aMeshIsReadTriangulatedAndJoined_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("vertices");
        QTest::addColumn<int>("triangles");
        QTest::addColumn<double>("area");
        const QByteArray identity = "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]";
        QTest::newRow("OBJ with a quad") << QStringLiteral("a.obj") << kQuad + "f 1/1 2/2 3/3 4/4\n" << 4 << 2 << 6.0;
        QTest::newRow("OBJ with triangles that share corners")
            << QStringLiteral("b.obj") << kQuad + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"
            << 4 << 2 << 6.0;
        QTest::newRow("OBJ with two objects, one without uvs")
            << QStringLiteral("c.obj") << kQuad + "o one\nf 1/1 2/2 3/3 4/4\no two\nf 1 2 3\n"
            << 7 << 3 << 9.0;
        QTest::newRow("OBJ with a triangle of no area")
            << QStringLiteral("d.obj") << kQuad + "f 1/1 2/2 3/3 4/4\nf 1/1 1/1 2/2\n"
            << 4 << 2 << 6.0;
        QTest::newRow("glTF") << QStringLiteral("e.gltf") << gltfQuad(identity, true) << 4 << 2 << 6.0;
        QTest::newRow("glTF under a node that doubles it")
            << QStringLiteral("f.gltf") << gltfQuad("[2,0,0,0,0,2,0,0,0,0,2,0,5,6,7,1]", true) << 4 << 2 << 24.0;
    }
    void aMeshIsReadTriangulatedAndJoined()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        QFETCH(int, vertices);
        QFETCH(int, triangles);
        QFETCH(double, area);
        const auto mesh = m_client.readMesh(written(name, bytes));
        QVERIFY2(mesh, mesh ? "" : qPrintable(mesh.error().message));
        QCOMPARE(static_cast<int>(mesh->positionsHd.size()), vertices);
        QCOMPARE(static_cast<int>(mesh->triangles.size()), triangles);
        QVERIFY(std::abs(areaOf(*mesh) - area) < 1e-4);
    }

    void uvsPointUpAndNormalsOutward()
    {
        const QByteArray matrix = "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]";
        for (const QString& file : {written(QStringLiteral("up.obj"), kQuad + "f 1/1 2/2 3/3 4/4\n"),
                                    written(QStringLiteral("up.gltf"), gltfQuad(matrix, true))}) {
            const auto mesh = m_client.readMesh(file);
            QVERIFY(mesh);
            QCOMPARE(positionAtUv(*mesh, {0.0F, 0.0F}), glm::vec3(0.0F, 0.0F, 0.0F));
            QCOMPARE(positionAtUv(*mesh, {1.0F, 1.0F}), glm::vec3(2.0F, 3.0F, 0.0F));
            for (const glm::vec3& normal : mesh->normalsHd)
                QVERIFY(glm::distance(normal, glm::vec3(0.0F, 0.0F, 1.0F)) < 1e-5F);
        }
    }

    void aMirroredNodeKeepsItsOutside()
    {
        const auto mesh = m_client.readMesh(
            written(QStringLiteral("mirror.gltf"), gltfQuad("[-1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]", true)));
        QVERIFY(mesh);
        for (const glm::uvec3& t : mesh->triangles) {
            const glm::vec3 a = mesh->positionsHd[t.x];
            const glm::vec3 across = glm::cross(mesh->positionsHd[t.y] - a, mesh->positionsHd[t.z] - a);
            QVERIFY(glm::dot(across, mesh->normalsHd[t.x]) > 0.0F);
        }
    }

    void aMeshReadBecomesAHead()
    {
        QByteArray obj;
        const sim::HeadMesh ball = test::makeBallHead(24, 11.0F);
        for (const glm::vec3& p : ball.positionsHd)
            obj += "v " + QByteArray::number(p.x) + ' ' + QByteArray::number(p.z * -1.0F) + ' ' +
                   QByteArray::number(p.y * 1.2F) + '\n';
        for (const glm::vec2& uv : ball.uvs)
            obj += "vt " + QByteArray::number(uv.x) + ' ' + QByteArray::number(uv.y) + '\n';
        for (const glm::uvec3& t : ball.triangles) {
            obj += 'f';
            for (int corner = 0; corner < 3; ++corner) {
                const QByteArray number = QByteArray::number(t[corner] + 1);
                obj += ' ' + number + '/' + number;
            }
            obj += '\n';
        }
        const auto mesh = m_client.readMesh(written(QStringLiteral("ball.obj"), obj));
        QVERIFY2(mesh, mesh ? "" : qPrintable(mesh.error().message));
        const HeadGuess guess = guessHead(*mesh);
        QCOMPARE(guess.unitScale, 0.01F);
        QVERIFY(guess.upAxis == UpAxis::Z);
        const auto head = makeHead(QStringLiteral("ball"), glbFromMesh(*mesh), guess.unitScale, guess.upAxis);
        QVERIFY(head);
        // A ball of 11 cm, stretched by 1.2 upward.
        QVERIFY((*head)->skin->areaM2() > 0.15 && (*head)->skin->areaM2() < 0.19);
    }

    void whatIsNoHeadIsRefused_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        const QByteArray identity = "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]";
        QTest::newRow("STL, which has no uvs")
            << QStringLiteral("a.stl")
            << QByteArray("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
                          "endfacet\nendsolid a\n");
        QTest::newRow("OBJ without uvs") << QStringLiteral("b.obj")
                                         << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        QTest::newRow("glTF without uvs") << QStringLiteral("c.gltf") << gltfQuad(identity, false);
        QTest::newRow("OBJ of lines") << QStringLiteral("d.obj") << QByteArray("v 0 0 0\nv 1 0 0\nl 1 2\n");
        QTest::newRow("an empty OBJ") << QStringLiteral("e.obj") << QByteArray("# nothing\n");
        QTest::newRow("a text") << QStringLiteral("f.txt") << QByteArray("hello");
        QTest::newRow("a text named glb") << QStringLiteral("g.glb") << QByteArray("hello");
        QTest::newRow("half a glTF") << QStringLiteral("h.gltf") << gltfQuad(identity, true).first(300);
        QTest::newRow("a matrix of nothing")
            << QStringLiteral("i.gltf") << gltfQuad("[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1]", true);
        QTest::newRow("light years away")
            << QStringLiteral("j.gltf") << gltfQuad("[1,0,0,0,0,1,0,0,0,0,1,0,1e20,0,0,1]", true);
    }
    void whatIsNoHeadIsRefused()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        const QString file = written(name, bytes);
        const auto mesh = m_client.readMesh(file);
        QVERIFY(!mesh);
        QVERIFY2(test::isOneSentenceNaming(mesh.error().message, file), qPrintable(mesh.error().message));
    }

    void missingUvsAreNamed()
    {
        const auto mesh = m_client.readMesh(written(QStringLiteral("n.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
        QVERIFY(!mesh && mesh.error().message.contains(QStringLiteral("uv")));
    }

    void aBufferThatIsNotThereIsNamed()
    {
        QByteArray model = gltfQuad("[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]", true);
        const auto uri = model.indexOf("data:");
        model.replace(uri, model.indexOf('"', uri) - uri, "far/away.bin");
        const QString file = written(QStringLiteral("torn.gltf"), model);
        const auto mesh = m_client.readMesh(file);
        QVERIFY(!mesh);
        QVERIFY2(mesh.error().message.contains(QStringLiteral("away.bin")), qPrintable(mesh.error().message));
        QVERIFY2(test::isOneSentenceNaming(mesh.error().message, file), qPrintable(mesh.error().message));
    }

    void aBufferOutsideOfTheFolderIsRefusedAsThat_data()
    {
        QTest::addColumn<QString>("uri");
        QTest::addColumn<bool>("isLinked");
        QTest::newRow("named by its path") << QStringLiteral("../outside/buffer.bin") << false;
        QTest::newRow("named by its whole path") << QStringLiteral("/outside/buffer.bin") << false;
        QTest::newRow("of a name that nothing has") << QStringLiteral("../outside/none.bin") << false;
        QTest::newRow("behind a link in the folder") << QStringLiteral("link.bin") << true;
    }
    void aBufferOutsideOfTheFolderIsRefusedAsThat()
    {
        QFETCH(QString, uri);
        QFETCH(bool, isLinked);
        const QTemporaryDir around;
        QVERIFY(QDir(around.path()).mkpath(QStringLiteral("inside")) &&
                QDir(around.path()).mkpath(QStringLiteral("outside")));
        if (uri.startsWith(QLatin1Char('/')))
            uri.prepend(around.path());
        const QString buffer = around.filePath(QStringLiteral("outside/buffer.bin"));
        test::writeBytes(buffer, QByteArray(92, '\0'));
#ifndef Q_OS_UNIX
        if (isLinked)
            QSKIP("Such links are for administrators here.");
#endif
        if (isLinked)
            QVERIFY(QFile::link(buffer, around.filePath(QStringLiteral("inside/") + uri)));
        QByteArray model = gltfQuad("[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]", true);
        const auto start = model.indexOf("data:");
        model.replace(start, model.indexOf('"', start) - start, uri.toUtf8());
        const QString file = around.filePath(QStringLiteral("inside/model.gltf"));
        test::writeBytes(file, model);
        const auto mesh = m_client.readMesh(file);
        QVERIFY(!mesh);
        const QString& said = mesh.error().message;
        QVERIFY2(test::isOneSentenceNaming(said, file), qPrintable(said));
        QVERIFY2(said.contains(QStringLiteral("lies outside of its folder")) &&
                     said.contains(uri.section(QLatin1Char('/'), -1)) && !said.contains(QStringLiteral("damaged")),
                 qPrintable(said));
    }

    /// The file that the user chose, wherever it lies.
    void aModelBehindALinkIsRead()
    {
#ifdef Q_OS_UNIX
        const QTemporaryDir store;
        const QString model = store.filePath(QStringLiteral("model.gltf"));
        test::writeBytes(model, gltfQuad("[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]", true));
        const QString link = m_folder.filePath(QStringLiteral("linked.gltf"));
        QVERIFY(QFile::link(model, link));
        const auto mesh = m_client.readMesh(link);
        QVERIFY2(mesh, mesh ? "" : qPrintable(mesh.error().message));
        QCOMPARE(mesh->triangles.size(), 2U);
#endif
    }

    void aPipeThatAModelNamesIsNotWaitedFor()
    {
#ifdef Q_OS_UNIX
        const QString model = written(QStringLiteral("pipe.obj"), "mtllib pipe.mtl\n" + kQuad + "f 1/1 2/2 3/3 4/4\n");
        const QByteArray pipe = QFile::encodeName(QFileInfo(model).absolutePath() + QStringLiteral("/pipe.mtl"));
        QCOMPARE(::mkfifo(pipe.constData(), 0600), 0);
        const auto mesh = m_client.readMesh(model); // Would end with the helper's time.
        QVERIFY2(mesh, mesh ? "" : qPrintable(mesh.error().message));
        QCOMPARE(mesh->triangles.size(), 2U);
#endif
    }

    void uvsOfOtherTilesAreMovedIntoTheUnitSquare_data()
    {
        QTest::addColumn<glm::vec2>("offset");
        QTest::newRow("the first tile") << glm::vec2(0.0F, 0.0F);
        QTest::newRow("the third tile") << glm::vec2(2.0F, 0.0F);
        QTest::newRow("negative") << glm::vec2(-1.0F, -4.0F);
    }
    void uvsOfOtherTilesAreMovedIntoTheUnitSquare()
    {
        QFETCH(glm::vec2, offset);
        importer::MeshBuilder builder;
        builder.add({{{.position = {0, 0, 0}, .uv = offset + glm::vec2(0.25F, 0.25F)},
                      {.position = {1, 0, 0}, .uv = offset + glm::vec2(0.75F, 0.25F)},
                      {.position = {0, 1, 0}, .uv = offset + glm::vec2(0.25F, 0.75F)}}});
        const sim::HeadMesh mesh = builder.take();
        QCOMPARE(mesh.uvs[0], glm::vec2(0.25F, 0.25F));
        QCOMPARE(mesh.uvs[1], glm::vec2(0.75F, 0.25F));
        QCOMPARE(mesh.normalsHd[2], glm::vec3(0.0F, 0.0F, 1.0F));
    }

    void trianglesThatAreNoneAreLeftOut()
    {
        importer::MeshBuilder builder;
        const float nan = std::numeric_limits<float>::quiet_NaN();
        builder.add({{{.position = {0, 0, 0}}, {.position = {1, 0, 0}}, {.position = {2, 0, 0}}}});
        builder.add({{{.position = {0, 0, nan}}, {.position = {1, 0, 0}}, {.position = {0, 1, 0}}}});
        builder.add({{{.position = {0, 0, 1e30F}}, {.position = {1, 0, 0}}, {.position = {0, 1, 0}}}});
        builder.add({{{.position = {0, 0, 0}, .uv = {nan, 0}}, {.position = {1, 0, 0}}, {.position = {0, 1, 0}}}});
        QCOMPARE(builder.triangleCount(), std::size_t{0});
        QCOMPARE(builder.vertexCount(), std::size_t{0});
    }
};

HAIRPAINT_TEST(TestImportMesh, Core)
#include "test_import_mesh.moc"
