// How hair grows on the heads that people get: around one whorl, and nowhere else without a direction.
#include "model/files/head_file.h"
#include "sim/groom/stream_raster.h"
#include "sim/skin/natural_stream.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>
#include <numbers>

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

struct Singular
{
    glm::vec3 middleHd{0.0F};
    int index = 0; ///< +1: a whorl, a source or a sink; -1: a saddle.
};

/// The angle of a direction in the plane of a triangle.
float angleIn(const glm::vec3& direction, const glm::vec3& x, const glm::vec3& y)
{
    return std::atan2(glm::dot(direction, y), glm::dot(direction, x));
}

/// Triangles round which the stream turns once: Poincare's index.
std::vector<Singular> singularTriangles(const sim::HeadMesh& mesh, const std::vector<glm::vec3>& stream)
{
    constexpr float kPi = std::numbers::pi_v<float>;
    std::vector<Singular> found;
    for (const glm::uvec3& triangle : mesh.triangles) {
        const glm::vec3 a = mesh.positionsHd[triangle.x];
        const glm::vec3 b = mesh.positionsHd[triangle.y];
        const glm::vec3 c = mesh.positionsHd[triangle.z];
        const glm::vec3 normal = glm::cross(b - a, c - a);
        if (glm::length(normal) < 1e-12F)
            continue;
        const glm::vec3 x = glm::normalize(b - a);
        const glm::vec3 y = glm::cross(glm::normalize(normal), x);
        float turned = 0.0F;
        for (int i = 0; i < 3; ++i) {
            const float from = angleIn(stream[triangle[i]], x, y);
            const float to = angleIn(stream[triangle[(i + 1) % 3]], x, y);
            turned += std::remainder(to - from, 2.0F * kPi);
        }
        const int index = static_cast<int>(std::lround(turned / (2.0F * kPi)));
        if (index != 0)
            found.push_back({.middleHd = (a + b + c) / 3.0F, .index = index});
    }
    return found;
}

} // namespace

class TestBustStream : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aBustHasOneWhorl_data()
    {
        QTest::addColumn<QString>("head");
        QTest::newRow("the new bust") << QStringLiteral("bust-2");
        QTest::newRow("the older one") << QStringLiteral("bust-1");
    }
    /// Its counterpart would lie in the foot, which is open.
    void aBustHasOneWhorl()
    {
        QFETCH(QString, head);
        const std::shared_ptr<const model::Head> bust = *model::builtInHead(head);
        const std::vector<Singular> found =
            singularTriangles(bust->skin->mesh(), sim::naturalStream(*bust->skin, bust->landmarks));
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found.front().index, 1);
        const glm::vec3 crown = (*bust->landmarks)[sim::HeadLandmark::Crown];
        QVERIFY(glm::distance(found.front().middleHd, crown) < 0.04F);
        QVERIFY(found.front().middleHd.x < 0.0F && found.front().middleHd.z < crown.z); // Behind it, on the right.
    }

    /// Whoever changes how hair grows bakes the bust's stream anew.
    void theBakedStreamIsWhatIsComputed()
    {
        constexpr int kUnits = 16; // The tolerance for rounding, of 65535.
        const std::shared_ptr<const model::Head> bust = *model::builtInHead(QStringLiteral("bust-2"));
        const auto computed = sim::streamRaster(*bust->skin, sim::naturalStream(*bust->skin, bust->landmarks));
        const sim::TiledRaster& baked = *bust->naturalDirection;
        QCOMPARE(baked.size(), computed->size());
        for (int y = 0; y < baked.size(); ++y)
            for (int x = 0; x < baked.size(); ++x)
                for (std::size_t channel = 0; channel < 2; ++channel)
                    QVERIFY(std::abs(baked.texel(x, y)[channel] - computed->texel(x, y)[channel]) <= kUnits);
    }

    /// Closed, with a nose and ears, not even, not known to anybody.
    void aForeignHeadHasAWhorlAndItsCounterpart()
    {
        sim::HeadMesh mesh = makeBallHead(96, 0.1F);
        const auto swollen = [](glm::vec3 p, glm::vec3 middle, float byM) {
            const float near = glm::dot(p - middle, p - middle) / (0.02F * 0.02F);
            return glm::normalize(p) * (byM * std::exp(-near));
        };
        for (glm::vec3& p : mesh.positionsHd) {
            p = {-p.y, p.x, p.z}; // Its poles, where triangles have no area, go to the sides.
            glm::vec3 displacement = swollen(p, {0.0F, -0.01F, 0.1F}, 0.02F);
            displacement += swollen(p, {0.1F, 0.0F, 0.0F}, 0.015F) + swollen(p, {-0.1F, 0.005F, 0.0F}, 0.012F);
            p = (p + displacement) * glm::vec3(0.8F, 1.15F, 1.0F);
        }
        const sim::Skin skin(std::move(mesh));
        // Hair stands upright in a whorl, so that right beside it triangles differ by nothing that shows.
        constexpr float kWhorlM = 0.012F;
        bool whorl = false;
        bool counterpart = false;
        for (const Singular& singular : singularTriangles(skin.mesh(), sim::naturalStream(skin, std::nullopt))) {
            const bool atTop = glm::distance(singular.middleHd, glm::vec3(0.0F, 0.115F, 0.0F)) < kWhorlM;
            const bool atBottom = glm::distance(singular.middleHd, glm::vec3(0.0F, -0.115F, 0.0F)) < kWhorlM;
            QVERIFY2(atTop || atBottom, qPrintable(QStringLiteral("%1 %2 %3")
                                                       .arg(singular.middleHd.x)
                                                       .arg(singular.middleHd.y)
                                                       .arg(singular.middleHd.z)));
            whorl |= atTop;
            counterpart |= atBottom;
        }
        QVERIFY(whorl && counterpart);
    }
};

HAIRPAINT_TEST(TestBustStream, Gui)
#include "test_bust_stream.moc"
