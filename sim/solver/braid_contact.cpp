// Nearest points of segments, half spaces for nodes, and these in lanes for the kernel.
#include "sim/solver/braid_contact.h"

#include "sim/base/parallel.h"
#include "sim/solver/strand_constants.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr std::size_t kStepsAContact = 4;
constexpr std::size_t kWindyStepsAContact = 8;
constexpr std::size_t kBraidsAtOnce = 8;
constexpr std::size_t kMostContactsASegment = 24;
constexpr float kTaken = 0.8F;       ///< Part of an overlap that two braids leave at once,
constexpr float kMostTakenM = 2e-3F; ///< each at most.
constexpr float kLeft = 0.02F;       ///< Fraction of the clearance by which braids may overlap: they lie still.
constexpr float kCreepsM = 5e-5F;    ///< m a step: half spaces do not follow what is slower.
/// How fast braids that grow too near to each other may come apart, as a fraction of the length from their roots.
constexpr float kSpread = 0.2F;

/// How much of an overlap is left by the braid at pHd, into which the normal points: most by that which is further out
/// from the head, for what is beneath it has no room (shock propagation, Guendelman and others 2003).
float partOfFirst(glm::vec3 pHd, glm::vec3 normal)
{
    constexpr float kOfOuter = 0.9F;
    const glm::vec3 outward(pHd.x, std::max(pHd.y, 0.0F), pHd.z);
    const float outward2 = glm::dot(outward, outward);
    return outward2 > 0.0F ? 0.5F + (kOfOuter - 0.5F) * glm::dot(normal, outward) / std::sqrt(outward2) : 0.5F;
}

glm::vec3 withoutCreeping(glm::vec3 velocityM)
{
    const float speed = std::sqrt(glm::dot(velocityM, velocityM));
    return speed > kCreepsM ? velocityM * (1.0F - kCreepsM / speed) : glm::vec3(0.0F);
}

} // namespace

void BraidContact::setGroom(const Groom& groom)
{
    const BasisStyles& basis = *groom.basis;
    const std::vector<float>& girths = basis[BasisQuantity::Girth];
    m_nodes = groom.nodes;
    m_firstNode = groom.isOfTails ? 1 : 2;
    const auto nodes = static_cast<std::size_t>(m_nodes);
    m_strands.clear();
    for (std::size_t strand = 0; strand < girths.size(); ++strand)
        if (girths[strand] > 0.0F && hasLane(basis.wanted, strand))
            m_strands.push_back(static_cast<std::uint32_t>(strand));
    const std::size_t all = m_strands.size() * nodes;
    m_braids.resize(all);
    m_restHd.resize(all);
    m_spreadM.resize(all);
    m_radiusM.resize(all);
    std::vector<float> girthsM(m_strands.size());
    std::vector<float> segmentsM(m_strands.size());
    for (std::size_t braid = 0; braid < m_strands.size(); ++braid) {
        const std::size_t strand = m_strands[braid];
        girthsM[braid] = girths[strand];
        segmentsM[braid] = basis[BasisQuantity::SegmentLength][strand];
        const float spread = kSpread * (1.0F - styledFraction(holdGain(basis[BasisQuantity::Gel][strand])));
        groom.blocks().read(basis.restPositions, strand, std::span(m_restHd).subspan(braid * nodes, nodes));
        for (std::size_t node = 0; node < nodes; ++node) {
            const float alongM = segmentsM[braid] * static_cast<float>(node);
            m_braids[braid * nodes + node] = static_cast<std::int32_t>(braid);
            m_spreadM[braid * nodes + node] = spread * alongM;
            m_radiusM[braid * nodes + node] = std::min(girthsM[braid], kGirthSlope * alongM);
        }
    }
    m_nodesHd.resize(all);
    m_velocitiesM.resize(all);
    m_x.resize(all);
    m_y.resize(all);
    m_z.resize(all);
    m_nodePlanes.resize(all);
    m_written.assign(all, 0);
    m_asleep.resize(m_strands.size());
    m_pairs.setBraids(girthsM, segmentsM, m_nodes);
    m_mostContacts = (nodes - 1) * kMostContactsASegment;
    m_contacts.resize(m_strands.size() * m_mostContacts);
    m_contactCounts.assign(m_strands.size(), 0);
    m_rowOfBlock.assign(basis.blockCount(), -1);
    m_firstOfRow.clear();
    for (std::size_t braid = 0; braid < m_strands.size(); ++braid) {
        std::int32_t& row = m_rowOfBlock[blockOf(m_strands[braid])];
        if (row < 0) {
            row = static_cast<std::int32_t>(m_firstOfRow.size());
            m_firstOfRow.push_back(static_cast<std::uint32_t>(braid));
        }
    }
    m_counts.assign(m_firstOfRow.size() * nodes, 0);
    m_rows.assign(m_counts.size() * kBraidRows * kLanes, 0.0F);
    m_firstOfRow.push_back(static_cast<std::uint32_t>(m_strands.size()));
    m_isFound = false;
}

void BraidContact::forget()
{
    std::ranges::fill(m_counts, std::uint8_t{0});
    m_isFound = false;
}

