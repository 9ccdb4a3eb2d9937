// The head's own mesh made coarser, put back onto its skin.
#include "model/cards/scalp_cap.h"

#include "sim/base/rounded.h"
#include "sim/groom/roots.h"
#include "sim/skin/skin.h"
#include "sim/skin/vertex_clusters.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hairpaint::model {

namespace {

constexpr float kAboveSkinM = 0.8e-3F;
constexpr float kFarthestCosine = -0.9F; ///< From the axis: beyond it the projection tears.
constexpr std::size_t kFinestVertices = 6'000;

/// Right and up of the plane that the axis stands on.
void mapAxes(const glm::vec3& axis, glm::vec3& right, glm::vec3& up)
{
    const glm::vec3 upward =
        std::abs(axis.y) < 0.9F ? glm::vec3(0.0F, 1.0F, 0.0F) : glm::vec3(0.0F, 0.0F, axis.y > 0.0F ? -1.0F : 1.0F);
    right = glm::normalize(glm::cross(upward, axis));
    up = glm::cross(axis, right);
}

/// The coarse triangles all of whose corners have roots around them.
std::vector<glm::uvec3> hairyTriangles(const sim::CoarseMesh& coarse, const sim::HeadMesh& fine,
                                       const std::vector<bool>& hairyFaces)
{
    std::vector<bool> hairy(coarse.mesh.positionsHd.size());
    for (std::size_t face = 0; face < fine.triangles.size(); ++face)
        if (hairyFaces[face])
            for (int corner = 0; corner < 3; ++corner)
                hairy[coarse.clusterOf[fine.triangles[face][corner]]] = true;
    std::vector<glm::uvec3> kept;
    for (const glm::uvec3& triangle : coarse.mesh.triangles)
        if (hairy[triangle.x] && hairy[triangle.y] && hairy[triangle.z])
            kept.push_back(triangle);
    return kept;
}

/// The roots' mean direction and the point around which they lie.
void setView(const CurveSet& set, const SampledHair& hair, ScalpCap& cap)
{
    const sim::HeadPose& pose = set.pose();
    glm::dvec3 sum(0.0);
    glm::dvec3 normal(0.0);
    for (const std::uint32_t i : cap.hairs) {
        const Curve& curve = set.curves()[hair.curve[i]];
        sum += glm::dvec3(hair.samples(i).front());
        normal += glm::dvec3(pose.rotation * set.roots(curve).normalHd[curve.slot]);
    }
    const double length = glm::length(normal);
    cap.axisWo = length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0F, 1.0F, 0.0F);
    // Roots all around a ball have no mean normal, and their mean is its middle.
    const auto spread = static_cast<float>(length) / static_cast<float>(cap.hairs.size());
    cap.middleWo = glm::vec3(sum / static_cast<double>(cap.hairs.size())) - spread * cap.radiusM * cap.axisWo;
}

} // namespace

glm::vec3 ScalpCap::upWo() const
{
    glm::vec3 right;
    glm::vec3 up;
    mapAxes(axisWo, right, up);
    return up;
}

glm::vec2 ScalpCap::flat(const glm::vec3& positionWo) const
{
    glm::vec3 right;
    glm::vec3 up;
    mapAxes(axisWo, right, up);
    const glm::vec3 away = positionWo - middleWo;
    const glm::vec2 around(glm::dot(away, right), -glm::dot(away, up));
    const float aside = glm::length(around);
    const float angle = sim::atan2Rounded(aside, glm::dot(away, axisWo));
    return aside > 0.0F ? around / aside * (angle * radiusM) : glm::vec2(0.0F);
}

std::optional<ScalpCap> capOver(const CurveSet& set, const SampledHair& hair, std::vector<std::uint32_t> hairs,
                                int triangles)
{
    const sim::Skin* skin = set.skin();
    if (hairs.empty() || skin == nullptr)
        return std::nullopt;
    ScalpCap cap;
    cap.hairs = std::move(hairs);
    setView(set, hair, cap);
    std::vector<bool> hairyFaces(skin->mesh().triangles.size());
    for (const std::uint32_t i : cap.hairs) {
        const Curve& curve = set.curves()[hair.curve[i]];
        hairyFaces[set.roots(curve).face[curve.slot]] = true;
    }
    sim::CoarseMesh coarse;
    constexpr std::size_t kFewestVertices = 32;
    for (std::size_t vertices = kFinestVertices; vertices >= kFewestVertices; vertices = vertices * 3 / 4) {
        coarse = sim::coarsened(skin->mesh(), vertices);
        cap.triangles = hairyTriangles(coarse, skin->mesh(), hairyFaces);
        if (cap.triangles.size() <= static_cast<std::size_t>(triangles))
            break;
    }
    if (cap.triangles.size() > static_cast<std::size_t>(triangles))
        return std::nullopt;

    const sim::HeadPose& pose = set.pose();
    constexpr auto kUnused = std::numeric_limits<unsigned>::max();
    std::vector<unsigned> corner(coarse.mesh.positionsHd.size(), kUnused);
    cap.leastM = glm::vec2(std::numeric_limits<float>::max());
    cap.greatestM = glm::vec2(std::numeric_limits<float>::lowest());
    const auto cornerOf = [&](unsigned cluster) {
        if (corner[cluster] != kUnused)
            return corner[cluster];
        const sim::SurfacePoint point = skin->nearest(coarse.mesh.positionsHd[cluster]);
        const glm::vec3 positionHd = point.positionHd + kAboveSkinM * point.normalHd;
        ScalpCap::Vertex made{.positionWo = pose.rotation * positionHd + pose.positionWo,
                              .normalWo = pose.rotation * point.normalHd};
        made.flatM = cap.flat(made.positionWo);
        cap.leastM = glm::min(cap.leastM, made.flatM);
        cap.greatestM = glm::max(cap.greatestM, made.flatM);
        corner[cluster] = static_cast<unsigned>(cap.vertices.size());
        cap.vertices.push_back(made);
        return corner[cluster];
    };
    const auto isBehind = [&](const glm::uvec3& triangle) {
        for (int i = 0; i < 3; ++i) {
            const glm::vec3 positionWo =
                pose.rotation * coarse.mesh.positionsHd[triangle[i]] + pose.positionWo - cap.middleWo;
            if (glm::dot(positionWo, cap.axisWo) < kFarthestCosine * glm::length(positionWo))
                return true;
        }
        return false;
    };
    std::erase_if(cap.triangles, isBehind);
    for (glm::uvec3& triangle : cap.triangles)
        for (int i = 0; i < 3; ++i)
            triangle[i] = cornerOf(triangle[i]);
    // Where the coarse skin folds over, it is turned to face outward.
    for (glm::uvec3& triangle : cap.triangles) {
        const ScalpCap::Vertex& first = cap.vertices[triangle.x];
        const glm::vec3 face = glm::cross(cap.vertices[triangle.y].positionWo - first.positionWo,
                                          cap.vertices[triangle.z].positionWo - first.positionWo);
        if (glm::dot(face, first.normalWo) < 0.0F)
            std::swap(triangle.y, triangle.z);
    }
    const glm::vec2 size = cap.greatestM - cap.leastM;
    if (cap.triangles.empty() || size.x <= 0.0F || size.y <= 0.0F)
        return std::nullopt;
    return cap;
}

} // namespace hairpaint::model
