// Hair as cards: locks, strips, the atlas and what is drawn into it.
#include "model/cards/alpha_coverage.h"
#include "model/cards/card_mesh.h"
#include "sim/skin/skin.h"
#include "tests/model/exported_hair.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

using namespace hairpaint;
using namespace hairpaint::model;
using test::frameOf;
using test::hairGroup;

namespace {

constexpr CardSettings kSmall{.triangles = 2'000, .atlasPx = 1024};

CurveSet curvesOf(const std::shared_ptr<const sim::StrandFrame>& frame, std::optional<std::size_t> hairs = {})
{
    CurveOptions options = test::allOf(*frame);
    options.hairs = hairs;
    return *CurveSet::of(frame, options);
}

/// Density of a scalp.
sim::GroomInput::Group denseGroup(std::uint16_t length, std::uint16_t curl)
{
    sim::GroomInput::Group group = hairGroup(1, 65535, length, curl);
    group.settings.greatestDensityPerM2 = 200'000.0F;
    return group;
}

HairCards cardsOf(const CurveSet& set, const CardSettings& settings = kSmall)
{
    return *makeCards(set, settings, {});
}

/// Dense hair as long as can be, made once for each curl.
const CurveSet& denseCurves(std::uint16_t curl)
{
    static std::map<std::uint16_t, CurveSet> sets;
    const auto found = sets.find(curl);
    return found != sets.end() ? found->second
                               : sets.emplace(curl, curvesOf(frameOf({denseGroup(65535, curl)}))).first->second;
}

/// Cards of such hair without curls.
const HairCards& straightCards()
{
    static const HairCards cards = cardsOf(denseCurves(0));
    return cards;
}

/// Cosine by which the side turns around the strip, whose bends do not count.
float turned(const StripNode& from, const StripNode& to)
{
    const glm::vec3 tangent = glm::cross(to.sideWo, to.normalWo);
    const glm::vec3 kept = from.sideWo - glm::dot(from.sideWo, tangent) * tangent;
    return glm::dot(kept, to.sideWo) / std::max(glm::length(kept), 1e-6F);
}

/// Empty where all is well.
QString problemOf(const HairCards& cards)
{
    const int size = cards.images.size();
    std::vector<std::uint8_t> taken(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (const AtlasPatch& patch : cards.patches) {
        if (patch.x < 1 || patch.y < 1 || patch.width < 1 || patch.height < 1 || patch.x + patch.width >= size ||
            patch.y + patch.height >= size)
            return QStringLiteral("A patch lies outside the atlas");
        for (int y = patch.y - 1; y <= patch.y + patch.height; ++y)
            for (int x = patch.x - 1; x <= patch.x + patch.width; ++x) {
                std::uint8_t& texel = taken[cards.images.indexOf(x, y)];
                const bool isBorder =
                    x < patch.x || y < patch.y || x >= patch.x + patch.width || y >= patch.y + patch.height;
                if (texel == 2 || (texel == 1 && !isBorder))
                    return QStringLiteral("Patches overlap");
                texel = isBorder ? 1 : 2;
            }
    }
    for (std::size_t i = 0; i < taken.size(); ++i)
        if (taken[i] != 2 && cards.images.alpha()[i] != 0)
            return QStringLiteral("There is hair outside the patches");
    for (const CardStrip& strip : cards.finest().strips)
        for (const StripNode& node : strip.nodes) {
            const float sum = node.middleWo.x + node.middleWo.y + node.middleWo.z + node.halfWidthM + node.alongM;
            if (!std::isfinite(sum) || node.halfWidthM <= 0.0F)
                return QStringLiteral("A strip has no shape");
            if (std::abs(glm::length(node.sideWo) - 1.0F) > 1e-3F ||
                std::abs(glm::length(node.normalWo) - 1.0F) > 1e-3F ||
                std::abs(glm::dot(node.sideWo, node.normalWo)) > 1e-3F)
                return QStringLiteral("A strip's frame is crooked");
        }
    return {};
}

} // namespace

class TestHairCards : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theBudgetIsMet_data()
    {
        QTest::addColumn<int>("triangles");
        for (const int triangles : {1'000, 5'000, 15'000})
            QTest::newRow(qPrintable(QString::number(triangles))) << triangles;
    }
    void theBudgetIsMet()
    {
        QFETCH(int, triangles);
        const CurveSet& set = denseCurves(10'000);
        const HairCards cards = cardsOf(set, {.triangles = triangles, .atlasPx = 1024});
        QVERIFY2(cards.finest().triangles() <= triangles && cards.finest().triangles() > triangles * 9 / 10,
                 qPrintable(QString::number(cards.finest().triangles())));
        QCOMPARE(problemOf(cards), QString());
        const CardMesh mesh = cardMesh(cards, cards.finest(), 0);
        QCOMPARE(mesh.indices.size(), 3 * static_cast<std::size_t>(cards.finest().triangles()));
        const float filled = filledPart(cards.patches, cards.images.size());
        QVERIFY2(filled >= 0.7F, qPrintable(QString::number(filled)));
    }

    void straysOfManyGroupsStayInTheBudgetToo()
    {
        std::vector<sim::GroomInput::Group> groups;
        for (int id = 1; id <= 6; ++id)
            groups.push_back(hairGroup(id, 30'000, 30'000, 65535));
        const CurveSet set = curvesOf(frameOf(groups));
        constexpr int kTriangles = 1'000;
        const HairCards cards = cardsOf(set, {.triangles = kTriangles, .atlasPx = 1024});
        QVERIFY2(cards.finest().triangles() <= kTriangles, qPrintable(QString::number(cards.finest().triangles())));
        std::vector<bool> held(set.curves().size());
        for (const CardStrip& strip : cards.finest().strips)
            for (const std::uint32_t hair : strip.hairs)
                held[hair] = true;
        QVERIFY(std::ranges::find(held, false) == held.end());
    }

    void everyCornerLiesInItsPatch()
    {
        const HairCards& cards = straightCards();
        const CardMesh mesh = cardMesh(cards, cards.finest(), 0);
        const auto size = static_cast<float>(cards.images.size());
        std::size_t at = 0;
        for (std::size_t i = 0; i < cards.finest().strips.size(); ++i) {
            const AtlasPatch& patch = cards.patches[i];
            for (std::size_t n = 0; n < 2 * cards.finest().strips[i].nodes.size(); ++n, ++at) {
                const glm::vec2 texel = size * mesh.vertices[at].uv - glm::vec2(patch.x, patch.y);
                QVERIFY(texel.x > -0.01F && texel.x < static_cast<float>(patch.width) + 0.01F);
                QVERIFY(texel.y > -0.01F && texel.y < static_cast<float>(patch.height) + 0.01F);
            }
        }
        QCOMPARE(at, mesh.vertices.size());
    }

    void everyHairBelongsToOneStripOfItsGroup()
    {
        const CurveSet set = curvesOf(frameOf({hairGroup(1, 65535, 65535, 0), hairGroup(2, 30'000, 20'000, 0)}));
        const HairCards cards = cardsOf(set);
        std::vector<int> seen(set.curves().size());
        for (std::size_t i = 0; i < cards.finest().strips.size(); ++i)
            for (const std::uint32_t hair : cards.finest().strips[i].hairs) {
                ++seen[hair];
                QCOMPARE(std::size_t{set.curves()[hair].group}, cards.finest().groups[i]);
            }
        const auto twice = std::ranges::count_if(seen, [](int times) { return times > 1; });
        const auto never = std::ranges::count(seen, 0);
        QVERIFY(never == 0 && static_cast<std::size_t>(twice) < seen.size() / 50);
        QVERIFY(!cardMesh(cards, cards.finest(), 0).indices.empty() &&
                !cardMesh(cards, cards.finest(), 1).indices.empty());
    }

    void coarserLevelsHaveHalfTheTrianglesOnTheSameAtlas()
    {
        sim::GroomInput::Group stubble = denseGroup(65535, 0);
        stubble.id = 2;
        stubble.settings.greatestLengthM = 0.003F;
        const CurveSet set = curvesOf(frameOf({denseGroup(65535, 10'000), stubble}));
        const HairCards cards = cardsOf(set, {.triangles = 8'000, .atlasPx = 1024, .levels = 3, .springBones = true});
        QCOMPARE(cards.levels.size(), std::size_t{3});
        QVERIFY(cards.levels[1].caps[1].has_value());
        QCOMPARE(problemOf(cards), QString());
        for (std::size_t number = 1; number < cards.levels.size(); ++number) {
            const CardLevel& level = cards.levels[number];
            const double part = static_cast<double>(level.triangles()) / cards.levels[number - 1].triangles();
            QVERIFY2(part > 0.42 && part <= 0.5, qPrintable(QString::number(part)));
            std::vector<bool> shown(set.curves().size());
            for (std::size_t i = 0; i < level.strips.size(); ++i) {
                const std::size_t patch = level.patchOf[i];
                QCOMPARE(cards.finest().groups[patch], level.groups[i]);
                QCOMPARE(cards.bones->chains[level.chainOf[i]].group, level.groups[i]);
                // The patch is that of a lock within.
                const std::vector<std::uint32_t>& own = level.strips[i].hairs;
                QVERIFY(std::ranges::any_of(cards.finest().strips[patch].hairs,
                                            [&](std::uint32_t hair) { return std::ranges::count(own, hair) > 0; }));
                for (const std::uint32_t hair : own)
                    shown[hair] = true;
            }
            // Some of those that stray from their locks are left out.
            std::size_t missing = 0;
            std::size_t all = 0;
            for (std::size_t i = 0; i < shown.size(); ++i) {
                QVERIFY(!shown[i] || set.curves()[i].group == 0);
                all += set.curves()[i].group == 0 ? 1U : 0U;
                missing += set.curves()[i].group == 0 && !shown[i] ? 1U : 0U;
            }
            QVERIFY2(missing * 20 < all, qPrintable(QStringLiteral("%1 of %2").arg(missing).arg(all)));
            for (std::size_t group = 0; group < 2; ++group) {
                const CardMesh mesh = cardMesh(cards, level, group);
                QCOMPARE(mesh.bones.size(), mesh.vertices.size());
                for (const CardVertex& vertex : mesh.vertices)
                    QVERIFY(glm::all(glm::greaterThan(vertex.uv, glm::vec2(0.0F))) &&
                            glm::all(glm::lessThan(vertex.uv, glm::vec2(1.0F))));
            }
        }
    }

    void noLevelHasMoreThanHalfOfWhatTheOneBeforeHas()
    {
        // With curls, few levels come near the budget of triangles.
        for (const std::uint16_t curl : std::array<std::uint16_t, 3>{15'000, 30'000, 45'000}) {
            const CurveSet& set = denseCurves(curl);
            const HairCards cards = cardsOf(set, {.triangles = 3'000, .atlasPx = 1024, .levels = 4});
            for (std::size_t number = 1; number < cards.levels.size(); ++number)
                QVERIFY2(2 * cards.levels[number].triangles() <= cards.levels[number - 1].triangles(),
                         qPrintable(QStringLiteral("%1: %2 after %3")
                                        .arg(curl)
                                        .arg(cards.levels[number].triangles())
                                        .arg(cards.levels[number - 1].triangles())));
        }
    }

    void aLevelMoreChangesNothingOfTheFirst()
    {
        const CurveSet& set = denseCurves(10'000);
        const HairCards alone = cardsOf(set);
        const HairCards first = cardsOf(set, {.triangles = 2'000, .atlasPx = 1024, .levels = 2});
        QCOMPARE(cardMesh(alone, alone.finest(), 0).indices, cardMesh(first, first.finest(), 0).indices);
        QVERIFY(alone.images.alpha() == first.images.alpha());
    }

    void stripsFaceAwayFromTheHead()
    {
        const CurveSet& set = denseCurves(0);
        const HairCards& cards = straightCards();
        const glm::vec3 middle = 0.5F * (set.groups()[0].leastWo + set.groups()[0].greatestWo);
        double outward = 0.0;
        double area = 0.0;
        for (const CardStrip& strip : cards.finest().strips)
            for (const StripNode& node : strip.nodes) {
                const glm::vec3 out = glm::normalize(node.middleWo - middle);
                outward += static_cast<double>(glm::dot(out, node.normalWo) * node.halfWidthM);
                area += static_cast<double>(node.halfWidthM);
            }
        // Hair that stands off the head has no outward side.
        QVERIFY2(outward / area > 0.1, qPrintable(QString::number(outward / area)));
    }

    void noStripCutsThroughTheHead()
    {
        // Hair that lies flat.
        sim::GroomInput::Group group = denseGroup(65535, 0);
        group.settings.greatestLengthM = 0.1F;
        group.maps[sim::MapSlot::Direction] = test::flat(2, {65535, 32768});
        const CurveSet set = curvesOf(frameOf({group}));
        const HairCards cards = cardsOf(set);
        std::size_t inside = 0;
        std::size_t all = 0;
        for (const CardStrip& strip : cards.finest().strips)
            for (std::size_t n = 0; n + 1 < strip.nodes.size(); ++n, ++all) {
                const glm::vec3 middle = 0.5F * (strip.nodes[n].middleWo + strip.nodes[n + 1].middleWo);
                const sim::SurfacePoint near = set.skin()->nearest(middle);
                inside += glm::dot(middle - near.positionHd, near.normalHd) < 0.0F ? 1U : 0U;
            }
        QVERIFY2(inside * 100 < all, qPrintable(QStringLiteral("%1 of %2").arg(inside).arg(all)));
    }

    void stripsDoNotTwist()
    {
        const HairCards cards = cardsOf(denseCurves(20'000));
        std::size_t sharp = 0;
        std::size_t all = 0;
        for (const CardStrip& strip : cards.finest().strips)
            for (std::size_t n = 1; n < strip.nodes.size(); ++n, ++all)
                sharp += turned(strip.nodes[n - 1], strip.nodes[n]) < 0.5F ? 1U : 0U;
        QVERIFY2(sharp * 8 < all, qPrintable(QStringLiteral("%1 of %2").arg(sharp).arg(all)));
    }

    void alphaCoversAsMuchInSmallerLevels()
    {
        const HairCards& cards = straightCards();
        const int size = cards.images.size();
        // The coverage of the whole atlas, whose smaller levels graphics cards make the same way.
        const auto covered = [&](int level) {
            return static_cast<double>(alphaCoverage(cards.images.alpha(), size, {0, 0, size, size}, level));
        };
        const double whole = covered(0);
        const std::array<double, 3> later{covered(1) / whole, covered(2) / whole, covered(3) / whole};
        const QString told = QStringLiteral("%1 %2 %3").arg(later[0]).arg(later[1]).arg(later[2]);
        QVERIFY2(std::abs(later[0] - 1.0) < 0.15 && std::abs(later[1] - 1.0) < 0.15, qPrintable(told));
        // There most patches are two texels across.
        QVERIFY2(std::abs(later[2] - 1.0) < 0.3, qPrintable(told));
    }

    void texelsBesideHairHaveItsColour()
    {
        sim::GroomInput::Group group = denseGroup(65535, 0);
        group.maps[sim::MapSlot::TipColour] = group.maps[sim::MapSlot::Colour];
        HairCards cards = cardsOf(curvesOf(frameOf({group})));
        // The hair is orange, and no texel of another colour shines in from beside it.
        for (const CardTexel& texel : cards.images.texels())
            QVERIFY(texel.colour.r > 200 && texel.colour.g > 90 && texel.colour.g < 170 && texel.colour.b < 10);
    }

    void rootsAreOnTopOfPatches()
    {
        const HairCards& cards = straightCards();
        for (std::size_t i = 0; i < cards.patches.size(); ++i) {
            if (cards.finest().strips[i].flyaway)
                continue;
            const AtlasPatch& patch = cards.patches[i];
            const auto& texels = cards.images.texels();
            const int x = patch.x + patch.width / 2;
            const int top = texels[cards.images.indexOf(x, patch.y + patch.height / 8)].rootToTip;
            const int low = texels[cards.images.indexOf(x, patch.y + patch.height * 7 / 8)].rootToTip;
            QVERIFY2(top < low, qPrintable(QStringLiteral("%1: %2 %3").arg(i).arg(top).arg(low)));
        }
    }

    void bonesHoldEveryVertexAndRootsStayWithTheHead()
    {
        const CurveSet set = curvesOf(frameOf({denseGroup(65535, 0), hairGroup(2, 30'000, 20'000, 0)}));
        const HairCards cards = cardsOf(set, {.triangles = 2'000, .atlasPx = 1024, .springBones = true});
        QVERIFY(cards.bones && cards.bones->chains.size() > 5);
        for (std::size_t i = 0; i < cards.finest().strips.size(); ++i) {
            const BoneChain& chain = cards.bones->chains[cards.finest().chainOf[i]];
            QCOMPARE(chain.group, cards.finest().groups[i]);
            for (const StripNode& node : cards.finest().strips[i].nodes) {
                const BoneWeights own = cards.bones->weightsAt(cards.finest().chainOf[i], node.middleWo);
                QVERIFY(std::abs(own.weights.x + own.weights.y - 1.0F) < 1e-5F && own.weights.x >= 0.0F);
                QVERIFY(std::ranges::all_of(own.joints,
                                            [&](std::size_t joint) { return joint < cards.bones->jointCount(); }));
            }
            const BoneWeights root = cards.bones->weightsAt(cards.finest().chainOf[i], chain.jointsWo.front());
            QVERIFY(root.joints[0] == 0 && root.weights.x == 1.0F);
        }
        const CardMesh mesh = cardMesh(cards, cards.finest(), 0);
        QCOMPARE(mesh.bones.size(), mesh.vertices.size());
        const HairCards stiff = cardsOf(set);
        QVERIFY(cardMesh(stiff, stiff.finest(), 0).bones.empty());
    }

    void hardlyAnyHairIsNoProblem_data()
    {
        QTest::addColumn<int>("hairs");
        QTest::addColumn<double>("lengthM");
        QTest::newRow("one hair") << 1 << 0.2;
        QTest::newRow("two hairs") << 2 << 0.2;
        QTest::newRow("many of 1 mm") << 100'000 << 0.001;
        QTest::newRow("one of 1 mm") << 1 << 0.001;
    }
    void hardlyAnyHairIsNoProblem()
    {
        QFETCH(int, hairs);
        QFETCH(double, lengthM);
        sim::GroomInput::Group group = hairGroup(1, 65535, 65535, 0);
        group.settings.greatestLengthM = static_cast<float>(lengthM);
        const CurveSet set = curvesOf(frameOf({group}), static_cast<std::size_t>(hairs));
        const HairCards cards = cardsOf(set);
        QVERIFY(!cards.patches.empty() && cards.finest().triangles() > 0 &&
                cards.finest().triangles() <= kSmall.triangles);
        QCOMPARE(problemOf(cards), QString());
    }

    void shortHairLiesOnACapOverTheSkin()
    {
        sim::GroomInput::Group group = denseGroup(65535, 0);
        group.settings.greatestLengthM = 0.003F;
        const CurveSet set = curvesOf(frameOf({group}));
        const HairCards cards = cardsOf(set);
        QVERIFY(cards.finest().caps[0] && cards.finest().strips.empty());
        QVERIFY(cards.finest().triangles() > 50 && cards.finest().triangles() <= kSmall.triangles);
        QCOMPARE(problemOf(cards), QString());
        const CardMesh mesh = cardMesh(cards, cards.finest(), 0);
        const sim::Skin& skin = *set.skin();
        for (const CardVertex& vertex : mesh.vertices) {
            const sim::SurfacePoint near = skin.nearest(vertex.position);
            QVERIFY(glm::distance(near.positionHd, vertex.position) < 0.0015F);
            QVERIFY(glm::dot(near.normalHd, vertex.normal) > 0.9F);
            QVERIFY(glm::all(glm::greaterThanEqual(vertex.uv, glm::vec2(0.0F))) &&
                    glm::all(glm::lessThanEqual(vertex.uv, glm::vec2(1.0F))));
        }
        // Seen from outside.
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const CardVertex& a = mesh.vertices[mesh.indices[i]];
            const CardVertex& b = mesh.vertices[mesh.indices[i + 1]];
            const CardVertex& c = mesh.vertices[mesh.indices[i + 2]];
            QVERIFY(glm::dot(glm::cross(b.position - a.position, c.position - a.position), a.normal) >= 0.0F);
        }
        const float covered = alphaCoverage(cards.images.alpha(), cards.images.size(), cards.patches[0], 0);
        QVERIFY2(covered > 0.02F, qPrintable(QString::number(covered)));
    }

    void noHairGivesNoCards()
    {
        const HairCards cards = cardsOf(curvesOf(frameOf({hairGroup(1, 0, 65535, 0)})));
        QVERIFY(cards.finest().strips.empty() && cards.patches.empty());
    }

    void patchesOfManySizesFillTheAtlas_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {1, 2, 7, 100, 3'000, 12'000})
            QTest::newRow(qPrintable(QString::number(count))) << count;
    }
    void patchesOfManySizesFillTheAtlas()
    {
        QFETCH(int, count);
        std::vector<PatchWish> wishes;
        wishes.reserve(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i)
            wishes.push_back({.widthM = 0.001F + 0.0001F * static_cast<float>(i * 7 % 90),
                              .heightM = 0.01F + 0.001F * static_cast<float>(i * 13 % 300)});
        const HairCards cards{
            .levels = {CardLevel{}}, .patches = packedAtlas(wishes, 1024), .images = CardImages(1024)};
        QCOMPARE(problemOf(cards), QString());
        const float filled = filledPart(cards.patches, 1024);
        QVERIFY2(filled >= (count < 10'000 ? 0.7F : 0.4F), qPrintable(QString::number(filled)));
    }
};

HAIRPAINT_TEST(TestHairCards, Core)
#include "test_hair_cards.moc"
