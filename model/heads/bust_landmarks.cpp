// Regions as closed curves on a sphere around the head's middle, drawn through points a hairdresser would mark.
#include "model/heads/bust_landmarks.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hairpaint::heads {

namespace {

// A curve seen from a point inside the head: Catmull-Rom through marks on the left side, kept as unit directions.
class SkinCurve
{
public:
    // The axis is where a closed curve's flat map is centred; it lies inside the region and has x = 0.
    SkinCurve(const glm::vec3& centre, const glm::vec3& axis, std::span<const glm::vec3> marks)
        : m_centre(centre), m_axis(glm::normalize(axis)), m_across(glm::cross(glm::vec3(1.0F, 0.0F, 0.0F), m_axis))
    {
        constexpr int steps = 6;
        for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
            const glm::vec3& p1 = marks[i];
            const glm::vec3& p2 = marks[i + 1];
            // Ends in the middle go on as their mirror image.
            const glm::vec3 p0 = i > 0 ? marks[i - 1] : beyond(p1, p2);
            const glm::vec3 p3 = i + 2 < marks.size() ? marks[i + 2] : beyond(p2, p1);
            for (int k = 0; k < steps; ++k) {
                const float t = static_cast<float>(k) / static_cast<float>(steps);
                add(p1 +
                    0.5F * t *
                        (p2 - p0 + t * (2.0F * p0 - 5.0F * p1 + 4.0F * p2 - p3 + t * (3.0F * (p1 - p2) + p3 - p0))));
            }
        }
        add(marks.back());
    }

    // Metres along the skin, never negative. `along` gets the nearest place on the curve, 0 to 1.
    float distance(const glm::vec3& p, float* along = nullptr) const
    {
        const glm::vec3 fromCentre = folded(p) - m_centre;
        const float radius = glm::length(fromCentre) + 1.0e-12F;
        const glm::vec3 direction = fromCentre / radius;
        float nearest = 8.0F;
        for (std::size_t i = 0; i + 1 < m_directions.size(); ++i) {
            const glm::vec3 edge = m_directions[i + 1] - m_directions[i];
            const glm::vec3 from = direction - m_directions[i];
            const float t = std::clamp(glm::dot(from, edge) / glm::dot(edge, edge), 0.0F, 1.0F);
            const glm::vec3 gap = from - edge * t;
            const float squared = glm::dot(gap, gap);
            if (squared < nearest) {
                nearest = squared;
                if (along != nullptr)
                    *along = (static_cast<float>(i) + t) / static_cast<float>(m_directions.size() - 1);
            }
        }
        return radius * 2.0F * std::asin(0.5F * std::sqrt(nearest));
    }

    // For a curve that starts and ends in the middle: the side on which the axis lies is positive.
    float signedDistance(const glm::vec3& p) const
    {
        const glm::vec2 flattened = flat(glm::normalize(folded(p) - m_centre));
        bool isInside = false;
        for (std::size_t i = 0; i + 1 < m_places.size(); ++i) {
            const glm::vec2& a = m_places[i];
            const glm::vec2& b = m_places[i + 1];
            if ((a.y > flattened.y) != (b.y > flattened.y) &&
                flattened.x < a.x + (b.x - a.x) * (flattened.y - a.y) / (b.y - a.y))
                isInside = !isInside;
        }
        return isInside ? distance(p) : -distance(p);
    }

private:
    static glm::vec3 folded(const glm::vec3& p) { return {std::abs(p.x), p.y, p.z}; }

    static glm::vec3 beyond(const glm::vec3& end, const glm::vec3& next)
    {
        return end.x == 0.0F ? glm::vec3(-next.x, next.y, next.z) : 2.0F * end - next;
    }

    // Azimuthal equidistant map around the axis.
    glm::vec2 flat(const glm::vec3& direction) const
    {
        const glm::vec2 sideways(direction.x, glm::dot(direction, m_across));
        const float sine = glm::length(sideways);
        return sideways * (std::atan2(sine, glm::dot(direction, m_axis)) / std::max(sine, 1.0e-12F));
    }

    void add(const glm::vec3& mark)
    {
        m_directions.push_back(glm::normalize(mark - m_centre));
        m_places.push_back(flat(m_directions.back()));
    }

    glm::vec3 m_centre;
    glm::vec3 m_axis;
    glm::vec3 m_across;
    std::vector<glm::vec3> m_directions;
    std::vector<glm::vec2> m_places;
};

const SkinCurve& hairline()
{
    static constexpr std::array<glm::vec3, 23> marks = {
        {{0.000F, 0.0745F, 0.0770F},    {0.016F, 0.0750F, 0.0755F},    {0.032F, 0.0765F, 0.0660F},
         {0.044F, 0.0755F, 0.0530F},    {0.052F, 0.0660F, 0.0460F},    {0.058F, 0.0530F, 0.0440F},
         {0.0625F, 0.0400F, 0.0440F},   {0.0675F, 0.0270F, 0.0380F},   {0.0700F, 0.0140F, 0.0270F},
         {0.0710F, 0.0000F, 0.0205F},   {0.0710F, -0.0120F, 0.0185F},  {0.0710F, -0.0165F, 0.0140F},
         {0.0720F, -0.0120F, 0.0105F},  {0.0730F, 0.0030F, 0.0095F},   {0.0740F, 0.0165F, 0.0060F},
         {0.0750F, 0.0240F, -0.0060F},  {0.0750F, 0.0215F, -0.0200F},  {0.0730F, 0.0080F, -0.0310F},
         {0.0700F, -0.0150F, -0.0350F}, {0.0620F, -0.0380F, -0.0420F}, {0.0450F, -0.0560F, -0.0600F},
         {0.0220F, -0.0650F, -0.0730F}, {0.0000F, -0.0630F, -0.0770F}}};
    static const SkinCurve curve({0.0F, 0.0F, -0.005F}, {0.0F, 0.85F, -0.50F}, marks);
    return curve;
}

