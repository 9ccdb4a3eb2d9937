// Which hair grows where another one would, were the head reflected over its middle.
#pragma once

#include "sim/motion/strand_frame.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::model {

/// Immutable; made in 40 ms for 100,000 hairs, by parallelFor. Each positioned hair goes with the one whose root is
/// nearest to its reflection, if one is within 5 mm (more where hair is sparse).
class MirroredRoots
{
public:
    explicit MirroredRoots(const sim::GroupFrame& hair);

    /// The slots of the hairs that go with that slot's, in ascending order.
    [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t slot) const
    {
        return std::span(m_slots).subspan(m_first[slot], m_first[slot + 1] - m_first[slot]);
    }

private:
    std::vector<std::uint32_t> m_first; ///< [slots + 1], into m_slots.
    std::vector<std::uint32_t> m_slots;
};

} // namespace hairpaint::model
