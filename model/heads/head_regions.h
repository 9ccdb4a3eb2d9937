// Where hair grows on a built-in head.
//
// Head space: metres, y up, face toward +z, origin at the head's centre. Everything is symmetric in x.
#pragma once

#include "model/heads/skin_curve.h"

#include <glm/glm.hpp>

#include <optional>
#include <span>

namespace hairpaint::heads {

/// Points on the left half of the skin through which the regions' borders run, from the middle or toward it.
struct RegionMarks
{
    std::span<const glm::vec3> hairline;  ///< From the forehead's middle over temple and ear to the nape's middle.
    std::span<const glm::vec3> beardline; ///< From below the nose over the cheek to below the jaw.
    std::span<const glm::vec3> browline;  ///< The brow's middle line, from its inner end outward.
    std::span<const glm::vec3> lashline;  ///< Where the closed lids meet, outward; empty where the eyes have no lids.
    glm::vec3 earCentre{0.0F};
    float earFlareDegrees = 0.0F; ///< How far the ear's rear edge stands off the head.
    float earTiltDegrees = 0.0F;  ///< How far its top leans forward.
    glm::vec3 lipsCentre{0.0F};
    float neckBelowY = 0.0F; ///< No beard grows below.
};

/// Signed distances along the skin, in metres, from a point on it to a region's border; positive inside. True to a few
/// percent near the border, a smooth field elsewhere. Points far off the skin get the value of the skin under them as
/// seen from inside the head. Pure functions of constants: any thread, no errors.
class HeadRegions
{
public:
    explicit HeadRegions(const RegionMarks& marks);

    /// Forehead with slight recession at the temples, sideburn, round the ear, nape; ears are outside.
    [[nodiscard]] float scalpDistance(const glm::vec3& p) const;
    /// Both eyebrows.
    [[nodiscard]] float browDistance(const glm::vec3& p) const;
    /// From where the lids meet, never negative; `along` gets the nearest position there, 0 (inner corner) to 1. Far
    /// from everything where the head's lids are not known.
    [[nodiscard]] float lashDistance(const glm::vec3& p, float* along = nullptr) const;
    /// Cheeks below the sideburns, moustache, chin, under the jaw; lips are outside.
    [[nodiscard]] float beardDistance(const glm::vec3& p) const;

private:
    [[nodiscard]] float outsideEar(const glm::vec3& p) const;

    SkinCurve m_hairline;
    SkinCurve m_beardline;
    SkinCurve m_browline;
    std::optional<SkinCurve> m_lashline;
    glm::vec3 m_earCentre;
    float m_earFlareDegrees;
    float m_earTiltDegrees;
    glm::vec3 m_lipsCentre;
    float m_neckBelowY;
};

} // namespace hairpaint::heads
