// Curls in real units measure what was set, hairs of a lock come into step, and locks form from the curl.
#include "sim/base/parallel.h"
#include "sim/groom/direction_texel.h"
#include "sim/groom/groom.h"
#include "sim/groom/lock_partition.h"
#include "sim/groom/strand_curve.h"
#include "sim/groom/strand_style.h"
#include "tests/sim/groom_bytes.h"
#include "tests/sim/groom_reading.h"
#include "tests/sim/small_groom.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

constexpr float kFullTurnRad = 6.2831853F;

StrandStyle coiled(const CurlSettings& curl, float lengthM, float phase, float chance)
{
    StrandStyle style;
    style.lengthM = lengthM;
    style.turns = lengthM / curl.pitchM;
    style.curlRadiusM = curl.diameterM * 0.5F;
    style.phase = phase;
    style.variation = chance;
    return style;
}

/// What the points of a hair along z from the origin tell of its curl, as one would measure an export.
struct Measured
{
    float diameterM = 0.0F; ///< Diameter in the middle half of the hair.
    float pitchM = 0.0F;
    float seenOverCut = 1.0F;
    float switchbacksPerM = 0.0F;
    float skips = 0.0F; ///< Fraction of the turns that are skipped.
};

Measured measured(const StrandStyle& style, const CurlSettings& curl)
{
    constexpr int kPointsPerTurn = 64;
    const int segments = static_cast<int>(style.turns * kPointsPerTurn);
    std::vector<glm::vec3> skeleton;
    skeleton.reserve(16);
    for (int i = 0; i < 16; ++i)
        skeleton.emplace_back(0.0F, 0.0F, style.lengthM * static_cast<float>(i) / 15.0F);
    std::vector<glm::vec3> points;
    evaluateStrand(skeleton, {1.0F, 0.0F, 0.0F}, style, segments, points, &curl);
    Measured found;
    float fibreM = 0.0F;
    float widest = 0.0F;
    float narrowest = 0.0F;
    int turning = 0; // Steps that go round,
    int lastSign = 0;
    int switches = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::vec3 a = points[i - 1];
        const glm::vec3 b = points[i];
        fibreM += b.z > style.lengthM * 0.25F ? glm::distance(a, b) : 0.0F;
        const bool isMiddle = b.z > style.lengthM * 0.25F && b.z < style.lengthM * 0.75F;
        if (isMiddle) {
            widest = std::max(widest, b.x);
            narrowest = std::min(narrowest, b.x);
        }
        if (b.z < style.lengthM * 0.1F)
            continue; // Where the coil is yet to open.
        const float angle = std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
        if (std::abs(angle) < 0.25F * kFullTurnRad / kPointsPerTurn)
            continue;
        ++turning;
        const int sign = angle > 0.0F ? 1 : -1;
        switches += lastSign != 0 && sign != lastSign ? 1 : 0;
        lastSign = sign;
    }
    const float seenM = style.lengthM * 0.9F;
    const float turns = static_cast<float>(turning) / kPointsPerTurn;
    found.diameterM = widest - narrowest;
    found.skips = 1.0F - turns / (seenM / curl.pitchM);
    found.pitchM = seenM / std::max(turns, 1e-3F);
    found.seenOverCut = style.lengthM * 0.75F / fibreM;
    found.switchbacksPerM = static_cast<float>(switches) / seenM;
    return found;
}

bool isWithin(float found, float wanted, float part)
{
    return std::abs(found - wanted) <= part * wanted;
}

/// Curly hair on a patch of skin, without clump.
GroomInput::Group curly(const CurlSettings& curl)
{
    GroomInput::Group group = smallGroup();
    group.settings.greatestLengthM = 0.16F; // 8 cm
    group.settings.turnsMode = TurnsMode::Coils;
    group.settings.curl = curl;
    group.maps[MapSlot::Curl] = uniformMap(1.0F);
    return group;
}

std::vector<glm::vec3> nodesOf(const Groom& groom, std::uint32_t slot)
{
    std::vector<glm::vec3> nodes;
    nodes.reserve(static_cast<std::size_t>(groom.nodes));
    for (int i = 0; i < groom.nodes; ++i)
        nodes.push_back(restNode(groom, slot, i));
    return nodes;
}

} // namespace

