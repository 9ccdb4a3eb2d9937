// Density and colour of the roots at each vertex.
#include "view/rendering/scalp_tint.h"

#include "sim/base/parallel.h"
#include "sim/groom/map_sampler.h"
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
constexpr std::array<glm::vec2, 5> kReads{glm::vec2(0.0F, 0.0F), glm::vec2(kBesideUv, kBesideUv),
                                          glm::vec2(-kBesideUv, kBesideUv), glm::vec2(kBesideUv, -kBesideUv),
                                          glm::vec2(-kBesideUv, -kBesideUv)};

float densityAround(const sim::MapSampler& density, glm::vec2 uv)
{
    std::array<float, kReads.size()> at{};
    for (std::size_t i = 0; i < at.size(); ++i)
        at[i] = density.scalar(uv + kReads[i]);
    // Dense on both sides of it: beyond an edge there is nothing.
    const float across = std::max(std::min(at[1], at[4]), std::min(at[2], at[3]));
    const float mean = std::accumulate(at.begin(), at.end(), 0.0F) / static_cast<float>(at.size());
    return std::max(std::min(at[0], mean), across);
}

/// All points that vertices read, kReads.size() a vertex.
std::vector<glm::vec2> pointsRead(std::span<const glm::vec2> uvs)
{
    std::vector<glm::vec2> points;
    points.reserve(uvs.size() * kReads.size());
    for (const glm::vec2 uv : uvs)
        for (const glm::vec2 offset : kReads)
            points.push_back(uv + offset);
    return points;
}

} // namespace

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
                               .densityPerM2 = settings.greatestDensityPerM2});
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
    if (otherMesh)
        m_indices.clear();
    const bool had = !m_texels.empty();
    if (!mesh || m_sources.empty() || mesh->uvs.size() != mesh->positionsHd.size()) {
        m_texels.clear();
        return had;
    }
    const auto alike = [](const ScalpTintSource& a, const ScalpTintSource& b) {
        return a.strength == b.strength && a.densityPerM2 == b.densityPerM2;
    };
    std::vector<std::uint32_t> vertices;
    bool some = had && !otherMesh && std::ranges::equal(before, m_sources, alike);
    for (std::size_t i = 0; some && i < before.size(); ++i)
        some = findChanged(before[i].density, m_sources[i].density, vertices) &&
               findChanged(before[i].colour, m_sources[i].colour, vertices);
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

bool ScalpTint::findChanged(const sim::MapRaster& before, const sim::MapRaster& after,
                            std::vector<std::uint32_t>& vertices)
{
    if (before == after)
        return true;
    const std::optional<std::vector<sim::TexelRect>> footprints = sim::footprintsThatDiffer(*before, *after);
    if (!footprints)
        return false;
    auto index = m_indices.find(after->size());
    if (index == m_indices.end())
        index = m_indices.emplace(after->size(), sim::TileIndex(pointsRead(m_mesh->uvs), after->size())).first;
    for (const std::uint32_t point : index->second.slotsIn(*footprints))
        vertices.push_back(point / static_cast<std::uint32_t>(kReads.size()));
    return true;
}

void ScalpTint::evaluate(std::span<const std::uint32_t> vertices)
{
    struct Maps
    {
        sim::MapSampler density, colour;
    };
    std::vector<Maps> maps;
    for (const ScalpTintSource& source : m_sources)
        maps.push_back({sim::MapSampler(source.density), sim::MapSampler(source.colour)});
    sim::parallelFor(vertices.size(), kVertexGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const glm::vec2 uv = m_mesh->uvs[vertices[i]];
            glm::vec4 tint(0.0F);
            for (std::size_t group = 0; group < maps.size(); ++group) {
                const float hairs = densityAround(maps[group].density, uv) * m_sources[group].densityPerM2;
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
