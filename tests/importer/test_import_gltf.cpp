// glTF as the standard has it, in this process; what needs files is asked of the real helper.
#include "app/importer/gltf_scene.h"
#include "app/importer/gltf_uri.h"
#include "app/importer/scene_flattener.h"
#include "model/files/importer_client.h"
#include "tests/importer/gltf_samples.h"
#include "tests/model/archive_maker.h"
#include "tests/model/sample_project.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <functional>
#include <numeric>

using namespace hairpaint;
using namespace hairpaint::model;
using test::ball;
using test::GltfMaker;
using test::Numbers;
using test::packedByDraco;
using test::packedByMeshopt;
using test::plain;
using test::skinned;
using MeshRead = tl::expected<RiggedMesh, wire::Refusal>;

namespace {

MeshRead readBytes(std::vector<std::byte> bytes)
{
    const tl::expected<importer::GltfFile, wire::Refusal> file = importer::parsedGltf(std::move(bytes));
    if (!file)
        return tl::unexpected(file.error());
    const auto scene = importer::gltfScene(
        *file, [](const std::string& uri) { return tl::unexpected(wire::Refusal(wire::Reason::MissingFile, uri)); });
    if (!scene)
        return tl::unexpected(scene.error());
    return importer::flattened(*scene);
}

QString said(const MeshRead& mesh)
{
    return mesh ? QString()
                : QStringLiteral("%1 %2")
                      .arg(static_cast<int>(mesh.error().reason))
                      .arg(QString::fromStdString(mesh.error().detail));
}

/// How far the corners of both meshes' triangles lie apart at most: positions in m, and uvs.
std::pair<float, float> differenceOf(const sim::HeadMesh& a, const sim::HeadMesh& b)
{
    if (a.triangles.size() != b.triangles.size())
        return {1e9F, 1e9F};
    std::pair<float, float> most(0.0F, 0.0F);
    for (std::size_t t = 0; t < a.triangles.size(); ++t)
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t i = a.triangles[t][corner];
            const std::uint32_t j = b.triangles[t][corner];
            most.first = std::max(most.first, glm::distance(a.positionsHd[i], b.positionsHd[j]));
            most.second = std::max(most.second, glm::distance(a.uvs[i], b.uvs[j]));
        }
    return most;
}

using GltfChange = std::function<void(GltfMaker&)>;

GltfChange attribute(const char* name, const Numbers& numbers, int components, test::ComponentType type,
                     bool normalized = false, std::size_t stride = 0)
{
    return [=](GltfMaker& maker) {
        maker.primitive()["attributes"][name] = maker.add(numbers, components, type, normalized, stride);
    };
}

} // namespace

Q_DECLARE_METATYPE(GltfChange)

