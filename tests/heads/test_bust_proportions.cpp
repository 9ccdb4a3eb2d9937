// The proportions of bust-2 against surveys of adults.
//
// Means of women and men together, rounded, after Zhuang and Bradtmiller, Head-and-Face Anthropometric Survey of U.S.
// Respirator Users (2005), and, for the ear, Farkas, Anthropometry of the Head and Face (1994).
#include <Eigen/Dense>
#include <QFile>
#include <QtTest>
#include <algorithm>
#include <cmath>

#include "glb_reader.h"
#include "model/heads/built_in_heads.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

using namespace hairpaint;
using namespace Qt::StringLiterals;

namespace {

constexpr double kTolerance = 0.05;
constexpr double kSeamsEnd = 0.25; ///< Fraction of the greatest hollow above which a point is on the seam.

} // namespace

class TestBustProportions : public QObject
{
    Q_OBJECT

private:
    tests::GlbMesh m_mesh;
    std::vector<glm::vec3> m_points; // cm
    std::vector<glm::vec3> m_middle; // x = 0, from the crown down the face

    template<typename Inside>
    std::vector<glm::vec3> pointsWhere(const Inside& inside) const
    {
        std::vector<glm::vec3> found;
        std::ranges::copy_if(m_points, std::back_inserter(found), inside);
        return found;
    }

    /// The farthest along an axis of those that lie inside.
    template<typename Inside>
    double farthest(const glm::vec3& axis, const Inside& inside) const
    {
        double most = -1e9;
        for (const glm::vec3& p : m_points)
            if (inside(p))
                most = std::max(most, static_cast<double>(glm::dot(p, axis)));
        return most;
    }

    glm::vec3 noseTip() const { return *std::ranges::max_element(m_middle, {}, &glm::vec3::z); }

    /// Where the nose's underside meets the lip: the deepest point behind the line from the tip to the
    /// upper lip's border.
    glm::vec3 subnasale() const
    {
        const glm::vec3 tip = noseTip();
        glm::vec3 lip(0.0F);
        for (const glm::vec3& p : m_middle)
            if (p.y < -5.5F && p.y > -6.0F && p.z > lip.z)
                lip = p;
        const glm::vec3 inward = glm::normalize(glm::vec3(0.0F, tip.z - lip.z, lip.y - tip.y));
        glm::vec3 deepest = tip;
        for (const glm::vec3& p : m_middle)
            if (p.y < tip.y && p.y > lip.y && glm::dot(p - tip, inward) > glm::dot(deepest - tip, inward))
                deepest = p;
        return deepest;
    }

    /// The middle of what stands out most of the left eye's lids.
    glm::vec3 pupil() const
    {
        const auto lids = pointsWhere(
            [](const glm::vec3& p) { return std::abs(p.x - 3.1F) < 1.0F && std::abs(p.y) < 0.5F && p.z > 6.0F; });
        const float most = std::ranges::max_element(lids, {}, &glm::vec3::z)->z;
        glm::vec3 sum(0.0F);
        float count = 0.0F;
        for (const glm::vec3& p : lids)
            if (p.z > most - 0.05F) {
                sum += p;
                count += 1.0F;
            }
        return sum / count;
    }

    /// The corner of the mouth on the left: where the seam between the lips, a hollow, ends.
    glm::vec3 mouthCorner() const
    {
        std::vector<double> hollow(m_points.size(), 0.0);
        for (const auto& t : m_mesh.triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                const glm::vec3 along = m_points[t[(i + 1) % 3]] - m_points[t[i]];
                const float rise = glm::dot(along, m_mesh.normals[t[i]]) / glm::dot(along, along);
                hollow[t[i]] += static_cast<double>(rise);
            }
        const auto onSeam = [this](std::size_t v) {
            const glm::vec3& p = m_points[v];
            return p.x >= 0.0F && p.x < 3.4F && std::abs(p.y + 6.9F) < 0.45F && p.z > 5.0F;
        };
        double most = 0.0;
        for (std::size_t v = 0; v < m_points.size(); ++v)
            if (onSeam(v))
                most = std::max(most, hollow[v]);
        glm::vec3 corner(0.0F);
        for (std::size_t v = 0; v < m_points.size(); ++v)
            if (onSeam(v) && hollow[v] > kSeamsEnd * most && m_points[v].x > corner.x)
                corner = m_points[v];
        return corner;
    }

