// Sampling, locks, strips, atlas and baking, one after another.
#include "model/exporting/cards/hair_cards.h"

#include "model/exporting/cards/card_baker.h"
#include "sim/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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

std::vector<CardStrip> stripsOf(const CurveSet& set, const SampledHair& hair, const HairField& field, int triangles)
{
    const std::vector<float> weights = weightsOf(hair, field);
    std::vector<std::vector<std::uint32_t>> byGroup(set.groups().size());
    for (std::uint32_t i = 0; i < hair.count(); ++i)
        byGroup[groupOf(set, hair, i)].push_back(i);
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
            strips[i].flyaway = i >= firstFlyaway;
        }
    });
    const auto order = [&](const CardStrip& strip) {
        return std::tuple(groupOf(set, hair, strip.hairs.front()), strip.flyaway, strip.openness);
    };
    std::ranges::stable_sort(strips, {}, order);
    return strips;
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
    return !progress || progress(kBaked);
}

} // namespace

int HairCards::triangles() const
{
    return std::accumulate(strips.begin(), strips.end(), 0,
                           [](int sum, const CardStrip& strip) { return sum + strip.triangles(); });
}

std::optional<HairCards> makeCards(const CurveSet& set, const CardSettings& settings, const Progress& progress)
{
    const std::optional<SampledHair> hair =
        sampledHair(set, [&progress](double done) { return !progress || progress(kSampled * done); });
    if (!hair || (progress && !progress(kSampled)))
        return std::nullopt;
    const HairField field(set, *hair);
    HairCards cards{.strips = stripsOf(set, *hair, field, settings.triangles),
                    .patches = {},
                    .groups = {},
                    .images = CardImages(settings.atlasPx)};
    std::vector<PatchWish> wishes;
    wishes.reserve(cards.strips.size());
    cards.groups.reserve(cards.strips.size());
    for (const CardStrip& strip : cards.strips) {
        wishes.push_back({.widthM = strip.greatestWidthM(), .heightM = strip.lengthM()});
        cards.groups.push_back(groupOf(set, *hair, strip.hairs.front()));
    }
    cards.patches = packedAtlas(wishes, settings.atlasPx);
    if (!bakeAll(set, *hair, field, cards, progress))
        return std::nullopt;
    cards.images.keepCoverage(cards.patches);
    cards.images.dilate();
    if (progress && !progress(1.0))
        return std::nullopt;
    return cards;
}

} // namespace hairpaint::model
