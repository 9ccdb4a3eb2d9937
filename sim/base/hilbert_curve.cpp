// Skilling's method: undo each level's rotation, then read the bits as a Gray code.
#include "sim/base/hilbert_curve.h"

namespace hairpaint::sim {

std::uint32_t hilbertIndex(glm::uvec3 cell)
{
    constexpr std::uint32_t kTop = 1U << (kHilbertBits - 1);
    for (std::uint32_t level = kTop; level > 1; level >>= 1U) {
        const std::uint32_t below = level - 1;
        for (int axis = 0; axis < 3; ++axis) {
            if ((cell[axis] & level) != 0) {
                cell.x ^= below;
            } else {
                const std::uint32_t swapped = (cell.x ^ cell[axis]) & below;
                cell.x ^= swapped;
                cell[axis] ^= swapped;
            }
        }
    }
    cell.y ^= cell.x;
    cell.z ^= cell.y;
    std::uint32_t flip = 0;
    for (std::uint32_t level = kTop; level > 1; level >>= 1U)
        if ((cell.z & level) != 0)
            flip ^= level - 1;
    cell ^= flip;

    std::uint32_t index = 0;
    for (int bit = kHilbertBits - 1; bit >= 0; --bit)
        for (int axis = 0; axis < 3; ++axis)
            index = (index << 1U) | ((cell[axis] >> static_cast<unsigned>(bit)) & 1U);
    return index;
}

} // namespace hairpaint::sim
