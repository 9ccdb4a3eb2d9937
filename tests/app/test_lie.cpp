// How hair lies on the bust, measured on exported curves: no spikes, close to the skin, and it stays where it is
// combed.
#include "model/files/head_file.h"
#include "model/files/project_file.h"
#include "sim/groom/direction_texel.h"
#include "sim/skin/skin_frame.h"
#include "tests/app/exported_hair.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <map>

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

constexpr int kHairs = 4000;
constexpr int kMapSize = 512;

/// A texel for every point of the built-in head's skin that a map of kMapSize shows.
template<typename ValueAt>
void paint(sim::TiledRaster& raster, const ValueAt& valueAt)
{
    const sim::Skin& skin = *model::defaultHead()->skin;
    for (int y = 0; y < kMapSize; ++y)
        for (int x = 0; x < kMapSize; ++x) {
            const glm::vec2 uv((static_cast<float>(x) + 0.5F) / kMapSize,
                               1.0F - (static_cast<float>(y) + 0.5F) / kMapSize);
            if (const auto point = skin.atUv(uv))
                raster.setTexel(x, y, valueAt(*point));
        }
}

} // namespace

class TestLie : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    std::map<float, Strands> m_natural; ///< By the length; what several tests look at is settled once.

    [[nodiscard]] Strands exported(const app::SettledHair& hair, std::optional<std::size_t> hairs = std::nullopt) const
    {
        return exportedHair(hair, m_folder.filePath(QStringLiteral("lie.hair")), hairs);
    }

    /// The scalp of "Buzz cut", straight hair of one length and gel, combed back or not at all.
    [[nodiscard]] static std::optional<model::Project> projectOf(float lengthM, float gel, bool combedBack)
    {
        std::optional<model::Project> project = styledProject(QStringLiteral("Buzz cut"));
        if (!project)
            return std::nullopt;
        model::HairGroup& group = project->groups.front();
        group.settings.greatestLengthM = lengthM;
        group.settings.nodesPerHair = 10;
        const auto scalar = [&](model::MapKind kind, float value) {
            model::MapStack& stack = group.map(kind);
            const auto texel = static_cast<std::uint16_t>(65535.0F * value);
            stack.layers.front().raster = sim::TiledRaster(stack.size, 2, {texel, 65535});
        };
        scalar(model::MapKind::Length, 1.0F);
        scalar(model::MapKind::Gel, gel);
        if (combedBack) {
            model::MapStack& stack = group.map(model::MapKind::Direction);
            stack.size = kMapSize;
            stack.layers.front().raster = sim::TiledRaster(kMapSize, 3, {32768, 32768, 0});
            paint(stack.layers.front().raster, [](const sim::SurfacePoint& point) {
                const sim::SkinFrame frame = sim::SkinFrame::at(point);
                const glm::vec2 back = frame.fromHd({0.0F, -0.2F, -1.0F});
                sim::Texel texel = sim::texelOfDirection(back * (0.95F / std::max(glm::length(back), 1e-6F)));
                texel[2] = 65535;
                return texel;
            });
        }
        return project;
    }

    /// Hair that nobody combed, after two seconds.
    [[nodiscard]] const Strands& natural(float lengthM)
    {
        Strands& hairs = m_natural[lengthM];
        if (const auto project = hairs.empty() ? projectOf(lengthM, 0.0F, false) : std::nullopt)
            hairs = exported(app::SettledHair(*project, 2.0), kHairs);
        return hairs;
    }

private Q_SLOTS:
    void naturalHairHasNoSpikes();
    void shortHairLiesCloseToTheSkin_data();
    void shortHairLiesCloseToTheSkin();
    void combedAndGelledHairStays_data();
    void combedAndGelledHairStays();
    void hairBesideAPartingNeitherStandsNorCrossesIt();
    void longHairAboveTheEarsHangsAsItsNeighboursDo();
    void hairAtTheEdgeOfAPartingLiesToItsOwnSide();
};

void TestLie::naturalHairHasNoSpikes()
{
    const Strands& hairs = natural(0.03F);
    QCOMPARE(hairs.size(), std::size_t{kHairs});
    const glm::vec3 whorl(-0.006F, 0.105F, -0.05F);
    int pairs = 0;
    int apart = 0;
    for (std::size_t i = 0; i < hairs.size(); ++i)
        for (std::size_t j = i + 1; j < hairs.size(); ++j) {
            if (glm::distance(hairs[i][0], hairs[j][0]) > 0.005F || glm::distance(hairs[i][0], whorl) < 0.025F)
                continue;
            const glm::vec3 a = glm::normalize(hairs[i][1] - hairs[i][0]);
            const glm::vec3 b = glm::normalize(hairs[j][1] - hairs[j][0]);
            ++pairs;
            apart += glm::dot(a, b) < std::cos(glm::radians(25.0F)) ? 1 : 0;
        }
    QVERIFY(pairs > 4000);
    QVERIFY2(apart < 0.05 * pairs, qPrintable(QStringLiteral("%1 of %2").arg(apart).arg(pairs)));
}

void TestLie::shortHairLiesCloseToTheSkin_data()
{
    QTest::addColumn<float>("lengthM");
    for (const float lengthM : {0.01F, 0.03F, 0.05F})
        QTest::addRow("%.0f cm", 100.0 * static_cast<double>(lengthM)) << lengthM;
}

