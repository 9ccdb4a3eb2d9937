// Patches by their texels, roots by greedy spacing and a few steps of Lloyd's method.
#include "sim/groom/braid_layout.h"

#include "sim/base/parallel.h"
#include "sim/groom/braid_path.h"
#include "sim/groom/strand_curve.h"
#include "sim/groom/strand_style.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace hairpaint::sim {

namespace {

constexpr std::uint32_t kSampledRanks = 32768; ///< Roots are chosen among these, which cover the skin evenly,
constexpr std::size_t kFewSampled = 32;        ///< and where a patch has fewer of them, among all of its hairs.
/// Greatest number in a patch; bounds the time that a tiny spacing would take.
constexpr std::size_t kMostBraids = 256;
constexpr int kLloydSteps = 4;
constexpr float kShortestM = 0.005F;
constexpr std::size_t kHairsAtOnce = 4096;

/// Greatest radius of a braid along a strip of that width. On a narrow strip it keeps within 6 mm of the skin; on a
/// wide one it is as thick as its hair makes it, as a braid that lies around the head is.
float greatestRowRadiusM(float widthM)
{
    constexpr float kCornrowM = 0.002F;
    constexpr float kNarrowM = 0.016F;
    constexpr float kOfFurther = 0.25F;
    return std::max(kCornrowM, kOfFurther * (widthM - kNarrowM));
}

float squaredDistance(glm::vec3 a, glm::vec3 b)
{
    const glm::vec3 away = a - b;
    return glm::dot(away, away);
}

std::size_t nearestOf(std::span<const glm::vec3> points, glm::vec3 to)
{
    return static_cast<std::size_t>(
        std::ranges::min_element(points, {}, [to](glm::vec3 point) { return squaredDistance(point, to); }) -
        points.begin());
}

std::uint16_t texelOf(const RasterTile& tile, std::size_t texel)
{
    return tile.isUniform() ? tile.uniform[0] : tile.pixels[texel];
}

/// A tile of the braid map without what is painted on bare skin.
RasterTilePtr lacedTile(const TiledRaster& braid, const TiledRaster& density, int index)
{
    static const RasterTilePtr bare = std::make_shared<const RasterTile>();
    const RasterTilePtr& painted = braid.tile(index);
    if (painted->isUniform() && painted->uniform[0] == 0)
        return bare;
    const bool isSameSize = braid.size() == density.size();
    if (isSameSize && density.tile(index)->isUniform())
        return density.tile(index)->uniform[0] > 0 ? painted : bare;
    RasterTile laced;
    laced.pixels.resize(kTileTexels);
    const TexelRect rect = braid.tileRect(index);
    const auto size = static_cast<float>(braid.size());
    for (std::size_t texel = 0; texel < kTileTexels; ++texel) {
        const auto x = static_cast<float>(rect.x0 + static_cast<int>(texel % TiledRaster::kTileSize)) + 0.5F;
        const auto y = static_cast<float>(rect.y0 + static_cast<int>(texel / TiledRaster::kTileSize)) + 0.5F;
        const bool isBare = isSameSize ? texelOf(*density.tile(index), texel) == 0
                                       : !(density.sampleScalar({x / size, 1.0F - y / size}) > 0.0F);
        laced.pixels[texel] = isBare ? std::uint16_t{0} : texelOf(*painted, texel);
    }
    return std::make_shared<const RasterTile>(folded(std::move(laced)));
}

/// The patch of a hair: that of its texel, or of one beside it where its own is bare.
std::optional<std::size_t> patchAt(const PatchLabels& labels, glm::vec2 uv, std::uint8_t kind, float texel)
{
    const auto isOfKind = [&](std::optional<std::size_t> patch) {
        return patch && static_cast<std::uint8_t>(braidKindOf(labels.patches()[*patch].kind)) == kind;
    };
    if (const std::optional<std::size_t> own = labels.at(uv); isOfKind(own))
        return own;
    for (int ring = 1; ring <= 2; ++ring)
        for (int y = -ring; y <= ring; ++y)
            for (int x = -ring; x <= ring; ++x) {
                const std::optional<std::size_t> beside = labels.at(uv + glm::vec2(x, y) * texel);
                if (isOfKind(beside))
                    return beside;
            }
    return std::nullopt;
}

/// Three significant bits: a braid's thickness follows its hairs by steps, so that not each of them changes all.
std::uint32_t rounded(std::uint32_t count)
{
    const int dropped = std::max(static_cast<int>(std::bit_width(count)) - 3, 0);
    return count >> dropped << dropped;
}

/// Radius r of a braid that `hairs` fill as densely as a real one.
float filledRadiusM(const GroupSettings& settings, BraidKind kind, std::uint32_t hairs)
{
    constexpr float kWidthsPerRadius = 0.31F; // A wisp's radius over the width of all its hairs side by side.
    const BraidLacing lacing = lacingOf(kind);
    return kWidthsPerRadius * settings.material.widthM * static_cast<float>(rounded(hairs)) /
           (static_cast<float>(lacing.wisps) * lacing.wisp);
}

/// Where braids are to stand, by greedy spacing in the order of ranks, each prefix of which is an even cover, and
/// Lloyd's method.
std::vector<glm::vec3> middlesOf(const RootSet& roots, std::span<const std::uint32_t> sample, float spacingM)
{
    std::vector<glm::vec3> middles;
    for (const std::uint32_t slot : sample) {
        const glm::vec3 at = roots.positionHd[slot];
        const bool isFar = std::ranges::all_of(
            middles, [&](glm::vec3 middle) { return squaredDistance(middle, at) >= spacingM * spacingM; });
        if (isFar && middles.size() < kMostBraids)
            middles.push_back(at);
    }
    for (int step = 0; step < kLloydSteps; ++step) {
        std::vector<glm::vec3> sums(middles.size(), glm::vec3(0.0F));
        std::vector<float> members(middles.size(), 0.0F);
        for (const std::uint32_t slot : sample) {
            const std::size_t cell = nearestOf(middles, roots.positionHd[slot]);
            sums[cell] += roots.positionHd[slot];
            members[cell] += 1.0F;
        }
        for (std::size_t i = 0; i < middles.size(); ++i)
            if (members[i] > 0.0F)
                middles[i] = sums[i] / members[i];
    }
    return middles;
}

} // namespace

