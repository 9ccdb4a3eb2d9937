// Texels by nearest root, then corrected by what each cut root should read.
#include "model/tools/cutting/cut_lengths.h"

#include "model/values/texel_math.h"
#include "sim/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace hairpaint::model {

namespace {

constexpr float kSpacings = 2.0F; ///< How far a root's texels may lie from it, in mean spacings of roots.
constexpr float kLeastReachTx = 2.0F, kMostReachTx = 16.0F;

/// A texel becomes no less than this fraction of what the shortest of the cut hairs that read it asks for, though it
/// may matter little to them: hair that is planted there later is read from it, too.
constexpr float kLeastOfWanted = 0.5F;
/// Limit on a texel's value over its former one, so that hair beside the cut keeps its length.
constexpr float kMostOfBefore = 1.15F;

} // namespace

CutLengths::CutLengths(const sim::GroupFrame& hair, sim::MapRaster shown, const StrandLengths& lengths)
    : m_shown(std::move(shown))
{
    const sim::Groom& groom = *hair.groom;
    const sim::RootSet& roots = *groom.roots;
    m_shortestM = groom.settings.shortestLengthM;
    m_rangeM = std::max(groom.settings.greatestLengthM - m_shortestM, 1e-6F);
    const int size = m_shown->size();
    const auto tileOf = [&](std::size_t slot) {
        const glm::ivec2 first = sim::TiledRaster::footprint(roots.uv[slot], size);
        return static_cast<std::size_t>(m_shown->tileIndexAt(first.x, first.y));
    };
    const auto tileCount = static_cast<std::size_t>(m_shown->tileCount());
    m_firstOfTile.assign(tileCount + 1, 0);
    for (std::size_t slot = 0; slot < roots.count(); ++slot)
        if (hair.isPositioned(slot))
            ++m_firstOfTile[tileOf(slot) + 1];
    std::partial_sum(m_firstOfTile.begin(), m_firstOfTile.end(), m_firstOfTile.begin());
    m_roots.resize(m_firstOfTile.back());
    m_kept.assign(m_roots.size(), 1.0F);
    m_rootOfSlot.assign(roots.count(), kNone);
    std::vector<std::uint32_t> next(m_firstOfTile.begin(), m_firstOfTile.end() - 1);
    for (std::size_t slot = 0; slot < roots.count(); ++slot) {
        if (!hair.isPositioned(slot))
            continue;
        const std::uint32_t root = next[tileOf(slot)]++;
        const glm::vec2 uv = roots.uv[slot];
        const glm::ivec2 first = sim::TiledRaster::footprint(uv, size);
        const glm::vec2 position = glm::vec2(uv.x, 1.0F - uv.y) * static_cast<float>(size) - 0.5F;
        m_roots[root] = {.slot = static_cast<std::uint32_t>(slot),
                         .isBaby = lengths.isBaby(static_cast<std::uint32_t>(slot)),
                         .first = first,
                         .fraction = glm::clamp(position - glm::vec2(first), 0.0F, 1.0F)};
        m_rootOfSlot[slot] = root;
    }
    m_workOfTile.assign(tileCount, -1);
    m_owners.resize(tileCount);
    m_reachTx.resize(tileCount);
    const int across = m_shown->tilesAcross();
    for (int tile = 0; tile < static_cast<int>(tileCount); ++tile) {
        std::uint32_t most = 1; // Where hair ends in a tile, roots are no further apart than in the next one.
        for (int y = std::max(tile / across - 1, 0); y <= std::min(tile / across + 1, across - 1); ++y)
            for (int x = std::max(tile % across - 1, 0); x <= std::min(tile % across + 1, across - 1); ++x) {
                const std::size_t beside =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(across) + static_cast<std::size_t>(x);
                most = std::max(most, m_firstOfTile[beside + 1] - m_firstOfTile[beside]);
            }
        m_reachTx[static_cast<std::size_t>(tile)] = std::clamp(
            kSpacings * static_cast<float>(kTile) / std::sqrt(static_cast<float>(most)), kLeastReachTx, kMostReachTx);
    }
}

