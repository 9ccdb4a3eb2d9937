// Maps drawn with ImageMagick (tests/data/images): hairs, lengths and turns in the .hair export follow their colours.
#include "model/files/head_file.h"
#include "model/files/project_file.h"
#include "tests/app/program.h"

#include <QImage>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

QString drawn(const char* name)
{
    return QStringLiteral(HAIRPAINT_TEST_DATA "/images/%1.png").arg(QLatin1String(name));
}

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
        const glm::dvec2 place = placeOf(uv) - 0.5;
        const int x = static_cast<int>(std::floor(place.x));
        const int y = static_cast<int>(std::floor(place.y));
        const double fx = place.x - x;
        const double fy = place.y - y;
        return std::lerp(std::lerp(texel(x, y), texel(x + 1, y), fx),
                         std::lerp(texel(x, y + 1), texel(x + 1, y + 1), fx), fy);
    }

    /// Least and greatest of the texel under a place and its eight neighbours.
    [[nodiscard]] std::pair<double, double> range(glm::vec2 uv) const
    {
        const glm::dvec2 place = placeOf(uv);
        std::pair<double, double> range{1.0, 0.0};
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const double value = texel(static_cast<int>(place.x) + dx, static_cast<int>(place.y) + dy);
                range = {std::min(range.first, value), std::max(range.second, value)};
            }
        return range;
    }

private:
    [[nodiscard]] glm::dvec2 placeOf(glm::vec2 uv) const { return glm::dvec2(uv.x, 1.0F - uv.y) * double(size()); }

    QImage m_image;
    Scale m_scale;
};

/// The chin and the neck push a few skeletons aside; turns are counted about those that stand straight.
bool isStraight(const std::vector<glm::vec3>& strand)
{
    const glm::dvec3 root(strand.front());
    const glm::dvec3 axis = glm::normalize(glm::dvec3(strand.back()) - root);
    return std::ranges::all_of(strand, [&](const glm::vec3& point) {
        const glm::dvec3 way = glm::dvec3(point) - root;
        return glm::length(way - axis * glm::dot(way, axis)) < 1e-6;
    });
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
        const glm::dvec3 way = glm::dvec3(strand[i]) - root;
        const glm::dvec3 offset = way - axis * glm::dot(way, axis);
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
    QTemporaryDir m_folder;

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }

    [[nodiscard]] QString filled(const char* name, const QColor& colour) const
    {
        QImage image(256, 256, QImage::Format_RGB32);
        image.fill(colour);
        const QString file = path(name);
        return image.save(file) ? file : QString();
    }

    /// A project of these maps; empty where it can't be made.
    [[nodiscard]] QString project(const char* name, const QStringList& maps) const
    {
        const QString file = path(name);
        QStringList arguments{QStringLiteral("new"), QStringLiteral("-o"), file};
        for (const QString& map : maps)
            arguments << QStringLiteral("--map") << map;
        const Outcome made = runProgram(arguments);
        return made.code == 0 && made.error.isEmpty() ? file : QString();
    }

    /// The rest shape of a project's hair; checked against `info`.
    [[nodiscard]] std::vector<std::vector<glm::vec3>> hairOf(const QString& project) const
    {
        const QString file = path("export.hair");
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
            roots.push_back(model::builtInHead()->skin->nearest(strand.front()));
        return roots;
    }