void BraidLayout::startOver()
{
    m_braids.clear();
    m_braidOfSlot.clear();
    m_braid.reset();
    m_density.reset();
    m_laced.reset();
}

bool BraidLayout::update(const Inputs& inputs, SlotSet& dirty)
{
    const bool otherPatches = updateLabels(inputs);
    const std::vector<Braid> before = m_braids;
    const std::vector<std::uint32_t> braidBefore = m_braidOfSlot;
    if (otherPatches || inputs.otherKinds) {
        m_braids.clear();
        m_middlesHd.clear();
        sortByPatch(inputs);
        m_firstBraid.assign(1, 0);
        for (std::size_t patch = 0; patch + 1 < m_firstMember.size(); ++patch) {
            plant(inputs, m_firstMember[patch], m_firstMember[patch + 1]);
            m_firstBraid.push_back(static_cast<std::uint32_t>(m_braids.size()));
        }
        borrowBasis(inputs);
        assignHairs(inputs);
    }
    measure(inputs);
    const bool otherLayout = m_braidOfSlot != braidBefore;
    if (m_braids == before && !otherLayout)
        return false;
    const std::size_t count = std::max(m_braidOfSlot.size(), braidBefore.size());
    parallelFor(dirty.chunkCount(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t slot = begin * kChunkSlots; slot < std::min(end * kChunkSlots, count); ++slot) {
            const std::uint32_t was = braidBefore.empty() ? kNoCentre : braidBefore[slot];
            const std::uint32_t is = m_braidOfSlot.empty() ? kNoCentre : m_braidOfSlot[slot];
            if (was == kNoCentre && is == kNoCentre)
                continue;
            if (was == kNoCentre || is == kNoCentre || before[was] != m_braids[is])
                dirty.insert(static_cast<std::uint32_t>(slot));
        }
    });
    return true;
}

bool BraidLayout::updateLabels(const Inputs& inputs)
{
    if (!m_laced && !inputs.otherKinds)
        return false; // Still none is to be braided.
    const bool isSame = m_laced && inputs.braid == m_braid && inputs.density == m_density;
    if (isSame || std::ranges::all_of(inputs.kinds, [](std::uint8_t kind) { return kind == 0; })) {
        if (!isSame)
            m_laced.reset();
        return false;
    }
    if (!m_islands || m_islands->skin() != inputs.roots.skin || m_islands->size() != inputs.braid->size())
        m_islands = std::make_shared<const SkinIslands>(inputs.roots.skin, inputs.braid->size());
    const bool isNew = !m_laced || m_laced->size() != inputs.braid->size();
    auto laced =
        isNew ? std::make_shared<TiledRaster>(inputs.braid->size(), 1) : std::make_shared<TiledRaster>(*m_laced);
    const bool isSameSize = inputs.braid->size() == inputs.density->size();
    bool differs = isNew;
    for (int tile = 0; tile < laced->tileCount(); ++tile) {
        if (!isNew && inputs.braid->tile(tile) == m_braid->tile(tile) &&
            (isSameSize ? inputs.density->tile(tile) == m_density->tile(tile) : inputs.density == m_density))
            continue;
        RasterTilePtr made = lacedTile(*inputs.braid, *inputs.density, tile);
        if (made == laced->tile(tile) || sameTexels(*made, *laced->tile(tile)))
            continue;
        laced->setTile(tile, std::move(made));
        differs = true;
    }
    m_braid = inputs.braid;
    m_density = inputs.density;
    if (!differs)
        return false;
    m_laced = std::move(laced);
    m_labels.update(m_laced, m_islands);
    return true;
}

