// Which strands of a group the software renderer draws.
#pragma once

#include "sim/groom/groom.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hairpaint::rendering {

/// Slots chunk by chunk, so that sixteen in a row are neighbours; within a chunk as `detail` rises, so that those that
/// stand for others lie side by side, and those that thin out, too.
class StrandList
{
public:
    void update(const std::shared_ptr<const sim::Groom>& groom, float detail);
    [[nodiscard]] std::span<const std::uint32_t> slots() const { return m_slots; }
    [[nodiscard]] float detail() const { return m_detail; }

private:
    std::shared_ptr<const sim::Groom> m_groom;
    float m_detail = -1.0F;
    std::vector<std::uint32_t> m_slots;
};

} // namespace hairpaint::rendering