class TestCoils : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void hairIsStraightAtItsRootAsFarAsIsSet()
    {
        const auto offM = [](float straightM, float alongM) {
            const CurlSettings curl{.diameterM = 0.015F, .pitchM = 0.04F, .straightM = straightM};
            const StrandStyle style = coiled(curl, 0.2F, 1.0F, 0.2F);
            return glm::length(coilOffset(style, curl, alongM / style.lengthM));
        };
        QVERIFY(offM(0.0F, 0.015F) > 0.001F);
        QCOMPARE(offM(0.02F, 0.015F), 0.0F);
        QVERIFY(std::abs(offM(0.02F, 0.1F) - 0.0075F) < 1e-4F);
        QVERIFY(offM(0.19F, 0.06F) > 0.0F); // No more than a quarter of it.
    }
    void aCoilMeasuresWhatWasSet_data()
    {
        QTest::addColumn<float>("diameterMm");
        QTest::addColumn<float>("pitchMm");
        QTest::addColumn<float>("switchbacks"); ///< In 10 cm.
        QTest::addColumn<float>("skips");
        QTest::newRow("3A") << 25.0F << 75.0F << 0.3F << 0.05F;
        QTest::newRow("3B") << 15.0F << 39.0F << 0.5F << 0.06F;
        QTest::newRow("3C") << 9.0F << 18.0F << 1.0F << 0.08F;
        QTest::newRow("4A") << 6.0F << 9.0F << 2.0F << 0.10F;
        QTest::newRow("4C") << 2.5F << 2.0F << 6.0F << 0.25F;
    }
    void aCoilMeasuresWhatWasSet()
    {
        QFETCH(float, diameterMm);
        QFETCH(float, pitchMm);
        QFETCH(float, switchbacks);
        QFETCH(float, skips);
        CurlSettings curl{.diameterM = diameterMm * 1e-3F, .pitchM = pitchMm * 1e-3F};
        const float lengthM = 40.0F * curl.pitchM;
        const Measured plain = measured(coiled(curl, lengthM, 1.0F, 0.2F), curl);
        QVERIFY2(isWithin(plain.diameterM, curl.diameterM, 0.02F), qPrintable(QString::number(plain.diameterM)));
        QVERIFY2(isWithin(plain.pitchM, curl.pitchM, 0.03F), qPrintable(QString::number(plain.pitchM)));
        GroupSettings settings;
        settings.turnsMode = TurnsMode::Coils;
        settings.lengthAsCut = true;
        settings.curl = curl;
        QVERIFY(isWithin(plain.seenOverCut, seenOverCut(settings, 1.0F, 0.5F), 0.03F));
        QCOMPARE(plain.switchbacksPerM, 0.0F);

        curl.switchbacksPerM = switchbacks * 10.0F;
        float sum = 0.0F;
        constexpr int kHairs = 60;
        for (int i = 0; i < kHairs; ++i)
            sum += measured(coiled(curl, lengthM, 0.1F * static_cast<float>(i), 0.2F), curl).switchbacksPerM;
        QVERIFY2(isWithin(sum / kHairs, curl.switchbacksPerM, 0.1F), qPrintable(QString::number(sum / kHairs)));

        curl.switchbacksPerM = 0.0F;
        curl.skips = skips;
        sum = 0.0F;
        for (int i = 0; i < kHairs; ++i)
            sum += measured(coiled(curl, lengthM, 1.0F, 0.033F * static_cast<float>(i) - 1.0F), curl).skips;
        QVERIFY2(isWithin(sum / kHairs, skips, 0.1F), qPrintable(QString::number(sum / kHairs)));
    }

    void aCoilKeepsItsRadiusWhereItsHairBends()
    {
        // Down, by 90 degrees within three segments, and on to the side.
        std::vector<glm::vec3> nodes{glm::vec3(0.0F)};
        for (int i = 0; i < 11; ++i) {
            const float rad = 0.25F * kFullTurnRad * std::clamp(static_cast<float>(i - 3) / 3.0F, 0.0F, 1.0F);
            nodes.push_back(nodes.back() + 0.027F * glm::vec3(std::sin(rad), -std::cos(rad), 0.0F));
        }
        const CurlSettings curl{.diameterM = 0.015F, .pitchM = 0.039F, .switchbacksPerM = 5.0F, .skips = 0.06F};
        StrandStyle style = coiled(curl, 0.297F, 1.0F, 0.2F);
        constexpr int kSegments = 400;
        std::vector<glm::vec3> wound;
        evaluateStrand(nodes, {0.0F, 0.0F, 1.0F}, style, kSegments, wound, &curl);
        style.turns = 0.0F;
        std::vector<glm::vec3> middle;
        evaluateStrand(nodes, {0.0F, 0.0F, 1.0F}, style, kSegments, middle, &curl);
        const auto radii = [&](int from, int to) {
            std::vector<float> all;
            for (auto i = static_cast<std::size_t>(from); i < static_cast<std::size_t>(to); ++i)
                all.push_back(glm::distance(wound[i], middle[i]));
            std::ranges::sort(all);
            return all;
        };
        const std::vector<float> bent = radii(kSegments * 3 / 11, kSegments * 7 / 11);
        // A switchback or a leap passes through the middle, within a part of a turn.
        QVERIFY(isWithin(bent[bent.size() / 2], curl.diameterM * 0.5F, 0.05F));
        QVERIFY(bent.back() < curl.diameterM * 0.5F * 1.05F);
    }

    void theFinestCoilsAreRound()
    {
        const CurlSettings curl{.diameterM = 0.0025F, .pitchM = 0.002F};
        const StrandStyle style = coiled(curl, 0.2F, 0.0F, 0.0F);
        QCOMPARE(segmentsOf(style, 8, &curl), 800);
        QCOMPARE(segmentsOf(style, 8), 256); // Files of before keep their points.
    }

    void aFlatOneIsAnS()
    {
        const CurlSettings curl{.diameterM = 0.045F, .pitchM = 0.225F, .flatness = 1.0F};
        std::vector<glm::vec3> points;
        const std::vector<glm::vec3> skeleton{
            {0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.2F}, {0.0F, 0.0F, 0.4F}, {0.0F, 0.0F, 0.6F}};
        evaluateStrand(skeleton, {1.0F, 0.0F, 0.0F}, coiled(curl, 0.6F, 0.3F, 0.2F), 200, points, &curl);
        for (const glm::vec3& point : points)
            QVERIFY(std::abs(point.y) < 1e-6F);
        const auto [least, most] = std::ranges::minmax(points, {}, &glm::vec3::x);
        QVERIFY(isWithin(most.x - least.x, curl.diameterM, 0.02F));
    }

    void weightDrawsTheTurnsNearTheRootOfLongHairApart()
    {
        const CurlSettings curl{.diameterM = 0.015F, .pitchM = 0.039F, .uncoil = 0.3F};
        const StrandStyle style = coiled(curl, 0.39F, 0.0F, 0.2F);
        const auto turnsOver = [&](float from, float to) {
            float round = 0.0F;
            glm::vec3 last = coilOffset(style, curl, from);
            for (int i = 1; i <= 2000; ++i) {
                const glm::vec3 next = coilOffset(style, curl, from + (to - from) * static_cast<float>(i) / 2000.0F);
                round += std::abs(std::atan2(last.x * next.y - last.y * next.x, last.x * next.x + last.y * next.y));
                last = next;
            }
            return round / kFullTurnRad;
        };
        // There are ten turns in all, and their density is 0.7 + 0.6 s.
        QVERIFY(std::abs(turnsOver(0.1F, 0.5F) - 3.52F) < 0.1F);
        QVERIFY(std::abs(turnsOver(0.5F, 1.0F) - 5.75F) < 0.1F);
        QVERIFY(glm::length(coilOffset(style, curl, 0.95F)) > 1.3F * glm::length(coilOffset(style, curl, 0.2F)));
    }

    void hairsOfALockComeIntoStep()
    {
        const auto groom = groomOf(inputOf(patch(), curly({.inStepFromM = 0.02F})));
        const RootSet& roots = *groom->roots;
        const auto agreement = [&](float atM) {
            std::map<std::uint32_t, std::vector<float>> angles;
            for (std::uint32_t slot = 0; slot < roots.count(); ++slot)
                if (const StrandStyle* style = styleAt(*groom, slot)) {
                    const glm::vec3 at = coilOffset(*style, groom->settings.curl, atM / style->lengthM);
                    angles[roots.neighbours[slot][0]].push_back(std::atan2(at.y, at.x));
                }
            float sum = 0.0F;
            int count = 0;
            for (const auto& [lock, of] : angles)
                for (std::size_t i = 1; i < of.size(); ++i, ++count)
                    sum += std::cos(of[i] - of[0]);
            return sum / static_cast<float>(count);
        };
        QVERIFY2(std::abs(agreement(0.008F)) < 0.1F, qPrintable(QString::number(agreement(0.008F))));
        QVERIFY(agreement(0.015F) > 0.3F);
        QVERIFY(agreement(0.021F) > 0.999F);
        QVERIFY(agreement(0.07F) > 0.999F);
    }

    void curlsAloneGatherInLocks()
    {
        const auto spread = [](const Groom& groom) {
            float sum = 0.0F;
            int count = 0;
            forEachHair(groom, [&](std::uint32_t slot, const StrandStyle&) {
                const std::uint32_t leader = groom.roots->basisSlot[groom.roots->neighbours[slot][0]];
                if (leader != slot && styleAt(groom, leader) != nullptr) {
                    sum += glm::distance(restNode(groom, slot, 7), restNode(groom, leader, 7));
                    ++count;
                }
            });
            return sum / static_cast<float>(count);
        };
        const auto loose = groomOf(inputOf(patch(), curly({})));
        const auto gathered = groomOf(inputOf(patch(), curly({.gather = 0.85F})));
        QVERIFY(spread(*gathered) < 0.2F * spread(*loose));
        GroomInput::Group straight = curly({.gather = 0.85F});
        straight.maps[MapSlot::Curl] = uniformMap(0.0F);
        QVERIFY(spread(*groomOf(inputOf(patch(), straight))) > 0.9F * spread(*loose));
    }

    void whatIsMeasuredInMmChangesNothingElsewhere()
    {
        GroomInput::Group plain = smallGroup();
        plain.maps[MapSlot::Curl] = uniformMap(0.6F);
        plain.maps[MapSlot::Clump] = uniformMap(0.5F);
        GroomInput::Group other = plain;
        other.settings.lengthAsCut = true;
        other.settings.curl = {.diameterM = 0.03F,
                               .pitchM = 0.01F,
                               .flatness = 0.5F,
                               .inStepFromM = 0.02F,
                               .switchbacksPerM = 10.0F,
                               .skips = 0.2F,
                               .uncoil = 0.3F};
        const auto a = groomOf(inputOf(patch(), plain));
        Groom b = *groomOf(inputOf(patch(), other));
        b.settings = a->settings;
        QCOMPARE(differenceOf(*a, b), nullptr);
    }

    void lengthsAsCutAreShortenedByTheirCurl()
    {
        GroomInput::Group group = curly({.diameterM = 0.015F, .pitchM = 0.0405F});
        group.settings.lengthAsCut = true;
        const auto groom = groomOf(inputOf(patch(), group));
        forEachHair(*groom, [&](std::uint32_t, const StrandStyle& style) {
            QVERIFY(isWithin(style.lengthM, 0.08F * 0.652F, 0.01F));
            QVERIFY(isWithin(style.turns, style.lengthM / 0.0405F, 0.001F));
        });
    }

    void locksHaveASizeOfTheirOwn()
    {
        GroomInput::Group group = smallGroup();
        group.settings.locks.sizeM = 0.025F;
        group.maps[MapSlot::Clump] = uniformMap(1.0F);
        const auto groom = groomOf(inputOf(patch(), group));
        std::map<std::uint32_t, int> hairsOf;
        forEachHair(*groom, [&](std::uint32_t slot, const StrandStyle&) {
            const std::uint32_t leader = groom->chunks[chunkOf(slot)]->lockLeader[inChunk(slot)];
            ++hairsOf[leader];
            const std::uint32_t leaderSlot = groom->roots->basisSlot[leader];
            QVERIFY(glm::distance(groom->roots->positionHd[slot], groom->roots->positionHd[leaderSlot]) < 0.05F);
            if (styleAt(*groom, leaderSlot) != nullptr)
                QVERIFY(glm::distance(restNode(*groom, slot, 7), restNode(*groom, leaderSlot, 7)) < 0.008F);
        });
        QCOMPARE(hairsOf.size(), std::size_t{64}); // 0.04 m2
    }

    /// Hair that hangs alike on both sides of a parting leaves it to its own.
    void noLockReachesOverAParting()
    {
        GroomInput::Group group = smallGroup();
        group.settings.greatestDensityPerM2 = 5e4F;
        group.settings.greatestLengthM = 0.4F;
        group.settings.locks.sizeM = 0.04F;
        group.maps[MapSlot::Length] = uniformMap(1.0F);
        auto direction = std::make_shared<TiledRaster>(512, 2, texelOfDirection({-0.95F, 0.0F}));
        for (int tile = 0; tile < direction->tileCount(); ++tile)
            if (direction->tileRect(tile).x0 >= 256)
                direction->setUniform(tile, texelOfDirection({0.95F, 0.0F}));
        group.maps[MapSlot::Direction] = direction;
        const auto skin = std::make_shared<const Skin>(makeBallHead());
        const auto loose = groomOf(inputOf(skin, group));
        group.maps[MapSlot::Clump] = uniformMap(1.0F);
        const auto gathered = groomOf(inputOf(skin, group));
        int moved = 0;
        int across = 0;
        forEachHair(*loose, [&](std::uint32_t slot, const StrandStyle&) {
            const glm::vec3 before = nodesOf(*loose, slot).back();
            const glm::vec3 after = nodesOf(*gathered, slot).back();
            constexpr float kBesideM = 0.055F; // Not merely drawn to where hair meets behind.
            const float rootM = gathered->roots->positionHd[slot].x;
            const bool isAtPole = std::abs(gathered->roots->positionHd[slot].y) > 0.05F;
            const bool isWhereSidesMeet = std::abs(gathered->roots->uv[slot].x - 0.5F) > 0.3F;
            if (!isAtPole && !isWhereSidesMeet &&
                std::min(std::abs(before.x - rootM), std::abs(after.x - rootM)) > kBesideM)
                across += (before.x < rootM) != (after.x < rootM) ? 1 : 0;
            moved += glm::distance(before, after) > 0.002F ? 1 : 0;
        });
        QVERIFY(moved > 1000);
        QCOMPARE(across, 0);
    }

    void locksAreShaped_data()
    {
        QTest::addColumn<int>("which");
        QTest::newRow("small locks") << 0;
        QTest::newRow("flatness") << 1;
        QTest::newRow("twist") << 2;
        QTest::newRow("ragged") << 3;
        QTest::newRow("parting") << 4;
    }
    void locksAreShaped()
    {
        QFETCH(int, which);
        constexpr float LockSettings::*kShapes[] = {&LockSettings::small, &LockSettings::flatness,
                                                    &LockSettings::twistsPerM, &LockSettings::ragged,
                                                    &LockSettings::parting};
        GroomInput::Group group = smallGroup();
        group.settings.locks.sizeM = 0.025F;
        group.settings.physics.volumeM = 0.03F; // A coat that can be flattened.
        group.maps[MapSlot::Clump] = uniformMap(0.9F);
        group.maps[MapSlot::Direction] = std::make_shared<const TiledRaster>(512, 2, texelOfDirection({0.0F, -0.95F}));
        const auto plain = groomOf(inputOf(patch(), group));
        group.settings.locks.*kShapes[which] = which == 2 ? 10.0F : 1.0F;
        const auto shaped = groomOf(inputOf(patch(), group));
        float moved = 0.0F;
        int count = 0;
        forEachHair(*plain, [&](std::uint32_t slot, const StrandStyle& style) {
            const std::vector<glm::vec3> a = nodesOf(*plain, slot);
            const std::vector<glm::vec3> b = nodesOf(*shaped, slot);
            for (std::size_t i = 1; i < b.size(); ++i)
                QVERIFY(isWithin(glm::distance(b[i], b[i - 1]), style.lengthM / 7.0F, 1e-3F));
            moved += glm::distance(a[5], b[5]);
            ++count;
        });
        QVERIFY(moved / static_cast<float>(count) > 1e-4F);
    }

    void anyNumberOfThreadsGivesTheSameBytes()
    {
        GroomInput::Group group = curly({.inStepFromM = 0.02F, .switchbacksPerM = 5.0F, .gather = 0.6F});
        group.settings.locks = {.sizeM = 0.025F, .small = 0.4F, .flatness = 0.3F, .ragged = 0.5F, .parting = 0.3F};
        setThreadCount(1);
        const auto one = groomOf(inputOf(patch(), group));
        for (const int threads : {2, 8}) {
            setThreadCount(threads);
            const auto several = groomOf(inputOf(patch(), group));
            setThreadCount(0);
            QCOMPARE(differenceOf(*one, *several), nullptr);
        }
    }

    void whatIsUpdatedIsWhatIsBuilt()
    {
        GroomInput::Group group = curly({.inStepFromM = 0.02F, .switchbacksPerM = 5.0F, .gather = 0.6F});
        group.settings.locks = {.sizeM = 0.025F, .small = 0.4F, .flatness = 0.3F, .ragged = 0.5F, .parting = 0.3F};
        GroomInput input = inputOf(patch(), group);
        GroomBuilder builder;
        static_cast<void>(builder.update(input));
        for (const MapSlot slot : {MapSlot::Length, MapSlot::Direction, MapSlot::Curl, MapSlot::Clump}) {
            MapRaster& map = input.groups[0].maps[slot];
            map = withDab(map, {0.4F, 0.55F}, 0.08F,
                          slot == MapSlot::Direction ? Texel{45000, 30000} : Texel{channelOf(0.3F)});
            const auto updated = builder.update(input).grooms[0];
            QCOMPARE(differenceOf(*groomOf(input), *updated), nullptr);
        }
    }
};

HAIRPAINT_TEST(TestCoils, None)
#include "test_coils.moc"
