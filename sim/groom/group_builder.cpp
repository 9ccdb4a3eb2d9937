// From what differs in a group's input to its next groom.
#include "sim/groom/group_builder.h"

#include "sim/base/parallel.h"
#include "sim/groom/braid_path.h"
#include "sim/groom/chunk_builder.h"
#include "sim/groom/rest_shape.h"
#include "sim/groom/strand_style.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <numeric>
#include <utility>

namespace hairpaint::sim {

namespace {

constexpr float kShortestBasisM = 0.005F;        ///< A shorter one's displacement in units of its length means nothing.
constexpr std::size_t kBasisGrain = kChunkSlots; ///< So that no two threads write to a chunk of PassedCells.

GroupSettings withinLimits(GroupSettings settings)
{
    settings.nodesPerHair = std::clamp(settings.nodesPerHair, kLeastNodes, kMostNodes);
    return settings;
}

/// Height in the coat: hairs from higher on the head lie over those from below; chance tells neighbours apart.
float heightOf(const RootSet& roots, std::uint32_t slot, float crownY)
{
    constexpr float kScalpM = 0.20F;
    constexpr float kChanceFraction = 0.3F;
    const float crownward = std::clamp(1.0F - (crownY - roots.positionHd[slot].y) / kScalpM, 0.0F, 1.0F);
    return crownward * (1.0F - kChanceFraction) +
           chanceOf(roots.seed, roots.rankOfSlot[slot]).coatHeight * kChanceFraction;
}

std::optional<MapSampler> samplerOf(const MapRaster& raster)
{
    return raster ? std::optional<MapSampler>(raster) : std::nullopt;
}

std::shared_ptr<BasisStyles> emptyBasis(const RootSet& roots, int nodes)
{
    auto basis = std::make_shared<BasisStyles>();
    basis->resize(nodes, blocksFor(roots.basisSlot.size()));
    float crownY = -std::numeric_limits<float>::max();
    for (const glm::vec3& position : roots.skin->mesh().positionsHd)
        crownY = std::max(crownY, position.y);
    for (std::size_t i = 0; i < roots.basisSlot.size(); ++i)
        (*basis)[BasisQuantity::Height][i] = heightOf(roots, roots.basisSlot[i], crownY);
    return basis;
}

} // namespace

GroupBuilder::Result GroupBuilder::update(const GroomInput::Group& input, const std::shared_ptr<const RootSet>& roots,
                                          const HeadLay& head, HairLimit limit)
{
    const GroupSettings settings = withinLimits(input.settings);
    const bool allDiffer = !m_groom || roots != m_roots || !sameFor(Affects::Hairs, m_groom->settings, settings) ||
                           head.natural != m_head.natural;
    Result result{m_groom, SlotSet(roots->count())};
    const Gathering::Inputs gathered{input.ties, input.gathered, head.distances, settings};
    if (!allDiffer && m_gathering.isFor(gathered) && settings == m_groom->settings && input.maps == m_input.maps &&
        input.visible == m_groom->visible && limit == m_groom->limit)
        return result;

    ChangedSlots dirty(roots->count());
    std::shared_ptr<Groom> groom;
    if (allDiffer) {
        startOver(input, roots);
        dirty.hairs.insertAll();
        dirty.basis.insertAll();
        groom = std::make_shared<Groom>();
        groom->groupId = input.id;
        groom->roots = roots;
        groom->nodes = settings.nodesPerHair;
        groom->chunks.resize(dirty.hairs.chunkCount());
        m_newBasis = emptyBasis(*roots, groom->nodes);
    } else {
        m_changes->find(m_input.maps, input.maps, dirty);
        groom = std::make_shared<Groom>(*m_groom);
    }
    m_gathering.update(gathered, *m_changes, dirty.hairs);
    updateLay(input, head, dirty);
    groom->visible = input.visible;
    groom->settings = settings;
    groom->density = input.maps[MapSlot::Density];
    groom->colour = input.maps[MapSlot::Colour];
    groom->limit = limit;

    if (allDiffer || !dirty.empty()) {
        const MapSamplers maps(input.maps);
        m_hairline.update(input.maps[MapSlot::Density], dirty.hairs);
        readKinds(maps, dirty.hairs);
        const std::optional<MapSampler> natural = samplerOf(head.natural);
        const LayInputs lay{maps[MapSlot::Direction],
                            natural ? &*natural : nullptr,
                            head.band ? &*m_layField : nullptr,
                            settings.physics.volumeM,
                            settings.physics.volumeRiseM,
                            settings.variation.partGapM,
                            kPartWavers * settings.variation.parting};
        dirty.hairs.forEach(
            [&](std::uint32_t slot) { dirty.basis.insert(roots->basisSlot[roots->neighbours[slot][0]]); });
        updateBasis(settings, maps, lay, dirty.basis);
        m_gathering.updateBasis({settings, maps, m_kinds, m_basisLengthM, m_locks}, dirty.basis, dirty.hairs);
        updateBraids(input, settings, maps, dirty.hairs);
        updateClumped(settings, maps[MapSlot::Clump], dirty.hairs);
        rebuildChunks(settings, maps, lay, dirty, *groom, result.rebuilt);
        updateWanted(*groom);
    }
    m_gathering.makeTails(m_groom.get(), *groom);
    m_input = input;
    m_head = head;
    m_groom = groom;
    result.groom = std::move(groom);
    return result;
}

void GroupBuilder::updateLay(const GroomInput::Group& input, const HeadLay& head, ChangedSlots& dirty)
{
    const MapRaster& direction = input.maps[MapSlot::Direction];
    if (!head.band)
        return; // All stands upright; what a field there is stays as it is for what comes next.
    if (!m_layField || m_layField->band() != head.band || m_layField->natural() != head.natural) {
        m_layField.emplace(head.band, head.natural, direction);
        return;
    }
    const LayField::Difference difference = m_layField->differenceTo(direction);
    if (m_groom)
        findRelaid(difference, dirty);
    m_layField->apply(difference);
}

void GroupBuilder::findRelaid(const LayField::Difference& difference, ChangedSlots& dirty) const
{
    const std::vector<std::uint32_t>& basisSlots = m_roots->basisSlot;
    const VariationSettings& variation = m_groom->settings.variation;
    if (variation.partGapM > 0.0F) {
        const float reachM = Lay::partingReachM(kPartWavers * variation.parting);
        m_passed.findPassing(m_layField->band()->around(difference.indices, reachM), m_layField->cellCount(),
                             dirty.hairs);
    } else {
        m_passed.findPassing(difference.indices, m_layField->cellCount(), dirty.hairs);
    }
    SlotSet basis(basisSlots.size());
    m_passedByBasis.findPassing(difference.indices, m_layField->cellCount(), basis);
    basis.forEach([&](std::uint32_t index) { dirty.basis.insert(basisSlots[index]); });
}

void GroupBuilder::startOver(const GroomInput::Group& input, const std::shared_ptr<const RootSet>& roots)
{
    const float lockSizeM = input.settings.locks.sizeM;
    if (roots != m_roots || lockSizeM != m_lockSizeM) {
        m_locks = LockPartition(*roots, lockSizeM);
        m_lockSizeM = lockSizeM;
    }
    m_hairline.startOver(roots, input.settings.hairline);
    if (roots != m_roots) {
        m_roots = roots;
        // Counted, summed up, filled in.
        m_firstLed.assign(roots->basisSlot.size() + 1, 0);
        for (const auto& neighbours : roots->neighbours)
            ++m_firstLed[neighbours[0] + 1];
        std::partial_sum(m_firstLed.begin(), m_firstLed.end(), m_firstLed.begin());
        m_led.resize(roots->neighbours.size());
        std::vector<std::uint32_t> next(m_firstLed.begin(), m_firstLed.end() - 1);
        for (std::uint32_t slot = 0; slot < roots->neighbours.size(); ++slot)
            m_led[next[roots->neighbours[slot][0]]++] = slot;
        m_changes.emplace(roots);
        m_changes->prepare(input.maps);
    }
    m_gathering.startOver(roots);
    const std::size_t basisCount = roots->basisSlot.size();
    m_groom.reset();
    m_basisLengthM.assign(basisCount, 0.0F);
    m_drawnDependents.assign(basisCount, 0);
    m_kinds.assign(roots->count(), 0);
    m_braided.assign(roots->count(), 0);
    m_braids.startOver();
    const int nodes = withinLimits(input.settings).nodesPerHair;
    m_passed.startOver(roots->count(), nodes);
    m_passedByBasis.startOver(basisCount, nodes);
}

void GroupBuilder::readKinds(const MapSamplers& maps, const SlotSet& dirty)
{
    parallelFor(dirty.chunkCount(), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t chunk = begin; chunk < end; ++chunk)
            dirty.forEachInChunk(chunk, [&](std::uint32_t slot) {
                m_kinds[slot] = static_cast<std::uint8_t>(braidKindOf(maps[MapSlot::Braid].index(m_roots->uv[slot])));
            });
    });
}