    double lengthOfSection(float height) const
    {
        // By azimuth around the neck's middle.
        std::vector<std::pair<float, glm::vec3>> ring;
        for (const glm::vec3& p : m_points)
            if (std::abs(p.y - height) < 0.25F)
                ring.emplace_back(std::atan2(p.x, p.z + 3.5F), glm::vec3(p.x, 0.0F, p.z));
        std::ranges::sort(ring, {}, &std::pair<float, glm::vec3>::first);
        constexpr int kSectors = 48;
        std::vector<glm::vec3> outline;
        for (int sector = 0; sector < kSectors; ++sector) {
            glm::vec3 sum(0.0F);
            float count = 0.0F;
            for (const auto& [azimuth, p] : ring)
                if (static_cast<int>((azimuth / 6.2831853F + 0.5F) * kSectors) == sector) {
                    sum += p;
                    count += 1.0F;
                }
            if (count > 0.0F)
                outline.push_back(sum / count);
        }
        double length = 0.0;
        for (std::size_t i = 0; i < outline.size(); ++i)
            length += static_cast<double>(glm::distance(outline[i], outline[(i + 1) % outline.size()]));
        return length;
    }

    /// How far out the side of the head lies.
    float sideAt(float y, float z) const
    {
        float most = 0.0F;
        for (const glm::vec3& p : m_points)
            if (std::abs(p.y - y) < 0.25F && std::abs(p.z - z) < 0.3F)
                most = std::max(most, p.x);
        return most;
    }

    static constexpr float kInFrontOfEar = 1.4F;
    static constexpr float kBehindEar = -4.4F;

    /// The left ear: what stands off the straight line from the skin before it to the skin behind it.
    std::vector<glm::vec3> ear(float standsOff) const
    {
        return pointsWhere([this, standsOff](const glm::vec3& p) {
            if (p.x < 5.0F || p.y < -6.0F || p.y > 2.8F || p.z < kBehindEar || p.z > kInFrontOfEar)
                return false;
            const float part = (kInFrontOfEar - p.z) / (kInFrontOfEar - kBehindEar);
            return p.x > std::lerp(sideAt(p.y, kInFrontOfEar), sideAt(p.y, kBehindEar), part) + standsOff;
        });
    }

    struct EarMeasures
    {
        glm::vec3 length; // from the lowest point to the highest
        glm::vec3 depth;  // from the front to the rear edge, at half its height
    };

    EarMeasures earMeasures() const
    {
        const std::vector<glm::vec3> points = ear(0.5F);
        const auto [low, high] = std::ranges::minmax(points, {}, &glm::vec3::y);
        std::vector<glm::vec3> middle;
        std::ranges::copy_if(
            ear(0.3F), std::back_inserter(middle),
            [half = 0.5F * (low.y + high.y)](const glm::vec3& p) { return std::abs(p.y - half) < 1.0F; });
        const auto [rear, front] = std::ranges::minmax(middle, {}, &glm::vec3::z);
        return {.length = high - low, .depth = rear - front};
    }

