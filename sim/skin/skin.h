// The head's surface: where a ray meets it, which point lies at a uv, and the frame a hair stands in.
#pragma once

#include "sim/skin/head_mesh.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace hairpaint::sim {

/// A point on the skin. `barycentric` weighs the face's three vertices and sums to 1.
struct SurfacePoint
{
    std::uint32_t face = 0;
    glm::vec3 barycentric{1.0F, 0.0F, 0.0F};
    glm::vec2 uv{0.0F};
    glm::vec3 positionHd{0.0F};
    glm::vec3 normalHd{0.0F, 1.0F, 0.0F};  ///< Smooth, unit.
    glm::vec3 tangentHd{1.0F, 0.0F, 0.0F}; ///< Smoothed dP/du projected on the tangent plane, unit.
    /// Unsmoothed derivatives of the position by u and v on this face, m per uv unit: a disc on the skin becomes the
    /// right ellipse of texels through them.
    glm::vec3 dPduHd{1.0F, 0.0F, 0.0F};
    glm::vec3 dPdvHd{0.0F, 1.0F, 0.0F};
};

struct RayHd
{
    glm::vec3 originHd{0.0F};
    glm::vec3 directionHd{0.0F, 0.0F, -1.0F}; ///< Unit.
};

/// Immutable; every method may be called from any thread. Building it: O(n log n) for a bounding volume tree over the
/// faces and a grid over uv.
class Skin
{
public:
    explicit Skin(HeadMesh mesh);
    /// The same, or null where `goesOn` returns false: it is asked on this thread, every few thousand faces.
    [[nodiscard]] static std::shared_ptr<const Skin> make(HeadMesh mesh, const std::function<bool()>& goesOn);
    ~Skin();
    Skin(const Skin&) = delete;
    Skin& operator=(const Skin&) = delete;

    [[nodiscard]] const HeadMesh& mesh() const { return m_mesh; }
    [[nodiscard]] double areaM2() const { return m_areaM2; }
    /// Area of one face, m2.
    [[nodiscard]] float faceAreaM2(std::uint32_t face) const;

    [[nodiscard]] SurfacePoint at(std::uint32_t face, glm::vec3 barycentric) const;
    /// The first face hit from outside or inside; none where the ray misses.
    [[nodiscard]] std::optional<SurfacePoint> pick(const RayHd& ray) const;
    /// The point whose uv this is; where islands overlap, the face with the lowest index. None off every island.
    [[nodiscard]] std::optional<SurfacePoint> atUv(glm::vec2 uv) const;
    /// The nearest point on the skin.
    [[nodiscard]] SurfacePoint nearest(glm::vec3 positionHd) const;
    /// The corresponding point on the other side of the plane x = 0: nearest(reflected position), or none where the
    /// skin is further than `toleranceM` from it.
    [[nodiscard]] std::optional<SurfacePoint> mirrored(const SurfacePoint& point, float toleranceM = 0.003F) const;

private:
    struct Index;
    /// Without an index where it is stopped.
    Skin(HeadMesh mesh, const std::function<bool()>& goesOn);
    HeadMesh m_mesh;
    std::vector<glm::vec3> m_tangentsHd;
    double m_areaM2 = 0.0;
    std::unique_ptr<const Index> m_index;
};

} // namespace hairpaint::sim
