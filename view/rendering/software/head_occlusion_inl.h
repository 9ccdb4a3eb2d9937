// Testing boxes of the picture against the head.
#if defined(HAIRPAINT_RENDERING_HEAD_OCCLUSION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_HEAD_OCCLUSION_INL_H_
#undef HAIRPAINT_RENDERING_HEAD_OCCLUSION_INL_H_
#else
#define HAIRPAINT_RENDERING_HEAD_OCCLUSION_INL_H_
#endif

#include "view/rendering/light/lanes_inl.h"
#include "view/rendering/software/occlusion_cells.h"

#include <glm/glm.hpp>

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

/// A box in the picture, samples. It touches the picture.
struct ScreenBox
{
    Lanes lowX, lowY, highX, highY;
};

/// Distance beyond which the head hides all that lies in the box, m; huge where it does not. `sizeSp`: the picture's.
HWY_INLINE Lanes hiddenBeyondM(const OcclusionCells& cells, const ScreenBox& box, glm::vec2 sizeSp)
{
    const IntTag di;
    const Lanes extent = most(box.highX - box.lowX, box.highY - box.lowY);
    float size = kOcclusionCellSp;
    Lanes perCell(1.0F / size);
    Lanes firstRow(0.0F);
    for (std::size_t level = 1; level < kOcclusionLevels; ++level, size *= 2.0F) {
        const Yes larger = extent > Lanes(size);
        perCell = select(larger, Lanes(0.5F / size), perCell);
        firstRow = select(larger, Lanes(static_cast<float>(cells.firstRow[level])), firstRow);
    }
    const Lanes x = clamped(box.lowX, 0.0F, sizeSp.x - 1.0F) * perCell;
    const Lanes y = floored(clamped(box.lowY, 0.0F, sizeSp.y - 1.0F) * perCell) + firstRow;
    const Ints index = hn::Add(hn::Mul(hn::ConvertTo(di, y.v), hn::Set(di, cells.across)), hn::ConvertTo(di, x.v));
    const Lanes found(hn::GatherIndex(Tag(), cells.beyondM, index));
    return select(extent <= Lanes(size), found, Lanes(std::numeric_limits<float>::max()));
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
