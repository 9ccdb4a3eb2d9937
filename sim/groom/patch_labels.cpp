// Parts of tiles found by flooding, and joined over the tiles' borders and over seams.
#include "sim/groom/patch_labels.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace hairpaint::sim {

namespace {

constexpr int kEdge = TiledRaster::kTileSize;

const std::shared_ptr<const PatchTile>& bareTile()
{
    static const std::shared_ptr<const PatchTile> bare = std::make_shared<PatchTile>();
    return bare;
}

/// Sets of numbers that are joined; the least stands for its set.
class JoinedSets
{
public:
    explicit JoinedSets(std::size_t count) : m_parent(count)
    {
        std::iota(m_parent.begin(), m_parent.end(), std::size_t{0});
    }
    [[nodiscard]] std::size_t find(std::size_t at)
    {
        while (m_parent[at] != at)
            at = m_parent[at] = m_parent[m_parent[at]];
        return at;
    }
    void join(std::size_t a, std::size_t b)
    {
        const std::size_t x = find(a);
        const std::size_t y = find(b);
        m_parent[std::max(x, y)] = std::min(x, y);
    }

private:
    std::vector<std::size_t> m_parent;
};

} // namespace

std::shared_ptr<const PatchTile> PatchLabels::labelled(int index, const RasterTilePtr& source) const
{
    if (source->isUniform() && source->uniform[0] == 0)
        return bareTile();
    const SkinIslands::Tile& islands = m_islands->tile(index);
    const auto value = [&](std::size_t texel) {
        return islands[texel] == 0   ? std::uint16_t{0}
               : source->isUniform() ? source->uniform[0]
                                     : source->pixels[texel];
    };
    auto made = std::make_shared<PatchTile>();
    made->source = source;
    made->parts.assign(kTileTexels, 0);
    std::vector<int> pending;
    for (std::size_t first = 0; first < kTileTexels; ++first) {
        const std::uint16_t kind = value(first);
        if (kind == 0 || made->parts[first] != 0)
            continue;
        made->kinds.push_back(kind);
        const auto part = static_cast<std::uint16_t>(made->kinds.size());
        std::uint32_t count = 0;
        pending.assign(1, static_cast<int>(first));
        made->parts[first] = part;
        while (!pending.empty()) {
            const int texel = pending.back();
            pending.pop_back();
            ++count;
            const auto reach = [&](int next) {
                const auto to = static_cast<std::size_t>(next);
                if (made->parts[to] == 0 && value(to) == kind &&
                    islands[to] == islands[static_cast<std::size_t>(texel)]) {
                    made->parts[to] = part;
                    pending.push_back(next);
                }
            };
            if (texel % kEdge > 0)
                reach(texel - 1);
            if (texel % kEdge < kEdge - 1)
                reach(texel + 1);
            if (texel >= kEdge)
                reach(texel - kEdge);
            if (texel < kEdge * (kEdge - 1))
                reach(texel + kEdge);
        }
        made->counts.push_back(count);
    }
    return made->kinds.empty() ? bareTile() : made;
}

void PatchLabels::update(const MapRaster& map, const std::shared_ptr<const SkinIslands>& islands)
{
    if (m_map == map && m_islands == islands)
        return;
    const auto count = static_cast<std::size_t>(map->tileCount());
    if (m_islands != islands || m_tiles.size() != count) {
        m_islands = islands;
        m_tiles.assign(count, bareTile());
        m_map.reset();
    }
    bool differs = m_map == nullptr;
    for (int index = 0; index < map->tileCount(); ++index) {
        if (m_map != nullptr && m_map->tile(index) == map->tile(index))
            continue;
        std::shared_ptr<const PatchTile>& tile = m_tiles[static_cast<std::size_t>(index)];
        std::shared_ptr<const PatchTile> made = labelled(index, map->tile(index));
        if (made->parts != tile->parts || made->kinds != tile->kinds) {
            tile = std::move(made);
            differs = true;
        }
    }
    m_map = map;
    if (differs)
        joinParts();
}

