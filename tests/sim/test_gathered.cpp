// Hair gathered into ties: taut over the skin, through the ring, and free from there.
#include "groom_bytes.h"
#include "sim/base/deterministic.h"
#include "sim/base/parallel.h"
#include "tests/support/test_program.h"
#include "tied_ball.h"

#include <QtTest>

#include <map>

using namespace hairpaint::sim;
using namespace hairpaint::test;
using namespace hairpaint::test::tied;

class TestGathered : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void cleanup() { setThreadCount(0); }

    void withoutTiesHairIsWhatItWas()
    {
        GroomInput loose = tiedBall();
        loose.groups.front().ties.clear();
        loose.groups.front().gathered = nullptr;
        const auto groom = groomed(loose);
        QVERIFY(groom->tails == nullptr);
        GroomInput other = tiedBall();
        other.groups.front().ties.front().number = 2; // No root has it.
        other.groups.front().gathered = mapOfTexel(1, {7});
        const auto same = groomed(other);
        for (std::size_t i = 0; i < groom->chunks.size(); ++i)
            QVERIFY(sameBytes(groom->chunks[i]->restPositions, same->chunks[i]->restPositions));
    }

    void hairOfThePatchGoesThroughTheRing()
    {
        const auto groom = groomed(tiedBall());
        const Tie tie = tiedBall().groups.front().ties.front();
        std::size_t gathered = 0;
        forEachGathered(*groom, [&](std::uint32_t slot, const StrandStyle& style, bool isTailed) {
            ++gathered;
            QVERIFY(isTailed);
            QVERIFY(groom->roots->uv[slot].y > 0.44F);
            const glm::vec3 through = restNode(*groom, slot, ringNode(groom->nodes));
            const glm::vec3 off = through - tie.pointHd;
            QVERIFY2(glm::length(off) <= kRingM * 1.01F, qPrintable(QString::number(glm::length(off))));
            QVERIFY(std::abs(glm::dot(off, tie.directionHd)) < 1e-4F);
            QCOMPARE(style.turns, 0.0F);
        });
        QVERIFY(gathered > 2000);
    }

    void tautHairTakesTheShortestWay()
    {
        const auto groom = groomed(tiedBall());
        const Tie tie = tiedBall().groups.front().ties.front();
        forEachGathered(*groom, [&](std::uint32_t slot, const StrandStyle&, bool) {
            const std::vector<glm::vec3> points = drawn(*groom, slot, restNodes(*groom, slot), 7 * 24);
            const std::size_t ring = 24 * static_cast<std::size_t>(ringNode(groom->nodes));
            const float taut = lengthOfLine(std::span(points).first(ring + 1));
            const float shortest = tautOverBall(groom->roots->positionHd[slot], tie.pointHd);
            QVERIFY2(taut < shortest * 1.03F + 1.5F * kRingM && taut > shortest * 0.97F - kRingM,
                     qPrintable(QStringLiteral("%1 for %2").arg(taut).arg(shortest)));
        });
    }

    void tautHairLiesOnTheSkin()
    {
        const auto groom = groomed(tiedBall());
        const Tie tie = tiedBall().groups.front().ties.front();
        float highest = 0.0F;
        float deepest = 0.0F;
        forEachGathered(*groom, [&](std::uint32_t slot, const StrandStyle&, bool) {
            const std::vector<glm::vec3> points = drawn(*groom, slot, restNodes(*groom, slot), 7 * 24);
            for (std::size_t i = 0; i <= 24 * static_cast<std::size_t>(ringNode(groom->nodes)); ++i) {
                const float distance = glm::length(points[i]) - kBallM;
                deepest = std::min(deepest, distance);
                // Where the straight line to the ring leaves the skin it may, and below it lies hair.
                const float toRing = glm::length(points[i] - tie.pointHd);
                const float leaves = std::sqrt(2.0F * kBallM * (kStandsM + kRingM)) + 0.01F;
                if (toRing > leaves)
                    highest = std::max(highest, distance);
            }
        });
        QVERIFY2(highest < 0.004F, qPrintable(QString::number(highest)));
        QVERIFY2(deepest > -0.0025F, qPrintable(QString::number(deepest)));
    }

    void neighboursStayTogether()
    {
        const auto groom = groomed(tiedBall(20000));
        std::vector<std::uint32_t> slots;
        forEachGathered(*groom, [&](std::uint32_t slot, const StrandStyle&, bool) { slots.push_back(slot); });
        const int middle = ringNode(groom->nodes) - 1;
        std::size_t pairs = 0;
        std::size_t apart = 0;
        for (std::size_t i = 0; i < slots.size(); i += 7)
            for (std::size_t j = i + 1; j < std::min(i + 40, slots.size()); ++j) {
                if (glm::length(groom->roots->positionHd[slots[i]] - groom->roots->positionHd[slots[j]]) > 0.006F)
                    continue;
                ++pairs;
                apart += glm::length(restNode(*groom, slots[i], middle) - restNode(*groom, slots[j], middle)) > 0.012F
                             ? 1
                             : 0;
            }
        QVERIFY(pairs > 500);
        QVERIFY2(apart * 100 <= pairs, qPrintable(QStringLiteral("%1 of %2").arg(apart).arg(pairs)));
    }

    void hairKeepsItsLength_data()
    {
        QTest::addColumn<float>("settled");
        QTest::addColumn<float>("most");
        QTest::newRow("as laid") << 0.0F << 0.015F;
        QTest::newRow("fallen") << 2.0F << 0.01F;
    }

    void hairKeepsItsLength()
    {
        QFETCH(float, settled);
        QFETCH(float, most);
        const GroomInput input = tiedBall();
        Simulation simulation;
        simulation.setInput(input);
        if (settled > 0.0F)
            simulation.settle(static_cast<double>(settled));
        else
            simulation.reset();
        const GroupFrame frame = frameOf(simulation);
        std::size_t count = 0;
        std::size_t wrong = 0;
        forEachGathered(*frame.groom, [&](std::uint32_t slot, const StrandStyle&, bool isTailed) {
            if (!isTailed)
                return;
            ++count;
            const float length = lengthOfLine(drawn(*frame.groom, slot, frameNodes(frame, slot), 7 * 24));
            wrong += std::abs(length - 0.4F) > most * 0.4F ? 1 : 0;
        });
        QVERIFY(count > 2000);
        QVERIFY2(wrong * 100 < count, qPrintable(QStringLiteral("%1 of %2").arg(wrong).arg(count)));
    }

    void shortHairEndsBeforeTheRing()
    {
        const auto groom = groomed(tiedBall(6000, 0.06F));
        const Tie tie = tiedBall().groups.front().ties.front();
        std::size_t ended = 0;
        forEachGathered(*groom, [&](std::uint32_t slot, const StrandStyle& style, bool isTailed) {
            const glm::vec3 root = groom->roots->positionHd[slot];
            if (tautOverBall(root, tie.pointHd) < 0.075F)
                return;
            ++ended;
            QVERIFY(!isTailed);
            QVERIFY(std::abs(style.lengthM - 0.06F) < 1e-5F);
            const float length = lengthOfLine(drawn(*groom, slot, restNodes(*groom, slot)));
            QVERIFY2(std::abs(length - 0.06F) < 0.0015F, qPrintable(QString::number(length)));
            QVERIFY(glm::length(restNode(*groom, slot, groom->nodes - 1) - tie.pointHd) <
                    glm::length(root - tie.pointHd));
        });
        QVERIFY(ended > 500);
    }

    void tailsFallAndComeToRest()
    {
        Simulation simulation;
        simulation.setInput(tiedBall());
        simulation.settle(20.0);
        QVERIFY(simulation.asleep());
        const GroupFrame frame = frameOf(simulation);
        const Tie tie = tiedBall().groups.front().ties.front();
        std::size_t count = 0;
        double below = 0.0;
        forEachGathered(*frame.groom, [&](std::uint32_t slot, const StrandStyle&, bool isTailed) {
            const std::vector<glm::vec3> nodes = frameNodes(frame, slot);
            for (int node = 0; node <= ringNode(frame.groom->nodes); ++node)
                QVERIFY(nodes[static_cast<std::size_t>(node)] == restNode(*frame.groom, slot, node));
            if (!isTailed)
                return;
            ++count;
            below += static_cast<double>(tie.pointHd.y - nodes.back().y);
        });
        below /= static_cast<double>(count);
        QVERIFY2(below > 0.1, qPrintable(QString::number(below)));
    }

    void noHairIsInTheSkin_data()
    {
        QTest::addColumn<float>("windMs");
        QTest::newRow("still air") << 0.0F;
        QTest::newRow("storm") << 15.0F;
    }

    void noHairIsInTheSkin()
    {
        QFETCH(float, windMs);
        Simulation simulation;
        simulation.setInput(tiedBall());
        if (windMs > 0.0F)
            simulation.setWind({.velocity = {0.0F, 0.0F, windMs}});
        simulation.settle(2.0);
        const GroupFrame frame = frameOf(simulation);
        float deepest = 0.0F;
        std::size_t count = 0;
        forEachGathered(*frame.groom, [&](std::uint32_t slot, const StrandStyle&, bool) {
            ++count;
            for (const glm::vec3& point : drawn(*frame.groom, slot, frameNodes(frame, slot)))
                deepest = std::min(deepest, glm::length(point) - kBallM);
        });
        QVERIFY(count > 2000);
        QVERIFY2(deepest > -0.003F, qPrintable(QString::number(deepest)));
    }

    void tautHairGoesWithTheHeadAndTheTailSwings()
    {
        Simulation simulation;
        simulation.setInput(tiedBall());
        simulation.settle(3.0);
        const GroupFrame before = frameOf(simulation);
        for (int step = 1; step <= 12; ++step) {
            const float angle = 0.05F * static_cast<float>(step);
            simulation.setPose({.rotation = glm::angleAxis(angle, glm::vec3(0.0F, 1.0F, 0.0F))});
            simulation.advance(1.0 / 60.0);
        }
        StrandFrame whole;
        simulation.writeFrame(whole);
        const GroupFrame& after = whole.groups.front();
        float most = 0.0F;
        forEachGathered(*after.groom, [&](std::uint32_t slot, const StrandStyle&, bool isTailed) {
            const std::vector<glm::vec3> nodes = frameNodes(after, slot);
            for (int node = 0; node <= ringNode(after.groom->nodes); ++node) {
                const glm::vec3 expected =
                    whole.pose.rotation * restNode(*after.groom, slot, node) + whole.pose.positionWo;
                QVERIFY(glm::length(nodes[static_cast<std::size_t>(node)] - expected) < 1e-5F);
            }
            if (isTailed)
                most =
                    std::max(most, glm::length(nodes.back() - whole.pose.rotation * frameNodes(before, slot).back()));
        });
        QVERIFY2(most > 0.02F, qPrintable(QString::number(most))); // The tip stays behind.
    }

    void aBunIsAClosedCoilThatMovesWithTheHead()
    {
        GroomInput input = tiedBall();
        Tie& tie = input.groups.front().ties.front();
        tie.form = TieForm::Bun;
        tie.directionHd = glm::normalize(tie.pointHd);
        Simulation simulation;
        simulation.setInput(input);
        simulation.settle(0.5);
        const GroupFrame frame = frameOf(simulation);
        std::size_t count = 0;
        forEachGathered(*frame.groom, [&](std::uint32_t slot, const StrandStyle& style, bool isTailed) {
            QVERIFY(!isTailed);
            if (style.braid == BraidKind::None)
                return;
            ++count;
            const std::vector<glm::vec3> points = drawn(*frame.groom, slot, frameNodes(frame, slot), 7 * 24);
            for (std::size_t i = 24 * static_cast<std::size_t>(ringNode(frame.groom->nodes)); i < points.size(); ++i) {
                const glm::vec3 off = points[i] - tie.pointHd;
                const float along = glm::dot(off, tie.directionHd);
                QVERIFY(glm::length(off - tie.directionHd * along) < tie.bunRadiusM * 1.1F);
                QVERIFY(along > -tie.bunRadiusM && along < 2.0F * tie.bunRadiusM);
            }
        });
        QVERIFY(count > 2000);
    }

    void aBunHasNoHoleAndIsWiderAtItsFoot_data()
    {
        QTest::addColumn<float>("lengthM");
        QTest::newRow("short hair") << 0.25F;
        QTest::newRow("long hair") << 0.7F;
    }

    void aBunHasNoHoleAndIsWiderAtItsFoot()
    {
        QFETCH(float, lengthM);
        constexpr int kCells = 15; // From its middle to its rim.
        GroomInput input = tiedBall(12000, lengthM);
        input.groups.front().settings.nodesPerHair = 16;
        Tie& tie = input.groups.front().ties.front();
        tie.form = TieForm::Bun;
        tie.directionHd = glm::normalize(tie.pointHd);
        const glm::vec3 across = glm::normalize(glm::cross(tie.directionHd, glm::vec3(1.0F, 0.0F, 0.0F)));
        const glm::vec3 aside = glm::cross(tie.directionHd, across);
        const auto groom = groomed(input);
        std::vector<float> top(static_cast<std::size_t>(4 * kCells * kCells), 0.0F);
        float highest = 0.0F;
        std::vector<glm::vec2> alongAndOut;
        forEachGathered(*groom, [&](std::uint32_t slot, const StrandStyle& style, bool) {
            if (style.braid == BraidKind::None)
                return;
            const std::vector<glm::vec3> points = drawn(*groom, slot, restNodes(*groom, slot), 240);
            for (std::size_t i = 80; i < points.size(); ++i) {
                const glm::vec3 off = points[i] - tie.pointHd;
                const float along = glm::dot(off, tie.directionHd);
                const glm::vec2 at(glm::dot(off, across), glm::dot(off, aside));
                highest = std::max(highest, along);
                alongAndOut.emplace_back(along, glm::length(at));
                const glm::ivec2 cell = glm::ivec2(glm::floor(at * (kCells / tie.bunRadiusM))) + kCells;
                if (cell.x >= 0 && cell.y >= 0 && cell.x < 2 * kCells && cell.y < 2 * kCells) {
                    float& height = top[static_cast<std::size_t>(cell.y * 2 * kCells + cell.x)];
                    height = std::max(height, along);
                }
            }
        });
        float lowest = 1.0F;
        for (int y = -kCells; y < kCells; ++y)
            for (int x = -kCells; x < kCells; ++x)
                if (glm::length(glm::vec2(x, y) + 0.5F) < 0.4F * kCells)
                    lowest = std::min(lowest, top[static_cast<std::size_t>((y + kCells) * 2 * kCells + x + kCells)]);
        QVERIFY2(lowest > 0.35F * highest, qPrintable(QStringLiteral("%1 of %2").arg(lowest).arg(highest)));
        float foot = 0.0F;
        float crown = 0.0F;
        for (const glm::vec2 point : alongAndOut) {
            foot = point.x < 0.4F * highest ? std::max(foot, point.y) : foot;
            crown = point.x > 0.85F * highest ? std::max(crown, point.y) : crown;
        }
        QVERIFY2(crown < 0.8F * foot, qPrintable(QStringLiteral("%1 of %2").arg(crown).arg(foot)));
    }

    void aTailIsBraidedWhereTheBraidMapSays()
    {
        GroomInput input = tiedBall();
        input.groups.front().maps[MapSlot::Braid] = mapOfTexel(1, {1});
        Simulation simulation;
        simulation.setInput(input);
        simulation.settle(2.0);
        const GroupFrame frame = frameOf(simulation);
        const int ring = ringNode(frame.groom->nodes);
        std::vector<glm::vec3> first;
        forEachGathered(*frame.groom, [&](std::uint32_t slot, const StrandStyle& style, bool isTailed) {
            if (!isTailed)
                return;
            QCOMPARE(style.braid, BraidKind::Plait);
            const std::vector<glm::vec3> nodes = frameNodes(frame, slot);
            if (first.empty())
                first = nodes;
            for (int node = ring; node < frame.groom->nodes; ++node)
                QVERIFY(glm::length(nodes[static_cast<std::size_t>(node)] - first[static_cast<std::size_t>(node)]) <
                        1e-4F);
        });
        QVERIFY(!first.empty());
    }

    void tautHairIsStraightWhereverItCurls()
    {
        GroomInput input = tiedBall();
        const auto straight = groomed(input);
        input.groups.front().maps[MapSlot::Curl] = mapOfTexel(1, {40000});
        const auto curled = groomed(input);
        std::size_t curls = 0;
        forEachGathered(*curled, [&](std::uint32_t slot, const StrandStyle& style, bool) {
            const std::vector<glm::vec3> a = drawn(*straight, slot, restNodes(*straight, slot), 7 * 24);
            const std::vector<glm::vec3> b = drawn(*curled, slot, restNodes(*curled, slot), 7 * 24);
            const std::size_t ring = 24 * static_cast<std::size_t>(ringNode(curled->nodes));
            for (std::size_t i = 0; i + 24 <= ring; ++i)
                QVERIFY(glm::length(a[i] - b[i]) < 1e-5F);
            curls += style.turns > 0.0F && glm::length(a[ring + 40] - b[ring + 40]) > 1e-3F ? 1 : 0;
        });
        QVERIFY(curls > 1000);
    }

    void withoutADistanceGridTheSkinItselfIsAsked()
    {
        GroomInput input = tiedBall(600);
        input.distances = nullptr;
        const auto groom = groomed(input);
        forEachGathered(*groom, [&](std::uint32_t slot, const StrandStyle&, bool) {
            for (int node = 1; node < ringNode(groom->nodes); ++node)
                QVERIFY(glm::length(restNode(*groom, slot, node)) > kBallM - 0.0005F);
        });
    }
};

HAIRPAINT_TEST(TestGathered, None)
#include "test_gathered.moc"
