// How hair grows where nobody combed it: one whorl, and streams away from it.
#include "sim/groom/direction_texel.h"
#include "sim/groom/stream_raster.h"
#include "sim/skin/natural_stream.h"
#include "sim/skin/skin_frame.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace hairpaint::sim;
using namespace hairpaint::test;

class TestNaturalStream : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aBallHasOneWhorlAndItsCounterpart_data();
    void aBallHasOneWhorlAndItsCounterpart();
    void landmarksPositionTheWhorl();
    void piecesApartHang();
    void theRasterTellsItInItsOwnFrames();
    void itIsTheSameEveryTime();
};

void TestNaturalStream::aBallHasOneWhorlAndItsCounterpart_data()
{
    QTest::addColumn<int>("segments");
    QTest::newRow("as fine as heads are") << 96;
    QTest::newRow("so fine that heat takes a coarser one") << 384;
}

void TestNaturalStream::aBallHasOneWhorlAndItsCounterpart()
{
    QFETCH(const int, segments);
    const Skin skin(makeBallHead(segments, 0.1F));
    const std::vector<glm::vec3> stream = naturalStream(skin, std::nullopt);
    const HeadMesh& mesh = skin.mesh();
    QCOMPARE(stream.size(), mesh.positionsHd.size());
    const glm::vec3 whorl(0.0F, 0.1F, 0.0F);
    for (std::size_t i = 0; i < stream.size(); ++i) {
        const glm::vec3 p = mesh.positionsHd[i];
        QVERIFY(std::abs(glm::dot(stream[i], mesh.normalsHd[i])) < 1e-4F);
        QVERIFY(glm::length(stream[i]) <= 1.0F);
        const float fromWhorl = glm::distance(p, whorl);
        if (fromWhorl < 0.001F)
            QVERIFY(glm::length(stream[i]) < 0.3F);
        if (fromWhorl < 0.06F || glm::distance(p, -whorl) < 0.02F)
            continue;
        // Down the ball, ever flatter.
        QVERIFY(glm::length(stream[i]) > 0.8F);
        const glm::vec3 down = glm::normalize(glm::vec3(0.0F, -1.0F, 0.0F) + mesh.normalsHd[i] * mesh.normalsHd[i].y);
        QVERIFY2(glm::dot(glm::normalize(stream[i]), down) > 0.97F,
                 qPrintable(QStringLiteral("%1 %2 %3").arg(p.x).arg(p.y).arg(p.z)));
    }
    for (const glm::uvec3& triangle : mesh.triangles) {
        const glm::vec3 middle =
            (mesh.positionsHd[triangle.x] + mesh.positionsHd[triangle.y] + mesh.positionsHd[triangle.z]) / 3.0F;
        if (glm::distance(middle, whorl) < 0.015F || glm::distance(middle, -whorl) < 0.015F)
            continue;
        for (int i = 0; i < 3; ++i)
            QVERIFY(glm::dot(glm::normalize(stream[triangle[i]]), glm::normalize(stream[triangle[(i + 1) % 3]])) >
                    0.8F);
    }
    // Clockwise, seen from outside.
    const SurfacePoint beside = skin.nearest(glm::vec3(0.012F, 0.1F, 0.0F));
    const glm::vec3 swirl = stream[mesh.triangles[beside.face].x];
    QVERIFY(glm::dot(glm::cross(glm::vec3(1.0F, 0.0F, 0.0F), glm::normalize(swirl)), glm::vec3(0.0F, 1.0F, 0.0F)) <
            -0.3F);
}

void TestNaturalStream::landmarksPositionTheWhorl()
{
    const Skin skin(makeBallHead(96, 0.1F));
    HeadLandmarks landmarks;
    landmarks[HeadLandmark::Crown] = glm::vec3(0.0F, 0.08F, -0.06F);
    landmarks[HeadLandmark::Chin] = glm::vec3(0.0F, -0.08F, 0.06F);
    const std::vector<glm::vec3> stream = naturalStream(skin, landmarks);
    const std::vector<glm::vec3>& positions = skin.mesh().positionsHd;
    const auto least = std::ranges::min_element(stream, {}, [](glm::vec3 v) { return glm::dot(v, v); });
    const glm::vec3 whorl = positions[static_cast<std::size_t>(least - stream.begin())];
    QVERIFY2(glm::distance(whorl, glm::vec3(-0.006F, 0.075F, -0.067F)) < 0.012F,
             qPrintable(QStringLiteral("%1 %2 %3").arg(whorl.x).arg(whorl.y).arg(whorl.z)));
    // Forward over the top.
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (glm::distance(positions[i], glm::vec3(0.0F, 0.1F, 0.0F)) < 0.015F)
            QVERIFY(glm::normalize(stream[i]).z > 0.8F);
}

void TestNaturalStream::piecesApartHang()
{
    HeadMesh mesh = makeBallHead(48, 0.1F);
    const HeadMesh eye = makeBallHead(24, 0.02F);
    const auto first = static_cast<std::uint32_t>(mesh.positionsHd.size());
    for (std::size_t i = 0; i < eye.positionsHd.size(); ++i) {
        mesh.positionsHd.push_back(eye.positionsHd[i] + glm::vec3(0.0F, 0.0F, 0.14F));
        mesh.normalsHd.push_back(eye.normalsHd[i]);
        mesh.uvs.push_back(eye.uvs[i]);
    }
    for (const glm::uvec3& triangle : eye.triangles)
        mesh.triangles.push_back(triangle + first);
    const Skin skin(mesh);
    const std::vector<glm::vec3> stream = naturalStream(skin, std::nullopt);
    for (std::size_t i = first; i < stream.size(); ++i) {
        QVERIFY(std::isfinite(stream[i].x + stream[i].y + stream[i].z));
        if (std::abs(mesh.normalsHd[i].y) < 0.9F)
            QVERIFY(stream[i].y < -0.3F);
    }
}

void TestNaturalStream::theRasterTellsItInItsOwnFrames()
{
    const Skin skin(makeBallHead(96, 0.1F));
    const std::shared_ptr<const TiledRaster> raster = streamRaster(skin, naturalStream(skin, std::nullopt));
    QCOMPARE(raster->size(), kStreamRasterSize);
    QCOMPARE(raster->channels(), 2);
    for (int i = 0; i < 200; ++i) {
        const glm::vec2 uv(std::fmod(0.618F * static_cast<float>(i), 1.0F), 0.15F + 0.003F * static_cast<float>(i));
        const std::optional<SurfacePoint> point = skin.atUv(uv);
        QVERIFY(point);
        const glm::vec3 direction =
            SkinFrame::at(*point).toHd(directionOfChannels(glm::vec2(raster->sampleBilinear(uv)) * 65535.0F));
        QVERIFY(direction.y < -0.6F * std::sqrt(1.0F - point->normalHd.y * point->normalHd.y));
    }
}

void TestNaturalStream::itIsTheSameEveryTime()
{
    const Skin skin(makeBallHead(48, 0.1F));
    QVERIFY(naturalStream(skin, std::nullopt) == naturalStream(skin, std::nullopt));
    int asked = 0;
    QVERIFY(naturalStream(skin, std::nullopt, [&asked] { return ++asked > 5; }).empty());
}

HAIRPAINT_TEST(TestNaturalStream, Core)
#include "test_natural_stream.moc"
