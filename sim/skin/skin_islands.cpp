// Faces that share vertices are an island; edges that two islands, or two sides of one, have in common are its seams.
#include "sim/skin/skin_islands.h"

#include "sim/skin/vertex_weld.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace hairpaint::sim {

namespace {

constexpr int kSide = TiledRaster::kTileSize;
constexpr float kSameUv = 1e-6F;
constexpr float kTouchTx = 0.75F; ///< A texel belongs to what comes as near to its centre.

unsigned rootOf(std::vector<unsigned>& parent, unsigned at)
{
    while (parent[at] != at)
        at = parent[at] = parent[parent[at]];
    return at;
}

/// Twice the signed area of the triangle a b p.
float turn(glm::vec2 a, glm::vec2 b, glm::vec2 p)
{
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

bool touches(const std::array<glm::vec2, 3>& face, glm::vec2 p)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec2 a = face[i];
        const glm::vec2 b = face[(i + 1) % 3];
        if (turn(a, b, p) < -kTouchTx * glm::length(b - a))
            return false;
    }
    return true;
}

} // namespace

SkinIslands::SkinIslands(std::shared_ptr<const Skin> skin, int size)
    : m_skin(std::move(skin)), m_size(size), m_tilesAcross(size / kSide),
      m_facesOfTile(static_cast<std::size_t>(m_tilesAcross) * static_cast<std::size_t>(m_tilesAcross)),
      m_tiles(m_facesOfTile.size())
{
    findIslands();
    sortFaces();
    findLinks();
}

glm::vec2 SkinIslands::texelOf(std::uint32_t vertex) const
{
    const glm::vec2 uv = glm::clamp(m_skin->mesh().uvs[vertex], 0.0F, 1.0F);
    return glm::vec2(uv.x, 1.0F - uv.y) * static_cast<float>(m_size);
}

void SkinIslands::findIslands()
{
    const HeadMesh& mesh = m_skin->mesh();
    std::vector<unsigned> parent(mesh.positionsHd.size());
    std::iota(parent.begin(), parent.end(), 0U);
    const auto join = [&](unsigned a, unsigned b) { parent[rootOf(parent, a)] = rootOf(parent, b); };
    for (const glm::uvec3& face : mesh.triangles) {
        join(face.x, face.y);
        join(face.y, face.z);
    }
    // Vertices that are two only for the sake of their normals are no seam.
    const std::vector<unsigned> welded = weldedVertices(mesh);
    for (unsigned vertex = 0; vertex < welded.size(); ++vertex)
        if (glm::distance(mesh.uvs[vertex], mesh.uvs[welded[vertex]]) < kSameUv)
            join(vertex, welded[vertex]);
    std::map<unsigned, std::uint16_t> numbers;
    m_islandOfVertex.resize(parent.size());
    for (unsigned vertex = 0; vertex < parent.size(); ++vertex) {
        const auto next = static_cast<std::uint16_t>(std::min<std::size_t>(numbers.size() + 1, 65535));
        m_islandOfVertex[vertex] = numbers.emplace(rootOf(parent, vertex), next).first->second;
    }
}

void SkinIslands::sortFaces()
{
    const HeadMesh& mesh = m_skin->mesh();
    for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
        const glm::uvec3& corners = mesh.triangles[face];
        const glm::vec2 a = texelOf(corners.x);
        const glm::vec2 b = texelOf(corners.y);
        const glm::vec2 c = texelOf(corners.z);
        const glm::vec2 low = glm::min(glm::min(a, b), c) - 2.0F;
        const glm::vec2 high = glm::max(glm::max(a, b), c) + 2.0F;
        const auto tileAt = [this](float texel) {
            return std::clamp(static_cast<int>(texel) / kSide, 0, m_tilesAcross - 1);
        };
        for (int y = tileAt(low.y); y <= tileAt(high.y); ++y)
            for (int x = tileAt(low.x); x <= tileAt(high.x); ++x)
                m_facesOfTile[static_cast<std::size_t>(y * m_tilesAcross + x)].push_back(face);
    }
}

