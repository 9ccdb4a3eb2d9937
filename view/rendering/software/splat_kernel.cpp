// Lays strands into the voxels of the opacity grids.
#include "view/rendering/software/opacity_grids.h"
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

constexpr int kMostSteps = 8; ///< That a span is laid in.

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

HWY_INLINE Ints voxelAt(const Triple<Lanes>& place)
{
    const IntTag di;
    const auto along = [&](Lanes p) {
        return hn::ConvertTo(di, clamped(p, 0.0F, static_cast<float>(kGridSide) - 0.5F).v);
    };
    const Ints side = hn::Set(di, kGridSide);
    return hn::Add(hn::Mul(hn::Add(hn::Mul(along(place.z), side), along(place.y)), side), along(place.x));
}

/// The strand's spans, as many at a time as there are lanes.
void splatStrand(const SplatTask& task, const float* node, std::int32_t strand, std::uint32_t* voxels)
{
    constexpr auto kVoxelsOfGrid = static_cast<std::size_t>(kGridSide) * kGridSide * kGridSide;
    constexpr auto kStride = static_cast<std::int32_t>(sim::StrandBlocks::kNodeStride);
    constexpr std::size_t kAxis = sim::StrandBlocks::kAxisStride;
    const IntTag di;
    const auto lanes = static_cast<int>(hn::Lanes(di));
    const int spans = task.nodes - 1;
    for (int first = 0; first < spans; first += lanes) {
        // Lanes without a span are the last one again.
        const Ints span = hn::Min(hn::Iota(di, first), hn::Set(di, spans - 1));
        const Ints at = hn::Mul(span, hn::Set(di, kStride));
        const auto loadedAt = [&](const float* from) {
            const auto axis = [&](std::size_t a) { return Lanes(hn::GatherIndex(Tag(), from + a * kAxis, at)); };
            return Triple<Lanes>{axis(0), axis(1), axis(2)};
        };
        const Triple<Lanes> a = loadedAt(node);
        const Triple<Lanes> b = loadedAt(node + kStride);
        const Triple<Lanes> seenA = seenFromEye(task, a);
        const Triple<Lanes> seenB = seenFromEye(task, b);
        const std::array<Triple<Lanes>, 2> from{inVoxels(task.gridFromWo, a), eyeVoxels(task, seenA)};
        const std::array<Triple<Lanes>, 2> to{inVoxels(task.gridFromWo, b), eyeVoxels(task, seenB)};
        const Lanes longest = most(distance(from[0], to[0]), distance(from[1], to[1]));
        const Lanes steps = floored(clamped(longest, 0.0F, static_cast<float>(kMostSteps) - 0.5F)) + Lanes(1.0F);
        const Lanes area = distance(a, b) * Lanes(task.weight) / steps;
        // A column widens with the distance. What no ray of the picture meets hides nothing.
        const Lanes nearer = Lanes(2.0F * task.eyeGrid.middleM) / most(seenA.z + seenB.z, Lanes(1e-2F));
        const Lanes middleX = (from[1].x + to[1].x) * Lanes(0.5F);
        const Lanes middleY = (from[1].y + to[1].y) * Lanes(0.5F);
        const Lanes end(static_cast<float>(kGridSide));
        const Yes met = (middleX > Lanes(0.0F)) & (middleX < end) & (middleY > Lanes(0.0F)) & (middleY < end) &
                        (least(seenA.z, seenB.z) > Lanes(0.01F));
        const Lanes seenArea = select(met, least(area * nearer * nearer, Lanes(1e6F)), Lanes(0.0F));
        HWY_ALIGN std::int32_t areas[kMostLanes];
        HWY_ALIGN std::int32_t seenAreas[kMostLanes];
        HWY_ALIGN std::int32_t counts[kMostLanes];
        hn::Store(hn::ConvertTo(di, (area + Lanes(0.5F)).v), di, areas);
        hn::Store(hn::ConvertTo(di, (seenArea + Lanes(0.5F)).v), di, seenAreas);
        hn::Store(hn::ConvertTo(di, steps.v), di, counts);
        const int used = std::min(lanes, spans - first);
        const int mostSteps = *std::max_element(counts, counts + used);
        for (int n = 0; n < mostSteps; ++n) {
            const Ints random = hashOf(
                hn::Add(hn::Mul(span, hn::Set(di, kMostSteps)), hn::Set(di, strand * kMostNodes * kMostSteps + n)));
            const auto jitter = [&](Ints bits) {
                return Lanes(hn::ConvertTo(Tag(), hn::And(bits, hn::Set(di, 0x3FF)))) * Lanes(1.0F / 1024.0F) -
                       Lanes(0.5F);
            };
            const Triple<Lanes> aside{jitter(random), jitter(hn::ShiftRight<10>(random)),
                                      jitter(hn::ShiftRight<20>(random))};
            const Lanes t = Lanes(static_cast<float>(n) + 0.5F) / steps;
            HWY_ALIGN std::int32_t places[2][kMostLanes];
            for (std::size_t grid = 0; grid < 2; ++grid)
                hn::Store(voxelAt(from[grid] + (to[grid] - from[grid]) * t + aside), di, places[grid]);
            for (int i = 0; i < used; ++i) {
                if (n >= counts[i])
                    continue;
                voxels[places[0][i]] += static_cast<std::uint32_t>(areas[i]);
                voxels[kVoxelsOfGrid + static_cast<std::size_t>(places[1][i])] +=
                    static_cast<std::uint32_t>(seenAreas[i]);
            }
        }
    }
}

void splatAll(const SplatTask& task, std::uint32_t* voxels)
{
    const sim::Groom& groom = *task.group->groom;
    const sim::StrandBlocks layout = groom.blocks();
    for (std::size_t i = task.first; i < task.slots.size(); i += task.step) {
        const std::size_t strand = groom.frameStrand(task.slots[i]);
        splatStrand(task, task.group->positions.data() + layout.index(strand, 0), static_cast<std::int32_t>(strand),
                    voxels);
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
