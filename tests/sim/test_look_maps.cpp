// What the maps of frizz, width and gloss do to a hair, and that they do nothing where nothing is painted.
#include "sim/groom/strand_curve.h"
#include "sim/groom/strand_look.h"
#include "sim/groom/strand_style.h"
#include "tests/sim/groom_bytes.h"
#include "tests/sim/groom_reading.h"
#include "tests/sim/small_groom.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

constexpr float kLengthM = 0.2F;
constexpr int kSegments = 160;

StrandStyle frizzy(float frizzM, float chance, float lengthM = kLengthM)
{
    StrandStyle style;
    style.lengthM = lengthM;
    style.frizzM = frizzM;
    style.variation = chance;
    return style;
}

/// Along a skeleton that runs straight down.
std::vector<glm::vec3> evaluated(const StrandStyle& style)
{
    constexpr int kNodes = 8;
    std::vector<glm::vec3> skeleton;
    skeleton.reserve(kNodes);
    for (int node = 0; node < kNodes; ++node)
        skeleton.emplace_back(0.0F, -style.lengthM * static_cast<float>(node) / (kNodes - 1), 0.0F);
    std::vector<glm::vec3> points;
    evaluateStrand(skeleton, glm::vec3(1.0F, 0.0F, 0.0F), style, kSegments, points);
    return points;
}

float lengthOfLine(const std::vector<glm::vec3>& points)
{
    float lengthM = 0.0F;
    for (std::size_t i = 1; i < points.size(); ++i)
        lengthM += glm::distance(points[i - 1], points[i]);
    return lengthM;
}

float strayAt(const std::vector<glm::vec3>& points, std::size_t i)
{
    return glm::length(glm::vec2(points[i].x, points[i].z));
}

} // namespace

