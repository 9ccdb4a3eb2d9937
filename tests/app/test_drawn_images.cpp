// Maps drawn with ImageMagick (tests/data/images): hairs, lengths and turns in the .hair export follow their colours.
// Pictures of them: test_drawn_pictures.cpp.
#include "model/files/head_file.h"
#include "model/files/project_file.h"
#include "tests/app/project_folder.h"
#include "tests/support/test_program.h"

#include <QImage>
#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

enum class Scale
{
    Green,
    Blue,
    Red
};

/// An image read as a scale, by the words of the paper: white, grey and black are 0, the pure colour is 1.
class DrawnScale
{
public:
    DrawnScale(const QString& path, Scale scale) : m_image(path), m_scale(scale) {}

    [[nodiscard]] bool good() const { return !m_image.isNull() && m_image.width() == m_image.height(); }
    [[nodiscard]] int size() const { return m_image.width(); }

    [[nodiscard]] double texel(int x, int y) const
    {
        x = std::clamp(x, 0, size() - 1);
        y = std::clamp(y, 0, size() - 1);
        const QRgba64 c = m_image.pixelColor(x, y).rgba64();
        const std::array<double, 3> rgb = {c.red() / 65535.0, c.green() / 65535.0, c.blue() / 65535.0};
        switch (m_scale) {
        case Scale::Green:
            return std::max(0.0, rgb[1] - std::max(rgb[0], rgb[2]));
        case Scale::Blue:
            return std::max(0.0, rgb[2] - std::max(rgb[0], rgb[1]));
        case Scale::Red:
            break;
        }
        return std::max(0.0, rgb[0] - std::max(rgb[1], rgb[2]));
    }

    /// Between the four nearest texel centres; row 0 is v = 1.
    [[nodiscard]] double at(glm::vec2 uv) const
    {
        const glm::dvec2 position = texelOf(uv) - 0.5;
        const int x = static_cast<int>(std::floor(position.x));
        const int y = static_cast<int>(std::floor(position.y));
        const double fx = position.x - x;
        const double fy = position.y - y;
        return std::lerp(std::lerp(texel(x, y), texel(x + 1, y), fx),
                         std::lerp(texel(x, y + 1), texel(x + 1, y + 1), fx), fy);
    }

    /// Least and greatest of the texel under a point and its eight neighbours.
    [[nodiscard]] std::pair<double, double> range(glm::vec2 uv) const
    {
        const glm::dvec2 position = texelOf(uv);
        std::pair<double, double> range{1.0, 0.0};
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const double value = texel(static_cast<int>(position.x) + dx, static_cast<int>(position.y) + dy);
                range = {std::min(range.first, value), std::max(range.second, value)};
            }
        return range;
    }

private:
    [[nodiscard]] glm::dvec2 texelOf(glm::vec2 uv) const { return glm::dvec2(uv.x, 1.0F - uv.y) * double(size()); }

    QImage m_image;
    Scale m_scale;
};

/// The chin and the neck push a few skeletons aside; turns are counted about those that stand straight.
bool isStraight(const std::vector<glm::vec3>& strand)
{
    const glm::dvec3 root(strand.front());
    const glm::dvec3 axis = glm::normalize(glm::dvec3(strand.back()) - root);
    return std::ranges::all_of(strand, [&](const glm::vec3& point) {
        const glm::dvec3 displacement = glm::dvec3(point) - root;
        return glm::length(displacement - axis * glm::dot(displacement, axis)) < 1e-6;
    });
}

/// How far a strand comes along its skeleton, which stands straight.
double reachOf(const std::vector<glm::vec3>& strand, const std::vector<glm::vec3>& uncurled)
{
    const glm::dvec3 root(uncurled.front());
    return glm::dot(glm::dvec3(strand.back()) - root, glm::normalize(glm::dvec3(uncurled.back()) - root));
}