void BraidLayout::sortByPatch(const Inputs& inputs)
{
    const std::size_t count = inputs.roots.count();
    std::vector<std::uint32_t> patchOf(count, kNoCentre);
    m_members.clear();
    m_firstMember.assign(1, 0);
    if (!m_laced)
        return;
    const float texel = 1.0F / static_cast<float>(m_laced->size());
    parallelFor(count, kHairsAtOnce, [&](std::size_t begin, std::size_t end) {
        for (std::size_t slot = begin; slot < end; ++slot)
            if (inputs.kinds[slot] != 0)
                if (const auto patch = patchAt(m_labels, inputs.roots.uv[slot], inputs.kinds[slot], texel))
                    patchOf[slot] = static_cast<std::uint32_t>(*patch);
    });
    m_firstMember.assign(m_labels.patches().size() + 1, 0);
    for (const std::uint32_t patch : patchOf)
        if (patch != kNoCentre)
            ++m_firstMember[patch + 1];
    for (std::size_t patch = 1; patch < m_firstMember.size(); ++patch)
        m_firstMember[patch] += m_firstMember[patch - 1];
    m_members.resize(m_firstMember.back());
    std::vector<std::uint32_t> next(m_firstMember.begin(), m_firstMember.end() - 1);
    for (std::size_t slot = 0; slot < count; ++slot)
        if (patchOf[slot] != kNoCentre)
            m_members[next[patchOf[slot]]++] = static_cast<std::uint32_t>(slot);
}

void BraidLayout::plant(const Inputs& inputs, std::size_t begin, std::size_t end)
{
    if (begin == end)
        return;
    const RootSet& roots = inputs.roots;
    const std::span<const std::uint32_t> members = std::span(m_members).subspan(begin, end - begin);
    std::vector<std::uint32_t> sample;
    std::ranges::copy_if(members, std::back_inserter(sample),
                         [&](std::uint32_t slot) { return roots.rankOfSlot[slot] < kSampledRanks; });
    if (sample.size() < kFewSampled)
        sample.assign(members.begin(), members.end());
    std::ranges::sort(sample, {}, [&](std::uint32_t slot) { return roots.rankOfSlot[slot]; });
    const auto first = m_braids.size();
    const auto painted = static_cast<BraidKind>(inputs.kinds[members.front()]);
    if (painted == BraidKind::Cornrow) {
        auto row = std::make_shared<const BraidRow>(rowAlong(roots, sample));
        m_middlesHd.push_back(row->pointsHd.back());
        m_braids.push_back({.kind = lacedKind(painted), .row = std::move(row)});
    } else {
        for (const glm::vec3 middle : middlesOf(roots, sample, inputs.settings.braidSpacingM)) {
            m_middlesHd.push_back(middle);
            m_braids.push_back({.kind = painted});
        }
    }
    // The hair nearest to the middle, or the solved hair of the same cell that is nearest to that, if it is about
    // there.
    constexpr float kAboutThere = 1.5F; // Greatest distance of such a solved hair, over the solved hairs' spacing.
    constexpr float kFar = std::numeric_limits<float>::max();
    const float aboutM =
        kAboutThere * std::sqrt(static_cast<float>(roots.skin->areaM2()) / static_cast<float>(roots.basisSlot.size()));
    const std::span<const glm::vec3> middles = std::span(m_middlesHd).subspan(first);
    std::vector<std::size_t> cells;
    std::vector<float> nearest(middles.size(), kFar);
    for (const std::uint32_t slot : sample) {
        const std::size_t cell = cells.emplace_back(nearestOf(middles, roots.positionHd[slot]));
        const float squared = squaredDistance(middles[cell], roots.positionHd[slot]);
        if (squared < nearest[cell]) {
            nearest[cell] = squared;
            m_braids[first + cell].root = slot;
            m_braids[first + cell].basis = kNoCentre;
        }
    }
    std::vector<float> nearestSolved(middles.size(), aboutM * aboutM);
    std::vector<std::uint32_t> solved(middles.size(), kNoCentre);
    for (std::size_t i = 0; i < sample.size(); ++i) {
        const std::uint32_t basis = roots.neighbours[sample[i]][0];
        if (roots.basisSlot[basis] != sample[i])
            continue;
        const std::size_t cell = cells[i];
        const float squared =
            squaredDistance(roots.positionHd[m_braids[first + cell].root], roots.positionHd[sample[i]]);
        if (squared < nearestSolved[cell]) {
            nearestSolved[cell] = squared;
            solved[cell] = basis;
        }
    }
    for (std::size_t i = 0; i < middles.size(); ++i)
        if (solved[i] != kNoCentre) {
            m_braids[first + i].basis = solved[i];
            m_braids[first + i].root = roots.basisSlot[solved[i]];
        }
    // A cell without a hair in the sample: its braid would have none.
    for (std::size_t i = middles.size(); i-- > 0;)
        if (nearest[i] == kFar) {
            m_braids.erase(m_braids.begin() + static_cast<std::ptrdiff_t>(first + i));
            m_middlesHd.erase(m_middlesHd.begin() + static_cast<std::ptrdiff_t>(first + i));
        }
}