BasisStyles& GroupBuilder::writableBasis()
{
    if (!m_newBasis)
        m_newBasis = std::make_shared<BasisStyles>(*m_basis);
    return *m_newBasis;
}

float GroupBuilder::basisLengthOf(std::size_t basisIndex, const GroupSettings& settings, const MapSampler& length) const
{
    constexpr float kMuchShorter = 0.5F;
    const float own = length.scalar(m_roots->uv[m_roots->basisSlot[basisIndex]]);
    if (length.isUniform())
        return lengthOf(settings, own);
    float longest = own;
    for (std::uint32_t i = m_firstLed[basisIndex]; i < m_firstLed[basisIndex + 1]; ++i)
        longest = std::max(longest, length.scalar(m_roots->uv[m_led[i]]));
    const float longestM = lengthOf(settings, longest);
    const float ownM = lengthOf(settings, own);
    return ownM < kMuchShorter * longestM ? longestM : ownM;
}

void GroupBuilder::updateBasis(const GroupSettings& settings, const MapSamplers& maps, const LayInputs& lay,
                               const SlotSet& dirty)
{
    const RootSet& roots = *m_roots;
    m_basisRelaid.assign(roots.basisSlot.size(), 0);
    const auto anyDirty = std::any_of(roots.basisSlot.begin(), roots.basisSlot.end(),
                                      [&](std::uint32_t slot) { return dirty.contains(slot); });
    if (!anyDirty)
        return;
    BasisStyles& basis = writableBasis();
    const auto nodeCount = static_cast<std::size_t>(settings.nodesPerHair);
    parallelFor(roots.basisSlot.size(), kBasisGrain, [&](std::size_t begin, std::size_t end) {
        LayInputs solved = lay;
        solved.partGapM = 0.0F;
        Lay batch(solved, settings.nodesPerHair);
        std::vector<std::size_t> added;
        std::array<glm::vec3, kMostNodes> buffer{};
        std::array<glm::vec3, kMostNodes> bufferBefore{};
        const std::span<glm::vec3> nodes = std::span(buffer).first(nodeCount);
        const std::span<glm::vec3> nodesBefore = std::span(bufferBefore).first(nodeCount);
        const StrandBlocks blocks(settings.nodesPerHair);
        const auto store = [&] {
            batch.lay();
            for (std::size_t hair = 0; hair < added.size(); ++hair) {
                const std::size_t i = added[hair];
                batch.read(hair, nodes);
                m_passedByBasis.put(i, batch.passed(hair));
                blocks.read(basis.restPositions, i, nodesBefore);
                m_basisRelaid[i] = std::ranges::equal(nodes, nodesBefore) ? 0 : 1;
                blocks.write(basis.restPositions, i, nodes);
            }
            batch.clear();
            added.clear();
        };
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t slot = roots.basisSlot[i];
            if (!dirty.contains(slot))
                continue;
            const float curl = m_kinds[slot] == 0 ? maps[MapSlot::Curl].scalar(roots.uv[slot]) : 0.0F;
            const float shortened = settings.lengthAsCut && curl > 0.0F
                                        ? seenOverCut(settings, curl, maps[MapSlot::CurlSize].scalar(roots.uv[slot]))
                                        : 1.0F;
            const float lengthM =
                std::max(basisLengthOf(i, settings, maps[MapSlot::Length]) * shortened, kShortestBasisM);
            basis[BasisQuantity::Gel][i] = maps[MapSlot::Gel].scalar(roots.uv[slot]);
            const Coil coil =
                curl > 0.0F ? coilOf(settings, curl, maps[MapSlot::CurlSize].scalar(roots.uv[slot]), lengthM) : Coil{};
            basis[BasisQuantity::Give][i] = curl > 0.0F ? giveOf(coil, lengthM) : 0.0F;
            m_basisLengthM[i] = lengthM;
            basis[BasisQuantity::SegmentLength][i] = lengthM / static_cast<float>(nodeCount - 1);
            (void)batch.add(layRootOf(settings, roots, slot, chanceOf(roots.seed, roots.rankOfSlot[slot]),
                                      liftOf(settings, coil.radiusM, lengthM)),
                            lengthM);
            added.push_back(i);
            if (batch.isFull())
                store();
        }
        store();
    });
}