BraidPlanes BraidContact::planes() const
{
    return {.rowOfBlock = m_rowOfBlock.data(),
            .rows = m_rows.data(),
            .counts = m_counts.data(),
            .stepsDone = static_cast<int>(m_stepsDone)};
}

void BraidContact::read(const StrandState& state)
{
    const auto nodes = static_cast<std::size_t>(m_nodes);
    parallelFor(m_strands.size(), kBraidsAtOnce, [&](std::size_t begin, std::size_t end) {
        for (std::size_t braid = begin; braid < end; ++braid) {
            const std::size_t strand = m_strands[braid];
            m_asleep[braid] = state.field(strand, kStill) >= kStillSteps ? 1 : 0;
            for (std::size_t node = 0; node < nodes; ++node) {
                const glm::vec3 now = state.shape().node(state.now(), strand, node);
                const std::size_t at = braid * nodes + node;
                m_nodesHd[at] = now;
                m_x[at] = now.x;
                m_y[at] = now.y;
                m_z[at] = now.z;
                m_velocitiesM[at] = now - state.shape().node(state.before(), strand, node);
            }
        }
    });
}

BraidNodes BraidContact::nodesInRows() const
{
    return {.x = m_x.data(), .y = m_y.data(), .z = m_z.data(), .radius = m_radiusM.data()};
}

/// The distance that the rest shape allows these points, which grows down the braids.
float BraidContact::allowedM(const Contact& contact) const
{
    const auto mixed = [](const auto& of, std::int32_t node, float along) {
        const auto* const at = &of[static_cast<std::size_t>(node)];
        return at[0] + (at[1] - at[0]) * along;
    };
    const glm::vec3 apart =
        mixed(m_restHd, contact.first, contact.alongFirst) - mixed(m_restHd, contact.second, contact.alongSecond);
    return std::sqrt(glm::dot(apart, apart)) + mixed(m_spreadM, contact.first, contact.alongFirst) +
           mixed(m_spreadM, contact.second, contact.alongSecond);
}

void BraidContact::findContacts(std::size_t braid)
{
    const std::span<Contact> contacts = std::span(m_contacts).subspan(braid * m_mostContacts, m_mostContacts);
    const std::span<const std::int32_t> firsts = m_pairs.first(braid);
    const std::span<const std::int32_t> seconds = m_pairs.second(braid);
    std::uint32_t count = 0;
    SegmentsApart apart;
    for (std::size_t from = 0; from < firsts.size(); from += SegmentsApart::kMost) {
        const std::size_t pairs = std::min(SegmentsApart::kMost, firsts.size() - from);
        findNearestPoints(nodesInRows(), {firsts.data() + from, seconds.data() + from}, apart, pairs);
        for (std::size_t i = 0; i < pairs && count < contacts.size(); ++i) {
            const float near = apart.clear[i] + BraidPairs::kNearM;
            if (!(apart.distance2[i] < near * near))
                continue;
            contacts[count] = {.first = firsts[from + i],
                               .second = seconds[from + i],
                               .alongFirst = apart.alongFirst[i],
                               .alongSecond = apart.alongSecond[i],
                               .clearM = apart.clear[i]};
            if (finish(contacts[count]))
                ++count;
        }
    }
    m_contactCounts[braid] = count;
}

/// Fills in how they touch; false if they do not.
bool BraidContact::finish(Contact& contact) const
{
    const auto first = static_cast<std::size_t>(contact.first);
    const auto second = static_cast<std::size_t>(contact.second);
    if (m_asleep[static_cast<std::size_t>(m_braids[first])] != 0 &&
        m_asleep[static_cast<std::size_t>(m_braids[second])] != 0)
        return false;
    const float s = contact.alongFirst;
    const float t = contact.alongSecond;
    const glm::vec3 alongA = m_nodesHd[first + 1] - m_nodesHd[first];
    const glm::vec3 alongB = m_nodesHd[second + 1] - m_nodesHd[second];
    const glm::vec3 apart = m_nodesHd[first] + alongA * s - m_nodesHd[second] - alongB * t;
    const float distance = std::sqrt(glm::dot(apart, apart));
    contact.clearM = std::min(contact.clearM, allowedM(contact));
    contact.gapM = distance - contact.clearM;
    if (contact.gapM > BraidPairs::kNearM)
        return false;
    constexpr float kMeets = 1e-6F; // Axes that meet leave across both.
    const glm::vec3 across = distance > kMeets ? apart : glm::cross(alongA, alongB);
    const float across2 = glm::dot(across, across);
    if (!(across2 > 0.0F))
        return false;
    contact.normal = across * (1.0F / std::sqrt(across2));
    const glm::vec3 velocity = m_velocitiesM[first] + (m_velocitiesM[first + 1] - m_velocitiesM[first]) * s +
                               m_velocitiesM[second] + (m_velocitiesM[second + 1] - m_velocitiesM[second]) * t;
    contact.velocityM = withoutCreeping(velocity * 0.5F);
    contact.ofFirst = partOfFirst(m_nodesHd[first], contact.normal);
    return true;
}

