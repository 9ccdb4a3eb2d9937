// Candidates laid out along a curve through the skin: rank by a scrambled bit reversal, slot by the curve.
#include "sim/groom/roots.h"

#include "sim/base/deterministic.h"
#include "sim/base/hilbert_curve.h"
#include "sim/base/parallel.h"
#include "sim/groom/basis_neighbours.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace hairpaint::sim {

namespace {

constexpr std::size_t kGrain = 4096;
constexpr std::uint64_t kScrambleKey = 0x726F6F7473U; ///< Apart from the keys of other uses of the seed.

/// The skin's faces one after another along the curve, with the area up to each.
struct AreaCurve
{
    std::vector<std::uint32_t> faces;
    std::vector<double> areaBefore; ///< [faces + 1], m2; ascending.
};

AreaCurve layOutFaces(const Skin& skin)
{
    const HeadMesh& mesh = skin.mesh();
    glm::vec3 lowest(std::numeric_limits<float>::max());
    glm::vec3 highest(-std::numeric_limits<float>::max());
    for (const glm::vec3& position : mesh.positionsHd) {
        lowest = glm::min(lowest, position);
        highest = glm::max(highest, position);
    }
    const glm::vec3 extent = highest - lowest;
    const float side = std::max({extent.x, extent.y, extent.z, 1e-20F});
    constexpr auto kLastCell = static_cast<float>((1U << static_cast<unsigned>(kHilbertBits)) - 1);

    std::vector<std::uint64_t> keys; // Index on the curve, then the face: no ties.
    keys.reserve(mesh.triangles.size());
    for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
        const float area = skin.faceAreaM2(face);
        if (!(area > 0.0F) || !std::isfinite(area))
            continue;
        const glm::uvec3 t = mesh.triangles[face];
        const glm::vec3 centre =
            (mesh.positionsHd[t.x] + mesh.positionsHd[t.y] + mesh.positionsHd[t.z]) * (1.0F / 3.0F);
        const glm::vec3 cell = glm::clamp((centre - lowest) / side, 0.0F, 1.0F) * kLastCell;
        keys.push_back((static_cast<std::uint64_t>(hilbertIndex(glm::uvec3(cell))) << 32U) | face);
    }
    std::sort(keys.begin(), keys.end());

    AreaCurve curve;
    curve.faces.reserve(keys.size());
    curve.areaBefore.reserve(keys.size() + 1);
    double area = 0.0;
    for (const std::uint64_t key : keys) {
        curve.faces.push_back(static_cast<std::uint32_t>(key));
        curve.areaBefore.push_back(area);
        area += static_cast<double>(skin.faceAreaM2(curve.faces.back()));
    }
    curve.areaBefore.push_back(area);
    return curve;
}

std::uint32_t reverseBits(std::uint32_t x)
{
    x = ((x & 0x55555555U) << 1U) | ((x >> 1U) & 0x55555555U);
    x = ((x & 0x33333333U) << 2U) | ((x >> 2U) & 0x33333333U);
    x = ((x & 0x0F0F0F0FU) << 4U) | ((x >> 4U) & 0x0F0F0F0FU);
    x = ((x & 0x00FF00FFU) << 8U) | ((x >> 8U) & 0x00FF00FFU);
    return (x << 16U) | (x >> 16U);
}

/// The van der Corput sequence with Owen's scrambling: of the first 2^k ranks exactly one falls in each 2^-k-th of the
/// curve. Every step lets a bit depend on lower bits only, which is what keeps that (Laine and Karras 2011).
class CurveSequence
{
public:
    explicit CurveSequence(std::uint64_t seed)
    {
        for (std::uint64_t i = 0; i < m_factors.size(); ++i)
            m_factors[i] = static_cast<std::uint32_t>(hash64(seed ^ kScrambleKey, i));
    }

    [[nodiscard]] std::uint32_t operator()(std::uint32_t rank) const
    {
        std::uint32_t x = rank + m_factors[0];
        x ^= x * (m_factors[1] & ~1U);
        x *= m_factors[2] | 1U;
        x ^= x * (m_factors[3] & ~1U);
        x += m_factors[4];
        x *= m_factors[5] | 1U;
        x ^= x * (m_factors[6] & ~1U);
        return reverseBits(x);
    }

private:
    std::array<std::uint32_t, 7> m_factors{};
};

