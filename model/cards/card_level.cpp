// Locks, those that stray from them, strips and caps.
#include "model/cards/card_level.h"

#include "model/cards/skin_clearance.h"
#include "sim/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>

namespace hairpaint::model {

namespace {

constexpr float kFlyawayPart = 0.06F; ///< Fraction of the triangles that flyaways get.
constexpr int kCapPart = 8;           ///< A cap gets at most one part in this many of the triangles.

/// Hairs of each group, and among them those that stray from their lock.
struct Strays
{
    std::vector<std::vector<std::uint32_t>> hairs; ///< By group.
    std::vector<bool> isOne;                       ///< By hair.
};

float rmsAway(std::span<const glm::vec3> samples, std::span<const glm::vec3> path)
{
    float sum = 0.0F;
    for (std::size_t i = 0; i < samples.size(); ++i)
        sum += glm::dot(samples[i] - path[i], samples[i] - path[i]);
    return std::sqrt(sum / static_cast<float>(samples.size()));
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
            const float away = rmsAway(hair.samples(i), lock.meanWo);
            if (away < std::max(kFar * lock.spreadM, kLeastM))
                continue;
            strays.isOne[i] = true;
            strays.hairs[groupOf(set, hair, i)].push_back(i);
        }
    return strays;
}

int stripTriangles(const std::vector<HairLock>& locks)
{
    int sum = 0;
    for (const HairLock& lock : locks)
        sum += model::stripTriangles(lock);
    return sum;
}

/// Each group with strays has a flyaway, however few triangles there are: those that are too many for them go back to
/// their locks.
void keepAsFit(std::vector<HairLock>& flyaways, int triangles, Strays& strays)
{
    for (int used = stripTriangles(flyaways); used > triangles && !flyaways.empty(); flyaways.pop_back()) {
        used -= model::stripTriangles(flyaways.back());
        for (const std::uint32_t i : flyaways.back().hairs)
            strays.isOne[i] = false;
    }
}

int flyawayTriangles(int triangles)
{
    return static_cast<int>(static_cast<float>(triangles) * kFlyawayPart);
}

void addStripsAlong(const std::vector<HairLock>& locks, bool flyaway, const CurveSet& set, const SampledHair& hair,
                    const HairField& field, std::vector<CardStrip>& strips)
{
    const std::size_t first = strips.size();
    strips.resize(first + locks.size());
    sim::parallelFor(locks.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            CardStrip& strip = strips[first + i];
            strip = stripOf(hair, locks[i], field);
            keepAboveSkin(set, strip);
            strip.flyaway = flyaway;
        }
    });
}

/// As CardLevel has them.
void sortStrips(const CurveSet& set, const SampledHair& hair, CardLevel& level)
{
    std::ranges::stable_sort(level.strips, {}, [&](const CardStrip& strip) {
        return std::tuple(groupOf(set, hair, strip.hairs.front()), strip.flyaway, strip.openness);
    });
    level.groups.reserve(level.strips.size());
    for (const CardStrip& strip : level.strips)
        level.groups.push_back(groupOf(set, hair, strip.hairs.front()));
}

/// Over hair too short for strips, which leaves `byGroup`; the triangles that are left.
int addCaps(const CurveSet& set, const SampledHair& hair, HairsByGroup& byGroup, CardLevel& level, int triangles)
{
    const int most = triangles / kCapPart;
    level.caps.resize(byGroup.size());
    for (std::size_t group = 0; group < byGroup.size() && triangles > 2 * most; ++group) {
        const auto isShort = [&hair](std::uint32_t i) { return hair.lengthM[i] < kShortestOnStripsM; };
        std::vector<std::uint32_t> shortHairs;
        std::ranges::copy_if(byGroup[group], std::back_inserter(shortHairs), isShort);
        constexpr std::size_t kFew = 500; // Those are better on strips.
        if (shortHairs.size() < kFew)
            continue;
        level.caps[group] = capOver(set, hair, std::move(shortHairs), most);
        if (!level.caps[group])
            continue;
        std::erase_if(byGroup[group], isShort);
        triangles -= static_cast<int>(level.caps[group]->triangles.size());
    }
    return triangles;
}

/// Over the same hair as the finest level's, with the same patch: coarser where so few triangles hold it.
int addCoarserCaps(const CurveSet& set, const SampledHair& hair, const CardLevel& finest, CardLevel& level,
                   int triangles)
{
    const int most = triangles / kCapPart;
    level.caps.resize(finest.caps.size());
    for (std::size_t group = 0; group < finest.caps.size(); ++group) {
        if (!finest.caps[group])
            continue;
        const ScalpCap& fine = *finest.caps[group];
        std::optional<ScalpCap> coarse = capOver(set, hair, fine.hairs, most);
        if (coarse) {
            coarse->leastM = fine.leastM;
            coarse->greatestM = fine.greatestM;
        }
        level.caps[group] = coarse ? std::move(coarse) : fine;
        triangles -= static_cast<int>(level.caps[group]->triangles.size());
    }
    return triangles;
}

