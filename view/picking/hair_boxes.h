// Where in the 3D area's picture the blocks of a group's hair lie.
#pragma once

#include "sim/motion/strand_frame.h"
#include "view/picking/lens.h"

#include <cstdint>
#include <vector>

namespace hairpaint::view {

/// px of the view.
struct PictureBox
{
    float left = 1e9F, top = 1e9F, right = -1e9F, bottom = -1e9F;

    [[nodiscard]] bool meets(const PictureBox& other) const
    {
        return left <= other.right && other.left <= right && top <= other.bottom && other.top <= bottom;
    }
    [[nodiscard]] PictureBox widened(float px) const { return {left - px, top - px, right + px, bottom + px}; }
    void add(glm::vec2 point)
    {
        left = std::min(left, point.x);
        top = std::min(top, point.y);
        right = std::max(right, point.x);
        bottom = std::max(bottom, point.y);
    }
    void add(const PictureBox& other)
    {
        left = std::min(left, other.left);
        top = std::min(top, other.top);
        right = std::max(right, other.right);
        bottom = std::max(bottom, other.bottom);
    }
};

/// How far a strand's drawn curve may stray from its skeleton.
[[nodiscard]] float strayM(const sim::Groom& groom, std::size_t slot);

/// For each block in which hairs are positioned, boxes around every kSpan segments of its skeletons, with room for the
/// curves that are drawn around them. Immutable. About 3 ms to make for 100,000 hairs on one core, less on several.
struct HairBoxes
{
    static constexpr std::size_t kSpan = 2; ///< Segments a box.

    struct Block
    {
        std::uint32_t firstSlot = 0;
        std::uint32_t lanes = 0; ///< Bit a lane: positioned hairs.
    };
    std::vector<Block> blocks;
    std::size_t spans = 0;          ///< Boxes a block.
    std::vector<PictureBox> wholes; ///< [blocks] box around all of a block's boxes.
    std::vector<PictureBox> boxes;  ///< [blocks][spans]
    std::vector<float> nearestM;    ///< [blocks][spans] Depth before which nothing of it is drawn.
    std::vector<float> strays;      ///< [blocks][kPickLanes] strayM() of positioned hairs.

    HairBoxes(const sim::GroupFrame& group, const Lens& lens);
};

} // namespace hairpaint::view