private Q_SLOTS:
    void hairsFollowTheGreenAndNoneGrowInWhiteBlackOrGrey()
    {
        const DrawnScale image(drawn("density"), Scale::Green);
        QVERIFY(image.good());
        const auto all =
            hairOf(project("full.hairpaint", {QStringLiteral("density=") + filled("full.png", Qt::green)}));
        const auto some = hairOf(project("some.hairpaint", {QStringLiteral("density=") + drawn("density")}));
        QVERIFY(all.size() > 20'000 && some.size() > 5'000);

        double expected = 0.0;
        std::map<int, std::pair<int, int>> byLevel; // all and some inside one shade, by its value of 255
        for (const sim::SurfacePoint& root : rootsOf(all)) {
            expected += image.at(root.uv);
            if (const auto [least, greatest] = image.range(root.uv); least == greatest)
                ++byLevel[static_cast<int>(std::lround(least * 255.0))].first;
        }
        int inside = 0;
        for (const sim::SurfacePoint& root : rootsOf(some)) {
            const auto [least, greatest] = image.range(root.uv);
            inside += greatest <= 0.0 ? 1 : 0;
            if (least == greatest)
                ++byLevel[static_cast<int>(std::lround(least * 255.0))].second;
        }
        QCOMPARE(inside, 0);
        const double share = static_cast<double>(some.size()) / expected;
        QVERIFY2(std::abs(share - 1.0) <= 0.02, qPrintable(QString::number(share)));
        QCOMPARE(byLevel.size(), std::size_t{5});
        for (const auto& [level, counts] : byLevel) {
            const double found = counts.second / static_cast<double>(counts.first) * 255.0;
            QVERIFY2(std::abs(found - level) <= 0.02 * level,
                     qPrintable(QStringLiteral("green %1: as if %2, of %3").arg(level).arg(found).arg(counts.first)));
        }
    }

    void lengthsFollowTheBlue()
    {
        const DrawnScale image(drawn("length"), Scale::Blue);
        QVERIFY(image.good());
        const QString file =
            project("length.hairpaint", {QStringLiteral("density=") + filled("thin.png", QColor(205, 255, 205)),
                                         QStringLiteral("length=") + drawn("length")});
        const auto strands = hairOf(file);
        const auto roots = rootsOf(strands);
        QVERIFY(strands.size() > 5'000);
        const model::Result<model::Project> loaded = model::loadProject(file);
        QVERIFY(loaded);
        const auto greatest = static_cast<double>(loaded->groups.front().settings.greatestLengthM);
        double shortest = 1.0;
        double longest = 0.0;
        for (std::size_t i = 0; i < strands.size(); ++i) {
            const double blue = image.at(roots[i].uv);
            shortest = std::min(shortest, blue);
            longest = std::max(longest, blue);
            const double wanted = blue * greatest;
            const double found = lengthOf(strands[i]);
            QVERIFY2(std::abs(found - wanted) <= 0.01 * wanted,
                     qPrintable(QStringLiteral("%1 m at blue %2").arg(found).arg(blue)));
        }
        QVERIFY(shortest < 0.3 && longest > 0.7);
    }

    void turnsFollowTheRed()
    {
        const DrawnScale image(drawn("curl"), Scale::Red);
        QVERIFY(image.good());
        const QString density = QStringLiteral("density=") + filled("thin.png", QColor(205, 255, 205));
        const auto straight = hairOf(project("straight.hairpaint", {density}));
        const auto strands = hairOf(project("curl.hairpaint", {density, QStringLiteral("curl=") + drawn("curl")}));
        const auto roots = rootsOf(strands);
        QCOMPARE(strands.size(), straight.size());
        constexpr std::array<double, 6> kTurns = {0.0, 0.5, 1.0, 4.0, 8.0, 16.0}; // table 1
        std::array<int, 6> seen{};
        std::size_t bent = 0;
        for (std::size_t i = 0; i < strands.size(); ++i) {
            bent += isStraight(straight[i]) ? 0 : 1;
            const auto [least, greatest] = image.range(roots[i].uv);
            if (least != greatest || !isStraight(straight[i]))
                continue;
            const auto level = static_cast<std::size_t>(std::lround(least * 5.0));
            QVERIFY(std::abs(least * 5.0 - static_cast<double>(level)) < 0.01);
            const double turns = turnsOf(strands[i], straight[i]);
            QCOMPARE(strands[i].front(), straight[i].front());
            QVERIFY2(std::abs(turns - kTurns[level]) <= 0.01 * kTurns[level],
                     qPrintable(QStringLiteral("%1 turns at red %2").arg(turns).arg(least)));
            ++seen[level];
        }
        QVERIFY2(bent < strands.size() / 10, qPrintable(QString::number(bent)));
        for (const int count : seen)
            QVERIFY2(count > 100, qPrintable(QString::number(count)));
    }

    /// The map's left half is the head's own right, which the view from behind shows on the right.
    void aPictureShowsHairWhereTheImageIsGreen()
    {
        const auto picture = [this](const QString& density) {
            const QString file =
                project("half.hairpaint", {QStringLiteral("density=") + density,
                                           QStringLiteral("length=") + filled("short.png", QColor(230, 230, 255))});
            const QString out = path("half-out.png");
            const Outcome outcome =
                runProgram({QStringLiteral("render"), file, QStringLiteral("-o"), out, QStringLiteral("--size"),
                            QStringLiteral("256x256"), QStringLiteral("--view"), QStringLiteral("back"),
                            QStringLiteral("--settle"), QStringLiteral("0")});
            return outcome.code == 0 ? QImage(out) : QImage();
        };
        const QImage bald = picture(filled("bald.png", Qt::white));
        const QImage half = picture(drawn("left_half"));
        QCOMPARE(bald.size(), QSize(256, 256));
        QCOMPARE(half.size(), QSize(256, 256));
        int left = 0;
        int right = 0;
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x)
                if (bald.pixel(x, y) != half.pixel(x, y))
                    ++(x < 128 ? left : right);
        QVERIFY2(right > 4000 && left < right / 10,
                 qPrintable(QStringLiteral("%1 pixels differ on the left, %2 on the right").arg(left).arg(right)));
    }

    void theSameImagesGiveTheSameBytes()
    {
        std::array<QByteArray, 2> projects;
        std::array<QByteArray, 2> hairs;
        std::array<QByteArray, 2> pictures;
        for (std::size_t i = 0; i < 2; ++i) {
            const QString file = project("same.hairpaint", {QStringLiteral("density=") + drawn("density"),
                                                            QStringLiteral("length=") + drawn("length"),
                                                            QStringLiteral("curl=") + drawn("curl")});
            const QString hair = path("same.hair");
            const QString out = path("same.png");
            QCOMPARE(runProgram({QStringLiteral("export"), file, QStringLiteral("-o"), hair, QStringLiteral("--settle"),
                                 QStringLiteral("0.2")})
                         .code,
                     0);
            QCOMPARE(runProgram({QStringLiteral("render"), file, QStringLiteral("-o"), out, QStringLiteral("--size"),
                                 QStringLiteral("160x160"), QStringLiteral("--settle"), QStringLiteral("0.2")})
                         .code,
                     0);
            projects[i] = contentOf(file);
            hairs[i] = contentOf(hair);
            pictures[i] = contentOf(out);
            QVERIFY(!projects[i].isEmpty() && !hairs[i].isEmpty() && !pictures[i].isEmpty());
        }
        QVERIFY(projects[0] == projects[1]);
        QVERIFY(hairs[0] == hairs[1]);
        QVERIFY(pictures[0] == pictures[1]);
    }
};

QTEST_GUILESS_MAIN(TestDrawnImages)
#include "test_drawn_images.moc"