const SkinIslands::Tile& SkinIslands::tile(int index) const
{
    const auto at = static_cast<std::size_t>(index);
    if (m_tiles[at] != nullptr)
        return *m_tiles[at];
    auto made = std::make_unique<Tile>();
    made->fill(0);
    const int left = index % m_tilesAcross * kSide;
    const int top = index / m_tilesAcross * kSide;
    for (const std::uint32_t face : m_facesOfTile[at]) {
        const glm::uvec3& corners = m_skin->mesh().triangles[face];
        std::array<glm::vec2, 3> flat{texelOf(corners.x), texelOf(corners.y), texelOf(corners.z)};
        if (turn(flat[0], flat[1], flat[2]) < 0.0F)
            std::swap(flat[1], flat[2]);
        const auto range = [&](int axis, int from) {
            const float low = std::min({flat[0][axis], flat[1][axis], flat[2][axis]}) - 1.5F;
            const float high = std::max({flat[0][axis], flat[1][axis], flat[2][axis]}) + 1.5F;
            return std::pair(std::clamp(static_cast<int>(low) - from, 0, kSide),
                             std::clamp(static_cast<int>(high) - from + 1, 0, kSide));
        };
        const auto [x0, x1] = range(0, left);
        const auto [y0, y1] = range(1, top);
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                std::uint16_t& island = (*made)[static_cast<std::size_t>(y * kSide + x)];
                const glm::vec2 centre(static_cast<float>(left + x) + 0.5F, static_cast<float>(top + y) + 0.5F);
                if (island == 0 && touches(flat, centre))
                    island = m_islandOfVertex[corners.x];
            }
    }
    m_tiles[at] = std::move(made);
    return *m_tiles[at];
}

void SkinIslands::findLinks()
{
    const HeadMesh& mesh = m_skin->mesh();
    const std::vector<unsigned> welded = weldedVertices(mesh);
    using Side = std::pair<std::uint32_t, glm::uvec2>; // A face, and the edge's vertices in the order of the key.
    std::map<std::pair<unsigned, unsigned>, std::vector<Side>> sides;
    for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face)
        for (int i = 0; i < 3; ++i) {
            unsigned a = mesh.triangles[face][i];
            unsigned b = mesh.triangles[face][(i + 1) % 3];
            if (welded[a] > welded[b])
                std::swap(a, b);
            sides[{welded[a], welded[b]}].emplace_back(face, glm::uvec2(a, b));
        }
    const auto isSeam = [&](unsigned a, unsigned b) {
        return a != b && glm::distance(mesh.uvs[a], mesh.uvs[b]) >= kSameUv;
    };
    for (const auto& [edge, both] : sides)
        for (std::size_t i = 1; i < both.size(); ++i)
            if (isSeam(both[0].second.x, both[i].second.x) || isSeam(both[0].second.y, both[i].second.y))
                addLinks(both[0].second, both[0].first, both[i].second, both[i].first);
    std::ranges::sort(m_links);
    m_links.erase(std::unique(m_links.begin(), m_links.end()), m_links.end());
}

void SkinIslands::addLinks(glm::uvec2 edgeA, std::uint32_t faceA, glm::uvec2 edgeB, std::uint32_t faceB)
{
    constexpr float kInsideTx = 0.5F;
    constexpr float kPerTexel = 2.0F;
    const auto inside = [&](glm::vec2 point, std::uint32_t face) {
        const glm::uvec3& corners = m_skin->mesh().triangles[face];
        const glm::vec2 toMiddle = (texelOf(corners.x) + texelOf(corners.y) + texelOf(corners.z)) / 3.0F - point;
        const glm::vec2 moved = point + toMiddle * std::min(kInsideTx / std::max(glm::length(toMiddle), 1e-6F), 1.0F);
        return glm::ivec2(glm::clamp(glm::floor(moved), 0.0F, static_cast<float>(m_size - 1)));
    };
    const glm::vec2 a0 = texelOf(edgeA.x);
    const glm::vec2 a1 = texelOf(edgeA.y);
    const glm::vec2 b0 = texelOf(edgeB.x);
    const glm::vec2 b1 = texelOf(edgeB.y);
    const int steps = 1 + static_cast<int>(kPerTexel * std::ceil(std::max(glm::length(a1 - a0), glm::length(b1 - b0))));
    for (int i = 0; i <= steps; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(steps);
        const glm::ivec2 a = inside(a0 + (a1 - a0) * t, faceA);
        const glm::ivec2 b = inside(b0 + (b1 - b0) * t, faceB);
        const auto tileOf = [this](glm::ivec2 at) { return at.y / kSide * m_tilesAcross + at.x / kSide; };
        const auto texel = [](glm::ivec2 at) {
            return static_cast<std::uint16_t>(at.y % kSide * kSide + at.x % kSide);
        };
        m_links.push_back({.tileA = tileOf(a), .tileB = tileOf(b), .texelA = texel(a), .texelB = texel(b)});
    }
}

} // namespace hairpaint::sim