/// Braids without a solved hair of their own borrow one from beside them that no other follows.
void BraidLayout::borrowBasis(const Inputs& inputs)
{
    const RootSet& roots = inputs.roots;
    std::vector<std::uint8_t> taken(roots.basisSlot.size(), 0);
    for (const Braid& braid : m_braids)
        if (braid.basis != kNoCentre)
            taken[braid.basis] = 1;
    for (Braid& braid : m_braids) {
        if (braid.basis != kNoCentre)
            continue;
        const auto& nearest = roots.neighbours[braid.root];
        const auto isFree = [&](std::uint32_t basis) { return taken[basis] == 0; };
        braid.basis = nearest[0];
        if (const auto* const free = std::ranges::find_if(nearest, isFree); free != nearest.end()) {
            braid.basis = *free;
        } else {
            for (const std::uint32_t basis : nearest) {
                const auto& next = roots.neighbours[roots.basisSlot[basis]];
                if (const auto* const beyond = std::ranges::find_if(next, isFree); beyond != next.end()) {
                    braid.basis = *beyond;
                    break;
                }
            }
        }
        taken[braid.basis] = 1;
    }
}

void BraidLayout::assignHairs(const Inputs& inputs)
{
    if (m_braids.empty()) {
        m_braidOfSlot.clear();
        m_hairCount.clear();
        return;
    }
    const RootSet& roots = inputs.roots;
    m_braidOfSlot.assign(roots.count(), kNoCentre);
    for (std::size_t patch = 0; patch + 1 < m_firstMember.size(); ++patch) {
        std::vector<glm::vec3> rootsHd;
        for (std::uint32_t i = m_firstBraid[patch]; i < m_firstBraid[patch + 1]; ++i)
            rootsHd.push_back(roots.positionHd[m_braids[i].root]);
        if (rootsHd.empty())
            continue;
        const std::size_t first = m_firstMember[patch];
        parallelFor(m_firstMember[patch + 1] - first, kHairsAtOnce, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = first + begin; i < first + end; ++i)
                m_braidOfSlot[m_members[i]] =
                    m_firstBraid[patch] +
                    static_cast<std::uint32_t>(nearestOf(rootsHd, roots.positionHd[m_members[i]]));
        });
    }
    m_hairCount.assign(m_braids.size(), 0);
    for (const std::uint32_t slot : m_members)
        ++m_hairCount[m_braidOfSlot[slot]];
}

void BraidLayout::measure(const Inputs& inputs)
{
    for (std::size_t i = 0; i < m_braids.size(); ++i) {
        Braid& braid = m_braids[i];
        const bool isOwn = inputs.roots.basisSlot[braid.basis] == braid.root;
        braid.lengthM =
            isOwn ? inputs.basisLengthM[braid.basis]
                  : std::max(lengthOf(inputs.settings, inputs.length.scalar(inputs.roots.uv[braid.root])), kShortestM);
        const float lacedM = braid.lengthM + (braid.row ? braid.row->lengthM : 0.0F);
        braid.radiusM =
            std::min(braidRadiusM(inputs.settings, lacedM), filledRadiusM(inputs.settings, braid.kind, m_hairCount[i]));
        if (braid.row)
            braid.radiusM = std::min(braid.radiusM, greatestRowRadiusM(braid.row->widthM));
    }
}

} // namespace hairpaint::sim
