// No two hairs are alike, the same hair always is, and where nothing is to differ nothing does.
#include "sim/groom/groom.h"
#include "sim/groom/variation.h"
#include "tests/support/test_grooms.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

constexpr std::uint64_t kVariedSeed = 7;
constexpr std::uint32_t kVariedHairs = 20'000;

/// All amounts, so that each is seen to leave the others' members alone.
struct Amount
{
    const char* name;
    float VariationSettings::*setting;
    float amount;
    std::function<double(const HairVariation&)> deviation; ///< Deviation of a hair; 0 where it does not vary.
    double most;                                           ///< Greatest deviation over all hairs.
    double mean;                                           ///< Mean of the deviations' absolute values.
};

const std::vector<Amount>& amounts()
{
    static const std::vector<Amount> all{
        {"length", &VariationSettings::length, 0.1F, [](const HairVariation& v) { return 1.0 - v.length; }, 0.1,
         0.0333},
        {"turns", &VariationSettings::curl, 0.2F, [](const HairVariation& v) { return v.turns - 1.0; }, 0.2, 0.0667},
        {"radius", &VariationSettings::curl, 0.2F, [](const HairVariation& v) { return v.radius - 1.0; }, 0.2, 0.0667},
        {"width", &VariationSettings::width, 0.3F, [](const HairVariation& v) { return v.width - 1.0; }, 0.3, 0.1},
        {"across", &VariationSettings::crossing, 0.06F, [](const HairVariation& v) { return v.acrossRad; }, 0.06, 0.02},
        {"lean", &VariationSettings::crossing, 0.06F, [](const HairVariation& v) { return v.leanRad; }, 0.06, 0.02},
        {"flyaway", &VariationSettings::flyaways, 0.1F, [](const HairVariation& v) { return v.isFlyaway ? 1.0 : 0.0; },
         1.0, 0.1},
        {"lift", &VariationSettings::flyaways, 0.1F, [](const HairVariation& v) { return v.liftRad; }, 0.16, 0.0095},
        // More to the side than off the others: what stands off along them is a second outline.
        {"flyaway across", &VariationSettings::flyaways, 0.1F,
         [](const HairVariation& v) { return v.isFlyaway ? v.acrossRad : 0.0F; }, 0.6, 0.02},
        {"grey", &VariationSettings::grey, 0.25F, [](const HairVariation& v) { return v.isGrey ? 1.0 : 0.0; }, 1.0,
         0.25}};
    return all;
}

/// A ball full of curly, clumped hair.
GroomInput ball(const VariationSettings& variation, float clump)
{
    GroomInput::Group group = uniformGroup();
    group.settings.greatestDensityPerM2 = 1e5F;
    group.settings.basisHairs = 256;
    group.settings.variation = variation;
    group.maps[MapSlot::Curl] = uniformMap(0.5F);
    group.maps[MapSlot::Clump] = uniformMap(clump);
    return inputOf(std::make_shared<const Skin>(makeBallHead(48, 0.1F)), group);
}

std::shared_ptr<const Groom> grownWith(const VariationSettings& variation, float clump = 0.6F)
{
    GroomBuilder builder;
    return builder.update(ball(variation, clump)).grooms[0];
}

std::vector<glm::vec3> nodesOf(const Groom& groom, std::size_t slot)
{
    std::vector<glm::vec3> nodes(static_cast<std::size_t>(groom.nodes));
    groom.blocks().read(groom.chunks[chunkOf(slot)]->restPositions, inChunk(slot), nodes);
    return nodes;
}

} // namespace

