// Pulls strings over the skin.
#include "sim/groom/taut_strings.h"

#include "sim/base/parallel.h"
#include "sim/groom/unit_vector.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr std::uint32_t kNoString = 0xFFFFFFFFU;
constexpr std::size_t kCoarse = 3;           ///< Spans of a string at first; they are halved twice.
constexpr std::array kPulls = {5, 4, 3};     ///< Times that a string is pulled before, between and after.
constexpr float kLeastHeadM = 0.03F;         ///< Least distance of the middle of the head from the strings' end,
constexpr float kMostHeadM = 0.12F;          ///< and the greatest.
constexpr float kLargeHeadM = 0.09F;         ///< That distance where a ray through the head meets no other side.

constexpr float kOtherSide = 0.3F; ///< Cosine of the angle at the middle of the head, between a root and the end, below
                                   ///< which the root is on the other side.
constexpr std::size_t kLastPoint = kStringPoints - 1;

static_assert(kCoarse << 2U == kStringPoints - 1);

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
    parallelFor(wanted.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            m_strings[first + i] = pulled(mesh.positionsHd[wanted[i]]);
    });
}

float TautStrings::layCoarse(Points& p, glm::vec3 aside) const
{
    const glm::vec3 a = p[0] - m_centreHd;
    const glm::vec3 b = p[kLastPoint] - m_centreHd;
    const float lengthA = lengthOfVector(a);
    const float lengthB = lengthOfVector(b);
    constexpr std::size_t kStride = kLastPoint / kCoarse;
    for (std::size_t i = kStride; i < kLastPoint; i += kStride) {
        const float t = static_cast<float>(i) / static_cast<float>(kLastPoint);
        const glm::vec3 between = unitVectorOr(a, m_outwardHd) * (1.0F - t) + unitVectorOr(b, m_outwardHd) * t;
        p[i] = m_centreHd + unitVectorOr(between + aside, m_outwardHd) * (lengthA * (1.0F - t) + lengthB * t);
        p[i] = m_distance.pushedOut(p[i], kStringClearanceM, m_centreHd);
    }
    pull(p, kStride, kPulls[0]);
    float lengthM = 0.0F;
    for (std::size_t i = kStride; i <= kLastPoint; i += kStride)
        lengthM += lengthOfVector(p[i] - p[i - kStride]);
    return lengthM;
}

void TautStrings::pull(Points& p, std::size_t stride, int times) const
{
    const std::size_t inner = kLastPoint / stride - 1;
    for (int pull = 0; pull < times; ++pull)
        for (std::size_t k = 1; k <= inner; ++k) {
            // To and fro, so that neither end is favoured.
            const std::size_t i = (pull % 2 == 0 ? k : inner + 1 - k) * stride;
            p[i] = m_distance.pushedOut((p[i - stride] + p[i + stride]) * 0.5F, kStringClearanceM, m_centreHd);
        }
}

TautString TautStrings::pulled(glm::vec3 fromHd) const
{
    TautString string;
    Points& p = string.pointsHd;
    p[0] = fromHd;
    p[kLastPoint] = m_endHd;
    float shortestM = layCoarse(p, glm::vec3(0.0F));
    const glm::vec3 a = unitVectorOr(fromHd - m_centreHd, m_outwardHd);
    const glm::vec3 b = unitVectorOr(m_endHd - m_centreHd, m_outwardHd);
    if (glm::dot(a, b) < kOtherSide) {
        for (const glm::vec3 aside : {glm::vec3(0.0F, 1.0F, 0.0F), glm::vec3(0.0F, 0.0F, -1.0F)}) {
            Points other = p;
            // Nobody ties hair across a face.
            constexpr float kFavoured = 0.8F;
            const float lengthM = layCoarse(other, aside) * kFavoured;
            if (lengthM < shortestM) {
                shortestM = lengthM;
                p = other;
            }
        }
    }
    std::size_t stride = kLastPoint / kCoarse;
    for (std::size_t level = 1; level < kPulls.size(); ++level) {
        stride /= 2;
        for (std::size_t i = stride; i < kLastPoint; i += 2 * stride)
            p[i] = m_distance.pushedOut((p[i - stride] + p[i + stride]) * 0.5F, kStringClearanceM, m_centreHd);
        pull(p, stride, kPulls.at(level));
    }
    return string;
}

std::array<std::uint32_t, 3> TautStrings::ofFace(std::uint32_t face) const
{
    const glm::uvec3 corners = m_distance.skin()->mesh().triangles[face];
    return {m_stringOf[corners.x], m_stringOf[corners.y], m_stringOf[corners.z]};
}

} // namespace hairpaint::sim