/// As a texel's value, 0..65535, which stays or becomes less.
float CutLengths::cutValue(float value, float kept) const
{
    const float lengthM = m_shortestM + m_rangeM * value / 65535.0F;
    return std::clamp((lengthM * kept - m_shortestM) / m_rangeM * 65535.0F, 0.0F, value);
}

void CutLengths::cut(std::span<const StrandCut> cuts, bool spares)
{
    for (const std::uint32_t root : m_cutRoots)
        m_kept[root] = 1.0F;
    m_cutRoots.clear();
    for (const StrandCut& one : cuts) {
        const std::uint32_t root = m_rootOfSlot[one.slot];
        if (root == kNone || !(one.kept < m_kept[root]))
            continue;
        m_kept[root] = std::max(one.kept, 0.0F);
    }
    for (std::uint32_t root = 0; root < m_kept.size(); ++root)
        if (m_kept[root] < 1.0F)
            m_cutRoots.push_back(root);
    findTiles();
    sim::parallelFor(m_works.size(), 1, [this](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (m_owners[static_cast<std::size_t>(m_works[i].tile)].empty())
                findOwners(m_works[i].tile);
            divide(m_works[i]);
        }
    });
    correct(spares);
    sim::parallelFor(m_works.size(), 8, [this](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t texel = 0; texel < sim::kTileTexels; ++texel) {
                m_works[i].mask[texel] = m_works[i].texels[texel].mayChange ? 65535 : 0;
                m_works[i].values[texel] = unit16(m_works[i].texels[texel].value / 65535.0F);
            }
    });
}

void CutLengths::findTiles()
{
    for (const int tile : m_tiles)
        m_workOfTile[static_cast<std::size_t>(tile)] = -1;
    m_tiles.clear();
    const int across = m_shown->tilesAcross();
    for (const std::uint32_t root : m_cutRoots) {
        const glm::ivec2 first = m_roots[root].first;
        const int reach =
            static_cast<int>(std::ceil(m_reachTx[static_cast<std::size_t>(m_shown->tileIndexAt(first.x, first.y))]));
        const int last = m_shown->size() - 1;
        for (int y = std::max(first.y - reach, 0) / kTile; y <= std::min(first.y + 1 + reach, last) / kTile; ++y)
            for (int x = std::max(first.x - reach, 0) / kTile; x <= std::min(first.x + 1 + reach, last) / kTile; ++x)
                if (int& work = m_workOfTile[static_cast<std::size_t>(y) * static_cast<std::size_t>(across) +
                                             static_cast<std::size_t>(x)];
                    work < 0) {
                    work = 0;
                    m_tiles.push_back(y * across + x);
                }
    }
    std::ranges::sort(m_tiles);
    m_works.resize(m_tiles.size());
    for (std::size_t i = 0; i < m_tiles.size(); ++i) {
        m_workOfTile[static_cast<std::size_t>(m_tiles[i])] = static_cast<int>(i);
        m_works[i].tile = m_tiles[i];
    }
}

/// Calls `use(tile)` for a tile and those beside it.
template<typename Use>
void forTilesAround(int tile, int across, const Use& use)
{
    for (int y = std::max(tile / across - 1, 0); y <= std::min(tile / across + 1, across - 1); ++y)
        for (int x = std::max(tile % across - 1, 0); x <= std::min(tile % across + 1, across - 1); ++x)
            use(static_cast<std::size_t>(y) * static_cast<std::size_t>(across) + static_cast<std::size_t>(x));
}

