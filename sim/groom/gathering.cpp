// Numbers of ties at roots, and what follows from them.
#include "sim/groom/gathering.h"

#include "sim/base/parallel.h"
#include "sim/groom/braid_path.h"
#include "sim/groom/gathered_tails.h"
#include "sim/groom/strand_style.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hairpaint::sim {

namespace {

constexpr float kShortestSolvedTailM = 0.005F;
constexpr std::size_t kRootsAtOnce = 1024;

bool isSoundTie(const Tie& tie)
{
    const auto isFinite = [](glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
    return tie.number != 0 && isFinite(tie.pointHd) && isFinite(tie.directionHd) && tie.radiusM > 0.0F &&
           std::isfinite(tie.radiusM);
}

} // namespace

void Gathering::startOver(std::shared_ptr<const RootSet> roots)
{
    m_roots = std::move(roots);
    m_ties.clear();
    m_map = nullptr;
    m_numbers.clear();
    m_numberOfBasis.clear();
    m_followed.clear();
    m_basis = nullptr;
}

bool Gathering::isFor(const Inputs& inputs) const
{
    if (inputs.ties.empty() || !inputs.map)
        return isOff();
    return inputs.map == m_map && inputs.distances == m_distances &&
           std::ranges::equal(inputs.ties, m_ties, {}, {}, [](const auto& state) { return state->tie; });
}

Gathering::TieState* Gathering::find(std::uint16_t number) const
{
    const auto at = std::ranges::lower_bound(m_ties, number, {},
                                             [](const std::unique_ptr<TieState>& state) { return state->tie.number; });
    return at != m_ties.end() && (*at)->tie.number == number ? at->get() : nullptr;
}

const Gathering::TieState& Gathering::tieOf(std::uint16_t number) const
{
    return *find(number);
}

void Gathering::update(const Inputs& inputs, MapChanges& changes, SlotSet& dirty)
{
    m_relaid.assign(m_roots->basisSlot.size(), 0);
    m_moved.assign(m_roots->basisSlot.size(), 0);
    if (isFor(inputs)) {
        for (const std::unique_ptr<TieState>& tie : m_ties)
            tie->isNew = false;
        m_otherNumbers = m_anyMoved = false;
        return;
    }
    m_coatM = inputs.settings.physics.volumeM;
    m_anyMoved = false;
    takeTies(inputs);
    readNumbers(inputs, changes, dirty);
    if (m_otherNumbers || m_anyMoved)
        findBasis();
    for (std::uint32_t slot = 0; slot < m_numbers.size(); ++slot)
        if (m_numbers[slot] != 0 && find(m_numbers[slot])->isNew)
            dirty.insert(slot);
    findFollowed(dirty);
    prepareStrings(dirty);
    m_map = inputs.map;
    m_distances = inputs.distances;
    if (m_ties.empty())
        startOver(m_roots);
}

void Gathering::takeTies(const Inputs& inputs)
{
    std::vector<std::unique_ptr<TieState>> ties;
    const SkinDistance distance(m_roots->skin, inputs.distances);
    const bool otherSkin = inputs.distances != m_distances;
    if (inputs.map) {
        for (const Tie& tie : inputs.ties) {
            if (!isSoundTie(tie) || (!ties.empty() && ties.back()->tie.number >= tie.number))
                continue;
            std::unique_ptr<TieState> state;
            for (std::unique_ptr<TieState>& known : m_ties)
                if (known && known->tie.number == tie.number)
                    state = std::move(known);
            const bool isKnown = state != nullptr;
            if (!isKnown)
                state = std::make_unique<TieState>();
            state->isNew = !isKnown || state->tie != tie || otherSkin;
            if (!isKnown || otherSkin || state->tie.pointHd != tie.pointHd)
                state->strings = TautStrings(distance, tie.pointHd);
            if (state->isNew)
                state->lay = GatheredLay(tie, state->strings, m_coatM);
            state->tie = tie;
            ties.push_back(std::move(state));
        }
    }
    m_otherNumbers = ties.size() != m_ties.size() ||
                     std::ranges::any_of(m_ties, [](const auto& t) { return t != nullptr; }) || m_numbers.empty();
    m_ties = std::move(ties);
}

void Gathering::readNumbers(const Inputs& inputs, MapChanges& changes, SlotSet& dirty)
{
    const RootSet& roots = *m_roots;
    const auto read = [&](std::uint32_t slot) {
        const std::uint16_t number = inputs.map->sampleNearest(roots.uv[slot])[0];
        return number != 0 && find(number) != nullptr ? number : std::uint16_t{0};
    };
    const auto take = [&](std::uint32_t slot, std::uint16_t number) {
        if (number == m_numbers[slot])
            return;
        m_numbers[slot] = number;
        dirty.insert(slot);
        m_anyMoved = true;
    };
    if (m_numbers.empty()) {
        m_numbers.assign(roots.count(), 0);
        m_followed.assign(roots.count(), {});
    }
    if (!m_otherNumbers && m_map && inputs.map) {
        if (m_map != inputs.map)
            changes.findNearest(*m_map, *inputs.map, [&](std::uint32_t slot) { take(slot, read(slot)); });
        return;
    }
    std::vector<std::uint16_t> numbers(roots.count(), 0);
    if (inputs.map)
        parallelFor(roots.count(), kRootsAtOnce, [&](std::size_t begin, std::size_t end) {
            for (std::size_t slot = begin; slot < end; ++slot)
                numbers[slot] = read(static_cast<std::uint32_t>(slot));
        });
    for (std::uint32_t slot = 0; slot < numbers.size(); ++slot)
        take(slot, numbers[slot]);
}

void Gathering::findBasis()
{
    const RootSet& roots = *m_roots;
    std::vector<std::uint16_t> numbers(roots.basisSlot.size(), 0);
    for (const std::unique_ptr<TieState>& tie : m_ties)
        tie->basis.clear();
    for (std::uint32_t basis = 0; basis < numbers.size(); ++basis) {
        numbers[basis] = m_numbers[roots.basisSlot[basis]];
        if (numbers[basis] != 0)
            find(numbers[basis])->basis.push_back(basis);
    }
    const std::vector<std::uint16_t> before = std::exchange(m_numberOfBasis, std::move(numbers));
    for (const std::unique_ptr<TieState>& tie : m_ties) {
        if (tie->basis.empty())
            borrowBasis(*tie);
        const std::uint32_t coreBefore = std::exchange(tie->core, kNoCentre);
        for (const std::uint32_t basis : tie->basis)
            if (tie->core == kNoCentre ||
                roots.rankOfSlot[roots.basisSlot[basis]] < roots.rankOfSlot[roots.basisSlot[tie->core]])
                tie->core = basis;
        if (coreBefore != tie->core) {
            tie->formerCore = coreBefore;
            tie->isOtherCore = true;
        }
    }
    for (std::size_t basis = 0; basis < before.size(); ++basis)
        m_moved[basis] = before[basis] != m_numberOfBasis[basis] ? 1 : 0;
}

/// The first that no tie has of those around the patch's first hair.
void Gathering::borrowBasis(TieState& tie)
{
    const RootSet& roots = *m_roots;
    std::uint32_t first = kNoCentre;
    for (std::uint32_t slot = 0; slot < m_numbers.size(); ++slot)
        if (m_numbers[slot] == tie.tie.number &&
            (first == kNoCentre || roots.rankOfSlot[slot] < roots.rankOfSlot[first]))
            first = slot;
    if (first == kNoCentre)
        return;
    const auto take = [&](std::uint32_t basis) {
        if (m_numberOfBasis[basis] != 0)
            return false;
        m_numberOfBasis[basis] = tie.tie.number;
        tie.basis.push_back(basis);
        return true;
    };
    for (const std::uint32_t basis : roots.neighbours[first])
        if (take(basis))
            return;
    for (const std::uint32_t basis : roots.neighbours[first])
        for (const std::uint32_t next : roots.neighbours[roots.basisSlot[basis]])
            if (take(next))
                return;
}

Followed Gathering::followedBy(std::uint32_t slot) const
{
    const RootSet& roots = *m_roots;
    const std::uint16_t number = m_numbers[slot];
    Followed followed;
    float sum = 0.0F;
    std::size_t count = 0;
    for (std::size_t k = 0; k < RootSet::kNeighbours; ++k) {
        const std::uint32_t basis = roots.neighbours[slot][k];
        const float weight = roots.weights[slot][k];
        if (m_numberOfBasis[basis] != number || !(weight > 0.0F))
            continue;
        followed.basis[count] = basis;
        followed.weights[count++] = weight;
        sum += weight;
    }
    if (count > 0) {
        for (float& weight : followed.weights)
            weight /= sum;
        for (; count < RootSet::kNeighbours; ++count)
            followed.basis[count] = followed.basis[0];
        return followed;
    }
    float nearest = std::numeric_limits<float>::max();
    for (const std::uint32_t basis : find(number)->basis) {
        const glm::vec3 apart = roots.positionHd[roots.basisSlot[basis]] - roots.positionHd[slot];
        const float squared = glm::dot(apart, apart);
        if (squared < nearest) {
            nearest = squared;
            followed = {.basis = {basis, basis, basis}, .weights = {1.0F, 0.0F, 0.0F}};
        }
    }
    return followed;
}

/// Whether it may follow others than before: one that follows none of its nearest does as the whole tie's change.
bool Gathering::isConcerned(std::uint32_t slot, const SlotSet& dirty) const
{
    const Followed& followed = m_followed[slot];
    const auto& nearest = m_roots->neighbours[slot];
    return dirty.contains(slot) || !(followed.weights[0] > 0.0F) ||
           std::ranges::find(nearest, followed.basis[0]) == nearest.end() ||
           std::ranges::any_of(nearest, [&](std::uint32_t basis) { return m_moved[basis] != 0; });
}

void Gathering::findFollowed(SlotSet& dirty)
{
    if (!m_otherNumbers && !m_anyMoved)
        return;
    parallelFor(dirty.chunkCount(), 1, [&](std::size_t begin, std::size_t end) {
        const std::size_t last = std::min(end * kChunkSlots, m_numbers.size());
        for (std::size_t i = begin * kChunkSlots; i < last; ++i) {
            const auto slot = static_cast<std::uint32_t>(i);
            if (m_numbers[slot] == 0 ? m_followed[slot] == Followed{} : !isConcerned(slot, dirty))
                continue;
            const Followed followed = m_numbers[slot] == 0 ? Followed{} : followedBy(slot);
            if (followed == m_followed[slot])
                continue;
            m_followed[slot] = followed;
            dirty.insert(slot);
        }
    });
}

void Gathering::prepareStrings(const SlotSet& dirty)
{
    const RootSet& roots = *m_roots;
    std::vector<std::vector<std::uint32_t>> faces(m_ties.size());
    for (std::size_t i = 0; i < m_ties.size(); ++i)
        for (const std::uint32_t basis : m_ties[i]->basis)
            faces[i].push_back(roots.face[roots.basisSlot[basis]]);
    dirty.forEach([&](std::uint32_t slot) {
        if (m_numbers[slot] == 0)
            return;
        const auto at = std::ranges::lower_bound(
            m_ties, m_numbers[slot], {}, [](const std::unique_ptr<TieState>& state) { return state->tie.number; });
        faces[static_cast<std::size_t>(at - m_ties.begin())].push_back(roots.face[slot]);
    });
    for (std::size_t i = 0; i < m_ties.size(); ++i)
        m_ties[i]->strings.prepare(faces[i]);
}

void Gathering::layTails(const BasisInputs& inputs, TieState& tie, std::span<const WantedTail> wanted,
                         const BasisStyles& before, BasisStyles& next)
{
    const RootSet& roots = *m_roots;
    const int nodes = inputs.settings.nodesPerHair;
    const int ring = ringNode(nodes);
    const auto rows = static_cast<std::size_t>(nodes - ring);
    const StrandBlocks behind(nodes - ring);
    std::array<float, std::size_t{kMostNodes} * StrandBlocks::kNodeStride> nodesHd;
    std::array<RootValues, kLanes> values;
    GatherLanes lanes;
    for (std::size_t lane = 0; lane < wanted.size(); ++lane) {
        const std::uint32_t basis = wanted[lane].second;
        const std::uint32_t slot = roots.basisSlot[basis];
        RootValues& value = values.at(lane);
        value = valuesAt(inputs.maps, roots.uv[slot]);
        tie.lay.put(lanes, lane, roots.face[slot], roots.positionHd[slot]);
        lanes.chance[lane] = chanceOf(roots.seed, roots.rankOfSlot[slot]).coatHeight;
        lanes.isCore[lane] = basis == tie.core ? 1.0F : 0.0F;
        lanes.seen[lane] = value.curl > 0.0F ? seenOverCut(inputs.settings, value.curl, value.curlSize) : 1.0F;
        lanes.cutM[lane] = inputs.basisLengthM[basis] / lanes.seen[lane];
    }
    tie.lay.lay(lanes, nodes, nodesHd, kShortestSolvedTailM);
    for (std::size_t lane = 0; lane < wanted.size(); ++lane) {
        const std::uint32_t basis = wanted[lane].second;
        const std::uint32_t slot = roots.basisSlot[basis];
        const float freeM = lanes.freeM[lane];
        const float* const from = nodesHd.data() + static_cast<std::size_t>(ring) * StrandBlocks::kNodeStride + lane;
        const float* const was = before.restPositions.data() + behind.index(basis, 0);
        float* const to = next.restPositions.data() + behind.index(basis, 0);
        bool isSame = true;
        for (std::size_t row = 0; row < rows * 3; ++row) {
            to[row * kLanes] = from[row * kLanes];
            isSame = isSame && from[row * kLanes] == was[row * kLanes];
        }
        m_relaid[basis] = isSame ? 0 : 1;
        const RootValues& value = values.at(lane);
        const bool isCore = basis == tie.core;
        next[BasisQuantity::SegmentLength][basis] = lanes.lineM[lane] / static_cast<float>(rows - 1);
        next[BasisQuantity::Gel][basis] = inputs.maps[MapSlot::Gel].scalar(roots.uv[slot]);
        next[BasisQuantity::Give][basis] =
            value.curl > 0.0F ? giveOf(coilOf(inputs.settings, value.curl, value.curlSize, freeM), freeM) : 0.0F;
        next[BasisQuantity::Girth][basis] = isCore ? braidGirthM(lacedKind(static_cast<BraidKind>(inputs.kinds[slot])),
                                                                 braidRadiusM(inputs.settings, freeM))
                                                   : 0.0F;
        next[BasisQuantity::Height][basis] = lanes.chance[lane];
        if (isCore)
            tie.coreFreeM = freeM;
    }
}

void Gathering::updateBasis(const BasisInputs& inputs, const SlotSet& dirtyBasis, SlotSet& dirty)
{
    const RootSet& roots = *m_roots;
    if (isOff()) {
        m_basis = nullptr;
        return;
    }
    const int ring = ringNode(inputs.settings.nodesPerHair);
    const auto tailNodes = static_cast<std::size_t>(inputs.settings.nodesPerHair - ring);
    const auto next = m_basis ? std::make_shared<BasisStyles>(*m_basis) : std::make_shared<BasisStyles>();
    if (!m_basis)
        next->resize(static_cast<int>(tailNodes), blocksFor(roots.basisSlot.size()));
    const BasisStyles before = *next;
    const StrandBlocks blocks(static_cast<int>(tailNodes));
    std::vector<WantedTail> wanted;
    std::ranges::fill(next->wanted, 0U);
    for (const std::unique_ptr<TieState>& tie : m_ties)
        for (const std::uint32_t basis : tie->basis) {
            if (tie->tie.form == TieForm::Tail)
                insertLane(next->wanted, basis);
            if (tie->isNew || !hasLane(before.wanted, basis) || dirtyBasis.contains(roots.basisSlot[basis]) ||
                dirty.contains(roots.basisSlot[basis]) || m_moved[basis] != 0 ||
                (tie->isOtherCore && (basis == tie->core || basis == tie->formerCore)))
                wanted.emplace_back(tie.get(), basis);
        }
    parallelFor(wanted.size(), kLanes, [&](std::size_t begin, std::size_t end) {
        while (begin < end) {
            std::size_t same = begin + 1;
            while (same < end && same - begin < kLanes && wanted[same].first == wanted[begin].first)
                ++same;
            layTails(inputs, *wanted[begin].first, std::span(wanted).subspan(begin, same - begin), before, *next);
            begin = same;
        }
    });
    const std::array<glm::vec3, kMostNodes> nothing{};
    for (std::size_t basis = 0; basis < m_numberOfBasis.size(); ++basis) {
        if (m_numberOfBasis[basis] != 0 || !(before[BasisQuantity::SegmentLength][basis] > 0.0F))
            continue;
        for (std::vector<float>& numbers : next->numbers)
            numbers[basis] = 0.0F;
        blocks.write(next->restPositions, basis, std::span(nothing).first(tailNodes));
    }
    for (const std::unique_ptr<TieState>& tie : m_ties)
        tie->isOtherCore = false;
    m_basis = next;
    findClumped(inputs, dirty);
}

std::uint32_t Gathering::leaderOf(std::uint32_t slot, const LockPartition& locks, float ragged) const
{
    const std::uint32_t leader = locks.leaderOf(*m_roots, slot, ragged);
    return m_numberOfBasis[leader] == m_numbers[slot] ? leader : m_followed[slot].basis[0];
}

void Gathering::findClumped(const BasisInputs& inputs, SlotSet& dirty) const
{
    const auto none = [](const std::vector<std::uint8_t>& flags) {
        return std::ranges::find(flags, std::uint8_t{1}) == flags.end();
    };
    if (none(m_relaid) && none(m_moved))
        return;
    const LockSettings& locks = inputs.settings.locks;
    const bool allClump = inputs.settings.curl.gather > 0.0F || locks.small > 0.0F;
    parallelFor(dirty.chunkCount(), 1, [&](std::size_t begin, std::size_t end) {
        const std::size_t last = std::min(end * kChunkSlots, m_numbers.size());
        for (std::size_t i = begin * kChunkSlots; i < last; ++i) {
            const auto slot = static_cast<std::uint32_t>(i);
            if (m_numbers[slot] == 0 || dirty.contains(slot))
                continue;
            const TieState& tie = *find(m_numbers[slot]);
            const bool isAlongCore = tie.core != kNoCentre && m_relaid[tie.core] != 0 &&
                                     (tie.tie.form == TieForm::Bun || inputs.kinds[slot] != 0);
            const bool clumps = allClump || inputs.maps[MapSlot::Clump].scalar(m_roots->uv[slot]) > 0.0F;
            // Who comes or goes is a leader in phase and kind, too.
            if (isAlongCore || m_moved[inputs.locks.leaderOf(*m_roots, slot, locks.ragged)] != 0 ||
                (clumps && (m_relaid[leaderOf(slot, inputs.locks, locks.ragged)] != 0 ||
                            m_relaid[m_followed[slot].basis[0]] != 0)))
                dirty.insert(slot);
        }
    });
}

void Gathering::makeTails(const Groom* before, Groom& groom) const
{
    groom.tails = isOff() || !m_basis ? nullptr : tailsOf(groom, m_basis, before);
}

} // namespace hairpaint::sim
