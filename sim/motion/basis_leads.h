// How the basis hairs of a group lie, by which hairs between them find those that they can follow.
#pragma once

#include "sim/groom/groom.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hairpaint::sim {

/// What of a hair is compared to tell whether hairs lie alike, see agreement().
struct HairLead
{
    glm::vec3 reach{0.0F}; ///< From the root to the tip, over the length that its displacements are divided by.
    glm::vec3 start{0.0F}; ///< Unit: direction from the root to about a quarter of its length.
    float lengthM = 0.0F;
    friend bool operator==(const HairLead&, const HairLead&) = default;
};

/// `perLength`: 1 over the length that its displacements are divided by.
[[nodiscard]] HairLead leadOf(const Groom& groom, std::span<const float> restPositions, std::size_t strand,
                              float lengthM, float perLength);
/// 1 where both lie at one position, 0 where they lie to different sides.
[[nodiscard]] float agreement(const HairLead& a, const HairLead& b);
/// By what a basis hair's displacements are divided: its length, but what stubble does in contact with the skin would
/// be zigzags on long hair beside it.
[[nodiscard]] float displacementScaleM(float basisLengthM);

/// One thread writes, any number read between.
class BasisLeads
{
public:
    /// Returns whether any differs from the groom before, and in `changed` [basis lanes] which.
    bool update(const Groom& groom, std::vector<std::uint8_t>& changed);

    [[nodiscard]] const HairLead& operator[](std::size_t basis) const { return m_leads[basis]; }
    /// Of the basis hairs of `leastM` and more the one whose root is nearest; none where there are none. 10 us.
    [[nodiscard]] std::optional<std::uint32_t> nearestAsLong(const RootSet& roots, glm::vec3 rootHd,
                                                             float leastM) const;

private:
    std::shared_ptr<const BasisStyles> m_basis;
    std::vector<HairLead> m_leads; ///< [basis lanes] of m_basis.
};

} // namespace hairpaint::sim
