// Building and walking the tree.
#include "sim/skin/bounding_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace hairpaint::sim {

namespace {

constexpr std::uint32_t kLeafFaces = 4;
constexpr std::size_t kDeepest = 64; ///< Median splits halve the faces, so 2^32 faces are 32 levels.
constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// A ray through an edge must hit one of its two faces, so each is taken to be this much larger.
constexpr float kEdgeTolerance = 1e-6F;

struct Corners
{
    glm::vec3 a, b, c;
};

Corners cornersOf(const HeadMesh& mesh, std::uint32_t face)
{
    const glm::uvec3 triangle = mesh.triangles[face];
    return {mesh.positionsHd[triangle.x], mesh.positionsHd[triangle.y], mesh.positionsHd[triangle.z]};
}

/// Moeller and Trumbore 1997, both sides.
bool hitTriangle(const Corners& t, glm::vec3 origin, glm::vec3 direction, FacePoint& hit)
{
    const glm::vec3 ab = t.b - t.a;
    const glm::vec3 ac = t.c - t.a;
    const glm::vec3 p = glm::cross(direction, ac);
    const float determinant = glm::dot(ab, p);
    if (determinant == 0.0F)
        return false;
    const float scale = 1.0F / determinant;
    const glm::vec3 s = origin - t.a;
    const float u = glm::dot(s, p) * scale;
    const glm::vec3 q = glm::cross(s, ab);
    const float v = glm::dot(direction, q) * scale;
    const float distance = glm::dot(ac, q) * scale;
    // Written so that a NaN is no hit.
    if (!(u >= -kEdgeTolerance && v >= -kEdgeTolerance && u + v <= 1.0F + kEdgeTolerance && distance >= 0.0F &&
          distance < kInfinity))
        return false;
    const float clampedU = std::clamp(u, 0.0F, 1.0F);
    const float clampedV = std::clamp(v, 0.0F, 1.0F - clampedU);
    hit.barycentric = {1.0F - clampedU - clampedV, clampedU, clampedV};
    hit.distance = distance;
    return true;
}

/// Ericson 2005, closest point on a triangle by its seven regions, as barycentrics.
glm::vec3 nearestBarycentric(const Corners& t, glm::vec3 p)
{
    const glm::vec3 ab = t.b - t.a;
    const glm::vec3 ac = t.c - t.a;
    const glm::vec3 ap = p - t.a;
    const float d1 = glm::dot(ab, ap);
    const float d2 = glm::dot(ac, ap);
    if (d1 <= 0.0F && d2 <= 0.0F)
        return {1.0F, 0.0F, 0.0F};
    const glm::vec3 bp = p - t.b;
    const float d3 = glm::dot(ab, bp);
    const float d4 = glm::dot(ac, bp);
    if (d3 >= 0.0F && d4 <= d3)
        return {0.0F, 1.0F, 0.0F};
    const float vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0F && d1 >= 0.0F && d3 <= 0.0F) {
        const float v = d1 / (d1 - d3);
        return {1.0F - v, v, 0.0F};
    }
    const glm::vec3 cp = p - t.c;
    const float d5 = glm::dot(ab, cp);
    const float d6 = glm::dot(ac, cp);
    if (d6 >= 0.0F && d5 <= d6)
        return {0.0F, 0.0F, 1.0F};
    const float vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0F && d2 >= 0.0F && d6 <= 0.0F) {
        const float w = d2 / (d2 - d6);
        return {1.0F - w, 0.0F, w};
    }
    const float va = d3 * d6 - d5 * d4;
    if (va <= 0.0F && d4 - d3 >= 0.0F && d5 - d6 >= 0.0F) {
        const float w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0.0F, 1.0F - w, w};
    }
    const float scale = 1.0F / (va + vb + vc);
    const float v = vb * scale;
    const float w = vc * scale;
    return {1.0F - v - w, v, w};
}

float squaredDistanceToBox(glm::vec3 lowest, glm::vec3 highest, glm::vec3 point)
{
    const glm::vec3 outside = point - glm::clamp(point, lowest, highest);
    return glm::dot(outside, outside);
}

/// 1 / direction, with a great number instead of infinity, so that 0 times it is no NaN.
glm::vec3 inverseOf(glm::vec3 direction)
{
    constexpr float kSmallest = 1e-18F;
    glm::vec3 inverse;
    for (int axis = 0; axis < 3; ++axis)
        inverse[axis] = 1.0F / (std::abs(direction[axis]) > kSmallest ? direction[axis] : kSmallest);
    return inverse;
}

/// Distance at which the ray enters the box, or infinity.
float entryDistance(glm::vec3 lowest, glm::vec3 highest, glm::vec3 origin, glm::vec3 inverseDirection)
{
    const glm::vec3 a = (lowest - origin) * inverseDirection;
    const glm::vec3 b = (highest - origin) * inverseDirection;
    const glm::vec3 nearer = glm::min(a, b);
    const glm::vec3 further = glm::max(a, b);
    const float enter = std::max({0.0F, nearer.x, nearer.y, nearer.z});
    const float leave = std::min({further.x, further.y, further.z});
    // Rounding must not lose a flat box.
    return enter <= leave * (1.0F + 1e-5F) + 1e-9F ? enter : kInfinity;
}

} // namespace

struct BoundingTree::Builder
{
    const HeadMesh& mesh;
    BoundingTree& tree;
    GoingOn& goingOn;
    std::vector<glm::vec3> centres;

