// Frames on the skin; the searches are those of the tree and the grid.
#include "sim/skin/skin.h"

#include "sim/skin/bounding_tree.h"
#include "sim/skin/going_on.h"
#include "sim/skin/uv_grid.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr float kTiny = 1e-20F;

/// `v` at unit length, or `otherwise` where it has none.
glm::vec3 unitOr(glm::vec3 v, glm::vec3 otherwise)
{
    const float squared = glm::dot(v, v);
    return squared > kTiny && std::isfinite(squared) ? v / std::sqrt(squared) : otherwise;
}

glm::vec3 anyPerpendicular(glm::vec3 unit)
{
    const glm::vec3 axis = std::abs(unit.x) < 0.7F ? glm::vec3(1.0F, 0.0F, 0.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
    return unitOr(axis - unit * glm::dot(axis, unit), glm::vec3(0.0F, 0.0F, 1.0F));
}

/// Twice the area times the face's normal.
glm::vec3 areaNormal(const HeadMesh& mesh, std::uint32_t face)
{
    const glm::uvec3 t = mesh.triangles[face];
    return glm::cross(mesh.positionsHd[t.y] - mesh.positionsHd[t.x], mesh.positionsHd[t.z] - mesh.positionsHd[t.x]);
}

struct Derivatives
{
    glm::vec3 dPdu, dPdv;
};

/// Derivatives of the position by uv on one face; none where the face has no extent in uv.
std::optional<Derivatives> derivativesOf(const HeadMesh& mesh, std::uint32_t face)
{
    const glm::uvec3 t = mesh.triangles[face];
    const glm::dvec2 ab = glm::dvec2(mesh.uvs[t.y]) - glm::dvec2(mesh.uvs[t.x]);
    const glm::dvec2 ac = glm::dvec2(mesh.uvs[t.z]) - glm::dvec2(mesh.uvs[t.x]);
    const double determinant = ab.x * ac.y - ab.y * ac.x;
    if (!(std::abs(determinant) > 1e-16))
        return std::nullopt;
    const glm::dvec3 edgeB = glm::dvec3(mesh.positionsHd[t.y]) - glm::dvec3(mesh.positionsHd[t.x]);
    const glm::dvec3 edgeC = glm::dvec3(mesh.positionsHd[t.z]) - glm::dvec3(mesh.positionsHd[t.x]);
    return Derivatives{glm::vec3((edgeB * ac.y - edgeC * ab.y) / determinant),
                       glm::vec3((edgeC * ab.x - edgeB * ac.x) / determinant)};
}

} // namespace

struct Skin::Index
{
    BoundingTree tree;
    UvGrid grid;
    std::vector<float> faceAreasM2;
    std::vector<std::optional<Derivatives>> derivatives; ///< By face.
};

Skin::Skin(HeadMesh mesh) : Skin(std::move(mesh), std::function<bool()>()) {}

std::shared_ptr<const Skin> Skin::make(HeadMesh mesh, const std::function<bool()>& goesOn)
{
    const std::shared_ptr<const Skin> skin(new Skin(std::move(mesh), goesOn));
    return skin->m_index ? skin : nullptr;
}