/// Orders the ranks along the curve. Among n <= 2^k ranks no two share their index's first k bits, so each has a cell
/// of its own and nothing need be compared.
void orderAlongCurve(RootSet& roots, const CurveSequence& sequence, std::size_t count)
{
    constexpr std::uint32_t kEmpty = std::numeric_limits<std::uint32_t>::max();
    const auto bits = static_cast<unsigned>(std::bit_width(count - 1));
    std::vector<std::uint32_t> rankOfCell(std::size_t{1} << bits, kEmpty);
    parallelFor(count, kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t rank = begin; rank < end; ++rank) {
            const std::uint64_t curvePosition = sequence(static_cast<std::uint32_t>(rank));
            rankOfCell[curvePosition >> (32U - bits)] = static_cast<std::uint32_t>(rank);
        }
    });
    roots.rankOfSlot.reserve(count);
    roots.slotOfRank.resize(count);
    for (const std::uint32_t rank : rankOfCell) {
        if (rank == kEmpty)
            continue;
        roots.slotOfRank[rank] = static_cast<std::uint32_t>(roots.rankOfSlot.size());
        roots.rankOfSlot.push_back(rank);
    }
}

/// Spreads 0..1 over a triangle, uniform by area: each pair of bits chooses one of four similar triangles
/// (Basu and Owen 2015), so that the curve goes on inside the face.
glm::vec3 barycentricAt(double fraction)
{
    constexpr int kLevels = 16;
    auto digits = static_cast<std::uint32_t>(std::clamp(fraction, 0.0, 1.0) * 4294967295.0);
    glm::vec2 corner(0.0F);
    float size = 1.0F; // Negative where the triangle is upside down.
    for (int level = 0; level < kLevels; ++level) {
        size *= 0.5F;
        switch (digits >> 30U) {
        case 0:
            break;
        case 1:
            corner.x += size;
            break;
        case 2:
            corner += size;
            size = -size;
            break;
        default:
            corner.y += size;
            break;
        }
        digits <<= 2U;
    }
    corner += size * (1.0F / 3.0F);
    return {1.0F - corner.x - corner.y, corner.x, corner.y};
}

void locateOnSkin(RootSet& roots, const CurveSequence& sequence, const AreaCurve& curve, std::uint64_t seed)
{
    const std::size_t count = roots.count();
    roots.face.resize(count);
    roots.uv.resize(count);
    roots.positionHd.resize(count);
    roots.normalHd.resize(count);
    roots.tangentHd.resize(count);
    roots.mirrored.resize(count);
    const double totalArea = curve.areaBefore.back();
    parallelFor(count, kGrain, [&](std::size_t begin, std::size_t end) {
        std::size_t at = 0;
        for (std::size_t slot = begin; slot < end; ++slot) {
            const std::uint32_t rank = roots.rankOfSlot[slot];
            // Below the sequence's 32 bits the index is random, so that it is not tied to a lattice.
            const std::uint64_t low = hash64(seed, rank) >> 43U;
            const std::uint64_t curvePosition = (static_cast<std::uint64_t>(sequence(rank)) << 21U) | low;
            const double area = static_cast<double>(curvePosition) * (totalArea / 9007199254740992.0);
            if (slot == begin)
                at = static_cast<std::size_t>(
                    std::upper_bound(curve.areaBefore.begin(), curve.areaBefore.end() - 1, area) -
                    curve.areaBefore.begin() - 1);
            while (at + 1 < curve.faces.size() && curve.areaBefore[at + 1] <= area)
                ++at;
            const double width = curve.areaBefore[at + 1] - curve.areaBefore[at];
            const double fraction = width > 0.0 ? (area - curve.areaBefore[at]) / width : 0.0;
            const SurfacePoint point = roots.skin->at(curve.faces[at], barycentricAt(fraction));
            roots.face[slot] = point.face;
            roots.uv[slot] = point.uv;
            roots.positionHd[slot] = point.positionHd;
            roots.normalHd[slot] = point.normalHd;
            roots.tangentHd[slot] = point.tangentHd;
            roots.mirrored[slot] = glm::dot(glm::cross(point.dPduHd, point.dPdvHd), point.normalHd) < 0.0F
                                       ? std::uint8_t{1}
                                       : std::uint8_t{0};
        }
    });
}