class TestLookMaps : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void widthMultipliesTheDiameter_data()
    {
        QTest::addColumn<float>("value");
        QTest::addColumn<float>("width");
        QTest::newRow("thinnest") << 0.0F << 0.3F;
        QTest::newRow("unpainted") << 32768.0F / 65535.0F << 1.0F;
        QTest::newRow("between") << 0.75F << 1.35F;
        QTest::newRow("thickest") << 1.0F << 1.7F;
    }
    void widthMultipliesTheDiameter()
    {
        QFETCH(float, value);
        QFETCH(float, width);
        if (width == 1.0F)
            QVERIFY(widthOf(value) == 1.0F); // Not nearly.
        QVERIFY(std::abs(widthOf(value) - width) < 1e-4F);
    }

    void whereNothingIsPaintedHairIsExactlyAsWithoutTheMaps()
    {
        GroomInput input = inputOf(patch(), smallGroup());
        auto& maps = input.groups[0].maps;
        for (const MapSlot slot : {MapSlot::Frizz, MapSlot::Width, MapSlot::Gloss})
            maps[slot] = withDab(maps[slot], {0.5F, 0.5F}, 0.2F, {65535});
        const auto groom = groomOf(input);
        const RootSet& roots = *groom->roots;
        std::size_t inside = 0;
        std::size_t outside = 0;
        forEachHair(*groom, [&](std::uint32_t slot, const StrandStyle& style) {
            const float distance = glm::length(roots.uv[slot] - glm::vec2(0.5F));
            if (distance > 0.21F) {
                ++outside;
                QVERIFY(style.width == 1.0F && style.frizzM == 0.0F && style.gloss == StrandStyle{}.gloss);
            } else if (distance < 0.19F) {
                ++inside;
                QVERIFY(std::abs(style.width - 1.7F) < 1e-4F && style.gloss == 65535);
                QVERIFY(style.frizzM == input.groups[0].settings.greatestFrizzM);
            }
        });
        QVERIFY(inside > 500 && outside > 5000);
    }

    void aDabChangesWhatHairLooksLikeAndNotHowItLies_data()
    {
        QTest::addColumn<int>("map");
        QTest::addColumn<bool>("braided");
        for (const bool braided : {false, true}) {
            const char* kind = braided ? ", braided" : "";
            QTest::addRow("frizz%s", kind) << static_cast<int>(MapSlot::Frizz) << braided;
            QTest::addRow("width%s", kind) << static_cast<int>(MapSlot::Width) << braided;
            QTest::addRow("gloss%s", kind) << static_cast<int>(MapSlot::Gloss) << braided;
        }
    }
    void aDabChangesWhatHairLooksLikeAndNotHowItLies()
    {
        QFETCH(int, map);
        QFETCH(bool, braided);
        GroomInput input = inputOf(patch(), smallGroup());
        auto& maps = input.groups[0].maps;
        input.groups[0].settings.variation = {.length = 0.1F, .width = 0.2F, .grey = 0.3F};
        maps[MapSlot::Clump] = uniformMap(0.6F);
        if (braided)
            maps[MapSlot::Braid] = indexMap(1);
        GroomBuilder builder;
        const auto before = builder.update(input).grooms[0];
        MapRaster& raster = maps[static_cast<MapSlot>(map)];
        raster = withDab(raster, {0.4F, 0.6F}, 0.1F, {50000});
        const auto report = builder.update(input);
        const Groom& after = *report.grooms[0];
        // pi r^2 of the patch's candidates.
        const double expected = 3.1416 * 0.01 * static_cast<double>(before->hairCount);
        QVERIFY(std::abs(static_cast<double>(report.rebuiltStrands) / expected - 1.0) < 0.15);
        QVERIFY(after.basis == before->basis);
        for (std::size_t i = 0; i < after.chunks.size(); ++i)
            QVERIFY(!after.chunks[i] || sameBytes(after.chunks[i]->restPositions, before->chunks[i]->restPositions));
        QVERIFY(differenceOf(after, *before) != nullptr);
        const char* difference = differenceOf(after, *groomOf(input));
        QVERIFY2(difference == nullptr, difference);
        raster = uniformGroup().maps[static_cast<MapSlot>(map)];
        difference = differenceOf(*builder.update(input).grooms[0], *before);
        QVERIFY2(difference == nullptr, difference);
    }

    void frizzGrowsToTheTipAndStaysWithinItsRadius()
    {
        constexpr float kFrizzM = 0.004F;
        const std::vector<glm::vec3> straight = evaluated(frizzy(0.0F, 0.3F));
        double atMiddle = 0.0;
        double atTip = 0.0;
        constexpr int kHairs = 200;
        for (int hair = 0; hair < kHairs; ++hair) {
            const float chance = -1.0F + 2.0F * static_cast<float>(hair) / kHairs;
            const std::vector<glm::vec3> points = evaluated(frizzy(kFrizzM, chance));
            QCOMPARE(points.front(), straight.front());
            for (std::size_t i = 0; i < points.size(); ++i)
                QVERIFY(strayAt(points, i) <= kFrizzM * static_cast<float>(i) / kSegments + 1e-6F);
            atMiddle += static_cast<double>(strayAt(points, kSegments / 2)) / kHairs;
            atTip += static_cast<double>(strayAt(points, kSegments)) / kHairs;
            const float lengthM = lengthOfLine(points);
            QVERIFY2(lengthM < 1.06F * kLengthM, qPrintable(QString::number(static_cast<double>(lengthM))));
        }
        QVERIFY2(atTip > 0.3 * kFrizzM, qPrintable(QString::number(atTip)));
        QVERIFY(std::abs(atMiddle / atTip - 0.5) < 0.15);
    }

    void shortHairKeepsItsLengthToo()
    {
        for (const float lengthM : {0.005F, 0.02F, 0.6F})
            for (const float frizzM : {0.001F, 0.02F})
                for (const float chance : {-0.7F, 0.1F, 0.9F}) {
                    const float frizzyM = lengthOfLine(evaluated(frizzy(frizzM, chance, lengthM)));
                    QVERIFY2(frizzyM < 1.08F * lengthM && frizzyM > 0.999F * lengthM,
                             qPrintable(QString::number(static_cast<double>(frizzyM / lengthM))));
                }
    }

    void noTwoHairsStrayAlikeAndEachAlwaysDoesTheSame()
    {
        const std::vector<glm::vec3> one = evaluated(frizzy(0.004F, 0.31F));
        QVERIFY(one == evaluated(frizzy(0.004F, 0.31F)));
        const std::vector<glm::vec3> other = evaluated(frizzy(0.004F, 0.36F));
        float apart = 0.0F;
        for (std::size_t i = 0; i < one.size(); ++i)
            apart = std::max(apart, glm::distance(one[i], other[i]));
        QVERIFY(apart > 0.001F);
    }

    void withoutATaperHairThinsOutOverAllOfItsLength()
    {
        const StrandMaterial material;
        for (int i = 0; i <= 20; ++i) {
            const float s = static_cast<float>(i) / 20.0F;
            QVERIFY(thinnedAt(material, perTaperOf(material, 0.3F), s) ==
                    glm::mix(material.rootAlpha, material.tipAlpha, s * s));
            QVERIFY(tipMixOf(material).at(s) == s);
        }
    }

    void aTaperLeavesTheRestWhole()
    {
        StrandMaterial material;
        material.taperM = 0.015F;
        const auto widthAt = [&](float lengthM, float fromTipM) {
            return thinnedAt(material, perTaperOf(material, lengthM), 1.0F - fromTipM / lengthM);
        };
        QCOMPARE(widthAt(0.3F, 0.016F), 1.0F);
        QCOMPARE(widthAt(0.3F, 0.2F), 1.0F);
        QVERIFY(std::abs(widthAt(0.3F, 0.0075F) - (1.0F - 0.25F * 0.65F)) < 1e-4F);
        QVERIFY(std::abs(widthAt(0.3F, 0.0F) - 0.35F) < 1e-4F);
        // Shorter than the taper: over all of it.
        QVERIFY(std::abs(widthAt(0.01F, 0.005F) - (1.0F - 0.25F * 0.65F)) < 1e-4F);
    }

    void theTipColourOfAHairBeginsBetweenTheGroupsStartAndTheTip()
    {
        StrandMaterial material;
        for (const float from : {0.0F, 0.3F}) {
            material.tipFrom = from;
            const TipMix group = tipMixOf(material);
            QVERIFY(tipMixOf(material, 0.0F).scale == group.scale && tipMixOf(material, 0.0F).offset == group.offset);
            for (const float wanted : {0.4F, 0.75F, 0.99F}) {
                const TipMix own = tipMixOf(material, tipStartOf(material, wanted));
                QCOMPARE(own.at(wanted - 0.001F), 0.0F);
                QVERIFY(std::abs(own.at(0.5F + 0.5F * wanted) - 0.5F) < 1e-3F);
                QVERIFY(own.at(1.0F) > 0.999F);
            }
            QCOMPARE(tipStartOf(material, 0.2F * from), 0.0F);
            QCOMPARE(tipMixOf(material, 1.0F).at(1.0F), 0.0F); // None at all.
        }
    }

    void tipStartsAreOfHairWhoseTipsAreDyed()
    {
        GroomInput input = inputOf(patch(), smallGroup());
        auto& maps = input.groups[0].maps;
        maps[MapSlot::TipStart] = withDab(maps[MapSlot::TipStart], {0.5F, 0.5F}, 0.2F, {32768});
        GroomBuilder builder;
        const auto plain = builder.update(input).grooms[0];
        forEachHair(*plain, [&](std::uint32_t, const StrandStyle& style) { QCOMPARE(style.tipStart, 0.0F); });
        maps[MapSlot::TipColour] = withDab(maps[MapSlot::TipColour], {0.6F, 0.5F}, 0.2F, {65535, 0, 0});
        const auto dyed = builder.update(input).grooms[0];
        std::size_t both = 0;
        forEachHair(*dyed, [&](std::uint32_t slot, const StrandStyle& style) {
            const glm::vec2 uv = dyed->roots->uv[slot];
            const float fromStart = glm::distance(uv, glm::vec2(0.5F));
            const float fromTip = glm::distance(uv, glm::vec2(0.6F, 0.5F));
            if (fromStart < 0.19F && fromTip < 0.19F) {
                ++both;
                QVERIFY(std::abs(style.tipStart - 0.5F) < 1e-3F);
            } else if (fromStart > 0.21F || fromTip > 0.21F) {
                QCOMPARE(style.tipStart, 0.0F);
            }
        });
        QVERIFY(both > 300);
        const char* difference = differenceOf(*dyed, *groomOf(input));
        QVERIFY2(difference == nullptr, difference);
    }

    void theTipColourBeginsWhereItShouldAndAsSoftly()
    {
        StrandMaterial material;
        material.tipFrom = 0.6F;
        QCOMPARE(tipMixOf(material).at(0.59F), 0.0F);
        QVERIFY(std::abs(tipMixOf(material).at(0.8F) - 0.5F) < 1e-5F);
        QVERIFY(std::abs(tipMixOf(material).at(1.0F) - 1.0F) < 1e-5F);
        material.tipOver = 0.25F;
        QVERIFY(std::abs(tipMixOf(material).at(0.65F) - 0.5F) < 1e-5F);
        QCOMPARE(tipMixOf(material).at(0.71F), 1.0F);
        material.tipOver = 0.0F;
        QCOMPARE(tipMixOf(material).at(0.599F), 0.0F);
        QCOMPARE(tipMixOf(material).at(0.602F), 1.0F);
    }
};

HAIRPAINT_TEST(TestLookMaps, None)
#include "test_look_maps.moc"
