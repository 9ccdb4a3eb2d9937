// Projection of lanes, for the kernels of picking.
#if defined(HAIRPAINT_VIEW_PICKING_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_VIEW_PICKING_LANES_INL_H_
#undef HAIRPAINT_VIEW_PICKING_LANES_INL_H_
#else
#define HAIRPAINT_VIEW_PICKING_LANES_INL_H_
#endif

#include "sim/base/lanes_inl.h"
#include "view/picking/lens.h"

#include <cstdint>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::view::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using namespace sim::HWY_NAMESPACE;

/// Bit a lane.
HWY_INLINE std::uint32_t bitsOf(Yes yes)
{
    std::uint8_t bytes[8] = {}; // As many as the function may write. NOLINT(modernize-avoid-c-arrays)
    hn::StoreMaskBits(Tag(), yes.m, bytes);
    return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8U;
}

/// Lens::seen().
HWY_INLINE Lanes3 seenBy(const Lens& lens, const Lanes3& p)
{
    const glm::mat4& m = lens.view();
    const auto row = [&](int r) {
        return Lanes(m[0][r]) * p.x + Lanes(m[1][r]) * p.y + Lanes(m[2][r]) * p.z + Lanes(m[3][r]);
    };
    const Lanes depth = Lanes(0.0F) - row(2);
    const Lanes scale = Lanes(lens.px()) / most(depth, Lanes(Lens::kNearestM));
    return {Lanes(lens.half().x) + row(0) * scale, Lanes(lens.half().y) - row(1) * scale, depth};
}

} // namespace hairpaint::view::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