/// An even subset of those of the finest level, as they are: wider ones would no longer be single hairs.
void addFewerFlyaways(const CardLevel& finest, int triangles, CardLevel& level)
{
    int all = 0;
    for (const CardStrip& strip : finest.strips)
        all += strip.flyaway ? strip.triangles() : 0;
    const int step = triangles > 0 ? (all + triangles - 1) / triangles : all;
    int number = 0;
    for (const CardStrip& strip : finest.strips)
        if (strip.flyaway && number++ % std::max(step, 1) == 0 && strip.triangles() <= triangles) {
            level.strips.push_back(strip);
            triangles -= strip.triangles();
        }
}

/// Those that do not stray from their locks in the finest level.
HairsByGroup hairsInLocks(const HairsByGroup& byGroup, const CardLevel& finest, std::size_t hairs)
{
    std::vector<bool> strays(hairs);
    for (const CardStrip& strip : finest.strips)
        if (strip.flyaway)
            for (const std::uint32_t i : strip.hairs)
                strays[i] = true;
    HairsByGroup kept = byGroup;
    for (std::size_t group = 0; group < kept.size(); ++group) {
        std::erase_if(kept[group], [&strays](std::uint32_t i) { return strays[i]; });
        if (kept[group].empty()) // Where a group has very few hairs, all of them may be strays.
            kept[group] = byGroup[group];
    }
    return kept;
}

/// By strip of `level`: the strip of `finest` that has most of its hairs.
std::vector<std::size_t> nearestStrips(const CardLevel& finest, const CardLevel& level, std::size_t hairs)
{
    constexpr auto kNone = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> stripOfHair(hairs, kNone);
    for (std::size_t strip = finest.strips.size(); strip-- > 0;) // What strays from a lock of few may be on two.
        for (const std::uint32_t i : finest.strips[strip].hairs)
            stripOfHair[i] = strip;
    std::vector<std::size_t> nearest;
    nearest.reserve(level.strips.size());
    std::vector<std::size_t> votes(finest.strips.size());
    for (const CardStrip& strip : level.strips) {
        std::size_t best = stripOfHair[strip.hairs.front()];
        for (const std::uint32_t i : strip.hairs)
            if (++votes[stripOfHair[i]] > votes[best])
                best = stripOfHair[i];
        for (const std::uint32_t i : strip.hairs)
            votes[stripOfHair[i]] = 0;
        nearest.push_back(best);
    }
    return nearest;
}

} // namespace

int CardLevel::triangles() const
{
    int sum = 0;
    for (const CardStrip& strip : strips)
        sum += strip.triangles();
    for (const std::optional<ScalpCap>& cap : caps)
        sum += cap ? static_cast<int>(cap->triangles.size()) : 0;
    return sum;
}

// Hair that is seen matters more than what lies under it.
std::vector<float> hairWeights(const SampledHair& hair, const HairField& field)
{
    constexpr float kHidden = 0.3F;
    constexpr std::size_t kGrain = 512;
    std::vector<float> weights(hair.count());
    sim::parallelFor(hair.count(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            float open = 0.0F;
            for (const glm::vec3& sample : hair.samples(i))
                open += field.openness(sample) / static_cast<float>(SampledHair::kSamples);
            weights[i] = kHidden + (1.0F - kHidden) * std::min(2.0F * open, 1.0F);
        }
    });
    return weights;
}

CardLevel finestLevel(const CurveSet& set, const SampledHair& hair, const HairField& field,
                      std::span<const float> weights, HairsByGroup& byGroup, int triangles)
{
    CardLevel level;
    const int left = addCaps(set, hair, byGroup, level, triangles);
    const int forFlyaways = flyawayTriangles(left);
    std::vector<HairLock> locks = dividedIntoLocks(hair, byGroup, weights, left - forFlyaways);
    Strays strays = straysFrom(set, hair, locks);
    std::vector<HairLock> flyaways = dividedIntoLocks(hair, std::move(strays.hairs), weights, forFlyaways);
    keepAsFit(flyaways, left - stripTriangles(locks), strays);
    for (HairLock& lock : locks) {
        std::vector<std::uint32_t> staying;
        staying.reserve(lock.hairs.size());
        std::ranges::copy_if(lock.hairs, std::back_inserter(staying),
                             [&strays](std::uint32_t i) { return !strays.isOne[i]; });
        if (!staying.empty())
            lock.hairs = std::move(staying);
    }
    addStripsAlong(locks, false, set, hair, field, level.strips);
    addStripsAlong(flyaways, true, set, hair, field, level.strips);
    sortStrips(set, hair, level);
    level.patchOf.resize(level.strips.size());
    std::iota(level.patchOf.begin(), level.patchOf.end(), std::size_t{0});
    return level;
}

CardLevel coarserLevel(const CurveSet& set, const SampledHair& hair, const HairField& field,
                       std::span<const float> weights, const HairsByGroup& byGroup, const CardLevel& finest,
                       int triangles)
{
    CardLevel level;
    const int left = addCoarserCaps(set, hair, finest, level, triangles);
    const int forFlyaways = flyawayTriangles(left);
    addFewerFlyaways(finest, forFlyaways, level);
    const std::vector<HairLock> locks =
        dividedIntoLocks(hair, hairsInLocks(byGroup, finest, hair.count()), weights, left - forFlyaways);
    addStripsAlong(locks, false, set, hair, field, level.strips);
    sortStrips(set, hair, level);
    level.patchOf = nearestStrips(finest, level, hair.count());
    return level;
}

} // namespace hairpaint::model
