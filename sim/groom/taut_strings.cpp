// Pulls strings over the skin.
#include "sim/groom/taut_strings.h"

#include "sim/base/parallel.h"
#include "sim/groom/taut_kernel.h"
#include "sim/groom/unit_vector.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr std::uint32_t kNoString = 0xFFFFFFFFU;
constexpr float kLeastHeadM = 0.03F; ///< Least distance of the middle of the head from the strings' end,
constexpr float kMostHeadM = 0.12F;  ///< and the greatest.
constexpr float kLargeHeadM = 0.09F; ///< That distance where a ray through the head meets no other side.

} // namespace

TautStrings::TautStrings(SkinDistance distance, glm::vec3 endHd) : m_distance(std::move(distance)), m_endHd(endHd)
{
    const Skin& skin = *m_distance.skin();
    const SurfacePoint foot = skin.nearest(endHd);
    m_outwardHd = foot.normalHd;
    constexpr float kInsideM = 1e-3F;
    const glm::vec3 from = foot.positionHd - foot.normalHd * kInsideM;
    float acrossM = 2.0F * kLargeHeadM;
    if (const auto other = skin.pick({.originHd = from, .directionHd = -foot.normalHd}))
        acrossM = lengthOfVector(other->positionHd - from);
    m_centreHd = foot.positionHd - foot.normalHd * std::clamp(0.5F * acrossM, kLeastHeadM, kMostHeadM);
    m_endHd = m_distance.pushedOut(endHd, kStringClearanceM, m_centreHd);
    m_stringOf.assign(skin.mesh().positionsHd.size(), kNoString);
}

void TautStrings::prepare(std::span<const std::uint32_t> faces)
{
    const HeadMesh& mesh = m_distance.skin()->mesh();
    std::vector<std::uint32_t> wanted;
    const auto first = static_cast<std::uint32_t>(m_strings.size());
    for (const std::uint32_t face : faces) {
        const glm::uvec3 corners = mesh.triangles[face];
        for (int corner = 0; corner < 3; ++corner) {
            std::uint32_t& string = m_stringOf[corners[corner]];
            if (string != kNoString)
                continue;
            string = first + static_cast<std::uint32_t>(wanted.size());
            wanted.push_back(corners[corner]);
        }
    }
    m_strings.resize(m_strings.size() + wanted.size());
    parallelFor(blocksFor(wanted.size()), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin * kLanes; i < std::min(end * kLanes, wanted.size()); i += kLanes) {
            const std::size_t count = std::min<std::size_t>(kLanes, wanted.size() - i);
            pull(std::span(m_strings).subspan(first + i, count), std::span(wanted).subspan(i, count));
        }
    });
}

void TautStrings::pull(std::span<TautString> strings, std::span<const std::uint32_t> vertices) const
{
    const HeadMesh& mesh = m_distance.skin()->mesh();
    std::array<float, kStringPoints * StrandBlocks::kNodeStride> points{};
    const TautTask task{.distance = &m_distance,
                        .centreHd = m_centreHd,
                        .outwardHd = m_outwardHd,
                        .endHd = m_endHd,
                        .pointsHd = points.data()};
    for (std::size_t lane = 0; lane < kLanes; ++lane)
        StrandBlocks::store(points.data() + lane, mesh.positionsHd[vertices[std::min(lane, vertices.size() - 1)]]);
    pullLanes(task);
    for (std::size_t lane = 0; lane < strings.size(); ++lane)
        StrandBlocks(kStringPoints).read(points, lane, strings[lane].pointsHd);
}

std::array<std::uint32_t, 3> TautStrings::ofFace(std::uint32_t face) const
{
    const glm::uvec3 corners = m_distance.skin()->mesh().triangles[face];
    return {m_stringOf[corners.x], m_stringOf[corners.y], m_stringOf[corners.z]};
}

} // namespace hairpaint::sim