Skin::Skin(HeadMesh mesh, const std::function<bool()>& goesOn) : m_mesh(std::move(mesh))
{
    GoingOn goingOn(goesOn);
    const auto faceCount = static_cast<std::uint32_t>(m_mesh.triangles.size());
    std::vector<float> areas(faceCount);
    std::vector<std::optional<Derivatives>> derivativesOfFaces(faceCount);
    // A vertex's tangent is the mean of its faces' dP/du, each by its area.
    m_tangentsHd.assign(m_mesh.positionsHd.size(), glm::vec3(0.0F));
    for (std::uint32_t face = 0; face < faceCount && goingOn.after(1); ++face) {
        const glm::vec3 cross = areaNormal(m_mesh, face);
        areas[face] = 0.5F * std::sqrt(glm::dot(cross, cross));
        m_areaM2 += static_cast<double>(areas[face]);
        derivativesOfFaces[face] = derivativesOf(m_mesh, face);
        if (const auto& derivatives = derivativesOfFaces[face]) {
            const glm::vec3 weighted = unitOr(derivatives->dPdu, glm::vec3(0.0F)) * areas[face];
            for (int corner = 0; corner < 3; ++corner)
                m_tangentsHd[m_mesh.triangles[face][corner]] += weighted;
        }
    }
    for (std::size_t vertex = 0; vertex < m_tangentsHd.size() && goingOn.after(1); ++vertex) {
        const glm::vec3 normal = unitOr(m_mesh.normalsHd[vertex], glm::vec3(0.0F, 1.0F, 0.0F));
        const glm::vec3 tangent = unitOr(m_tangentsHd[vertex], glm::vec3(0.0F));
        m_tangentsHd[vertex] = unitOr(tangent - normal * glm::dot(normal, tangent), anyPerpendicular(normal));
    }
    auto index = std::make_unique<const Index>(
        Index{BoundingTree(m_mesh, goingOn), UvGrid(m_mesh, goingOn), std::move(areas), std::move(derivativesOfFaces)});
    if (!goingOn.stopped())
        m_index = std::move(index);
}

Skin::~Skin() = default;

float Skin::faceAreaM2(std::uint32_t face) const
{
    return m_index->faceAreasM2[face];
}

SurfacePoint Skin::at(std::uint32_t face, glm::vec3 barycentric) const
{
    const glm::uvec3 t = m_mesh.triangles[face];
    const auto blend = [&](const auto& values) {
        return values[t.x] * barycentric.x + values[t.y] * barycentric.y + values[t.z] * barycentric.z;
    };
    SurfacePoint point;
    point.face = face;
    point.barycentric = barycentric;
    point.uv = blend(m_mesh.uvs);
    point.positionHd = blend(m_mesh.positionsHd);
    constexpr glm::vec3 kNone(0.0F);
    point.normalHd = unitOr(blend(m_mesh.normalsHd), kNone);
    if (point.normalHd == kNone)
        point.normalHd = unitOr(areaNormal(m_mesh, face), glm::vec3(0.0F, 1.0F, 0.0F));
    const glm::vec3 tangent = blend(m_tangentsHd);
    point.tangentHd = unitOr(tangent - point.normalHd * glm::dot(point.normalHd, tangent), kNone);
    if (point.tangentHd == kNone)
        point.tangentHd = anyPerpendicular(point.normalHd);
    if (const auto& derivatives = m_index->derivatives[face]) {
        point.dPduHd = derivatives->dPdu;
        point.dPdvHd = derivatives->dPdv;
    } else {
        point.dPduHd = point.tangentHd;
        point.dPdvHd = glm::cross(point.normalHd, point.tangentHd);
    }
    return point;
}

std::optional<SurfacePoint> Skin::pick(const RayHd& ray) const
{
    const auto hit = m_index->tree.firstHit(m_mesh, ray.originHd, ray.directionHd);
    if (!hit)
        return std::nullopt;
    return at(hit->face, hit->barycentric);
}

std::optional<SurfacePoint> Skin::atUv(glm::vec2 uv) const
{
    const auto found = m_index->grid.find(m_mesh, uv);
    if (!found)
        return std::nullopt;
    return at(found->first, found->second);
}

SurfacePoint Skin::nearest(glm::vec3 positionHd) const
{
    const auto found = m_index->tree.nearest(m_mesh, positionHd);
    return found ? at(found->face, found->barycentric) : SurfacePoint{};
}

std::optional<SurfacePoint> Skin::mirrored(const SurfacePoint& point, float toleranceM) const
{
    const glm::vec3 reflected = point.positionHd * glm::vec3(-1.0F, 1.0F, 1.0F);
    const auto found = m_index->tree.nearest(m_mesh, reflected);
    if (!found || !(found->distance <= toleranceM))
        return std::nullopt;
    return at(found->face, found->barycentric);
}

} // namespace hairpaint::sim
