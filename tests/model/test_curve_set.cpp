// What is exported of hair: which curves, in which order, with how many points.
#include "model/exporting/curve_set.h"
#include "model/exporting/curve_simplify.h"
#include "model/exporting/ribbon.h"
#include "tests/model/exported_hair.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

using namespace hairpaint;
using namespace hairpaint::model;
using test::allOf;
using test::frameOf;
using test::hairGroup;

namespace {

std::vector<std::vector<glm::vec3>> pointsOf(const CurveSet& set)
{
    std::vector<std::vector<glm::vec3>> all;
    CurveScratch scratch;
    for (const Curve& curve : set.curves()) {
        const std::span<const glm::vec3> points = set.points(curve, scratch);
        all.emplace_back(points.begin(), points.end());
    }
    return all;
}

float distanceToLine(const glm::vec3& point, const std::vector<glm::vec3>& line)
{
    float nearest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const glm::vec3 along = line[i + 1] - line[i];
        const float square = glm::dot(along, along);
        const float at = square > 0.0F ? glm::clamp(glm::dot(point - line[i], along) / square, 0.0F, 1.0F) : 0.0F;
        nearest = std::min(nearest, glm::distance(point, line[i] + at * along));
    }
    return nearest;
}

} // namespace

class TestCurveSet : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void everyDrawnHairOfTheWantedGroupsIsThereOnce()
    {
        const auto frame = frameOf({hairGroup(1, 65535, 65535, 0), hairGroup(3, 40'000, 65535, 0)});
        const std::optional<CurveSet> both = CurveSet::of(frame, allOf(*frame));
        QVERIFY(both);
        QCOMPARE(both->curves().size(), frame->groups[0].groom->drawnCount + frame->groups[1].groom->drawnCount);
        std::set<std::uint32_t> ids;
        for (const Curve& curve : both->curves())
            ids.insert(both->id(curve));
        QCOMPARE(ids.size(), both->curves().size());

        const std::optional<CurveSet> one =
            CurveSet::of(frame, {.groups = {{.id = 3, .name = QStringLiteral("B")}}, .hairs = {}});
        QVERIFY(one);
        QCOMPARE(one->groups().size(), std::size_t{1});
        QCOMPARE(one->groups().front().name, QStringLiteral("B"));
        QCOMPARE(one->curves().size(), frame->groups[1].groom->drawnCount);
        const auto all = pointsOf(*both);
        const auto second = pointsOf(*one);
        QVERIFY(std::equal(second.begin(), second.end(), all.end() - static_cast<std::ptrdiff_t>(second.size())));
    }

    void fewerHairsAreAnEvenSubset()
    {
        const auto frame = frameOf({hairGroup(1, 65535, 65535, 0)});
        CurveOptions options = allOf(*frame);
        const std::optional<CurveSet> all = CurveSet::of(frame, options);
        options.hairs = all->curves().size() / 4;
        const std::optional<CurveSet> few = CurveSet::of(frame, options);
        QCOMPARE(few->curves().size(), *options.hairs);
        QVERIFY(std::abs(few->thinning() - 4.0F) < 0.05F);
        QCOMPARE(all->thinning(), 1.0F);
        const auto above = [](const CurveSet& set) {
            CurveScratch scratch;
            std::size_t count = 0;
            for (const Curve& curve : set.curves())
                count += set.points(curve, scratch).front().y > 0.0F ? 1U : 0U;
            return static_cast<double>(count) / static_cast<double>(set.curves().size());
        };
        QVERIFY(std::abs(above(*few) - above(*all)) < 0.03);
    }

    void guidesAreTheBasisHairsThatAreExported()
    {
        const auto frame = frameOf({hairGroup(1, 65535, 65535, 30'000)});
        const std::optional<CurveSet> set = CurveSet::of(frame, allOf(*frame));
        const CurveGroup& group = set->groups().front();
        QVERIFY(group.guides.size() > 100 && group.guides.size() <= 256);
        std::set<std::uint32_t> ids;
        for (const Curve& curve : group.curves)
            ids.insert(set->id(curve));
        CurveScratch scratch;
        for (const Curve& guide : group.guides) {
            QVERIFY(ids.contains(set->id(guide)));
            QCOMPARE(set->guidePoints(guide, scratch).size(), std::size_t{8});
        }
    }

    void toleranceLeavesOutPointsAndNothingElse_data()
    {
        QTest::addColumn<int>("curl");
        QTest::addColumn<float>("tolerance");
        QTest::newRow("straight") << 0 << 0.0005F;
        QTest::newRow("curled") << 65535 << 0.003F;
    }
    void toleranceLeavesOutPointsAndNothingElse()
    {
        QFETCH(int, curl);
        QFETCH(float, tolerance);
        const auto frame = frameOf({hairGroup(1, 20'000, 65535, static_cast<std::uint16_t>(curl))});
        CurveOptions options = allOf(*frame);
        const std::optional<CurveSet> whole = CurveSet::of(frame, options);
        options.toleranceM = tolerance;
        const std::optional<CurveSet> few = CurveSet::of(frame, options);
        QCOMPARE(few->curves().size(), whole->curves().size());
        QVERIFY(few->pointCount() * 4 < whole->pointCount() * 3);
        const auto before = pointsOf(*whole);
        const auto after = pointsOf(*few);
        for (std::size_t i = 0; i < before.size(); i += 7) {
            QCOMPARE(after[i].front(), before[i].front());
            QCOMPARE(after[i].back(), before[i].back());
            for (const glm::vec3& point : before[i])
                QVERIFY(distanceToLine(point, after[i]) <= tolerance * 1.001F);
        }
        const Curve& last = few->curves().back();
        QCOMPARE(few->fraction(last, 0), 0.0F);
        QCOMPARE(few->fraction(last, last.points - 1), 1.0F);
    }

    void whatTapersKeepsThePointWhereItBegins()
    {
        sim::GroomInput::Group input = hairGroup(1, 20'000, 65535, 0);
        input.settings.material.taperM = 0.02F;
        const auto frame = frameOf({input});
        CurveOptions options = allOf(*frame);
        options.toleranceM = 1.0F;
        const std::optional<CurveSet> few = CurveSet::of(frame, options);
        for (const Curve& curve : few->curves()) {
            QCOMPARE(curve.points, std::uint32_t{3});
            const float begins = few->fraction(curve, 1);
            QVERIFY(begins > 0.8F && begins <= 0.9F); // The taper of hair of 20 cm.
            QCOMPARE(few->width(curve, begins), few->width(curve, 0.0F));
            QVERIFY(few->width(curve, 1.0F) < 0.4F * few->width(curve, 0.0F));
        }
    }

    void simplifyingKeepsCorners()
    {
        const std::vector<glm::vec3> points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {2, 2, 0}};
        std::vector<std::uint16_t> kept;
        keptPoints(points, 0.01F, kept);
        QCOMPARE(kept, (std::vector<std::uint16_t>{0, 2, 5}));
        keptPoints(points, 5.0F, kept);
        QCOMPARE(kept, (std::vector<std::uint16_t>{0, 5}));
    }

    void measuringCanBeCancelled()
    {
        const auto frame = frameOf({hairGroup(1, 65535, 65535, 0)});
        QVERIFY(!CurveSet::of(frame, allOf(*frame), [](double) { return false; }));
    }

    void ribbonsFaceOutwardAndNeverFlip()
    {
        // Out of the top of a head, over it and down its side.
        std::vector<glm::vec3> points;
        points.reserve(33);
        for (int i = 0; i <= 32; ++i) {
            const float angle = static_cast<float>(i) / 32.0F * std::numbers::pi_v<float>;
            points.emplace_back(0.1F * std::sin(angle), 0.1F * std::cos(angle), 0.001F * static_cast<float>(i));
        }
        points.insert(points.begin(), glm::vec3(0.0F, 0.09F, 0.0F));
        std::vector<RibbonFrame> frames;
        ribbonFrames(points, glm::vec3(0.0F), frames);
        QCOMPARE(frames.size(), points.size());
        for (std::size_t i = 0; i < frames.size(); ++i) {
            QVERIFY(std::abs(glm::length(frames[i].normal) - 1.0F) < 1e-5F);
            QVERIFY(std::abs(glm::dot(frames[i].normal, frames[i].side)) < 1e-5F);
            if (i > 0)
                QVERIFY(glm::dot(frames[i].side, frames[i - 1].side) > 0.7F);
            if (i > 2)
                QVERIFY(std::abs(glm::dot(frames[i].normal, glm::normalize(points[i]))) > 0.95F);
        }
    }
};

HAIRPAINT_TEST(TestCurveSet, Core)
#include "test_curve_set.moc"