void GroupBuilder::updateBraids(const GroomInput::Group& input, const GroupSettings& settings, const MapSamplers& maps,
                                SlotSet& dirty)
{
    const RootSet& roots = *m_roots;
    const bool otherKinds = readBraided(settings.variation, maps, dirty);
    const std::vector<Braid> before(m_braids.braids().begin(), m_braids.braids().end());
    const BraidLayout::Inputs inputs{.roots = roots,
                                     .braid = input.maps[MapSlot::Braid],
                                     .density = input.maps[MapSlot::Density],
                                     .kinds = m_braided,
                                     .otherKinds = otherKinds,
                                     .settings = settings,
                                     .length = maps[MapSlot::Length],
                                     .basisLengthM = m_basisLengthM};
    if (!m_braids.update(inputs, dirty))
        return;
    std::vector<float> girthM(roots.basisSlot.size(), 0.0F);
    for (const Braid& braid : m_braids.braids())
        girthM[braid.basis] = std::max(girthM[braid.basis], braidGirthM(braid.kind, braid.radiusM));
    std::ranges::copy(girthM, writableBasis()[BasisQuantity::Girth].begin());
}

/// Which hairs are to be braided; true where that differs.
bool GroupBuilder::readBraided(const VariationSettings& variation, const MapSamplers& maps, const SlotSet& dirty)
{
    const RootSet& roots = *m_roots;
    std::atomic<bool> differs = false;
    parallelFor(dirty.chunkCount(), 8, [&](std::size_t begin, std::size_t end) {
        bool any = false;
        for (std::size_t chunk = begin; chunk < end; ++chunk)
            dirty.forEachInChunk(chunk, [&](std::uint32_t slot) {
                const bool isBraided = m_kinds[slot] != 0 && m_gathering.numberOf(slot) == 0 &&
                                       roots.threshold(slot) < hairDensity(variation, m_hairline, maps, roots, slot);
                const std::uint8_t kind = isBraided ? m_kinds[slot] : std::uint8_t{0};
                any |= kind != m_braided[slot];
                m_braided[slot] = kind;
            });
        if (any)
            differs = true;
    });
    return differs;
}