class TestVariation : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void eachAmountChangesWhatItNamesAndNothingElse_data()
    {
        QTest::addColumn<int>("which");
        for (int i = 0; i < static_cast<int>(amounts().size()); ++i)
            QTest::newRow(amounts()[static_cast<std::size_t>(i)].name) << i;
    }
    void eachAmountChangesWhatItNamesAndNothingElse()
    {
        QFETCH(int, which);
        const Amount& amount = amounts()[static_cast<std::size_t>(which)];
        VariationSettings settings;
        settings.*amount.setting = amount.amount;
        double sum = 0.0;
        double most = 0.0;
        for (std::uint32_t rank = 0; rank < kVariedHairs; ++rank) {
            const HairVariation own = variationOf(settings, kVariedSeed, rank);
            const double size = std::abs(amount.deviation(own));
            sum += size;
            most = std::max(most, size);
            for (const Amount& other : amounts())
                if (other.setting != amount.setting && !own.isFlyaway) // Which lie across, too.
                    QCOMPARE(other.deviation(own), 0.0);
        }
        QVERIFY2(most <= amount.most + 1e-6 && most > 0.9 * amount.most, qPrintable(QString::number(most)));
        QVERIFY2(std::abs(sum / kVariedHairs - amount.mean) < 0.06 * amount.mean,
                 qPrintable(QString::number(sum / kVariedHairs)));
    }

    void whatAHairHasFromChanceDoesNotHangOnWhatElseIsSet()
    {
        const VariationSettings all{
            .length = 0.1F, .curl = 0.2F, .width = 0.3F, .crossing = 0.06F, .flyaways = 0.0F, .grey = 0.3F};
        for (const Amount& amount : amounts()) {
            if (amount.setting == &VariationSettings::flyaways)
                continue;
            VariationSettings alone;
            alone.*amount.setting = all.*amount.setting;
            for (std::uint32_t rank = 0; rank < 100; ++rank)
                QCOMPARE(amount.deviation(variationOf(all, kVariedSeed, rank)),
                         amount.deviation(variationOf(alone, kVariedSeed, rank)));
        }
    }

    void noHairIsMuchShorterThanIsAllowed()
    {
        const VariationSettings settings{.length = 0.2F, .mostShorterM = 0.015F};
        float most = 0.0F;
        for (std::uint32_t rank = 0; rank < 1000; ++rank) {
            const float own = variationOf(settings, kVariedSeed, rank).length;
            most = std::max(most, 0.5F - 0.5F * lengthLeft(settings, own, 0.5F, glm::vec3(0.0F)));
            QCOMPARE(lengthLeft(settings, own, 0.05F, glm::vec3(0.0F)), own); // Short hair by its fraction.
        }
        QVERIFY2(std::abs(most - settings.mostShorterM) < 1e-5F, qPrintable(QString::number(most)));
    }

    void lengthBeforeIsTheInverseOfLengthLeft()
    {
        const VariationSettings settings{.length = 0.2F, .mostShorterM = 0.015F, .patches = 0.5F};
        for (std::uint32_t rank = 0; rank < 200; ++rank) {
            const float own = variationOf(settings, kVariedSeed, rank).length;
            const glm::vec3 root(0.0F, 0.001F * static_cast<float>(rank), 0.1F);
            for (const float leftM : {0.002F, 0.02F, 0.1F, 0.6F}) {
                const float beforeM = lengthBefore(settings, own, leftM, root);
                QVERIFY(beforeM >= leftM && std::isfinite(beforeM));
                const float againM = beforeM * lengthLeft(settings, own, beforeM, root);
                QVERIFY2(std::abs(againM - leftM) < 1e-4F * leftM + 1e-6F,
                         qPrintable(QStringLiteral("%1 of %2").arg(againM).arg(leftM)));
            }
        }
        QCOMPARE(lengthBefore({}, 1.0F, 0.1F, glm::vec3(0.0F)), 0.1F);
        QVERIFY(std::isinf(lengthBefore({}, 0.0F, 0.1F, glm::vec3(0.0F))));
    }

    void patchesAreSoftAndAsDeepAsIsSet()
    {
        QCOMPARE(densityLeft({}, glm::vec3(0.03F)), 1.0F);
        QCOMPARE(lengthLeft({}, 0.9F, 0.3F, glm::vec3(0.03F)), 0.9F);
        const VariationSettings settings{.patches = 1.0F};
        float least = 1.0F;
        float most = 0.0F;
        for (int step = 0; step < 300; ++step) {
            const auto at = [](int mm) { return glm::vec3(0.0F, 0.001F * static_cast<float>(mm), 0.1F); };
            const float density = densityLeft(settings, at(step));
            QVERIFY(std::abs(densityLeft(settings, at(step + 1)) - density) < 0.08F);
            least = std::min(least, density);
            most = std::max(most, density);
        }
        QVERIFY2(least > 0.49F && least < 0.65F, qPrintable(QString::number(least)));
        QVERIFY2(most > 0.85F && most <= 1.0F, qPrintable(QString::number(most)));
    }

    void anotherSeedIsOtherHair()
    {
        const VariationSettings settings{.length = 0.1F};
        int same = 0;
        for (std::uint32_t rank = 0; rank < 100; ++rank)
            same += variationOf(settings, 1, rank).length == variationOf(settings, 2, rank).length ? 1 : 0;
        QCOMPARE(same, 0);
    }

    void hairsStrayAsFarAsIsSetAndTheLineTheyMakeIsSmooth()
    {
        const SkinFrame frame{};
        const VariationSettings settings{.parting = 0.003F};
        QCOMPARE(strayOf({}, kVariedSeed, 1, glm::vec3(0.1F), frame), glm::vec3(0.0F));
        float most = 0.0F;
        float leastOfLine = 1.0F;
        float mostOfLine = -1.0F;
        glm::vec3 before(0.0F);
        for (int step = 0; step < 100; ++step) {
            const glm::vec3 rootHd(0.0F, 0.1F, 0.001F * static_cast<float>(step)); // 10 cm of a parting.
            glm::vec3 mean(0.0F);
            constexpr std::uint32_t kMany = 400;
            for (std::uint32_t rank = 0; rank < kMany; ++rank) {
                const glm::vec3 stray = strayOf(settings, kVariedSeed, rank, rootHd, frame);
                QVERIFY(std::abs(glm::dot(stray, frame.normal)) < 1e-6F);
                most = std::max(most, glm::dot(stray, frame.x));
                mean += stray / static_cast<float>(kMany);
            }
            if (step > 0)
                QVERIFY(glm::distance(mean, before) < 0.0008F);
            before = mean;
            leastOfLine = std::min(leastOfLine, mean.x);
            mostOfLine = std::max(mostOfLine, mean.x);
        }
        QVERIFY2(most <= 0.003F && most > 0.002F, qPrintable(QString::number(most)));
        QVERIFY2(mostOfLine - leastOfLine > 0.0012F, qPrintable(QString::number(mostOfLine - leastOfLine)));
    }

    void turnedHairKeepsItsLengthAndItsRoot()
    {
        const VariationSettings settings{.crossing = 0.3F, .flyaways = 0.2F};
        const auto plain = grownWith({}, 0.0F);
        const auto turned = grownWith(settings, 0.0F);
        float furthest = 0.0F;
        int moved = 0;
        for (std::size_t slot = 0; slot < plain->roots->count(); ++slot) {
            if (!plain->isDrawn(slot))
                continue;
            const std::vector<glm::vec3> a = nodesOf(*plain, slot);
            const std::vector<glm::vec3> b = nodesOf(*turned, slot);
            QCOMPARE(a.front(), b.front());
            const bool isFlyaway = variationOf(settings, plain->roots->seed, plain->roots->rankOfSlot[slot]).isFlyaway;
            for (std::size_t node = 1; node < a.size() && !isFlyaway; ++node)
                QVERIFY(std::abs(glm::distance(a[node], a[node - 1]) - glm::distance(b[node], b[node - 1])) < 1e-5F);
            const float tipM = glm::distance(a.back(), b.back());
            furthest = std::max(furthest, isFlyaway ? 0.0F : tipM);
            moved += tipM > 0.001F ? 1 : 0;
        }
        QVERIFY(moved > 1000);
        QVERIFY2(furthest < 0.085F, qPrintable(QString::number(furthest)));
    }

    void hairThatKeepsToItsLockLiesAcrossNoOther()
    {
        const auto plain = grownWith({}, 1.0F);
        const auto turned = grownWith({.crossing = 0.3F}, 1.0F);
        int locked = 0;
        for (std::uint32_t slot = 0; slot < plain->roots->count(); ++slot)
            if (plain->isDrawn(slot) && plain->roots->basisSlot[plain->roots->neighbours[slot][0]] != slot) {
                ++locked;
                QVERIFY(glm::distance(nodesOf(*plain, slot).back(), nodesOf(*turned, slot).back()) < 1e-5F);
            }
        QVERIFY(locked > 1000);
    }

    void whatIsCutOffTakesItsTurnsAlong()
    {
        const auto plain = grownWith({});
        const auto cut = grownWith({.length = 0.5F});
        float shortest = 1.0F;
        for (std::uint32_t slot = 0; slot < plain->roots->count(); ++slot)
            if (plain->isDrawn(slot)) {
                const float kept = cut->style(slot).lengthM / plain->style(slot).lengthM;
                shortest = std::min(shortest, kept);
                QVERIFY(std::abs(cut->style(slot).turns - kept * plain->style(slot).turns) < 1e-4F);
                QCOMPARE(cut->style(slot).curlRadiusM, plain->style(slot).curlRadiusM);
            }
        QVERIFY(shortest < 0.55F);
    }

    void locksCurlAsOne()
    {
        const auto groom = grownWith({.curl = 0.3F});
        const RootSet& roots = *groom->roots;
        std::vector<std::vector<float>> turnsOfLock(roots.basisSlot.size());
        for (std::uint32_t slot = 0; slot < roots.count(); ++slot)
            if (groom->isDrawn(slot) && roots.basisSlot[roots.neighbours[slot][0]] != slot)
                turnsOfLock[roots.neighbours[slot][0]].push_back(groom->style(slot).turns);
        int locks = 0;
        float least = 1e6F;
        float greatest = 0.0F;
        for (const std::vector<float>& turns : turnsOfLock)
            if (turns.size() > 2) {
                ++locks;
                QCOMPARE(*std::ranges::max_element(turns), *std::ranges::min_element(turns));
                least = std::min(least, turns.front());
                greatest = std::max(greatest, turns.front());
            }
        QVERIFY(locks > 50);
        QVERIFY(greatest > 1.2F * least);
    }
};

HAIRPAINT_TEST(TestVariation, Core)
#include "test_variation.moc"