/// Within each chunk by rank: what a coarse picture leaves out lies in blocks of its own, which nobody need compute.
void orderChunksByRank(RootSet& roots)
{
    const std::size_t chunks = (roots.count() + kChunkSlots - 1) / kChunkSlots;
    parallelFor(chunks, 16, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> slots;
        for (std::size_t chunk = begin; chunk < end; ++chunk) {
            const std::size_t first = chunk * kChunkSlots;
            slots.resize(std::min<std::size_t>(kChunkSlots, roots.count() - first));
            std::iota(slots.begin(), slots.end(), static_cast<std::uint32_t>(first));
            std::ranges::sort(slots, {}, [&](std::uint32_t slot) { return roots.rankOfSlot[slot]; });
            const auto order = [&]<class T>(std::vector<T>& values) {
                std::vector<T> ordered(slots.size());
                std::ranges::transform(slots, ordered.begin(), [&](std::uint32_t slot) { return values[slot]; });
                std::ranges::copy(ordered, values.begin() + static_cast<std::ptrdiff_t>(first));
            };
            order(roots.rankOfSlot);
            order(roots.face);
            order(roots.uv);
            order(roots.positionHd);
            order(roots.normalHd);
            order(roots.tangentHd);
            order(roots.mirrored);
            order(roots.neighbours);
            order(roots.weights);
            for (std::size_t slot = first; slot < first + slots.size(); ++slot)
                roots.slotOfRank[roots.rankOfSlot[slot]] = static_cast<std::uint32_t>(slot);
        }
    });
}

} // namespace

SurfacePoint RootSet::surfacePoint(std::uint32_t slot) const
{
    const HeadMesh& mesh = skin->mesh();
    const glm::uvec3 corners = mesh.triangles[face[slot]];
    const glm::vec2 a = mesh.uvs[corners.x];
    const glm::vec2 ab = mesh.uvs[corners.y] - a;
    const glm::vec2 ac = mesh.uvs[corners.z] - a;
    const glm::vec2 at = uv[slot] - a;
    const float area = ab.x * ac.y - ab.y * ac.x;
    glm::vec3 barycentric(1.0F, 0.0F, 0.0F);
    if (std::abs(area) > 0.0F) {
        barycentric.y = (at.x * ac.y - at.y * ac.x) / area;
        barycentric.z = (ab.x * at.y - ab.y * at.x) / area;
        barycentric.x = 1.0F - barycentric.y - barycentric.z;
    }
    return skin->at(face[slot], barycentric);
}

std::shared_ptr<const RootSet> buildRoots(std::shared_ptr<const Skin> skin, std::size_t count, std::size_t basisCount,
                                          std::uint64_t seed)
{
    auto roots = std::make_shared<RootSet>();
    roots->skin = std::move(skin);
    roots->seed = seed;
    const AreaCurve curve = layOutFaces(*roots->skin);
    if (count == 0 || curve.faces.empty())
        return roots;
    const CurveSequence sequence(seed);
    orderAlongCurve(*roots, sequence, count);
    locateOnSkin(*roots, sequence, curve, seed);

    const std::size_t basis = std::min(basisCount, count);
    roots->basisSlot.reserve(basis);
    for (std::uint32_t slot = 0; slot < count; ++slot)
        if (roots->rankOfSlot[slot] < basis)
            roots->basisSlot.push_back(slot);
    findBasisNeighbours(*roots);

    std::vector<std::uint32_t> basisRank(basis);
    std::ranges::transform(roots->basisSlot, basisRank.begin(), [&](auto slot) { return roots->rankOfSlot[slot]; });
    orderChunksByRank(*roots);
    std::ranges::transform(basisRank, roots->basisSlot.begin(), [&](auto rank) { return roots->slotOfRank[rank]; });
    return roots;
}

} // namespace hairpaint::sim
