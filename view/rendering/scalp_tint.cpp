// Density and colour of the roots at each vertex.
#include "view/rendering/scalp_tint.h"

#include "sim/base/parallel.h"
#include "sim/groom/map_sampler.h"
#include "sim/skin/uv_raster.h"
#include "view/rendering/light/encoded_colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace hairpaint::rendering {
namespace {

constexpr std::size_t kVertexGrain = 2048;
constexpr float kRoots = 0.63e6F; ///< Roots per m2 that leave 1/e of the skin as it is, where the strength is 1.

/// A vertex reads density around itself too: the edge of hair is sharper than vertices are close and would show their
/// triangles; where a parting is a line without roots, the skin beside it counts.
constexpr float kBesideUv = 0.003F;
/// So does a ring as far off as a hairline is soft: beyond an edge it is bare.
constexpr std::size_t kAround = 8;
constexpr float kDiagonal = 0.70710678F;
constexpr std::array<glm::vec2, 5> kBeside{glm::vec2(0.0F, 0.0F), glm::vec2(1.0F, 1.0F), glm::vec2(-1.0F, 1.0F),
                                           glm::vec2(1.0F, -1.0F), glm::vec2(-1.0F, -1.0F)};
constexpr std::array<glm::vec2, kAround> kRing{glm::vec2(1.0F, 0.0F),  glm::vec2(kDiagonal, kDiagonal),
                                               glm::vec2(0.0F, 1.0F),  glm::vec2(-kDiagonal, kDiagonal),
                                               glm::vec2(-1.0F, 0.0F), glm::vec2(-kDiagonal, -kDiagonal),
                                               glm::vec2(0.0F, -1.0F), glm::vec2(kDiagonal, -kDiagonal)};

/// Where a vertex reads.
struct Reads
{
    std::array<glm::vec2, kBeside.size() + kAround> offsets{};
    std::size_t count = kBeside.size(); ///< Without the ring where no hairline is soft.

    explicit Reads(float ringUv)
    {
        for (std::size_t i = 0; i < kBeside.size(); ++i)
            offsets.at(i) = kBeside.at(i) * kBesideUv;
        if (ringUv <= 0.0F)
            return;
        for (std::size_t i = 0; i < kAround; ++i)
            offsets.at(kBeside.size() + i) = kRing.at(i) * ringUv;
        count = offsets.size();
    }
};

/// How far the skin is from where hair ends, 0 at its edge, 1 beyond the softened width. What the layout does not
/// cover, beyond a seam, says nothing.
float insideEdge(const sim::MapSampler& density, glm::vec2 uv, float here, const Reads& reads, const LayoutCover& cover)
{
    float around = 0.0F;
    int covered = 0;
    for (std::size_t i = kBeside.size(); i < reads.count; ++i) {
        const glm::vec2 at = uv + reads.offsets.at(i);
        if (!cover.covers(at))
            continue;
        around += std::min(density.scalar(at) / here, 1.0F);
        ++covered;
    }
    // Half of a circle about a point of a straight edge is bare.
    return covered == 0 ? 1.0F : std::clamp(2.0F * around / static_cast<float>(covered) - 1.0F, 0.0F, 1.0F);
}

float densityAround(const sim::MapSampler& density, glm::vec2 uv, const Reads& reads, const LayoutCover& cover)
{
    std::array<float, kBeside.size()> at{};
    for (std::size_t i = 0; i < at.size(); ++i)
        at.at(i) = density.scalar(uv + reads.offsets.at(i));
    // Dense on both sides of it: beyond an edge there is nothing.
    const float across = std::max(std::min(at[1], at[4]), std::min(at[2], at[3]));
    const float mean = std::accumulate(at.begin(), at.end(), 0.0F) / static_cast<float>(at.size());
    const float here = std::max(std::min(at[0], mean), across);
    if (reads.count == kBeside.size() || !(here > 0.0F))
        return here;
    return here * insideEdge(density, uv, here, reads, cover);
}

/// All points that vertices read, `reads.count` a vertex.
std::vector<glm::vec2> pointsRead(std::span<const glm::vec2> uvs, const Reads& reads)
{
    std::vector<glm::vec2> points;
    points.reserve(uvs.size() * reads.count);
    for (const glm::vec2 uv : uvs)
        for (const glm::vec2 offset : std::span(reads.offsets).first(reads.count))
            points.push_back(uv + offset);
    return points;
}

/// The root of the layout's area over the skin's.
float uvPerMetre(const sim::HeadMesh& mesh)
{
    double uvArea = 0.0;
    double area = 0.0;
    for (const glm::uvec3 corners : mesh.triangles) {
        const glm::vec2 u = mesh.uvs[corners.y] - mesh.uvs[corners.x];
        const glm::vec2 v = mesh.uvs[corners.z] - mesh.uvs[corners.x];
        uvArea += std::abs(u.x * v.y - u.y * v.x);
        area += glm::length(glm::cross(mesh.positionsHd[corners.y] - mesh.positionsHd[corners.x],
                                       mesh.positionsHd[corners.z] - mesh.positionsHd[corners.x]));
    }
    return area > 0.0 ? static_cast<float>(std::sqrt(uvArea / area)) : 0.0F;
}

} // namespace