void PatchLabels::joinParts()
{
    m_firstPart.clear();
    std::uint32_t total = 0;
    for (const auto& tile : m_tiles) {
        m_firstPart.push_back(total);
        total += static_cast<std::uint32_t>(tile->kinds.size());
    }
    m_patches.clear();
    m_patchOfPart.assign(total, 0);
    if (total == 0)
        return;
    JoinedSets sets(total);
    const auto meet = [&](int tileA, std::size_t texelA, int tileB, std::size_t texelB, bool acrossSeam) {
        const PatchTile& a = tile(tileA);
        const PatchTile& b = tile(tileB);
        if (a.parts.empty() || b.parts.empty())
            return;
        const std::uint16_t partA = a.parts[texelA];
        const std::uint16_t partB = b.parts[texelB];
        if (partA == 0 || partB == 0 || a.kinds[partA - 1U] != b.kinds[partB - 1U])
            return;
        if (acrossSeam || m_islands->tile(tileA)[texelA] == m_islands->tile(tileB)[texelB])
            sets.join(m_firstPart[static_cast<std::size_t>(tileA)] + partA - 1U,
                      m_firstPart[static_cast<std::size_t>(tileB)] + partB - 1U);
    };
    const int across = m_map->tilesAcross();
    for (int index = 0; index < m_map->tileCount(); ++index) {
        if (tile(index).parts.empty())
            continue;
        for (int i = 0; i < kEdge; ++i) {
            if (index % across + 1 < across)
                meet(index, static_cast<std::size_t>(i * kEdge + kEdge - 1), index + 1,
                     static_cast<std::size_t>(i * kEdge), false);
            if (index / across + 1 < across)
                meet(index, static_cast<std::size_t>((kEdge - 1) * kEdge + i), index + across,
                     static_cast<std::size_t>(i), false);
        }
    }
    for (const SkinIslands::Link& link : m_islands->links())
        meet(link.tileA, link.texelA, link.tileB, link.texelB, true);

    std::map<std::size_t, std::size_t> patchOfSet;
    for (int index = 0; index < m_map->tileCount(); ++index) {
        const PatchTile& of = tile(index);
        for (std::size_t part = 0; part < of.kinds.size(); ++part) {
            const std::size_t number = m_firstPart[static_cast<std::size_t>(index)] + part;
            const auto [found, isNew] = patchOfSet.emplace(sets.find(number), m_patches.size());
            if (isNew)
                m_patches.push_back({.kind = of.kinds[part], .texels = 0, .parts = {}});
            Patch& patch = m_patches[found->second];
            patch.texels += of.counts[part];
            patch.parts.emplace_back(index, static_cast<std::uint16_t>(part + 1));
            m_patchOfPart[number] = found->second;
        }
    }
}

std::optional<std::size_t> PatchLabels::at(glm::vec2 uv) const
{
    if (m_map == nullptr)
        return std::nullopt;
    const int size = m_map->size();
    const auto texel = [size](float along) {
        return std::clamp(static_cast<int>(std::clamp(along, 0.0F, 1.0F) * static_cast<float>(size)), 0, size - 1);
    };
    const int x = texel(uv.x);
    const int y = texel(1.0F - uv.y);
    const int index = m_map->tileIndexAt(x, y);
    const PatchTile& of = tile(index);
    const std::uint16_t part =
        of.parts.empty() ? std::uint16_t{0} : of.parts[static_cast<std::size_t>(y % kEdge * kEdge + x % kEdge)];
    return part == 0 ? std::nullopt : std::optional(patchOf(index, part));
}

std::uint32_t texelsInBoth(const PatchLabels& a, std::size_t patchA, const PatchLabels& b, std::size_t patchB)
{
    if (a.tileCount() != b.tileCount())
        return 0;
    std::uint32_t count = 0;
    const auto& partsB = b.patches()[patchB].parts;
    for (const auto& [index, partA] : a.patches()[patchA].parts)
        for (auto at = std::ranges::lower_bound(partsB, std::pair(index, std::uint16_t{0}));
             at != partsB.end() && at->first == index; ++at) {
            const std::uint16_t partB = at->second;
            if (a.tilePointer(index) == b.tilePointer(index)) {
                count += partA == partB ? a.tile(index).counts[partA - 1U] : 0U;
                continue;
            }
            const std::vector<std::uint16_t>& ofA = a.tile(index).parts;
            const std::vector<std::uint16_t>& ofB = b.tile(index).parts;
            for (std::size_t texel = 0; texel < kTileTexels; ++texel)
                count += ofA[texel] == partA && ofB[texel] == partB ? 1U : 0U;
        }
    return count;
}

bool samePatch(const PatchLabels& a, std::size_t patchA, const PatchLabels& b, std::size_t patchB)
{
    const Patch& one = a.patches()[patchA];
    const Patch& other = b.patches()[patchB];
    return one.kind == other.kind && one.texels == other.texels && one.parts.size() == other.parts.size() &&
           texelsInBoth(a, patchA, b, patchB) == one.texels;
}

} // namespace hairpaint::sim