    double measured(const QString& name) const
    {
        const auto always = [](const glm::vec3&) { return true; };
        const auto aboveEars = [](const glm::vec3& p) { return p.y > 2.8F; };
        const auto cheek = [](const glm::vec3& p) { return p.y > -2.5F && p.y < 0.0F && p.z > 1.5F && p.z < 3.5F; };
        const auto jawAngle = [](const glm::vec3& p) {
            return p.y > -7.5F && p.y < -6.5F && p.z > -0.5F && p.z < 1.5F;
        };
        const auto nose = [](const glm::vec3& p) { return p.y > -4.4F && p.y < -3.4F && p.z > 8.95F; };
        const auto chin = [](const glm::vec3& p) { return p.z > 5.0F && p.y > -13.0F; };
        const auto brow = [](const glm::vec3& p) { return p.x == 0.0F && p.y > 1.0F && p.y < 4.0F; };
        if (name == "head length"_L1)
            return farthest({0.0F, 0.0F, 1.0F}, brow) + farthest({0.0F, 0.0F, -1.0F}, aboveEars);
        if (name == "head breadth"_L1)
            return 2.0 * farthest({1.0F, 0.0F, 0.0F}, aboveEars);
        if (name == "vertex to chin"_L1)
            return farthest({0.0F, 1.0F, 0.0F}, always) + farthest({0.0F, -1.0F, 0.0F}, chin);
        if (name == "face breadth"_L1)
            return 2.0 * farthest({1.0F, 0.0F, 0.0F}, cheek);
        if (name == "jaw breadth"_L1)
            return 2.0 * farthest({1.0F, 0.0F, 0.0F}, jawAngle);
        if (name == "nose length"_L1) // The forehead runs into the nose without a dent: from the pupils' height.
            return static_cast<double>(pupil().y - subnasale().y);
        if (name == "nose protrusion"_L1)
            return static_cast<double>(glm::distance(noseTip(), subnasale()));
        if (name == "nose breadth"_L1)
            return 2.0 * farthest({1.0F, 0.0F, 0.0F}, nose);
        if (name == "mouth breadth"_L1)
            return 2.0 * static_cast<double>(mouthCorner().x);
        if (name == "pupil distance"_L1)
            return 2.0 * static_cast<double>(pupil().x);
        if (name == "neck circumference"_L1)
            return lengthOfSection(-12.5F);
        if (name == "ear length"_L1)
            return static_cast<double>(glm::length(earMeasures().length));
        return static_cast<double>(glm::length(earMeasures().depth)); // ear breadth
    }

private Q_SLOTS:
    void initTestCase()
    {
        QFile file(test::sourcePath(u"resources/heads/bust-2.glb"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        m_mesh = tests::readGlb(file.readAll());
        QCOMPARE(m_mesh.error, QString());
        for (const glm::vec3& p : m_mesh.positions)
            m_points.push_back(100.0F * p);
        m_middle =
            pointsWhere([](const glm::vec3& p) { return p.x == 0.0F && p.z > 0.0F && p.y > -11.0F && p.y < 6.0F; });
        std::ranges::sort(m_middle, std::ranges::greater{}, &glm::vec3::y);
    }

    void measuresAreThoseOfAnAdult_data()
    {
        QTest::addColumn<double>("cm");
        QTest::newRow("head length") << 19.5;
        QTest::newRow("head breadth") << 15.2;
        QTest::newRow("vertex to chin") << 22.5;
        QTest::newRow("face breadth") << 13.8;
        QTest::newRow("jaw breadth") << 11.5;
        QTest::newRow("nose length") << 5.1;
        QTest::newRow("nose protrusion") << 2.1;
        QTest::newRow("nose breadth") << 3.5;
        QTest::newRow("mouth breadth") << 5.1;
        QTest::newRow("ear length") << 6.3;
        QTest::newRow("ear breadth") << 3.6;
        QTest::newRow("pupil distance") << 6.3;
        QTest::newRow("neck circumference") << 36.0;
    }
    void measuresAreThoseOfAnAdult()
    {
        QFETCH(double, cm);
        const double found = measured(QString::fromLatin1(QTest::currentDataTag()));
        qInfo("%.2f cm, %.2f wanted", found, cm);
        QVERIFY(std::abs(found / cm - 1.0) <= kTolerance);
    }

    void theEarStandsOffAndLeansBack()
    {
        const EarMeasures ear = earMeasures();
        constexpr float kMiddle = -1.5F;
        const float inward = sideAt(kMiddle, kInFrontOfEar) - sideAt(kMiddle, kBehindEar);
        const float side = std::atan2(-inward, kInFrontOfEar - kBehindEar);
        const double off = glm::degrees(static_cast<double>(std::atan2(ear.depth.x, -ear.depth.z) - side));
        const double tilt = glm::degrees(static_cast<double>(std::atan2(-ear.length.z, ear.length.y)));
        qInfo("turned out %.1f degrees, tilted back %.1f", off, tilt);
        QVERIFY(off >= 20.0 && off <= 25.0);
        QVERIFY(tilt >= 10.0 && tilt <= 15.0);
    }
};

HAIRPAINT_TEST(TestBustProportions, None)
#include "test_bust_proportions.moc"