class TestImportGltf : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    ImporterClient m_client{test::importProgram(), 60'000};

private Q_SLOTS:
    void numbersOfEveryTypeAreRead_data()
    {
        QTest::addColumn<GltfChange>("change");
        QTest::addColumn<float>("offM");
        QTest::addColumn<float>("offUv");
        const auto row = [](const char* name, const GltfChange& change, float offM = 1e-7F, float offUv = 1e-6F) {
            QTest::newRow(name) << change << offM << offUv;
        };
        const Numbers uvs = test::uvsOf(ball());
        row("plain", [](GltfMaker&) {});
        row("uvs of 16 bits", attribute("TEXCOORD_0", uvs, 2, test::kUnsignedShort, true), 1e-7F, 2e-5F);
        row("uvs of 8 bits, four bytes apart", attribute("TEXCOORD_0", uvs, 2, test::kUnsignedByte, true, 4), 1e-7F,
            4e-3F);
        row("uvs apart from each other", attribute("TEXCOORD_0", uvs, 2, test::kFloat, false, 20));
        const auto quantized = [](float scale, const GltfChange& change) {
            return [=](GltfMaker& maker) {
                change(maker);
                maker.json["nodes"][0]["scale"] = {scale, scale, scale};
                maker.json["extensionsRequired"] = {"KHR_mesh_quantization"};
            };
        };
        const auto positions = [](float scale, test::ComponentType type, bool normalized, std::size_t stride) {
            return attribute("POSITION", test::positionsOf(ball(), 1.0F / scale), 3, type, normalized, stride);
        };
        row("positions of 16 bits", quantized(0.1F, positions(0.1F, test::kShort, true, 8)), 4e-6F);
        row("positions of whole numbers", quantized(1e-5F, positions(1e-5F, test::kShort, false, 8)), 1e-5F);
        row("positions of bytes", quantized(0.1F, positions(0.1F, test::kByte, true, 4)), 1e-3F);
        row("normals of bytes", attribute("NORMAL", test::normalsOf(ball()), 3, test::kByte, true, 4));
        row("no normals", [](GltfMaker& maker) { maker.primitive()["attributes"].erase("NORMAL"); });
        row("indices of 16 bits", [](GltfMaker& maker) {
            maker.primitive()["indices"] = maker.add(test::indicesOf(ball()), 1, test::kUnsignedShort);
        });
        row("indices of 8 bits", [](GltfMaker& maker) {
            maker.primitive()["indices"] = maker.add(test::indicesOf(ball()), 1, test::kUnsignedByte);
        });
        row("no indices", [](GltfMaker& maker) {
            Numbers all;
            Numbers uv;
            for (const glm::uvec3& t : ball().triangles)
                for (int corner = 0; corner < 3; ++corner) {
                    const glm::vec3& p = ball().positionsHd[t[corner]];
                    all.insert(all.end(), {p.x, p.y, p.z});
                    uv.insert(uv.end(), {ball().uvs[t[corner]].x, 1.0F - ball().uvs[t[corner]].y});
                }
            maker.primitive() = {
                {"attributes",
                 {{"POSITION", maker.add(all, 3, test::kFloat)}, {"TEXCOORD_0", maker.add(uv, 2, test::kFloat)}}}};
        });
        row("some positions told apart (sparse)", [](GltfMaker& maker) {
            Numbers zeros = test::positionsOf(ball());
            Numbers own(zeros.begin() + 15, zeros.begin() + 21);
            std::fill(zeros.begin() + 15, zeros.begin() + 21, 0.0F);
            const int accessor = maker.add(zeros, 3, test::kFloat);
            maker.json["accessors"][static_cast<std::size_t>(accessor)]["sparse"] = {
                {"count", 2},
                {"indices",
                 {{"bufferView", maker.addView(GltfMaker::encoded({5, 6}, 1, test::kUnsignedShort))},
                  {"componentType", 5123}}},
                {"values", {{"bufferView", maker.addView(GltfMaker::encoded(own, 3, test::kFloat))}}}};
            maker.primitive()["attributes"]["POSITION"] = accessor;
        });
        row("moved by a target", [](GltfMaker& maker) {
            const Numbers half = test::positionsOf(ball(), 0.5F);
            maker.primitive()["attributes"]["POSITION"] = maker.add(half, 3, test::kFloat);
            maker.primitive()["targets"] = {{{"POSITION", maker.add(test::positionsOf(ball()), 3, test::kFloat)}}};
            maker.json["meshes"][0]["weights"] = {0.5};
        });
        row("the uvs that the base colour uses", [=](GltfMaker& maker) {
            attribute("TEXCOORD_1", uvs, 2, test::kFloat)(maker);
            attribute("TEXCOORD_0", Numbers(uvs.size(), 0.5F), 2, test::kFloat)(maker);
            maker.json["materials"] = {
                {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 1}}}}}}};
            maker.primitive()["material"] = 0;
        });
        row(
            "uvs that the texture's transform makes whole",
            [=](GltfMaker& maker) {
                Numbers small = uvs;
                for (float& number : small)
                    number = number * 0.25F + 0.125F;
                attribute("TEXCOORD_0", small, 2, test::kFloat)(maker);
                const nlohmann::json transform = {{"offset", {-0.5, -0.5}}, {"scale", {4, 4}}};
                maker.json["materials"] = {
                    {{"pbrMetallicRoughness",
                      {{"baseColorTexture", {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}}}}}}};
                maker.json["extensionsRequired"] = {"KHR_texture_transform"};
                maker.primitive()["material"] = 0;
            },
            1e-7F, 1e-5F);
        row("a texture that is repeated", [=](GltfMaker& maker) {
            maker.json["materials"] = {
                {{"pbrMetallicRoughness",
                  {{"baseColorTexture",
                    {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {4, 4}}}}}}}}}}}};
            maker.primitive()["material"] = 0;
        });
    }
    void numbersOfEveryTypeAreRead()
    {
        QFETCH(GltfChange, change);
        QFETCH(float, offM);
        QFETCH(float, offUv);
        GltfMaker maker = plain();
        change(maker);
        const MeshRead expected = readBytes(plain().glb());
        const MeshRead mesh = readBytes(maker.glb());
        QVERIFY2(expected && mesh, qPrintable(said(mesh)));
        const auto [metres, uvs] = differenceOf(*mesh, *expected);
        QVERIFY2(metres <= offM && uvs <= offUv, qPrintable(QStringLiteral("%1 m, %2").arg(metres).arg(uvs)));
        for (std::size_t i = 0; i < mesh->positionsHd.size(); ++i) // Outward, whatever they are made of.
            QVERIFY(glm::dot(mesh->normalsHd[i], glm::normalize(mesh->positionsHd[i])) > 0.7F);
        QCOMPARE(mesh->told.metresPerUnit, 1.0F);
        QVERIFY(mesh->told.up == ToldAxis::Y);
    }

    void aStripAndAFanAreTriangles_data()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("strip") << 5;
        QTest::newRow("fan") << 6;
    }
    void aStripAndAFanAreTriangles()
    {
        QFETCH(int, mode);
        const Numbers positions =
            mode == 5 ? Numbers{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0} : Numbers{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
        GltfMaker maker;
        maker.primitive() = {{"attributes",
                              {{"POSITION", maker.add(positions, 3, test::kFloat)},
                               {"TEXCOORD_0", maker.add({0, 0, 1, 0, 0, 1, 1, 1}, 2, test::kFloat)}}},
                             {"mode", mode}};
        const MeshRead mesh = readBytes(maker.glb());
        QVERIFY2(mesh, qPrintable(said(mesh)));
        QCOMPARE(mesh->triangles.size(), 2U);
        for (const glm::vec3& normal : mesh->normalsHd)
            QVERIFY(normal.z > 0.99F); // Both the right way round.
    }

    void weightsOfEveryTypeAreRead_data()
    {
        QTest::addColumn<int>("type");
        QTest::newRow("floats") << static_cast<int>(test::kFloat);
        QTest::newRow("8 bits") << static_cast<int>(test::kUnsignedByte);
        QTest::newRow("16 bits") << static_cast<int>(test::kUnsignedShort);
    }
    void weightsOfEveryTypeAreRead()
    {
        QFETCH(int, type);
        const MeshRead mesh = readBytes(skinned(static_cast<test::ComponentType>(type), type != test::kFloat).glb());
        QVERIFY2(mesh, qPrintable(said(mesh)));
        QCOMPARE(mesh->skeleton.joints.size(), 2U);
        for (const BoneWeights& held : mesh->skeleton.weights)
            QVERIFY(std::abs(held.weights.x - 0.5F) < 1e-4F && std::abs(held.weights.y - 0.5F) < 1e-4F);
    }

    void oddSkinsAreReadAsFarAsTheyGo_data()
    {
        QTest::addColumn<GltfChange>("change");
        QTest::addColumn<float>("second"); // The weight of the second joint of a vertex.
        const auto row = [](const char* name, float second, const GltfChange& change) {
            QTest::newRow(name) << change << second;
        };
        row("a joint that does not exist", 0.0F, [](GltfMaker& maker) { maker.json["skins"][0]["joints"] = {1, 77}; });
        row("fewer joints than are named", 0.0F, [](GltfMaker& maker) { maker.json["skins"][0]["joints"] = {1}; });
        row("a joint twice", 0.5F, [](GltfMaker& maker) { maker.json["skins"][0]["joints"] = {1, 2, 1, 2}; });
        row("joints outside of the scene", 0.5F, [](GltfMaker& maker) { maker.json["scenes"][0]["nodes"] = {0}; });
        row("one matrix for two joints", 0.5F, [](GltfMaker& maker) {
            maker.json["skins"][0]["inverseBindMatrices"] =
                maker.add({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, 16, test::kFloat);
        });
    }
    void oddSkinsAreReadAsFarAsTheyGo()
    {
        QFETCH(GltfChange, change);
        QFETCH(float, second);
        GltfMaker maker = skinned(test::kFloat, false);
        change(maker);
        const MeshRead mesh = readBytes(maker.glb());
        QVERIFY2(mesh, qPrintable(said(mesh)));
        QVERIFY(!mesh->skeleton.empty());
        for (const BoneWeights& held : mesh->skeleton.weights)
            QCOMPARE(held.weights.y, second);
    }

    void aVrm0IsTurnedToTheFront_data()
    {
        QTest::addColumn<bool>("isOld");
        QTest::newRow("VRM 0.x looks along -z") << true;
        QTest::newRow("VRM 1.0 along z") << false;
    }
    void aVrm0IsTurnedToTheFront()
    {
        QFETCH(bool, isOld);
        GltfMaker maker = skinned(test::kFloat, false);
        maker.json["nodes"][2]["translation"] = {0.02, 0.1, -0.04}; // The face.
        maker.json["skins"][0]["inverseBindMatrices"] =
            maker.add({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,      0,     0,     1,
                       1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -0.02F, -0.1F, 0.04F, 1},
                      16, test::kFloat);
        maker.json["extensions"] = {{isOld ? "VRM" : "VRMC_vrm", {{"specVersion", "0.0"}}}};
        const MeshRead mesh = readBytes(maker.glb());
        QVERIFY2(mesh, qPrintable(said(mesh)));
        const std::vector<JointPose> poses = posesOf(mesh->skeleton);
        const glm::vec3 face = poses.back().position;
        QVERIFY(glm::distance(face, isOld ? glm::vec3(-0.02F, 0.1F, 0.04F) : glm::vec3(0.02F, 0.1F, -0.04F)) < 1e-6F);
        const MeshRead straight = readBytes(plain().glb());
        QVERIFY(straight);
        const glm::vec3& own = mesh->positionsHd[mesh->triangles[40].x];
        const glm::vec3& other = straight->positionsHd[straight->triangles[40].x];
        QVERIFY(glm::distance(own, isOld ? glm::vec3(-other.x, other.y, -other.z) : other) < 1e-6F);
    }

    void compressedMeshesAreDecoded_data()
    {
        QTest::addColumn<bool>("isDraco");
        QTest::newRow("meshopt") << false;
        QTest::newRow("Draco") << true;
    }
    void compressedMeshesAreDecoded()
    {
        QFETCH(bool, isDraco);
        GltfMaker maker = isDraco ? packedByDraco() : packedByMeshopt();
        const MeshRead mesh = readBytes(maker.glb());
        QVERIFY2(mesh, qPrintable(said(mesh)));
        const MeshRead expected = readBytes(plain().glb());
        QVERIFY(expected);
        // meshopt may turn a triangle's corners.
        QCOMPARE(mesh->triangles.size(), expected->triangles.size());
        glm::vec3 sum(0.0F);
        glm::vec2 uvSum(0.0F);
        for (const auto& [read, sign] : {std::pair(&*mesh, 1.0F), std::pair(&*expected, -1.0F)})
            for (const glm::uvec3& t : read->triangles)
                for (int corner = 0; corner < 3; ++corner) {
                    sum += sign * glm::abs(read->positionsHd[t[corner]]);
                    uvSum += sign * read->uvs[t[corner]];
                }
        QVERIFY(glm::length(sum) < 0.01F && glm::length(uvSum) < 0.01F);
    }

    void whatIsNotUnderstoodIsNamed_data()
    {
        QTest::addColumn<GltfChange>("change");
        QTest::addColumn<int>("reason");
        QTest::addColumn<QString>("told");
        const auto row = [](const char* name, wire::Reason reason, const char* told, const GltfChange& change) {
            QTest::newRow(name) << change << static_cast<int>(reason) << QString::fromLatin1(told);
        };
        row("an extension", wire::Reason::UnknownExtension, "ACME_shape",
            [](GltfMaker& maker) { maker.json["extensionsRequired"] = {"ACME_shape"}; });
        row("Draco without sense", wire::Reason::UndecodedCompression, "Draco", [](GltfMaker& maker) {
            maker = packedByDraco();
            std::fill(maker.bin.begin(), maker.bin.end(), std::byte{7});
        });
        row("meshopt without sense", wire::Reason::UndecodedCompression, "meshopt", [](GltfMaker& maker) {
            maker = packedByMeshopt();
            std::fill(maker.bin.begin(), maker.bin.end(), std::byte{7});
        });
        row("a view beyond its buffer", wire::Reason::Malformed, "buffer view 0 reaches beyond",
            [](GltfMaker& maker) { maker.json["bufferViews"][0]["byteOffset"] = 1 << 20; });
        row("an accessor beyond its view", wire::Reason::Malformed, "buffer view 0 holds less",
            [](GltfMaker& maker) { maker.json["accessors"][0]["count"] = 1 << 19; });
        row("more than a head has", wire::Reason::TooLarge, "",
            [](GltfMaker& maker) { maker.json["accessors"][0]["count"] = 1 << 30; });
        row("an accessor that does not exist", wire::Reason::Malformed, "accessor 99",
            [](GltfMaker& maker) { maker.primitive()["attributes"]["NORMAL"] = 99; });
        row("numbers of another kind", wire::Reason::Malformed, "accessor 2 is not of the type",
            [](GltfMaker& maker) { maker.primitive()["attributes"]["NORMAL"] = 2; });
        row("triangles of no vertices", wire::Reason::Malformed, "vertices that do not exist", [](GltfMaker& maker) {
            maker.primitive()["indices"] = maker.add({0, 1, 60000}, 1, test::kUnsignedShort);
        });
        row("no uvs", wire::Reason::NoUvs, "",
            [](GltfMaker& maker) { maker.primitive()["attributes"].erase("TEXCOORD_0"); });
        row("points", wire::Reason::NoTriangles, "", [](GltfMaker& maker) { maker.primitive()["mode"] = 0; });
        row("the version before", wire::Reason::UnknownFormat, "",
            [](GltfMaker& maker) { maker.json["asset"]["version"] = "1.0"; });
        row("nodes in a circle", wire::Reason::NoTriangles, "", [](GltfMaker& maker) {
            maker.json["nodes"] = {{{"children", {1}}}, {{"children", {0}}}};
        });
    }
    void whatIsNotUnderstoodIsNamed()
    {
        QFETCH(GltfChange, change);
        QFETCH(int, reason);
        QFETCH(QString, told);
        GltfMaker maker = plain();
        change(maker);
        const MeshRead mesh = readBytes(maker.glb());
        QVERIFY(!mesh);
        QCOMPARE(static_cast<int>(mesh.error().reason), reason);
        QVERIFY2(QString::fromStdString(mesh.error().detail).contains(told), qPrintable(said(mesh)));
    }

    void noCutOfAFileIsReadBeyondItsEnd()
    {
        const std::vector<std::byte> whole = packedByMeshopt().glb();
        for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 200)
            QVERIFY(!readBytes({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}));
    }

    void buffersLieInTheFolder_data()
    {
        QTest::addColumn<QString>("uri");
        QTest::addColumn<QString>("file"); // None: it is not read.
        QTest::newRow("a blank as its code") << QStringLiteral("my%20head.bin") << QStringLiteral("my head.bin");
        QTest::newRow("a blank as it is") << QStringLiteral("my head.bin") << QStringLiteral("my head.bin");
        QTest::newRow("in a folder") << QStringLiteral("parts/a%C3%A4.bin") << QStringLiteral("parts/aä.bin");
        QTest::newRow("a name with a code that is none") << QStringLiteral("100%.bin") << QStringLiteral("100%.bin");
        QTest::newRow("round about") << QStringLiteral("parts/../b.bin") << QStringLiteral("b.bin");
        QTest::newRow("above") << QStringLiteral("../above.bin") << QString();
        QTest::newRow("above, by codes") << QStringLiteral("%2e%2e%2fabove.bin") << QString();
        QTest::newRow("whole") << QStringLiteral("/etc/hostname") << QString();
        QTest::newRow("a file's URL") << QStringLiteral("file:///etc/hostname") << QString();
        QTest::newRow("of the net") << QStringLiteral("https://example.com/a.bin") << QString();
    }
    void buffersLieInTheFolder()
    {
        QFETCH(QString, uri);
        QFETCH(QString, file);
        const QTemporaryDir around;
        const QDir inside(around.filePath(QStringLiteral("inside")));
        QVERIFY(QDir().mkpath(inside.filePath(QStringLiteral("parts"))));
        GltfMaker maker = plain();
        const QByteArray bytes(reinterpret_cast<const char*>(maker.bin.data()),
                               static_cast<qsizetype>(maker.bin.size()));
        test::writeBytes(around.filePath(QStringLiteral("above.bin")), bytes);
        if (!file.isEmpty())
            test::writeBytes(inside.filePath(file), bytes);
        maker.json["buffers"] = {{{"byteLength", maker.bin.size()}, {"uri", uri.toStdString()}}};
        const QString model = inside.filePath(QStringLiteral("model.gltf"));
        test::writeBytes(model, QByteArray::fromStdString(maker.json.dump()));
        const Result<RiggedMesh> mesh = m_client.readMesh(model);
        if (!file.isEmpty()) {
            QVERIFY2(mesh, mesh ? "" : qPrintable(mesh.error().message));
            QCOMPARE(mesh->triangles.size(), ball().triangles.size());
            return;
        }
        QVERIFY(!mesh);
        QVERIFY2(mesh.error().message.contains(QStringLiteral("lies outside of its folder")),
                 qPrintable(mesh.error().message));
        QVERIFY2(test::isOneSentenceNaming(mesh.error().message, model), qPrintable(mesh.error().message));
    }

    void dataInAUriIsDecoded_data()
    {
        QTest::addColumn<QByteArray>("uri");
        QTest::addColumn<QByteArray>("data");
        QTest::newRow("bytes") << QByteArray("data:application/octet-stream;base64,AP8Q")
                               << QByteArray("\0\xFF\x10", 3);
        QTest::newRow("no kind") << QByteArray("data:;base64,AP8=") << QByteArray("\0\xFF", 2);
        QTest::newRow("for URLs") << QByteArray("DATA:a/b;base64,-_8") << QByteArray("\xFB\xFF", 2);
        QTest::newRow("not base 64") << QByteArray("data:text/plain,abc") << QByteArray();
        QTest::newRow("no digits") << QByteArray("data:;base64,A*==") << QByteArray();
    }
    void dataInAUriIsDecoded()
    {
        QFETCH(QByteArray, uri);
        QFETCH(QByteArray, data);
        const auto bytes = importer::dataOfUri(uri.toStdString());
        QCOMPARE(bytes.has_value(), !data.isEmpty());
        if (bytes)
            QCOMPARE(QByteArray(reinterpret_cast<const char*>(bytes->data()), static_cast<qsizetype>(bytes->size())),
                     data);
    }
};

HAIRPAINT_TEST(TestImportGltf, Core)
#include "test_import_gltf.moc"
