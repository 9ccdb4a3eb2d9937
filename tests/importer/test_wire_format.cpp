// Messages between the editor and the helper come back as they were, and nothing else is believed.
#include "model/files/wire_format.h"
#include "tests/support/mannequin.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>

using namespace hairpaint;

namespace {

std::span<const std::byte> bodyOf(const wire::Bytes& message)
{
    return std::span(message).subspan(wire::kHeaderBytes);
}

wire::Image sampleImage()
{
    wire::Image image{.width = 3, .height = 2, .channels = 4, .samples = {}};
    for (int i = 0; i < 24; ++i)
        image.samples.push_back(static_cast<std::uint16_t>(i * 2731));
    return image;
}

template<typename T>
wire::Bytes patched(wire::Bytes message, std::size_t at, T value)
{
    std::memcpy(message.data() + at, &value, sizeof(value));
    return message;
}

} // namespace

class TestWireFormat : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void anImageComesBack()
    {
        const wire::Bytes message = wire::encodeImage(sampleImage());
        const auto header = wire::decodeHeader(message);
        QVERIFY(header && header->kind == wire::Kind::Image);
        QCOMPARE(header->bodyBytes, static_cast<std::uint64_t>(message.size() - wire::kHeaderBytes));
        const auto image = wire::decodeImage(bodyOf(message));
        QVERIFY(image && image->samples == sampleImage().samples && image->width == 3 && image->channels == 4);
    }

    void aMeshComesBack()
    {
        const sim::HeadMesh mesh = test::makeBallHead(8);
        const auto back = wire::decodeMesh(bodyOf(wire::encodeMesh(mesh)));
        QVERIFY(back && back->positionsHd == mesh.positionsHd && back->uvs == mesh.uvs);
        QVERIFY(back->triangles == mesh.triangles);
    }

    void aSkeletonComesBack()
    {
        const model::RiggedMesh body = test::makeMannequin(0.5F);
        const auto back = wire::decodeMesh(bodyOf(wire::encodeMesh(body)));
        QVERIFY(back && back->positionsHd == body.positionsHd && back->skeleton == body.skeleton);
        const wire::Bytes bare = wire::encodeMesh(test::makeBallHead(8));
        QVERIFY(wire::decodeMesh(bodyOf(bare))->skeleton.empty());
    }

    void aSkeletonThatContradictsItselfIsRefused_data()
    {
        QTest::addColumn<std::function<void(model::HeadSkeleton&)>>("spoil");
        using Spoil = std::function<void(model::HeadSkeleton&)>;
        const float nan = std::numeric_limits<float>::quiet_NaN();
        QTest::newRow("a parent after its child") << Spoil([](auto& s) { s.joints[2].parent = 5; });
        QTest::newRow("a second root") << Spoil([](auto& s) { s.joints[2].parent = -1; });
        QTest::newRow("a position that is no number") << Spoil([nan](auto& s) { s.joints[2].translation.x = nan; });
        QTest::newRow("a rotation of no length") << Spoil([](auto& s) { s.joints[2].rotation = {0, 0, 0, 0}; });
        QTest::newRow("a control character") << Spoil([](auto& s) { s.joints[2].name = "a\x1B"; });
        QTest::newRow("a name too long") << Spoil([](auto& s) { s.joints[2].name.assign(65, 'a'); });
        QTest::newRow("too many joints") << Spoil([](auto& s) { s.joints.resize(1025, {.name = "a", .parent = 0}); });
        QTest::newRow("a joint that is not there") << Spoil([](auto& s) { s.weights[2].joints[1] = 21; });
        QTest::newRow("weights that do not sum to 1") << Spoil([](auto& s) { s.weights[2].weights.x = 0.5F; });
        QTest::newRow("a weight that is no number") << Spoil([nan](auto& s) { s.weights[2].weights.w = nan; });
        QTest::newRow("too few weights") << Spoil([](auto& s) { s.weights.pop_back(); });
        QTest::newRow("too many weights") << Spoil([](auto& s) { s.weights.push_back({}); });
        QTest::newRow("weights without joints") << Spoil([](auto& s) { s.joints.clear(); });
    }
    void aSkeletonThatContradictsItselfIsRefused()
    {
        QFETCH(std::function<void(model::HeadSkeleton&)>, spoil);
        model::RiggedMesh body = test::makeMannequin();
        spoil(body.skeleton);
        QVERIFY(!wire::decodeMesh(bodyOf(wire::encodeMesh(body))));
    }

    void requestsAndRefusalsComeBack()
    {
        QCOMPARE(wire::decodePath(bodyOf(wire::encodeText(wire::Kind::ReadMesh, "/tmp/ä.obj"))),
                 std::string("/tmp/ä.obj"));
        const auto request =
            wire::decodeRequest(bodyOf(wire::encodeRequest({.bits = 8, .ending = "tif", .image = sampleImage()})));
        QVERIFY(request && request->bits == 8 && request->ending == "tif");
        QVERIFY(request->image.samples == sampleImage().samples);
        const auto reason = wire::decodeRefusal(bodyOf(wire::encodeRefusal(wire::Reason::NoUvs)));
        QVERIFY(reason == wire::Reason::NoUvs);
        const wire::Refusal missing(wire::Reason::MissingFile, "kopf ä.bin");
        QVERIFY(wire::decodeRefusal(bodyOf(wire::encodeRefusal(missing))) == missing);
        const wire::Refusal outside(wire::Reason::OutsideFolder, "kopf ä.bin");
        QVERIFY(wire::decodeRefusal(bodyOf(wire::encodeRefusal(outside))) == outside);
        QVERIFY(!wire::decodeRefusal(bodyOf(wire::encodeRefusal(wire::Reason::MissingFile)))); // No name.
        QVERIFY(!wire::decodeRefusal(bodyOf(wire::encodeRefusal(wire::Reason::OutsideFolder))));
        QVERIFY(!wire::decodeRefusal(bodyOf(wire::encodeRefusal({wire::Reason::Damaged, "x"}))));
        const wire::Sandbox sandbox{.landlockVersion = 7, .filtersCalls = 1, .mostMegabytes = 1800};
        const wire::Bytes told = wire::encodeSandbox(sandbox);
        QVERIFY(wire::decodeSandbox(bodyOf(told)) == sandbox);
        QVERIFY(!wire::decodeSandbox(bodyOf(patched(told, wire::kHeaderBytes + 4, std::uint32_t{2}))));
        QVERIFY(!wire::decodeSandbox(bodyOf(told).first(11)));
    }

    void aHeaderThatIsNotOursIsRefused_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        const wire::Bytes good = wire::encodeRefusal(wire::Reason::Damaged);
        const auto row = [](const char* name, const wire::Bytes& bytes) {
            QTest::newRow(name) << QByteArray(reinterpret_cast<const char*>(bytes.data()),
                                              static_cast<qsizetype>(bytes.size()));
        };
        row("empty", {});
        row("short", wire::Bytes(good.begin(), good.begin() + 19));
        row("another magic", patched(good, 0, 'X'));
        row("another version", patched(good, 7, '9'));
        row("an unknown kind", patched(good, 8, std::uint32_t{77}));
        row("no body", patched(good, 12, std::uint64_t{0}));
        row("a body above its limit", patched(good, 12, wire::kLongestName + 5));
        row("an endless image", patched(wire::encodeImage(sampleImage()), 12, ~std::uint64_t{0}));
    }
    void aHeaderThatIsNotOursIsRefused()
    {
        QFETCH(QByteArray, bytes);
        QVERIFY(
            !wire::decodeHeader(std::as_bytes(std::span(bytes.constData(), static_cast<std::size_t>(bytes.size())))));
    }

    void anImageThatContradictsItselfIsRefused_data()
    {
        QTest::addColumn<quint32>("width");
        QTest::addColumn<quint32>("height");
        QTest::addColumn<quint32>("channels");
        QTest::newRow("wider than its samples") << 4U << 2U << 4U;
        QTest::newRow("fewer samples than there are") << 3U << 1U << 4U;
        QTest::newRow("no width") << 0U << 2U << 4U;
        QTest::newRow("five channels") << 3U << 2U << 5U;
        QTest::newRow("a product that wraps round") << 0x80000000U << 2U << 4U;
        QTest::newRow("all ones") << 0xFFFFFFFFU << 0xFFFFFFFFU << 0xFFFFFFFFU;
    }
    void anImageThatContradictsItselfIsRefused()
    {
        QFETCH(quint32, width);
        QFETCH(quint32, height);
        QFETCH(quint32, channels);
        wire::Bytes message = wire::encodeImage(sampleImage());
        message = patched(patched(patched(message, 20, width), 24, height), 28, channels);
        QVERIFY(!wire::decodeImage(bodyOf(message)));
    }

    void aMeshWithAnImpossibleNumberIsRefused_data()
    {
        QTest::addColumn<std::function<void(sim::HeadMesh&)>>("spoil");
        using Spoil = std::function<void(sim::HeadMesh&)>;
        const float nan = std::numeric_limits<float>::quiet_NaN();
        QTest::newRow("a position that is no number") << Spoil([nan](auto& m) { m.positionsHd[1].y = nan; });
        QTest::newRow("a position too far") << Spoil([](auto& m) { m.positionsHd[1].y = -2e7F; });
        QTest::newRow("a normal of no length") << Spoil([](auto& m) { m.normalsHd[1] = glm::vec3(0.0F); });
        QTest::newRow("a normal that is no number") << Spoil([nan](auto& m) { m.normalsHd[1].x = nan; });
        QTest::newRow("a uv outside") << Spoil([](auto& m) { m.uvs[1].x = 1.5F; });
        QTest::newRow("a uv that is no number") << Spoil([nan](auto& m) { m.uvs[1].x = nan; });
        QTest::newRow("an index out of range") << Spoil([](auto& m) { m.triangles[1].z = 1U << 30U; });
        QTest::newRow("no triangles") << Spoil([](auto& m) { m.triangles.clear(); });
    }
    void aMeshWithAnImpossibleNumberIsRefused()
    {
        QFETCH(std::function<void(sim::HeadMesh&)>, spoil);
        sim::HeadMesh mesh = test::makeBallHead(8);
        QVERIFY(wire::decodeMesh(bodyOf(wire::encodeMesh(mesh))));
        spoil(mesh);
        QVERIFY(!wire::decodeMesh(bodyOf(wire::encodeMesh(mesh))));
    }

    void alteredMessagesNeverCrash()
    {
        const wire::Bytes mesh = wire::encodeMesh(test::makeBallHead(6));
        const wire::Bytes body = wire::encodeMesh(test::makeMannequin(0.0F, 4));
        const wire::Bytes image = wire::encodeImage(sampleImage());
        const wire::Bytes request = wire::encodeRequest({.bits = 16, .ending = "png", .image = sampleImage()});
        std::mt19937 random(5);
        int decoded = 0;
        for (int round = 0; round < 5000; ++round) {
            wire::Bytes bytes = round % 3 == 0 ? mesh : round % 3 == 1 ? image : request;
            const std::size_t range = std::min<std::size_t>(bytes.size(), 60);
            bytes[random() % range] = static_cast<std::byte>(random() & 0xFFU);
            bytes.resize(bytes.size() - (round % 7 == 0 ? random() % (bytes.size() - wire::kHeaderBytes) : 0));
            decoded += wire::decodeHeader(bytes).has_value() ? 1 : 0;
            decoded += wire::decodeMesh(bodyOf(bytes)).has_value() ? 1 : 0;
            decoded += wire::decodeImage(bodyOf(bytes)).has_value() ? 1 : 0;
            decoded += wire::decodeRequest(bodyOf(bytes)).has_value() ? 1 : 0;
            decoded += wire::decodePath(bodyOf(bytes)).has_value() ? 1 : 0;
            // The joints stand near the end.
            wire::Bytes skinned = body;
            skinned[skinned.size() - 1 - random() % (skinned.size() / 2)] = static_cast<std::byte>(random() & 0xFFU);
            decoded += wire::decodeMesh(bodyOf(skinned)).has_value() ? 1 : 0;
        }
        QVERIFY(decoded > 0);
    }
};

HAIRPAINT_TEST(TestWireFormat, Core)
#include "test_wire_format.moc"
