// How far away the foremost hair under a brush is, and which blocks reach before it.
#pragma once

#include "view/picking/front_hair.h"
#include "view/picking/picture_brush.h"
#include "view/picking/picture_hair.h"

#include <compare>
#include <cstdint>
#include <vector>

namespace hairpaint::view {

/// A block of the picture's boxes that reaches near a brush.
struct NearBlock
{
    float depthM; ///< Least depth of its hair near the brush.
    std::uint32_t index;
    std::uint32_t spans;                                                   ///< Bit a box: those near the brush.
    friend auto operator<=>(const NearBlock&, const NearBlock&) = default; // NOLINT(modernize-use-nullptr)
};

/// Told by some of the blocks near the brush, from the eye on. The same for any number of threads.
class BrushFront
{
public:
    /// Both must outlive it.
    BrushFront(const PictureHair& picture, const PictureBrush& brush);

    [[nodiscard]] const FrontHair& hair() const { return m_front; }
    /// Hair that lies deeper is hidden wherever the brush is.
    [[nodiscard]] float deepestM() const { return m_deepestM; }
    /// The blocks that reach near the brush before that depth, in ascending order.
    [[nodiscard]] const std::vector<NearBlock>& blocks() const { return m_blocks; }
    /// Where to look in such a block: what hair in front hides as a whole is left out.
    [[nodiscard]] BlockQuestion questionOf(const NearBlock& block) const;

private:
    const PictureHair& m_picture;
    const PictureBrush& m_brush;
    FrontHair m_front;
    float m_deepestM;
    std::vector<NearBlock> m_blocks;
};

} // namespace hairpaint::view