/// Turns about the skeleton, which stands straight on the skin: it is settled for no time. The angle runs evenly from
/// the root, where the radius is 0 and the angle can't be seen.
double turnsOf(const std::vector<glm::vec3>& strand, const std::vector<glm::vec3>& uncurled)
{
    const glm::dvec3 axis = glm::normalize(glm::dvec3(uncurled.back()) - glm::dvec3(uncurled.front()));
    const glm::dvec3 root(strand.front());
    double angle = 0.0;
    glm::dvec3 last(0.0);
    for (std::size_t i = 1; i < strand.size(); ++i) {
        const glm::dvec3 displacement = glm::dvec3(strand[i]) - root;
        const glm::dvec3 offset = displacement - axis * glm::dot(displacement, axis);
        if (glm::length(offset) < 1e-6)
            return 0.0;
        if (i > 1)
            angle += std::atan2(glm::dot(glm::cross(last, offset), axis), glm::dot(last, offset));
        last = offset;
    }
    const auto segments = static_cast<double>(strand.size() - 1);
    return std::abs(angle) / (2.0 * std::numbers::pi) * segments / (segments - 1.0);
}

} // namespace

class TestDrawnImages : public QObject
{
    Q_OBJECT
private:
    ProjectFolder m_folder;

    /// The rest shape of a project's hair; checked against `info`.
    [[nodiscard]] std::vector<std::vector<glm::vec3>> hairOf(const QString& project) const
    {
        const QString file = m_folder.path("export.hair");
        const Outcome outcome = runProgram({QStringLiteral("export"), project, QStringLiteral("-o"), file});
        auto strands = readHair(file);
        const QJsonObject info = infoOf(project);
        const bool agree = info.value(QLatin1String("exported")).toInteger(-1) == static_cast<qint64>(strands.size());
        return outcome.code == 0 && agree ? strands : std::vector<std::vector<glm::vec3>>();
    }

    [[nodiscard]] static std::vector<sim::SurfacePoint> rootsOf(const std::vector<std::vector<glm::vec3>>& strands)
    {
        std::vector<sim::SurfacePoint> roots;
        roots.reserve(strands.size());
        for (const auto& strand : strands)
            roots.push_back(model::defaultHead()->skin->nearest(strand.front()));
        return roots;
    }

