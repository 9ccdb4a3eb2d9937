// Sixteen points of a span at a time.
#include "view/rendering/software/splat_kernel.h"

#include "view/rendering/software/strand_block.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "view/rendering/software/splat_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "view/rendering/light/lanes_inl.h"
#include <algorithm>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

constexpr int kMostSteps = 32;  ///< That a span is laid in: close by it lies in many voxels.
constexpr int kSpanNumbers = 8; ///< From a span's first random number to the next one's.

HWY_INLINE Ints hashOf(Ints x)
{
    const IntTag di;
    const auto shifted = [&]<int kBits>(Ints v) {
        const hn::RebindToUnsigned<IntTag> du;
        return hn::BitCast(di, hn::ShiftRight<kBits>(hn::BitCast(du, v)));
    };
    x = hn::Xor(x, shifted.operator()<16>(x));
    x = hn::Mul(x, hn::Set(di, 0x7FEB352D));
    x = hn::Xor(x, shifted.operator()<15>(x));
    x = hn::Mul(x, hn::Set(di, static_cast<std::int32_t>(0x846CA68BU)));
    return hn::Xor(x, shifted.operator()<16>(x));
}

HWY_INLINE Triple<Lanes> inVoxels(const glm::mat4& gridFromWo, const Triple<Lanes>& wo)
{
    constexpr auto kSize = static_cast<float>(kGridSide);
    const auto row = [&](int r) {
        return (wo.x * Lanes(gridFromWo[0][r]) + wo.y * Lanes(gridFromWo[1][r]) + wo.z * Lanes(gridFromWo[2][r]) +
                Lanes(gridFromWo[3][r])) *
               Lanes(kSize);
    };
    return {row(0), row(1), row(2)};
}

/// In voxels too; the third is the distance along the view, m.
HWY_INLINE Triple<Lanes> seenFromEye(const SplatTask& task, const Triple<Lanes>& wo)
{
    const glm::mat4& m = task.projectionFromWo;
    const auto row = [&](int r) {
        return wo.x * Lanes(m[0][r]) + wo.y * Lanes(m[1][r]) + wo.z * Lanes(m[2][r]) + Lanes(m[3][r]);
    };
    const Lanes away = row(3);
    const Lanes per = Lanes(1.0F) / most(away, Lanes(1e-3F));
    constexpr auto kSize = static_cast<float>(kGridSide);
    return {(row(0) * per - Lanes(task.eyeGrid.low.x)) * Lanes(task.eyeGrid.per.x * kSize),
            (row(1) * per - Lanes(task.eyeGrid.low.y)) * Lanes(task.eyeGrid.per.y * kSize), away};
}

HWY_INLINE Triple<Lanes> eyeVoxels(const SplatTask& task, const Triple<Lanes>& seen)
{
    return {seen.x, seen.y,
            (seen.z - Lanes(task.eyeGrid.low.z)) * Lanes(task.eyeGrid.per.z * static_cast<float>(kGridSide))};
}

HWY_INLINE Lanes distance(const Triple<Lanes>& a, const Triple<Lanes>& b)
{
    const Triple<Lanes> step = b - a;
    return root(dot(step, step));
}

HWY_INLINE Ints voxelAt(const Triple<Lanes>& position)
{
    const IntTag di;
    const auto along = [&](Lanes p) {
        return hn::ConvertTo(di, clamped(p, 0.0F, static_cast<float>(kGridSide) - 0.5F).v);
    };
    const Ints side = hn::Set(di, kGridSide);
    return hn::Add(hn::Mul(hn::Add(hn::Mul(along(position.z), side), along(position.y)), side), along(position.x));
}

/// A node of some strands, one a lane, as the grids have it.
struct SplatNode
{
    Triple<Lanes> wo;
    std::array<Triple<Lanes>, 2> inGrid; ///< Voxels of the light's grid and of the eye's.
    Lanes awayM;                         ///< Along the view.
};

HWY_INLINE SplatNode nodeAt(const SplatTask& task, const float* positions, Ints at)
{
    constexpr std::size_t kAxis = sim::StrandBlocks::kAxisStride;
    const auto axis = [&](std::size_t a) { return Lanes(hn::GatherIndex(Tag(), positions + a * kAxis, at)); };
    const Triple<Lanes> wo{axis(0), axis(1), axis(2)};
    const Triple<Lanes> seen = seenFromEye(task, wo);
    return {.wo = wo, .inGrid = {inVoxels(task.gridFromWo, wo), eyeVoxels(task, seen)}, .awayM = seen.z};
}