LayoutCover::LayoutCover(const sim::HeadMesh& mesh) : m_isCovered(kSide * kSide, false)
{
    for (const glm::vec2 uv : mesh.uvs) // A fine mesh's faces have no texel's middle.
        if (isInside(uv))
            m_isCovered[texelAt(uv)] = true;
    for (const glm::uvec3& corners : mesh.triangles)
        sim::eachTexelOf(mesh, corners, int{kSide}, [this](std::size_t texel) { m_isCovered[texel] = true; });
}

bool LayoutCover::covers(glm::vec2 uv) const
{
    return isInside(uv) && !m_isCovered.empty() && m_isCovered[texelAt(uv)];
}

ScalpTintSources scalpTintSources(const sim::StrandFrame* hair)
{
    ScalpTintSources sources;
    if (hair == nullptr)
        return sources;
    for (const sim::GroupFrame& group : hair->groups) {
        if (!group.groom || !group.groom->visible || !group.groom->density || !group.groom->colour)
            continue;
        const sim::GroupSettings& settings = group.groom->settings;
        if (settings.material.scalpTint > 0.0F)
            sources.push_back({.density = group.groom->density,
                               .colour = group.groom->colour,
                               .strength = settings.material.scalpTint,
                               .densityPerM2 = settings.greatestDensityPerM2,
                               .softenM = settings.hairline.softenM});
    }
    return sources;
}

bool ScalpTint::update(const std::shared_ptr<const sim::HeadMesh>& mesh, const ScalpTintSources& sources)
{
    const bool otherMesh = mesh != m_mesh;
    if (!otherMesh && sources == m_sources)
        return false;
    const ScalpTintSources before = std::exchange(m_sources, sources);
    m_mesh = mesh;
    if (otherMesh) {
        m_indices.clear();
        m_cover.reset();
    }
    const bool had = !m_texels.empty();
    if (!mesh || m_sources.empty() || mesh->uvs.size() != mesh->positionsHd.size()) {
        m_texels.clear();
        return had;
    }
    if (!m_cover) {
        m_uvPerM = uvPerMetre(*mesh);
        m_cover = LayoutCover(*mesh);
    }
    const auto alike = [](const ScalpTintSource& a, const ScalpTintSource& b) {
        return a.strength == b.strength && a.densityPerM2 == b.densityPerM2 && a.softenM == b.softenM;
    };
    std::vector<std::uint32_t> vertices;
    bool some = had && !otherMesh && std::ranges::equal(before, m_sources, alike);
    for (std::size_t i = 0; some && i < before.size(); ++i)
        some = findChanged(before[i].density, m_sources[i].density, m_sources[i].softenM, vertices) &&
               findChanged(before[i].colour, m_sources[i].colour, 0.0F, vertices);
    if (some) {
        std::ranges::sort(vertices);
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    } else {
        vertices.resize(mesh->positionsHd.size());
        std::iota(vertices.begin(), vertices.end(), 0U);
        m_texels.assign(vertices.size(), Texel(0));
    }
    evaluate(vertices);
    return true;
}

bool ScalpTint::findChanged(const sim::MapRaster& before, const sim::MapRaster& after, float softenM,
                            std::vector<std::uint32_t>& vertices)
{
    if (before == after)
        return true;
    const std::optional<std::vector<sim::TexelRect>> footprints = sim::footprintsThatDiffer(*before, *after);
    if (!footprints)
        return false;
    const Reads reads(softenM * m_uvPerM);
    auto index = m_indices.find({after->size(), softenM});
    if (index == m_indices.end())
        index = m_indices
                    .emplace(std::pair(after->size(), softenM),
                             sim::TileIndex(pointsRead(m_mesh->uvs, reads), after->size()))
                    .first;
    for (const std::uint32_t point : index->second.slotsIn(*footprints))
        vertices.push_back(point / static_cast<std::uint32_t>(reads.count));
    return true;
}

void ScalpTint::evaluate(std::span<const std::uint32_t> vertices)
{
    struct Maps
    {
        sim::MapSampler density, colour;
        Reads reads;
    };
    std::vector<Maps> maps;
    for (const ScalpTintSource& source : m_sources)
        maps.push_back(
            {sim::MapSampler(source.density), sim::MapSampler(source.colour), Reads(source.softenM * m_uvPerM)});
    sim::parallelFor(vertices.size(), kVertexGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const glm::vec2 uv = m_mesh->uvs[vertices[i]];
            glm::vec4 tint(0.0F);
            for (std::size_t group = 0; group < maps.size(); ++group) {
                const float hairs =
                    densityAround(maps[group].density, uv, maps[group].reads, *m_cover) * m_sources[group].densityPerM2;
                if (!(hairs > 0.0F))
                    continue;
                const float cover = m_sources[group].strength * (1.0F - std::exp(-hairs / kRoots));
                tint = tint * (1.0F - cover) +
                       glm::vec4(linearOfEncoded(glm::vec3(maps[group].colour.channels(uv))), 1.0F) * cover;
            }
            m_texels[vertices[i]] = Texel(glm::clamp(tint, 0.0F, 1.0F) * 65535.0F + 0.5F);
        }
    });
}

} // namespace hairpaint::rendering
