// Painted hair ends softly towards bare skin, and nowhere else.
#include "groom_bytes.h"
#include "sim/base/parallel.h"
#include "sim/groom/group_builder.h"
#include "small_groom.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

constexpr float kSoftenM = 0.010F;

/// Hair of 10 cm on the left half of a square of 20 cm, as dense as `left`, and `right` on the other.
GroomInput halfPatch(float left, float right, const HairlineSettings& hairline)
{
    GroomInput::Group group = smallGroup();
    group.settings.hairline = hairline;
    group.maps[MapSlot::Density] = halves(left, right);
    return inputOf(patch(), group);
}

/// Bare between two edges so far from the middle line, in texels.
MapRaster withGap(float halfTx)
{
    auto map = std::make_shared<TiledRaster>(512, 1, Texel{65535});
    for (int x = 0; x < map->size(); ++x)
        if (std::abs(static_cast<float>(x) - 255.5F) < halfTx)
            for (int y = 0; y < map->size(); ++y)
                map->setTexel(x, y, {0});
    return map;
}

/// Hairs of a strip, by how far from the middle line they stand.
struct Strip
{
    std::size_t roots = 0;
    std::size_t hairs = 0;
    double lengthM = 0.0;
    double width = 0.0;
};

/// The middle line is where u is one half.
Strip stripOf(const Groom& groom, float fromM, float toM)
{
    Strip strip;
    const RootSet& roots = *groom.roots;
    for (std::uint32_t slot = 0; slot < roots.count(); ++slot) {
        const float insideM = (0.5F - roots.uv[slot].x) * 0.2F;
        if (insideM < fromM || insideM >= toM)
            continue;
        ++strip.roots;
        if (!groom.isDrawn(slot))
            continue;
        ++strip.hairs;
        strip.lengthM += groom.style(slot).lengthM;
        strip.width += groom.style(slot).width;
    }
    return strip;
}

} // namespace