void CutLengths::findOwners(int tile)
{
    const sim::TexelRect rect = m_shown->tileRect(tile);
    std::vector<std::uint32_t>& owners = m_owners[static_cast<std::size_t>(tile)];
    owners.assign(sim::kTileTexels, kNone);
    std::vector<float> squares(sim::kTileTexels, std::numeric_limits<float>::max());
    const auto spread = [&](std::uint32_t root, float reachTx) {
        const glm::vec2 at = m_roots[root].positionTx();
        const int y0 = std::max(static_cast<int>(std::ceil(at.y - reachTx)), rect.y0);
        const int y1 = std::min(static_cast<int>(std::floor(at.y + reachTx)), rect.y1 - 1);
        for (int y = y0; y <= y1; ++y) {
            const float dy = static_cast<float>(y) - at.y;
            const float half = std::sqrt(std::max(reachTx * reachTx - dy * dy, 0.0F));
            const int x0 = std::max(static_cast<int>(std::ceil(at.x - half)), rect.x0);
            const int x1 = std::min(static_cast<int>(std::floor(at.x + half)), rect.x1 - 1);
            for (int x = x0; x <= x1; ++x) {
                const std::size_t texel =
                    static_cast<std::size_t>(y - rect.y0) * kTile + static_cast<std::size_t>(x - rect.x0);
                const float dx = static_cast<float>(x) - at.x;
                const float square = dx * dx + dy * dy;
                if (square < squares[texel]) {
                    squares[texel] = square;
                    owners[texel] = root;
                }
            }
        }
    };
    forTilesAround(tile, m_shown->tilesAcross(), [&](std::size_t from) {
        for (std::uint32_t root = m_firstOfTile[from]; root < m_firstOfTile[from + 1]; ++root)
            spread(root, m_reachTx[from]);
    });
}

/// Finds the texels of a tile that the cuts change, and what each would be by its own root alone.
void CutLengths::divide(Work& work) const
{
    const sim::TexelRect rect = m_shown->tileRect(work.tile);
    const std::vector<std::uint32_t>& owners = m_owners[static_cast<std::size_t>(work.tile)];
    std::vector<float> kept(sim::kTileTexels);
    for (std::size_t texel = 0; texel < sim::kTileTexels; ++texel)
        kept[texel] = owners[texel] == kNone ? 1.0F : m_kept[owners[texel]];
    const auto forRead = [&](std::uint32_t root, const auto& use) {
        const glm::ivec2 first = m_roots[root].first;
        const int last = m_shown->size() - 1;
        for (int k = 0; k < 4; ++k) {
            const int x = std::min(first.x + k % 2, last);
            const int y = std::min(first.y + k / 2, last);
            if (x >= rect.x0 && x < rect.x1 && y >= rect.y0 && y < rect.y1)
                use(static_cast<std::size_t>(y - rect.y0) * kTile + static_cast<std::size_t>(x - rect.x0));
        }
    };
    const int across = m_shown->tilesAcross();
    const bool hasLeft = work.tile % across > 0;
    for (const bool isCut : {true, false})
        for (const int from : {work.tile, hasLeft ? work.tile - 1 : -1, work.tile - across,
                               hasLeft ? work.tile - across - 1 : -1}) { // Whose roots read texels of this one.
            if (from < 0)
                continue;
            const auto tile = static_cast<std::size_t>(from);
            for (std::uint32_t root = m_firstOfTile[tile]; root < m_firstOfTile[tile + 1]; ++root)
                if (isCut ? m_kept[root] < 1.0F : isHeld(root))
                    forRead(root, [&](std::size_t texel) {
                        kept[texel] = isCut ? std::min(kept[texel], m_kept[root]) : 1.0F;
                    });
        }
    const sim::RasterTile& shown = *m_shown->tile(work.tile);
    const auto channels = static_cast<std::size_t>(m_shown->channels());
    work.texels.resize(sim::kTileTexels);
    work.values.resize(sim::kTileTexels);
    for (std::size_t texel = 0; texel < sim::kTileTexels; ++texel) {
        const auto before = static_cast<float>(shown.isUniform() ? shown.uniform[0] : shown.pixels[texel * channels]);
        const bool isCut = kept[texel] < 1.0F;
        work.texels[texel] = {.value = isCut ? cutValue(before, kept[texel]) : before,
                              .before = before,
                              .least = before,
                              .most = std::min(before * kMostOfBefore, 65535.0F),
                              .mayChange = isCut};
    }
}