void TestLie::shortHairLiesCloseToTheSkin()
{
    QFETCH(float, lengthM);
    const Strands& hairs = natural(lengthM);
    QCOMPARE(hairs.size(), std::size_t{kHairs});
    const sim::DistanceGrid& grid = *model::defaultHead()->distances;
    int points = 0;
    int close = 0;
    for (const auto& hair : hairs)
        for (const glm::vec3& point : hair) {
            const auto sample = grid.at(point);
            ++points;
            close += sample && sample->distanceM < 0.015F ? 1 : 0;
        }
    QVERIFY2(close > 0.9 * points, qPrintable(QStringLiteral("%1 of %2").arg(close).arg(points)));
}

void TestLie::combedAndGelledHairStays_data()
{
    QTest::addColumn<double>("settleSeconds");
    QTest::addColumn<bool>("nods");
    QTest::newRow("ten seconds of still air") << 10.0 << false;
    QTest::newRow("a nod") << 1.0 << true;
}

void TestLie::combedAndGelledHairStays()
{
    QFETCH(double, settleSeconds);
    QFETCH(bool, nods);
    const std::optional<model::Project> project = projectOf(0.09F, 0.3F, true);
    QVERIFY(project);
    app::SettledHair hair(*project, 0.0);
    const Strands combed = exported(hair, kHairs);
    hair.advance(settleSeconds);
    if (nods) { // As the program moves the head before it exports.
        hair.setMotion(sim::NeckMotion::Nod);
        hair.advance(sim::secondsOf(sim::NeckMotion::Nod));
        hair.setMotion(std::nullopt);
        hair.advance(1.0);
    }
    const Strands settled = exported(hair, kHairs);
    QCOMPARE(combed.size(), std::size_t{kHairs});
    QCOMPARE(settled.size(), combed.size());
    std::vector<float> shifts;
    for (std::size_t i = 0; i < combed.size(); ++i)
        shifts.push_back(glm::distance(combed[i].back(), settled[i].back()));
    std::ranges::sort(shifts);
    const float most = shifts[shifts.size() * 99 / 100];
    QVERIFY2(most < 0.03F, qPrintable(QString::number(most)));
    QVERIFY(shifts.back() < 0.045F);
}

void TestLie::hairBesideAPartingNeitherStandsNorCrossesIt()
{
    const std::optional<model::Project> bob = styledProject(QStringLiteral("Bob"));
    QVERIFY(bob);
    app::SettledHair hair(*bob, 0.0);
    const Strands rest = exported(hair);
    hair.advance(3.0);
    const Strands hairs = exported(hair);
    QCOMPARE(hairs.size(), rest.size());
    constexpr std::size_t kNode = 4;
    int beside = 0;
    int standing = 0;
    int crossing = 0;
    for (std::size_t i = 0; i < hairs.size(); ++i) {
        const glm::vec3 root = hairs[i].front();
        if (std::abs(root.x) > 0.008F || root.y < 0.06F)
            continue;
        ++beside;
        const float wanted = rest[i][kNode].x - root.x;
        crossing += std::abs(wanted) > 0.02F && (hairs[i][kNode].x - root.x) * wanted < 0.0F ? 1 : 0;
        standing += std::ranges::any_of(hairs[i], [&](glm::vec3 p) { return p.y > root.y + 0.02F; }) ? 1 : 0;
    }
    const QString found = QStringLiteral("%1 stand and %2 cross of %3").arg(standing).arg(crossing).arg(beside);
    QVERIFY2(beside > 3000 && standing == 0 && crossing < 0.02 * beside, qPrintable(found));
}

void TestLie::longHairAboveTheEarsHangsAsItsNeighboursDo()
{
    const std::optional<model::Project> project = styledProject(QStringLiteral("Long straight"));
    QVERIFY(project);
    const Strands hairs = exported(app::SettledHair(*project, 3.0));
    QVERIFY(hairs.size() > 60000);
    // What is laid over an ear points away from the head, and sinks.
    const auto aside = std::ranges::count_if(hairs, [](const std::vector<glm::vec3>& hair) {
        return std::ranges::any_of(
            hair, [](const glm::vec3& p) { return p.y > -0.14F && p.x * p.x + p.z * p.z > 0.165F * 0.165F; });
    });
    QVERIFY2(aside < 6, qPrintable(QString::number(aside)));
}

void TestLie::hairAtTheEdgeOfAPartingLiesToItsOwnSide()
{
    const std::optional<model::Project> project = styledProject(QStringLiteral("Split dye"));
    QVERIFY(project);
    constexpr std::size_t kNode = 4;
    int beside = 0;
    int crossing = 0;
    for (const std::vector<glm::vec3>& hair : exported(app::SettledHair(*project, 0.0))) {
        const glm::vec3 root = hair.front();
        if (std::abs(root.x) > 0.015F || root.y < 0.06F)
            continue;
        ++beside;
        crossing += hair[kNode].x * (root.x > 0.0F ? 1.0F : -1.0F) < -0.01F ? 1 : 0;
    }
    // Single hairs fly away or keep to a lock of the other side.
    QVERIFY2(beside > 4000 && crossing < 0.001 * beside,
             qPrintable(QStringLiteral("%1 of %2").arg(crossing).arg(beside)));
}

HAIRPAINT_TEST(TestLie, Core)
#include "test_lie.moc"