    void fill(std::uint32_t nodeIndex, std::uint32_t begin, std::uint32_t end)
    {
        if (!goingOn.after(end - begin))
            return;
        glm::vec3 lowest(kInfinity);
        glm::vec3 highest(-kInfinity);
        glm::vec3 lowestCentre(kInfinity);
        glm::vec3 highestCentre(-kInfinity);
        for (std::uint32_t i = begin; i < end; ++i) {
            const std::uint32_t face = tree.m_faces[i];
            const Corners t = cornersOf(mesh, face);
            lowest = glm::min(lowest, glm::min(t.a, glm::min(t.b, t.c)));
            highest = glm::max(highest, glm::max(t.a, glm::max(t.b, t.c)));
            lowestCentre = glm::min(lowestCentre, centres[face]);
            highestCentre = glm::max(highestCentre, centres[face]);
        }
        if (end - begin <= kLeafFaces) {
            tree.m_nodes[nodeIndex] = {lowest, begin, highest, end - begin};
            return;
        }
        const glm::vec3 extent = highestCentre - lowestCentre;
        int axis = extent.y > extent.x ? 1 : 0;
        if (extent.z > extent[axis])
            axis = 2;
        const std::uint32_t middle = begin + (end - begin) / 2;
        std::nth_element(tree.m_faces.begin() + begin, tree.m_faces.begin() + middle, tree.m_faces.begin() + end,
                         [&](std::uint32_t left, std::uint32_t right) {
                             const float l = centres[left][axis];
                             const float r = centres[right][axis];
                             return l != r ? l < r : left < right;
                         });
        const auto children = static_cast<std::uint32_t>(tree.m_nodes.size());
        tree.m_nodes.resize(tree.m_nodes.size() + 2);
        tree.m_nodes[nodeIndex] = {lowest, children, highest, 0};
        fill(children, begin, middle);
        fill(children + 1, middle, end);
    }
};

BoundingTree::BoundingTree(const HeadMesh& mesh, GoingOn& goingOn)
{
    m_faces.resize(mesh.triangles.size());
    if (m_faces.empty())
        return;
    std::iota(m_faces.begin(), m_faces.end(), 0U);
    Builder builder{mesh, *this, goingOn, {}};
    builder.centres.reserve(m_faces.size());
    for (std::uint32_t face = 0; face < m_faces.size(); ++face) {
        const Corners t = cornersOf(mesh, face);
        builder.centres.push_back((t.a + t.b + t.c) * (1.0F / 3.0F));
    }
    m_nodes.reserve(m_faces.size());
    m_nodes.resize(1);
    builder.fill(0, 0, static_cast<std::uint32_t>(m_faces.size()));
}

std::optional<FacePoint> BoundingTree::firstHit(const HeadMesh& mesh, glm::vec3 origin, glm::vec3 direction) const
{
    if (m_nodes.empty())
        return std::nullopt;
    const glm::vec3 inverse = inverseOf(direction);
    std::optional<FacePoint> best;
    std::array<std::uint32_t, kDeepest * 2> stack;
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const Node& node = m_nodes[stack[--depth]];
        const float enter = entryDistance(node.lowest, node.highest, origin, inverse);
        if (enter == kInfinity || (best && enter > best->distance))
            continue;
        if (node.count == 0) {
            const Node& first = m_nodes[node.first];
            const Node& second = m_nodes[node.first + 1];
            const bool firstIsNearer = entryDistance(first.lowest, first.highest, origin, inverse) <=
                                       entryDistance(second.lowest, second.highest, origin, inverse);
            stack[depth++] = firstIsNearer ? node.first + 1 : node.first;
            stack[depth++] = firstIsNearer ? node.first : node.first + 1;
            continue;
        }
        for (const std::uint32_t face : std::span(m_faces).subspan(node.first, node.count)) {
            FacePoint hit{face, {}, 0.0F};
            if (!hitTriangle(cornersOf(mesh, face), origin, direction, hit))
                continue;
            if (!best || hit.distance < best->distance || (hit.distance == best->distance && face < best->face))
                best = hit;
        }
    }
    return best;
}

std::optional<FacePoint> BoundingTree::nearest(const HeadMesh& mesh, glm::vec3 point) const
{
    if (m_nodes.empty())
        return std::nullopt;
    FacePoint best;
    float bestSquared = kInfinity;
    std::array<std::uint32_t, kDeepest * 2> stack;
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const Node& node = m_nodes[stack[--depth]];
        if (squaredDistanceToBox(node.lowest, node.highest, point) > bestSquared)
            continue;
        if (node.count == 0) {
            const Node& first = m_nodes[node.first];
            const Node& second = m_nodes[node.first + 1];
            const bool firstIsNearer = squaredDistanceToBox(first.lowest, first.highest, point) <=
                                       squaredDistanceToBox(second.lowest, second.highest, point);
            stack[depth++] = firstIsNearer ? node.first + 1 : node.first;
            stack[depth++] = firstIsNearer ? node.first : node.first + 1;
            continue;
        }
        for (const std::uint32_t face : std::span(m_faces).subspan(node.first, node.count)) {
            const Corners t = cornersOf(mesh, face);
            const glm::vec3 barycentric = nearestBarycentric(t, point);
            const glm::vec3 away = point - (t.a * barycentric.x + t.b * barycentric.y + t.c * barycentric.z);
            const float squared = glm::dot(away, away);
            if (squared < bestSquared || (squared == bestSquared && face < best.face)) {
                bestSquared = squared;
                best.face = face;
                best.barycentric = barycentric;
            }
        }
    }
    best.distance = bestSquared < kInfinity ? std::sqrt(bestSquared) : kInfinity;
    return best;
}

} // namespace hairpaint::sim
