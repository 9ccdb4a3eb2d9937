// Sampling, locks, strips, atlas and baking, one after another.
#include "model/exporting/cards/hair_cards.h"

#include "model/exporting/cards/alpha_coverage.h"
#include "model/exporting/cards/card_baker.h"
#include "model/exporting/cards/skin_clearance.h"
#include "sim/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace hairpaint::model {

namespace {

constexpr double kSampled = 0.2; ///< Of all work.
constexpr double kDivided = 0.5;
constexpr double kBaked = 0.9;
constexpr float kFlyawayPart = 0.06F; ///< Of the triangles.

/// Hairs of each group, and among them those that stray from their lock.
struct Strays
{
    std::vector<std::vector<std::uint32_t>> hairs; ///< By group.
    std::vector<bool> isOne;                       ///< By hair.
};

float rmsAway(std::span<const glm::vec3> places, std::span<const glm::vec3> path)
{
    float sum = 0.0F;
    for (std::size_t i = 0; i < places.size(); ++i)
        sum += glm::dot(places[i] - path[i], places[i] - path[i]);
    return std::sqrt(sum / static_cast<float>(places.size()));
}

std::size_t groupOf(const CurveSet& set, const SampledHair& hair, std::uint32_t i)
{
    return set.curves()[hair.curve[i]].group;
}

Strays straysFrom(const CurveSet& set, const SampledHair& hair, const std::vector<HairLock>& locks)
{
    constexpr float kFar = 2.0F; ///< In spreads of the lock.
    constexpr float kLeastM = 2e-3F;
    Strays strays{.hairs = std::vector<std::vector<std::uint32_t>>(set.groups().size()),
                  .isOne = std::vector<bool>(hair.count())};
    for (const HairLock& lock : locks)
        for (const std::uint32_t i : lock.hairs) {
            const float away = rmsAway(hair.places(i), lock.meanWo);
            if (away < std::max(kFar * lock.spreadM, kLeastM))
                continue;
            strays.isOne[i] = true;
            strays.hairs[groupOf(set, hair, i)].push_back(i);
        }
    return strays;
}

/// Hair that is seen matters more than what lies under it.
std::vector<float> weightsOf(const SampledHair& hair, const HairField& field)
{
    constexpr float kHidden = 0.3F;
    constexpr std::size_t kGrain = 512;
    std::vector<float> weights(hair.count());
    sim::parallelFor(hair.count(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            float open = 0.0F;
            for (const glm::vec3& place : hair.places(i))
                open += field.openness(place) / static_cast<float>(SampledHair::kPlaces);
            weights[i] = kHidden + (1.0F - kHidden) * std::min(2.0F * open, 1.0F);
        }
    });
    return weights;
}

using HairsByGroup = std::vector<std::vector<std::uint32_t>>;

std::vector<CardStrip> stripsOf(const CurveSet& set, const SampledHair& hair, const HairField& field,
                                const HairsByGroup& byGroup, int triangles)
{
    const std::vector<float> weights = weightsOf(hair, field);
    const auto forFlyaways = static_cast<int>(static_cast<float>(triangles) * kFlyawayPart);
    std::vector<HairLock> locks = dividedIntoLocks(hair, byGroup, weights, triangles - forFlyaways);
    Strays strays = straysFrom(set, hair, locks);
    for (HairLock& lock : locks) {
        std::vector<std::uint32_t> staying;
        staying.reserve(lock.hairs.size());
        std::ranges::copy_if(lock.hairs, std::back_inserter(staying),
                             [&strays](std::uint32_t i) { return !strays.isOne[i]; });
        if (!staying.empty())
            lock.hairs = std::move(staying);
    }
    const std::size_t firstFlyaway = locks.size();
    for (HairLock& lock : dividedIntoLocks(hair, std::move(strays.hairs), weights, forFlyaways))
        locks.push_back(std::move(lock));
    std::vector<CardStrip> strips(locks.size());
    sim::parallelFor(locks.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            strips[i] = stripOf(hair, locks[i], field);
            keepAboveSkin(set, strips[i]);
            strips[i].flyaway = i >= firstFlyaway;
        }
    });
    const auto order = [&](const CardStrip& strip) {
        return std::tuple(groupOf(set, hair, strip.hairs.front()), strip.flyaway, strip.openness);
    };
    std::ranges::stable_sort(strips, {}, order);
    return strips;
}