class TestHairline : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void cleanup() { setThreadCount(0); }

    void hairThinsOutShortensAndIsFinerTowardsBareSkin()
    {
        const auto groom = groomOf(halfPatch(1.0F, 0.0F, {.softenM = kSoftenM}));
        double density = 0.0;
        double length = 0.0;
        double width = 0.0;
        for (const float fromM : {0.0F, 0.003F, 0.006F, 0.02F}) {
            const Strip strip = stripOf(*groom, fromM, fromM + 0.003F);
            QVERIFY(strip.hairs > 20);
            const auto hairs = static_cast<double>(strip.hairs);
            QVERIFY(hairs / static_cast<double>(strip.roots) > density);
            QVERIFY(strip.lengthM / hairs > length);
            QVERIFY(strip.width / hairs > width);
            density = hairs / static_cast<double>(strip.roots);
            length = strip.lengthM / hairs;
            width = strip.width / hairs;
        }
        // Inside all is as painted; at the edge there is less than half of it.
        const Strip inside = stripOf(*groom, 0.02F, 0.09F);
        QCOMPARE(inside.hairs, inside.roots);
        const Strip edge = stripOf(*groom, 0.0F, 0.002F);
        QVERIFY(edge.hairs * 2 < edge.roots);
        QCOMPARE(stripOf(*groom, -0.1F, -0.002F).hairs, std::size_t{0});
    }

    void whereDensityOnlyFallsNothingChanges()
    {
        const auto soft = groomOf(halfPatch(1.0F, 0.4F, {.softenM = kSoftenM, .baby = 1.0F}));
        const auto plain = groomOf(halfPatch(1.0F, 0.4F, {}));
        QCOMPARE(soft->hairCount, plain->hairCount);
        for (std::size_t i = 0; i < plain->chunks.size(); ++i)
            QVERIFY(sameBytes(plain->chunks[i]->restPositions, soft->chunks[i]->restPositions) &&
                    sameBytes(plain->chunks[i]->styles, soft->chunks[i]->styles));
    }

    void anUnevenEdgeLiesFurtherInsideHereThanThere()
    {
        const auto deepest = [](float uneven) {
            const auto groom = groomOf(halfPatch(1.0F, 0.0F, {.softenM = kSoftenM, .uneven = uneven}));
            // Hairs within 8 mm of the middle, in ten strips from top to bottom.
            std::array<int, 10> hairs{};
            const RootSet& roots = *groom->roots;
            for (std::uint32_t slot = 0; slot < roots.count(); ++slot)
                if (groom->isDrawn(slot) && (0.5F - roots.uv[slot].x) * 0.2F < 0.008F)
                    ++hairs[std::min<std::size_t>(static_cast<std::size_t>(roots.uv[slot].y * 10.0F), 9)];
            return std::pair(*std::ranges::min_element(hairs), *std::ranges::max_element(hairs));
        };
        const auto [evenLeast, evenMost] = deepest(0.0F);
        const auto [least, most] = deepest(1.0F);
        QVERIFY2(evenMost < 2 * evenLeast, qPrintable(QStringLiteral("%1 %2").arg(evenLeast).arg(evenMost)));
        QVERIFY2(most > 2 * least, qPrintable(QStringLiteral("%1 %2").arg(least).arg(most)));
    }

    void theGapOfAPartIsNoEdge_data()
    {
        QTest::addColumn<float>("gapM");
        QTest::addColumn<bool>("isEdge");
        QTest::newRow("the narrowest line") << 0.0008F << false;
        QTest::newRow("a part") << 0.0015F << false;
        QTest::newRow("a wide part") << 0.0025F << false;
        QTest::newRow("a shaved strip") << 0.012F << true;
    }
    void theGapOfAPartIsNoEdge()
    {
        QFETCH(float, gapM);
        QFETCH(bool, isEdge);
        GroomInput input = halfPatch(1.0F, 1.0F, {.softenM = kSoftenM, .baby = 0.5F, .uneven = 1.0F});
        input.groups[0].maps[MapSlot::Density] = withGap(0.5F * gapM / 0.2F * 512.0F);
        const auto hairsBeside = [&] {
            const auto groom = groomOf(input);
            const Strip beside = stripOf(*groom, 0.5F * gapM + 0.0006F, 0.005F + 0.5F * gapM);
            return std::pair(static_cast<double>(beside.hairs) / static_cast<double>(beside.roots),
                             beside.lengthM / static_cast<double>(std::max<std::size_t>(beside.hairs, 1)));
        };
        const auto [share, lengthM] = hairsBeside();
        input.groups[0].settings.hairline = {};
        const auto [plainShare, plainM] = hairsBeside();
        if (isEdge) {
            QVERIFY(share < 0.8 * plainShare && lengthM < 0.95 * plainM);
        } else {
            QCOMPARE(share, plainShare);
            QCOMPARE(lengthM, plainM);
        }
    }

    void babyHairsAreShortFewAndAtTheEdge()
    {
        const auto groom = groomOf(halfPatch(1.0F, 0.0F, {.softenM = kSoftenM, .baby = 0.5F}));
        const RootSet& roots = *groom->roots;
        std::size_t babies = 0;
        for (std::uint32_t slot = 0; slot < roots.count(); ++slot) {
            if (!groom->isDrawn(slot) || groom->style(slot).lengthM > 0.021F)
                continue;
            ++babies;
            QVERIFY((0.5F - roots.uv[slot].x) * 0.2F < 1.7F * kSoftenM);
            QVERIFY(groom->style(slot).turns > 0.0F && groom->style(slot).width < 0.75F);
        }
        const std::size_t near = stripOf(*groom, 0.0F, kSoftenM).hairs;
        QVERIFY2(babies > near / 50 && babies < near / 3, qPrintable(QString::number(babies)));
    }

    void anEditBesideHairEqualsAFreshBuildAndRebuildsLittle_data()
    {
        QTest::addColumn<int>("threads");
        QTest::newRow("one") << 1;
        QTest::newRow("two") << 2;
        QTest::newRow("eight") << 8;
    }
    void anEditBesideHairEqualsAFreshBuildAndRebuildsLittle()
    {
        QFETCH(int, threads);
        setThreadCount(threads);
        GroomInput input = halfPatch(1.0F, 0.0F, {.softenM = kSoftenM, .baby = 0.5F});
        GroomBuilder builder;
        builder.setCollectSlots(true);
        const auto first = builder.update(input);
        const MapRaster painted = input.groups[0].maps[MapSlot::Density];
        auto& density = input.groups[0].maps[MapSlot::Density];
        struct Edit
        {
            glm::vec2 centre;
            float radius;
            std::uint16_t value;
        };
        for (const Edit& edit : {Edit{{0.25F, 0.5F}, 0.05F, 0}, Edit{{0.5F, 0.3F}, 0.06F, 65535},
                                 Edit{{0.47F, 0.7F}, 0.05F, 0}, Edit{{0.3F, 0.5F}, 0.02F, 40000}}) {
            density = withDab(density, edit.centre, edit.radius, {edit.value});
            const auto report = builder.update(input);
            const char* difference = differenceOf(*report.grooms[0], *groomOf(input));
            QVERIFY2(difference == nullptr, difference);
            float furthestM = 0.0F;
            for (const std::uint32_t slot : report.rebuiltSlots)
                furthestM = std::max(furthestM, glm::length(first.grooms[0]->roots->uv[slot] - edit.centre) * 0.2F);
            QVERIFY2(furthestM < edit.radius * 0.2F + 1.9F * kSoftenM,
                     qPrintable(QStringLiteral("%1 around %2").arg(furthestM).arg(edit.centre.x)));
        }
        density = painted;
        QVERIFY(differenceOf(*builder.update(input).grooms[0], *first.grooms[0]) == nullptr);
    }

    void hairThatIsBuiltAnewIsAtTheEdgeThatThereIsThen()
    {
        GroomInput input = halfPatch(1.0F, 0.0F, {.softenM = kSoftenM, .baby = 0.5F});
        GroupMaps& maps = input.groups[0].maps;
        GroomBuilder builder;
        (void)builder.update(input);
        const auto verifyAsFresh = [&] {
            const char* difference = differenceOf(*builder.update(input).grooms[0], *groomOf(input));
            QVERIFY2(difference == nullptr, difference);
        };
        maps[MapSlot::Length] = uniformMap(0.3F);
        verifyAsFresh();
        // The same texels in another raster.
        maps[MapSlot::Density] = halves(1.0F, 0.0F);
        maps[MapSlot::Length] = uniformMap(0.4F);
        verifyAsFresh();
        maps[MapSlot::Density] = withDab(maps[MapSlot::Density], {0.3F, 0.5F}, 0.1F, {0});
        maps[MapSlot::Length] = uniformMap(0.5F);
        verifyAsFresh();
        maps[MapSlot::Density] = halves(0.0F, 1.0F);
        verifyAsFresh();
        input.groups[0].settings.hairline.uneven = 0.7F;
        verifyAsFresh();
    }

    void aColourLeavesItAlone()
    {
        GroomInput input = halfPatch(1.0F, 0.0F, {.softenM = kSoftenM, .baby = 0.5F});
        GroomBuilder builder;
        const auto first = builder.update(input);
        input.groups[0].maps[MapSlot::Colour] = uniformColour({0.9F, 0.1F, 0.1F});
        const auto second = builder.update(input);
        QVERIFY(differenceOf(*second.grooms[0], *groomOf(input)) == nullptr);
        QVERIFY(sameBytes(first.grooms[0]->chunks[0]->restPositions, second.grooms[0]->chunks[0]->restPositions));
    }
};

HAIRPAINT_TEST(TestHairline, Core)
#include "test_hairline.moc"