    using Strands = std::vector<std::vector<glm::vec3>>;
    QString m_styled;   ///< The project of all three images, made by one command.
    Strands m_strands;  ///< Its hair.
    Strands m_straight; ///< The same hair without the curl: where each one's skeleton runs.
    std::vector<sim::SurfacePoint> m_roots;

private Q_SLOTS:
    void initTestCase()
    {
        const QString density = QStringLiteral("density=") + drawn("density");
        const QString length = QStringLiteral("length=") + drawn("length");
        m_styled = m_folder.project("styled.hairpaint", {density, length, QStringLiteral("curl=") + drawn("curl")});
        m_strands = hairOf(m_styled);
        m_straight = hairOf(m_folder.project("straight.hairpaint", {density, length}));
        m_roots = rootsOf(m_strands);
        QVERIFY(m_strands.size() > 5'000);
        QCOMPARE(m_straight.size(), m_strands.size());
        for (std::size_t i = 0; i < m_strands.size(); ++i)
            QCOMPARE(m_strands[i].front(), m_straight[i].front());
        const auto bent = std::ranges::count_if(m_straight, [](const auto& strand) { return !isStraight(strand); });
        QVERIFY2(bent < static_cast<std::ptrdiff_t>(m_strands.size() / 10), qPrintable(QString::number(bent)));
    }

    void hairsFollowTheGreenAndNoneGrowInWhiteBlackOrGrey()
    {
        const DrawnScale image(drawn("density"), Scale::Green);
        QVERIFY(image.good());
        const auto all = hairOf(
            m_folder.project("full.hairpaint", {QStringLiteral("density=") + m_folder.filled("full.png", Qt::green)}));
        QVERIFY(all.size() > 20'000);

        double expected = 0.0;
        std::map<int, std::pair<int, int>> byLevel; // all and some inside one shade, by its value of 255
        for (const sim::SurfacePoint& root : rootsOf(all)) {
            expected += image.at(root.uv);
            if (const auto [least, greatest] = image.range(root.uv); least == greatest)
                ++byLevel[static_cast<int>(std::lround(least * 255.0))].first;
        }
        int inside = 0;
        for (const sim::SurfacePoint& root : m_roots) {
            const auto [least, greatest] = image.range(root.uv);
            inside += greatest <= 0.0 ? 1 : 0;
            if (least == greatest)
                ++byLevel[static_cast<int>(std::lround(least * 255.0))].second;
        }
        QCOMPARE(inside, 0);
        const double fraction = static_cast<double>(m_strands.size()) / expected;
        QVERIFY2(std::abs(fraction - 1.0) <= 0.02, qPrintable(QString::number(fraction)));
        QCOMPARE(byLevel.size(), std::size_t{5});
        for (const auto& [level, counts] : byLevel) {
            const double found = counts.second / static_cast<double>(counts.first) * 255.0;
            QVERIFY2(std::abs(found - level) <= 0.02 * level,
                     qPrintable(QStringLiteral("green %1: as if %2, of %3").arg(level).arg(found).arg(counts.first)));
        }
    }

    /// A curled hair is as long as the skeleton that it winds about. Equation 1's third part, cos t sin t, moves its
    /// end along that by half a radius at most, one hair up and the other down.
    void lengthsFollowTheBlue()
    {
        const DrawnScale blueImage(drawn("length"), Scale::Blue);
        const DrawnScale redImage(drawn("curl"), Scale::Red);
        QVERIFY(blueImage.good() && redImage.good());
        const model::Result<model::Project> loaded = model::loadProject(m_styled);
        QVERIFY(loaded);
        const auto greatest = static_cast<double>(loaded->groups.front().settings.greatestLengthM);
        const double radius = static_cast<double>(loaded->groups.front().settings.greatestCurlRadiusM) / 2.0;
        std::pair<double, double> blues(1.0, 0.0);
        std::array<int, 2> seen{}; // uncurled and curled
        double curledWanted = 0.0;
        double curledFound = 0.0;
        for (std::size_t i = 0; i < m_strands.size(); ++i) {
            const bool curled = redImage.range(m_roots[i].uv).second > 0.0;
            if (curled && !isStraight(m_straight[i]))
                continue;
            const double blue = blueImage.at(m_roots[i].uv);
            blues = {std::min(blues.first, blue), std::max(blues.second, blue)};
            const double wanted = blue * greatest;
            const double found = curled ? reachOf(m_strands[i], m_straight[i]) : lengthOf(m_strands[i]);
            QVERIFY2(std::abs(found - wanted) <= 0.01 * wanted + (curled ? radius / 2.0 : 0.0),
                     qPrintable(QStringLiteral("%1 m at blue %2, curled: %3").arg(found).arg(blue).arg(curled)));
            ++seen[curled ? 1 : 0];
            curledWanted += curled ? wanted : 0.0;
            curledFound += curled ? found : 0.0;
        }
        QVERIFY(blues.first < 0.1 && blues.second > 0.9);
        QVERIFY2(seen[0] > 1000 && seen[1] > 1000, qPrintable(QStringLiteral("%1, %2").arg(seen[0]).arg(seen[1])));
        QVERIFY2(std::abs(curledFound / curledWanted - 1.0) <= 0.01,
                 qPrintable(QString::number(curledFound / curledWanted)));
    }

    void turnsFollowTheRed()
    {
        const DrawnScale image(drawn("curl"), Scale::Red);
        QVERIFY(image.good());
        constexpr std::array<double, 6> kTurns = {0.0, 0.5, 1.0, 4.0, 8.0, 16.0}; // table 1
        std::array<int, 6> seen{};
        for (std::size_t i = 0; i < m_strands.size(); ++i) {
            const auto [least, greatest] = image.range(m_roots[i].uv);
            if (least != greatest || !isStraight(m_straight[i]))
                continue;
            const auto level = static_cast<std::size_t>(std::lround(least * 5.0));
            QVERIFY(std::abs(least * 5.0 - static_cast<double>(level)) < 0.01);
            const double turns = turnsOf(m_strands[i], m_straight[i]);
            QVERIFY2(std::abs(turns - kTurns[level]) <= 0.01 * kTurns[level],
                     qPrintable(QStringLiteral("%1 turns at red %2").arg(turns).arg(least)));
            ++seen[level];
        }
        for (const int count : seen)
            QVERIFY2(count > 100, qPrintable(QString::number(count)));
    }
};

HAIRPAINT_TEST(TestDrawnImages, Core)
#include "test_drawn_images.moc"
