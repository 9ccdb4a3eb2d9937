// Tiles first, then the candidates that sample them.
#include "sim/groom/map_changes.h"

#include "sim/base/parallel.h"
#include "sim/groom/map_sampler.h"

#include <algorithm>

namespace hairpaint::sim {

namespace {

constexpr std::size_t kSlotGrain = 256;

} // namespace

const TileIndex& MapChanges::indexFor(int rasterSize)
{
    const auto found = m_indices.find(rasterSize);
    if (found != m_indices.end())
        return found->second;
    return m_indices.emplace(rasterSize, TileIndex(m_roots->uv, rasterSize)).first->second;
}

void MapChanges::prepare(const GroupMaps& maps)
{
    for (const MapRule& rule : kMapRules)
        (void)indexFor(maps[rule.slot]->size());
}

template<typename Differs, typename Insert>
void MapChanges::visitChanged(const TiledRaster& before, const TiledRaster& after, const Differs& differs,
                              const Insert& insert)
{
    const std::optional<std::vector<TexelRect>> footprints = footprintsThatDiffer(before, after);
    if (!footprints) {
        const std::size_t chunks = (m_roots->count() + kChunkSlots - 1) / kChunkSlots;
        parallelFor(chunks, 4, [&](std::size_t begin, std::size_t end) {
            const std::size_t last = std::min(end * kChunkSlots, m_roots->count());
            for (std::size_t slot = begin * kChunkSlots; slot < last; ++slot)
                if (differs(static_cast<std::uint32_t>(slot)))
                    insert(static_cast<std::uint32_t>(slot));
        });
        return;
    }
    if (footprints->empty())
        return;
    // A tile's candidates are of many chunks: looked at by all threads, kept by this one.
    const std::vector<std::uint32_t> slots = indexFor(after.size()).slotsIn(*footprints);
    std::vector<std::uint8_t> changed(slots.size());
    parallelFor(slots.size(), kSlotGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            changed[i] = differs(slots[i]) ? 1 : 0;
    });
    for (std::size_t i = 0; i < slots.size(); ++i)
        if (changed[i] != 0)
            insert(slots[i]);
}

template<typename Read>
void MapChanges::compare(const MapRule& rule, const Read& read, const MapRaster& before, const MapRaster& after,
                         ChangedSlots& changed)
{
    const MapSampler was(before);
    const MapSampler is(after);
    const auto basisCount = static_cast<std::uint32_t>(m_roots->basisSlot.size());
    const MapEffect effect = rule.effect;
    const bool ofAll = effect.hairs || effect.look;
    const auto isBasis = [&](std::uint32_t slot) { return effect.basis && m_roots->rankOfSlot[slot] < basisCount; };
    const auto differs = [&](std::uint32_t slot) {
        return (ofAll || isBasis(slot)) && read(was, m_roots->uv[slot]) != read(is, m_roots->uv[slot]);
    };
    visitChanged(*before, *after, differs, [&](std::uint32_t slot) {
        if (effect.hairs)
            changed.hairs.insert(slot);
        if (isBasis(slot))
            changed.basis.insert(slot);
        if (effect.look)
            changed.look.insert(slot);
    });
}

void MapChanges::find(const GroupMaps& before, const GroupMaps& after, ChangedSlots& changed)
{
    const auto nearest = [](const MapSampler& map, glm::vec2 uv) { return map.index(uv); };
    const auto scalar = [](const MapSampler& map, glm::vec2 uv) { return map.scalar(uv); };
    const auto direction = [](const MapSampler& map, glm::vec2 uv) { return map.vector(uv); };
    const auto channels = [](const MapSampler& map, glm::vec2 uv) { return map.channels(uv); };
    for (const MapRule& rule : kMapRules) {
        const MapRaster& was = before[rule.slot];
        const MapRaster& is = after[rule.slot];
        // A map that shows another's own raster does not differ anywhere else.
        const auto isCompared = [&](const MapRule& other) {
            return other.slot < rule.slot && other.effect == rule.effect && before[other.slot] == was &&
                   after[other.slot] == is;
        };
        if (was == is || rule.effect == MapEffect{} || std::ranges::any_of(kMapRules, isCompared))
            continue;
        if (rule.sampling == MapSampling::Nearest)
            compare(rule, nearest, was, is, changed);
        else if (rule.slot == MapSlot::Direction)
            compare(rule, direction, was, is, changed);
        else if (rule.channels == 1)
            compare(rule, scalar, was, is, changed);
        else
            compare(rule, channels, was, is, changed);
    }
}

void MapChanges::findNearest(const TiledRaster& before, const TiledRaster& after,
                             const std::function<void(std::uint32_t)>& changed)
{
    const auto differs = [&](std::uint32_t slot) {
        return before.sampleNearest(m_roots->uv[slot]) != after.sampleNearest(m_roots->uv[slot]);
    };
    SlotSet slots(m_roots->count());
    visitChanged(before, after, differs, [&](std::uint32_t slot) { slots.insert(slot); });
    slots.forEach(changed);
}

} // namespace hairpaint::sim
