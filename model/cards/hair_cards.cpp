// Sampling, levels, atlas and baking, one after another.
#include "model/cards/hair_cards.h"

#include "model/cards/alpha_coverage.h"
#include "model/cards/card_baker.h"
#include "sim/base/parallel.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

/// Fractions of all work that are done once hairs are sampled, locks divided and textures baked.
constexpr double kSampled = 0.2;
constexpr double kDivided = 0.5;
constexpr double kBaked = 0.9;

std::vector<PatchWish> wishesOf(const CardLevel& level)
{
    std::vector<PatchWish> wishes;
    wishes.reserve(level.strips.size() + level.caps.size());
    for (const CardStrip& strip : level.strips)
        wishes.push_back({.widthM = strip.greatestWidthM(), .heightM = strip.lengthM()});
    for (const std::optional<ScalpCap>& cap : level.caps)
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
    const CardLevel& level = cards.finest();
    for (std::size_t first = 0; first < level.strips.size(); first += kAtOnce) {
        if (progress && !progress(kDivided + (kBaked - kDivided) * static_cast<double>(first) /
                                                 static_cast<double>(level.strips.size())))
            return false;
        const std::size_t count = std::min(kAtOnce, level.strips.size() - first);
        sim::parallelFor(count, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = first + begin; i < first + end; ++i)
                bakeCard(set, hair, field, level.strips[i], cards.patches[i], cards.images);
        });
    }
    std::size_t patch = level.strips.size();
    for (const std::optional<ScalpCap>& cap : level.caps)
        if (cap)
            bakeCap(set, hair, field, *cap, cards.patches[patch++], cards.images);
    return !progress || progress(kBaked);
}

/// False where `progress` cancels.
bool addLevels(const CurveSet& set, const SampledHair& hair, const HairField& field, const CardSettings& settings,
               const Progress& progress, HairCards& cards)
{
    HairsByGroup byGroup(set.groups().size());
    for (std::uint32_t i = 0; i < hair.count(); ++i)
        byGroup[set.curves()[hair.curve[i]].group].push_back(i);
    const std::vector<float> weights = hairWeights(hair, field);
    int triangles = settings.triangles;
    for (int number = 0; number < settings.levels; ++number, triangles /= 2) {
        if (progress && !progress(kSampled + (kDivided - kSampled) * number / settings.levels))
            return false;
        cards.levels.push_back(number == 0
                                   ? finestLevel(set, hair, field, weights, byGroup, triangles)
                                   : coarserLevel(set, hair, field, weights, byGroup, cards.finest(), triangles));
        triangles = cards.levels.back().triangles(); // Half of what it has, not of what it might have.
    }
    if (!settings.springBones || cards.finest().strips.empty())
        return true;
    cards.bones = bonesFor(hair, std::move(byGroup));
    for (CardLevel& level : cards.levels) {
        level.chainOf.reserve(level.strips.size());
        for (const CardStrip& strip : level.strips)
            level.chainOf.push_back(cards.bones->chainFor(strip));
    }
    return true;
}

} // namespace

const AtlasPatch& HairCards::capPatch(std::size_t group) const
{
    const std::vector<std::optional<ScalpCap>>& caps = finest().caps;
    const auto before = std::count_if(caps.begin(), caps.begin() + static_cast<std::ptrdiff_t>(group),
                                      [](const std::optional<ScalpCap>& cap) { return cap.has_value(); });
    return patches[finest().strips.size() + static_cast<std::size_t>(before)];
}

std::optional<HairCards> makeCards(const CurveSet& set, const CardSettings& settings, const Progress& progress)
{
    const std::optional<SampledHair> hair =
        sampledHair(set, [&progress](double done) { return !progress || progress(kSampled * done); });
    if (!hair)
        return std::nullopt;
    const HairField field(set, *hair);
    HairCards cards{.levels = {}, .patches = {}, .images = CardImages(settings.atlasPx)};
    if (!addLevels(set, *hair, field, settings, progress, cards))
        return std::nullopt;
    cards.patches = packedAtlas(wishesOf(cards.finest()), settings.atlasPx);
    if (!bakeAll(set, *hair, field, cards, progress))
        return std::nullopt;
    cards.images.dilate();
    keepAlphaCoverage(cards.images.alpha(), settings.atlasPx, cards.patches);
    if (progress && !progress(1.0))
        return std::nullopt;
    return cards;
}

} // namespace hairpaint::model