void GroupBuilder::updateClumped(const GroupSettings& settings, const MapSampler& clump, SlotSet& dirty) const
{
    if (!m_groom)
        return;
    if (!m_locks.isOfBasis())
        return updateLocks(settings, clump, dirty);
    const RootSet& roots = *m_roots;
    for (std::size_t basis = 0; basis < m_basisRelaid.size(); ++basis) {
        if (m_basisRelaid[basis] == 0)
            continue;
        for (std::uint32_t i = m_firstLed[basis]; i < m_firstLed[basis + 1]; ++i) {
            const std::uint32_t slot = m_led[i];
            const StrandChunk* chunk = m_groom->chunks[chunkOf(slot)].get();
            if (chunk != nullptr && chunk->hairs[inChunk(slot)] && !dirty.contains(slot) &&
                roots.basisSlot[basis] != slot && (settings.curl.gather > 0.0F || clump.scalar(roots.uv[slot]) > 0.0F))
                dirty.insert(slot);
        }
    }
}

void GroupBuilder::updateLocks(const GroupSettings& settings, const MapSampler& clump, SlotSet& dirty) const
{
    if (std::ranges::find(m_basisRelaid, std::uint8_t{1}) == m_basisRelaid.end())
        return;
    const RootSet& roots = *m_roots;
    parallelFor(m_groom->chunks.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index) {
            const StrandChunk* chunk = m_groom->chunks[index].get();
            if (chunk == nullptr)
                continue;
            const std::size_t firstSlot = index * kChunkSlots;
            for (std::size_t local = 0; local < std::min<std::size_t>(kChunkSlots, roots.count() - firstSlot);
                 ++local) {
                const auto slot = static_cast<std::uint32_t>(firstSlot + local);
                const bool isRelaid = m_basisRelaid[chunk->lockLeader[local]] != 0 ||
                                      (settings.locks.small > 0.0F && m_basisRelaid[roots.neighbours[slot][0]] != 0);
                if (isRelaid && chunk->hairs[local] && !dirty.contains(slot) &&
                    (settings.curl.gather > 0.0F || settings.locks.small > 0.0F || clump.scalar(roots.uv[slot]) > 0.0F))
                    dirty.insert(slot);
            }
        }
    });
}