const SkinCurve& beardline()
{
    static constexpr std::array<glm::vec3, 15> marks = {{{0.0000F, -0.0520F, 0.0930F},
                                                         {0.0100F, -0.0520F, 0.0920F},
                                                         {0.0200F, -0.0550F, 0.0850F},
                                                         {0.0310F, -0.0590F, 0.0760F},
                                                         {0.0430F, -0.0520F, 0.0640F},
                                                         {0.0570F, -0.0400F, 0.0440F},
                                                         {0.0670F, -0.0250F, 0.0240F},
                                                         {0.0710F, -0.0150F, 0.0180F},
                                                         {0.0720F, -0.0150F, 0.0110F},
                                                         {0.0690F, -0.0330F, 0.0070F},
                                                         {0.0620F, -0.0560F, 0.0020F},
                                                         {0.0530F, -0.0820F, 0.0030F},
                                                         {0.0380F, -0.1000F, 0.0120F},
                                                         {0.0200F, -0.1080F, 0.0240F},
                                                         {0.0000F, -0.1110F, 0.0290F}}};
    static const SkinCurve curve({0.0F, -0.030F, 0.010F}, {0.0F, -0.80F, 0.60F}, marks);
    return curve;
}

const SkinCurve& browline()
{
    static constexpr std::array<glm::vec3, 6> marks = {{{0.0120F, 0.0225F, 0.0900F},
                                                        {0.0190F, 0.0255F, 0.0885F},
                                                        {0.0270F, 0.0280F, 0.0855F},
                                                        {0.0360F, 0.0290F, 0.0790F},
                                                        {0.0440F, 0.0270F, 0.0710F},
                                                        {0.0510F, 0.0220F, 0.0610F}}};
    static const SkinCurve curve({0.0F, 0.0F, -0.005F}, {0.0F, 0.3F, 0.95F}, marks);
    return curve;
}

// First-order signed distance to an ellipsoid, positive outside.
float outsideEllipsoid(const glm::vec3& p, const glm::vec3& semiAxes)
{
    const glm::vec3 scaled = p / semiAxes;
    const float radial = glm::length(scaled);
    return radial * (radial - 1.0F) / std::max(glm::length(scaled / semiAxes), 1.0e-6F);
}

// The ear's flap hides skin behind it that has the same direction. Frame: back, up, out of the ear, tilted and flared
// as the ear is.
float outsideEar(const glm::vec3& p)
{
    const glm::vec3 q = glm::vec3(std::abs(p.x), p.y, p.z) - glm::vec3(0.0725F, -0.0140F, -0.0100F);
    const float tiltCos = std::cos(glm::radians(12.0F));
    const float tiltSin = std::sin(glm::radians(12.0F));
    const glm::vec2 tilted(tiltCos * q.y + tiltSin * q.z, -tiltSin * q.y + tiltCos * q.z);
    const float flareCos = std::cos(glm::radians(28.0F));
    const float flareSin = std::sin(glm::radians(28.0F));
    const glm::vec3 e(flareSin * q.x - flareCos * tilted.y, tilted.x, flareCos * q.x + flareSin * tilted.y);
    return outsideEllipsoid(e - glm::vec3(0.0F, 0.0005F, 0.0015F), {0.0230F, 0.0350F, 0.0100F});
}

float outsideLips(const glm::vec3& p)
{
    const glm::vec3 q = p - glm::vec3(0.0F, -0.0708F, 0.0850F);
    return outsideEllipsoid(q, {0.0290F, 0.0115F, 0.0260F});
}

} // namespace

float scalpDistance(const glm::vec3& p)
{
    return std::min(hairline().signedDistance(p), outsideEar(p));
}

float browDistance(const glm::vec3& p)
{
    float along = 0.0F;
    const float distance = browline().distance(p, &along);
    const float halfWidth = 0.0048F - 0.0032F * along * along;
    return halfWidth - distance;
}

float beardDistance(const glm::vec3& p)
{
    // The chest lies in the directions of the jaw's underside.
    const float aboveNeck = p.y + 0.128F;
    const float belowSideburn = -hairline().signedDistance(p);
    return std::min({beardline().signedDistance(p), outsideLips(p), outsideEar(p), belowSideburn, aboveNeck});
}

BustLandmarks bustLandmarks()
{
    return {.crown = {0.0F, 0.11097F, -0.03705F},
            .forehead = {0.0F, 0.0745F, 0.0782F},
            .earLeft = {0.0742F, -0.0178F, -0.0064F},
            .earRight = {-0.0742F, -0.0178F, -0.0064F},
            .nape = {0.0F, -0.0625F, -0.0770F},
            .chin = {0.0F, -0.1120F, 0.0881F},
            .noseTip = {0.0F, -0.0363F, 0.1109F}};
}

} // namespace hairpaint::heads