/// Over hair too short for strips, which leaves `byGroup`; the triangles that are left.
int addCaps(const CurveSet& set, const SampledHair& hair, HairsByGroup& byGroup, HairCards& cards, int triangles)
{
    constexpr int kPart = 8; ///< Of the triangles, at most, for each.
    const int most = triangles / kPart;
    cards.caps.resize(byGroup.size());
    for (std::size_t group = 0; group < byGroup.size() && triangles > 2 * most; ++group) {
        const auto isShort = [&hair](std::uint32_t i) { return hair.lengthM[i] < kShortestOnStripsM; };
        std::vector<std::uint32_t> shortHairs;
        std::ranges::copy_if(byGroup[group], std::back_inserter(shortHairs), isShort);
        constexpr std::size_t kFew = 500; // Those are better on strips.
        if (shortHairs.size() < kFew)
            continue;
        cards.caps[group] = capOver(set, hair, std::move(shortHairs), most);
        if (!cards.caps[group])
            continue;
        std::erase_if(byGroup[group], isShort);
        triangles -= static_cast<int>(cards.caps[group]->triangles.size());
    }
    return triangles;
}

std::vector<PatchWish> wishesOf(const HairCards& cards)
{
    std::vector<PatchWish> wishes;
    wishes.reserve(cards.strips.size() + cards.caps.size());
    for (const CardStrip& strip : cards.strips)
        wishes.push_back({.widthM = strip.greatestWidthM(), .heightM = strip.lengthM()});
    for (const std::optional<ScalpCap>& cap : cards.caps)
        if (cap) {
            const glm::vec2 size = cap->greatestM - cap->leastM;
            wishes.push_back({.widthM = size.x, .heightM = size.y});
        }
    return wishes;
}

bool bakeAll(const CurveSet& set, const SampledHair& hair, const HairField& field, HairCards& cards,
             const Progress& progress)
{
    constexpr std::size_t kAtOnce = 64;
    for (std::size_t first = 0; first < cards.strips.size(); first += kAtOnce) {
        if (progress && !progress(kDivided + (kBaked - kDivided) * static_cast<double>(first) /
                                                 static_cast<double>(cards.strips.size())))
            return false;
        const std::size_t count = std::min(kAtOnce, cards.strips.size() - first);
        sim::parallelFor(count, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = first + begin; i < first + end; ++i)
                bakeCard(set, hair, field, cards.strips[i], cards.patches[i], cards.images);
        });
    }
    std::size_t patch = cards.strips.size();
    for (const std::optional<ScalpCap>& cap : cards.caps)
        if (cap)
            bakeCap(set, hair, field, *cap, cards.patches[patch++], cards.images);
    return !progress || progress(kBaked);
}

} // namespace

int HairCards::triangles() const
{
    int sum = 0;
    for (const CardStrip& strip : strips)
        sum += strip.triangles();
    for (const std::optional<ScalpCap>& cap : caps)
        sum += cap ? static_cast<int>(cap->triangles.size()) : 0;
    return sum;
}

std::optional<HairCards> makeCards(const CurveSet& set, const CardSettings& settings, const Progress& progress)
{
    const std::optional<SampledHair> hair =
        sampledHair(set, [&progress](double done) { return !progress || progress(kSampled * done); });
    if (!hair || (progress && !progress(kSampled)))
        return std::nullopt;
    const HairField field(set, *hair);
    HairsByGroup byGroup(set.groups().size());
    for (std::uint32_t i = 0; i < hair->count(); ++i)
        byGroup[groupOf(set, *hair, i)].push_back(i);
    HairCards cards{
        .strips = {}, .groups = {}, .caps = {}, .patches = {}, .images = CardImages(settings.atlasPx), .bones = {}};
    const int left = addCaps(set, *hair, byGroup, cards, settings.triangles);
    cards.strips = stripsOf(set, *hair, field, byGroup, left);
    cards.groups.reserve(cards.strips.size());
    for (const CardStrip& strip : cards.strips)
        cards.groups.push_back(groupOf(set, *hair, strip.hairs.front()));
    if (settings.springBones && !cards.strips.empty())
        cards.bones = bonesFor(*hair, std::move(byGroup), cards.strips);
    cards.patches = packedAtlas(wishesOf(cards), settings.atlasPx);
    if (!bakeAll(set, *hair, field, cards, progress))
        return std::nullopt;
    cards.images.dilate();
    keepAlphaCoverage(cards.images.alpha(), settings.atlasPx, cards.patches);
    if (progress && !progress(1.0))
        return std::nullopt;
    return cards;
}

} // namespace hairpaint::model