void GroupBuilder::rebuildChunks(const GroupSettings& settings, const MapSamplers& maps, const LayInputs& lay,
                                 const ChangedSlots& dirty, Groom& groom, SlotSet& rebuilt)
{
    std::vector<std::size_t> stale;
    for (std::size_t chunk = 0; chunk < dirty.hairs.chunkCount(); ++chunk)
        if (!dirty.hairs.chunkEmpty(chunk) || !dirty.look.chunkEmpty(chunk))
            stale.push_back(chunk);
    const ChunkInputs inputs{settings, *m_roots, maps,    lay,        m_newBasis ? *m_newBasis : *m_basis,
                             m_braids, m_kinds,  m_locks, m_hairline, m_gathering};
    const std::vector<std::shared_ptr<const StrandChunk>> before = groom.chunks;
    parallelFor(stale.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            groom.chunks[stale[i]] = rebuildChunk(inputs, before[stale[i]], stale[i], dirty, m_passed, rebuilt);
    });

    for (const std::size_t i : stale) {
        const StrandChunk* was = before[i].get();
        const StrandChunk* is = groom.chunks[i].get();
        if (was == is)
            continue;
        // Most often they follow whom they followed.
        if (was == nullptr || is == nullptr || was->drawn != is->drawn || was->braidCentre != is->braidCentre ||
            was->lockLeader != is->lockLeader || was->gathered != is->gathered) {
            // Subtracting modulo 2^32: one of -1 takes a dependent away.
            countDependents(was, i, rebuilt, ~0U);
            countDependents(is, i, rebuilt, 1U);
        }
        groom.hairCount += (is != nullptr ? is->hairs.count() : 0) - (was != nullptr ? was->hairs.count() : 0);
        groom.drawnCount += (is != nullptr ? is->drawn.count() : 0) - (was != nullptr ? was->drawn.count() : 0);
    }
    groom.packedChunk.resize(groom.chunks.size());
    groom.packedChunks = 0;
    for (std::size_t i = 0; i < groom.chunks.size(); ++i)
        groom.packedChunk[i] = groom.chunks[i] ? groom.packedChunks++ : -1;
}

void GroupBuilder::countDependents(const StrandChunk* chunk, std::size_t chunkIndex, const SlotSet& slots,
                                   std::uint32_t one)
{
    if (chunk == nullptr)
        return;
    slots.forEachInChunk(chunkIndex, [&](std::uint32_t slot) {
        const std::size_t local = inChunk(slot);
        if (!chunk->drawn[local] || chunk->gathered[local])
            return;
        if (chunk->braidCentre[local] != kNoCentre) {
            m_drawnDependents[chunk->braidCentre[local]] += one;
            return;
        }
        if (!chunk->lockLeader.empty())
            m_drawnDependents[chunk->lockLeader[local]] += one;
        for (std::size_t k = 0; k < RootSet::kNeighbours; ++k)
            if (m_roots->weights[slot][k] > 0.0F)
                m_drawnDependents[m_roots->neighbours[slot][k]] += one;
    });
}

void GroupBuilder::updateWanted(Groom& groom)
{
    const std::size_t basisCount = m_drawnDependents.size();
    std::vector<std::uint32_t> wanted(blocksFor(basisCount), 0);
    groom.basisCount = 0;
    for (std::size_t i = 0; i < basisCount; ++i) {
        if (m_drawnDependents[i] == 0)
            continue;
        insertLane(wanted, i);
        ++groom.basisCount;
    }
    const BasisStyles& now = m_newBasis ? *m_newBasis : *m_basis;
    if (wanted != now.wanted)
        writableBasis().wanted = std::move(wanted);
    if (m_newBasis)
        m_basis = std::exchange(m_newBasis, nullptr);
    groom.basis = m_basis;
}

} // namespace hairpaint::sim