/// `weight`: how much of the point that touches follows the node, 0..1. A node that decides less than half of it may
/// move the further against the other braid.
void BraidContact::addTo(std::size_t node, float weight, const Contact& contact, bool isFirst)
{
    const float room = contact.gapM > 0.0F ? -0.5F * contact.gapM
                                           : std::min((isFirst ? contact.ofFirst : 1.0F - contact.ofFirst) * kTaken *
                                                          std::max(-contact.gapM - kLeft * contact.clearM, 0.0F),
                                                      kMostTakenM);
    const float offset = room - (1.0F - std::min(2.0F * weight, 1.0F)) * contact.clearM;
    if (offset < -BraidPairs::kNearM)
        return;
    NodePlanes& at = m_nodePlanes[node];
    ++at.contacts;
    at.velocitiesM += contact.velocityM;
    const std::int32_t other = m_braids[static_cast<std::size_t>(isFirst ? contact.second : contact.first)];
    // That of the same braid, or a new one, or instead of that which asks for the least.
    const auto known = std::span(at.planes).first(at.count);
    auto of = std::ranges::find(known, other, &Plane::other);
    if (of == known.end()) {
        if (at.count < at.planes.size()) {
            at.planes[at.count++] = {other, offset, isFirst ? contact.normal : -contact.normal};
            return;
        }
        of = std::ranges::min_element(known, {}, &Plane::offsetM);
    }
    if (offset > of->offsetM)
        *of = {other, offset, isFirst ? contact.normal : -contact.normal};
}

void BraidContact::addPlanes(const Contact& contact)
{
    const auto first = static_cast<std::size_t>(contact.first);
    const auto second = static_cast<std::size_t>(contact.second);
    addTo(first, 1.0F - contact.alongFirst, contact, true);
    addTo(first + 1, contact.alongFirst, contact, true);
    addTo(second, 1.0F - contact.alongSecond, contact, false);
    addTo(second + 1, contact.alongSecond, contact, false);
}

/// The braids of one block, each into its lane.
void BraidContact::writeBlock(std::size_t row)
{
    const auto nodes = static_cast<std::size_t>(m_nodes);
    for (auto node = static_cast<std::size_t>(m_firstNode); node < nodes; ++node) {
        std::uint32_t most = 0;
        for (std::size_t braid = m_firstOfRow[row]; braid < m_firstOfRow[row + 1]; ++braid) {
            const NodePlanes& from = m_nodePlanes[braid * nodes + node];
            float* const to = m_rows.data() + (row * nodes + node) * kBraidRows * kLanes + laneOf(m_strands[braid]);
            std::uint8_t& written = m_written[braid * nodes + node];
            most = std::max(most, from.count);
            for (std::size_t i = 0; i < std::max<std::size_t>(from.count, written); ++i) {
                // One that is no longer there holds nothing back: 0 >= 0.
                float* const plane = to + (3 + 4 * i) * kLanes;
                const bool isThere = i < from.count;
                const glm::vec3 normal = isThere ? from.planes[i].normal : glm::vec3(0.0F);
                StrandBlocks::store(plane, normal);
                plane[3 * StrandBlocks::kAxisStride] =
                    isThere ? glm::dot(normal, m_nodesHd[braid * nodes + node]) + from.planes[i].offsetM : 0.0F;
            }
            written = static_cast<std::uint8_t>(from.count);
            if (from.count > 0)
                StrandBlocks::store(to, from.velocitiesM * (1.0F / static_cast<float>(from.contacts)));
        }
        m_counts[row * nodes + node] = static_cast<std::uint8_t>(most);
    }
}

std::size_t BraidContact::meet(const StrandState& state, std::span<const StepForces> wanted)
{
    const bool windy = wanted.front().windy;
    const std::size_t most = windy ? kWindyStepsAContact : kStepsAContact;
    if (!m_isFound || m_stepsDone >= most) {
        read(state);
        m_pairs.update(m_nodesHd, nodesInRows());
        parallelFor(m_strands.size(), kBraidsAtOnce, [&](std::size_t begin, std::size_t end) {
            for (std::size_t braid = begin; braid < end; ++braid)
                findContacts(braid);
        });
        for (NodePlanes& node : m_nodePlanes) {
            node.count = 0;
            node.contacts = 0;
            node.velocitiesM = glm::vec3(0.0F);
        }
        for (std::size_t braid = 0; braid < m_strands.size(); ++braid)
            for (std::size_t i = 0; i < m_contactCounts[braid]; ++i)
                addPlanes(m_contacts[braid * m_mostContacts + i]);
        parallelFor(m_firstOfRow.size() - 1, kBraidsAtOnce, [&](std::size_t begin, std::size_t end) {
            for (std::size_t row = begin; row < end; ++row)
                writeBlock(row);
        });
        m_isFound = true;
        m_stepsDone = 0;
    }
    const auto other = std::ranges::find_if(wanted, [windy](const StepForces& step) { return step.windy != windy; });
    return std::min(static_cast<std::size_t>(other - wanted.begin()), most - m_stepsDone);
}

} // namespace hairpaint::sim