LengthRead CutLengths::readAt(std::uint32_t root)
{
    const glm::ivec2 first = m_roots[root].first;
    const glm::vec2 fraction = m_roots[root].fraction;
    const int last = m_shown->size() - 1;
    LengthRead read;
    float now = 0.0F;
    for (std::size_t k = 0; k < 4; ++k) {
        const int x = std::min(first.x + static_cast<int>(k % 2), last);
        const int y = std::min(first.y + static_cast<int>(k / 2), last);
        Work& work = m_works[workOf(m_shown->tileIndexAt(x, y))];
        LengthTexel& texel =
            work.texels[static_cast<std::size_t>(y % kTile) * kTile + static_cast<std::size_t>(x % kTile)];
        read.texels[k] = &texel;
        read.weights[k] = (k % 2 == 0 ? 1.0F - fraction.x : fraction.x) * (k / 2 == 0 ? 1.0F - fraction.y : fraction.y);
        now += read.weights[k] * texel.before;
    }
    read.wanted = cutValue(now, m_kept[root]);
    return read;
}

void CutLengths::correct(bool spares)
{
    const float perM = 65535.0F / m_rangeM;
    std::vector<LengthRead> reads;
    reads.reserve(m_cutRoots.size());
    for (const std::uint32_t root : m_cutRoots) {
        reads.push_back(readAt(root));
        for (LengthTexel* texel : reads.back().texels)
            texel->least = std::min(texel->least, kLeastOfWanted * cutValue(texel->before, m_kept[root]));
    }
    bringToWanted(reads, perM);
    constexpr int kRounds = 3; // Each may let more texels change.
    for (int round = 0; round < kRounds && !spares && releaseTooLong(reads, perM); ++round) {
        std::vector<LengthRead> beside = readsBeside();
        shortenTooLong(reads, beside, perM);
    }
}

/// The reads of roots that are not cut, at texels which cuts may change.
std::vector<LengthRead> CutLengths::readsBeside()
{
    const int last = m_shown->size() - 1;
    const auto changes = [&](glm::ivec2 first, int k) {
        const int x = std::min(first.x + k % 2, last);
        const int y = std::min(first.y + k / 2, last);
        const int work = m_workOfTile[static_cast<std::size_t>(m_shown->tileIndexAt(x, y))];
        const auto texel = static_cast<std::size_t>(y % kTile) * kTile + static_cast<std::size_t>(x % kTile);
        return work >= 0 && m_works[static_cast<std::size_t>(work)].texels[texel].mayChange;
    };
    std::vector<LengthRead> reads;
    for (const int tile : m_tiles) // A cut root's tiles reach further than texels that it frees.
        for (std::uint32_t root = m_firstOfTile[static_cast<std::size_t>(tile)];
             root < m_firstOfTile[static_cast<std::size_t>(tile) + 1]; ++root) {
            const glm::ivec2 first = m_roots[root].first;
            if (!isHeld(root) || !(changes(first, 0) || changes(first, 1) || changes(first, 2) || changes(first, 3)))
                continue;
            reads.push_back(readAt(root));
            for (LengthTexel* texel : reads.back().texels)
                texel->isReadBeside = true;
        }
    return reads;
}

float CutLengths::keptAt(int x, int y) const
{
    const int work = m_workOfTile[static_cast<std::size_t>(m_shown->tileIndexAt(x, y))];
    if (work < 0)
        return 1.0F;
    const Work& there = m_works[static_cast<std::size_t>(work)];
    const auto texel = static_cast<std::size_t>(y % kTile) * kTile + static_cast<std::size_t>(x % kTile);
    if (there.mask[texel] == 0)
        return 1.0F;
    const auto lengthM = [this](std::uint16_t value) {
        return m_shortestM + m_rangeM * static_cast<float>(value) / 65535.0F;
    };
    return lengthM(there.values[texel]) / std::max(lengthM(m_shown->texel(x, y)[0]), 1e-6F);
}

} // namespace hairpaint::model