/// Span `span` of some strands, from `a` to `b`; the first `used` lanes count. `strand`: numbers.
HWY_INLINE void splatSpan(const SplatTask& task, const SplatNode& a, const SplatNode& b, int span, Ints strand,
                          int used, std::uint32_t* voxels)
{
    constexpr auto kVoxelsOfGrid = static_cast<std::size_t>(kGridSide) * kGridSide * kGridSide;
    const IntTag di;
    const Lanes longest = most(distance(a.inGrid[0], b.inGrid[0]), distance(a.inGrid[1], b.inGrid[1]));
    const Lanes steps = floored(clamped(longest, 0.0F, static_cast<float>(kMostSteps) - 0.5F)) + Lanes(1.0F);
    const Lanes area = distance(a.wo, b.wo) * Lanes(task.weight) / steps;
    // A column widens with the distance. What no ray of the picture meets hides nothing.
    const Lanes nearer = Lanes(2.0F * task.eyeGrid.middleM) / most(a.awayM + b.awayM, Lanes(1e-2F));
    const Lanes middleX = (a.inGrid[1].x + b.inGrid[1].x) * Lanes(0.5F);
    const Lanes middleY = (a.inGrid[1].y + b.inGrid[1].y) * Lanes(0.5F);
    const Lanes end(static_cast<float>(kGridSide));
    const Yes met = (middleX > Lanes(0.0F)) & (middleX < end) & (middleY > Lanes(0.0F)) & (middleY < end) &
                    (least(a.awayM, b.awayM) > Lanes(0.01F));
    const Lanes seenArea = select(met, least(area * nearer * nearer, Lanes(1e6F)), Lanes(0.0F));
    HWY_ALIGN std::int32_t areas[kMostLanes];
    HWY_ALIGN std::int32_t seenAreas[kMostLanes];
    HWY_ALIGN std::int32_t counts[kMostLanes];
    hn::Store(hn::ConvertTo(di, (area + Lanes(0.5F)).v), di, areas);
    hn::Store(hn::ConvertTo(di, (seenArea + Lanes(0.5F)).v), di, seenAreas);
    hn::Store(hn::ConvertTo(di, steps.v), di, counts);
    const int mostSteps = *std::max_element(counts, counts + used);
    const Ints seed =
        hn::Add(hn::Mul(strand, hn::Set(di, kMostNodes * kSpanNumbers)), hn::Set(di, span * kSpanNumbers));
    for (int n = 0; n < mostSteps; ++n) {
        const Ints random = hashOf(hn::Add(seed, hn::Set(di, n)));
        const auto jitter = [&](Ints bits) {
            return Lanes(hn::ConvertTo(Tag(), hn::And(bits, hn::Set(di, 0x3FF)))) * Lanes(1.0F / 1024.0F) - Lanes(0.5F);
        };
        const Triple<Lanes> aside{jitter(random), jitter(hn::ShiftRight<10>(random)),
                                  jitter(hn::ShiftRight<20>(random))};
        const Lanes t = Lanes(static_cast<float>(n) + 0.5F) / steps;
        HWY_ALIGN std::int32_t cells[2][kMostLanes];
        for (std::size_t grid = 0; grid < 2; ++grid)
            hn::Store(voxelAt(a.inGrid[grid] + (b.inGrid[grid] - a.inGrid[grid]) * t + aside), di, cells[grid]);
        for (int i = 0; i < used; ++i) {
            if (n >= counts[i])
                continue;
            voxels[cells[0][i]] += static_cast<std::uint32_t>(areas[i]);
            voxels[kVoxelsOfGrid + static_cast<std::size_t>(cells[1][i])] += static_cast<std::uint32_t>(seenAreas[i]);
        }
    }
}

/// As many strands at a time as there are lanes.
void splatAll(const SplatTask& task, std::uint32_t* voxels)
{
    const IntTag di;
    const auto lanes = static_cast<int>(hn::Lanes(di));
    const sim::Groom& groom = *task.group->groom;
    const sim::StrandBlocks layout = groom.blocks();
    const float* positions = task.group->positions.data();
    for (std::size_t i = task.first; i < task.slots.size();) {
        HWY_ALIGN std::int32_t strands[kMostLanes] = {};
        HWY_ALIGN std::int32_t indices[kMostLanes] = {};
        int used = 0;
        for (; used < lanes && i < task.slots.size(); ++used, i += task.step) {
            const std::size_t strand = groom.frameStrand(task.slots[i]);
            strands[used] = static_cast<std::int32_t>(strand);
            indices[used] = static_cast<std::int32_t>(layout.index(strand, 0));
        }
        const Ints strand = hn::Load(di, strands);
        const Ints at = hn::Load(di, indices);
        SplatNode before = nodeAt(task, positions, at);
        for (int span = 0; span + 1 < task.nodes; ++span) {
            const std::size_t next = static_cast<std::size_t>(span + 1) * sim::StrandBlocks::kNodeStride;
            const SplatNode after = nodeAt(task, positions + next, at);
            splatSpan(task, before, after, span, strand, used, voxels);
            before = after;
        }
    }
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::rendering {

HWY_EXPORT(splatAll);

void splatStrands(const SplatTask& task, std::uint32_t* voxels)
{
    HWY_DYNAMIC_DISPATCH(splatAll)(task, voxels);
}

} // namespace hairpaint::rendering
#endif
