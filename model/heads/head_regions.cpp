// Regions as closed curves on a sphere around the head's middle.
#include "model/heads/head_regions.h"

#include "sim/base/rounded.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::heads {

namespace {

/// First-order signed distance to an ellipsoid, positive outside.
float outsideEllipsoid(const glm::vec3& p, const glm::vec3& semiAxes)
{
    const glm::vec3 scaled = p / semiAxes;
    const float radial = glm::length(scaled);
    return radial * (radial - 1.0F) / std::max(glm::length(scaled / semiAxes), 1.0e-6F);
}

} // namespace

HeadRegions::HeadRegions(const RegionMarks& marks)
    : m_hairline({0.0F, 0.0F, -0.005F}, {0.0F, 0.85F, -0.50F}, marks.hairline),
      m_beardline({0.0F, -0.030F, 0.010F}, {0.0F, -0.80F, 0.60F}, marks.beardline),
      m_browline({0.0F, 0.0F, -0.005F}, {0.0F, 0.3F, 0.95F}, marks.browline), m_earCentre(marks.earCentre),
      m_earFlareDegrees(marks.earFlareDegrees), m_earTiltDegrees(marks.earTiltDegrees), m_lipsCentre(marks.lipsCentre),
      m_neckBelowY(marks.neckBelowY)
{
    if (!marks.lashline.empty())
        m_lashline.emplace(glm::vec3(0.0F, 0.0F, -0.005F), glm::vec3(0.0F, 0.0F, 1.0F), marks.lashline);
}

/// The ear's flap hides skin behind it that has the same direction. Frame: back, up, out of the ear, tilted and flared
/// as the ear is.
float HeadRegions::outsideEar(const glm::vec3& p) const
{
    const glm::vec3 q = glm::vec3(std::abs(p.x), p.y, p.z) - m_earCentre;
    const float tiltCos = sim::cosRounded(glm::radians(m_earTiltDegrees));
    const float tiltSin = sim::sinRounded(glm::radians(m_earTiltDegrees));
    const glm::vec2 tilted(tiltCos * q.y + tiltSin * q.z, -tiltSin * q.y + tiltCos * q.z);
    const float flareCos = sim::cosRounded(glm::radians(m_earFlareDegrees));
    const float flareSin = sim::sinRounded(glm::radians(m_earFlareDegrees));
    const glm::vec3 e(flareSin * q.x - flareCos * tilted.y, tilted.x, flareCos * q.x + flareSin * tilted.y);
    return outsideEllipsoid(e - glm::vec3(0.0F, 0.0005F, 0.0015F), {0.0230F, 0.0350F, 0.0100F});
}

float HeadRegions::scalpDistance(const glm::vec3& p) const
{
    return std::min(m_hairline.signedDistance(p), outsideEar(p));
}

float HeadRegions::browDistance(const glm::vec3& p) const
{
    float along = 0.0F;
    const float distance = m_browline.distance(p, &along);
    const float halfWidth = 0.0048F - 0.0032F * along * along;
    return halfWidth - distance;
}

float HeadRegions::lashDistance(const glm::vec3& p, float* along) const
{
    constexpr float farM = 1.0F;
    return m_lashline && p.z > 0.0F ? m_lashline->distance(p, along) : farM;
}

float HeadRegions::beardDistance(const glm::vec3& p) const
{
    // The chest lies in the directions of the jaw's underside.
    const float aboveNeck = p.y - m_neckBelowY;
    const float belowSideburn = -m_hairline.signedDistance(p);
    const float outsideLips = outsideEllipsoid(p - m_lipsCentre, {0.0290F, 0.0115F, 0.0260F});
    return std::min({m_beardline.signedDistance(p), outsideLips, outsideEar(p), belowSideburn, aboveNeck});
}

} // namespace hairpaint::heads
