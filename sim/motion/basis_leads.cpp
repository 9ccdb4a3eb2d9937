// Leads from rest shapes.
#include "sim/motion/basis_leads.h"

#include "sim/solver/agreement.h"

#include <algorithm>
#include <limits>

namespace hairpaint::sim {

HairLead leadOf(const Groom& groom, std::span<const float> restPositions, std::size_t strand, float lengthM,
                float perLength)
{
    const auto last = static_cast<std::size_t>(groom.nodes - 1);
    const auto node = [&](std::size_t i) { return groom.blocks().node(restPositions, strand, i); };
    const glm::vec3 root = node(0);
    const glm::vec3 start = node((last + 3) / 4) - root;
    return {(node(last) - root) * perLength, start / std::max(glm::length(start), 1e-9F), lengthM};
}

float agreement(const HairLead& a, const HairLead& b)
{
    // By their tips alone both sides of a bob's parting would be near each other.
    const float start = std::clamp(glm::dot(a.start, b.start) + 0.5F, 0.0F, 1.0F);
    return start * agreementOfTips(&a.reach.x, &b.reach.x);
}

float displacementScaleM(float basisLengthM)
{
    constexpr float kStubbleM = 0.03F;
    return std::max(basisLengthM, kStubbleM);
}

bool BasisLeads::update(const Groom& groom, std::vector<std::uint8_t>& changed)
{
    if (!groom.basis || m_basis == groom.basis)
        return false;
    const BasisStyles& basis = *groom.basis;
    const std::size_t count = basis.blockCount() * kLanes;
    m_basis = groom.basis;
    m_leads.resize(count);
    changed.assign(count, 0);
    bool any = false;
    const auto last = static_cast<std::size_t>(groom.nodes - 1);
    for (std::size_t i = 0; i < count; ++i) {
        const float lengthM = basis[BasisQuantity::SegmentLength][i] * static_cast<float>(last);
        const HairLead lead = leadOf(groom, basis.restPositions, i, lengthM, 1.0F / displacementScaleM(lengthM));
        changed[i] = lead == m_leads[i] ? 0 : 1;
        any = any || changed[i] != 0;
        m_leads[i] = lead;
    }
    return any;
}

std::optional<std::uint32_t> BasisLeads::nearestAsLong(const RootSet& roots, glm::vec3 rootHd, float leastM) const
{
    std::optional<std::uint32_t> nearest;
    float least = std::numeric_limits<float>::max();
    for (std::uint32_t basis = 0; basis < roots.basisSlot.size(); ++basis) {
        if (m_leads[basis].lengthM < leastM)
            continue;
        const glm::vec3 apart = roots.positionHd[roots.basisSlot[basis]] - rootHd;
        if (const float square = glm::dot(apart, apart); square < least) {
            least = square;
            nearest = basis;
        }
    }
    return nearest;
}

} // namespace hairpaint::sim
