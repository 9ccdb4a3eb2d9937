// Names and shapes of what is skin.
#include "model/heads/part_choice.h"

#include "model/heads/layout_packing.h"
#include "sim/skin/mesh_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <string_view>
#include <tuple>
#include <unordered_set>

namespace hairpaint::model {

namespace {

bool isNamedAs(const MeshPart& part, std::span<const std::string_view> words)
{
    const auto names = [words](std::string name) {
        std::ranges::transform(name, name.begin(),
                               [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
        return std::ranges::any_of(words,
                                   [&name](std::string_view word) { return name.find(word) != std::string::npos; });
    };
    return names(part.name) || names(part.material);
}

bool isNamedAsOther(const MeshPart& part)
{
    static constexpr std::array<std::string_view, 40> kOthers = {
        "eye",    "iris",   "cornea", "pupil", "lash",     "brow",   "teeth",   "tooth",    "tongue",   "mouth",
        "gum",    "hair",   "kami",   "bang",  "ponytail", "glass",  "cloth",   "shirt",    "tops",     "pants",
        "bottom", "dress",  "skirt",  "shoe",  "sock",     "glove",  "jacket",  "helmet",   "beard",    "earring",
        "horn",   "ribbon", "mask",   "crown", "jewel",    "weapon", "headset", "headband", "headwear", "headphone"};
    return isNamedAs(part, kOthers);
}

bool isNamedAsHead(const MeshPart& part)
{
    static constexpr std::array<std::string_view, 4> kHeads = {"head", "face", "scalp", "skull"};
    return isNamedAs(part, kHeads);
}

/// A position to a hundred thousandth of the mesh.
using GridCell = std::tuple<int, int, int>;
struct GridCellHash
{
    std::size_t operator()(const GridCell& cell) const
    {
        const auto word = [](int number) { return static_cast<std::size_t>(static_cast<std::uint32_t>(number)); };
        return (word(std::get<0>(cell)) * 0x9E3779B1U) ^ (word(std::get<1>(cell)) * 0x85EBCA77U << 1U) ^
               (word(std::get<2>(cell)) * 0xC2B2AE3DU << 2U);
    }
};

class LikelyUses
{
public:
    LikelyUses(const RiggedMesh& source, const glm::vec3& up, float metresPerUnit)
        : m_source(source), m_up(up), m_metres(metresPerUnit), m_ranges(rangesOf(source)),
          m_uses(source.parts.size(), PartUse::Seen)
    {}

    std::vector<PartUse> find()
    {
        std::vector<std::size_t> candidates;
        for (const bool strict : {true, false}) {
            if (!candidates.empty())
                break;
            for (std::size_t part = 0; part < m_ranges.size(); ++part)
                if (m_source.parts[part].hasLayout && !(strict && isNamedAsOther(m_source.parts[part])))
                    candidates.push_back(part);
        }
        if (candidates.empty())
            return m_uses;
        m_uses[withTheScalp(candidates)] = PartUse::Grows;
        while (addNeighbours(candidates)) {
        }
        return m_uses;
    }

private:
    [[nodiscard]] float heightOf(std::uint32_t vertex) const { return glm::dot(m_source.positionsHd[vertex], m_up); }
    /// Height of the triangle's middle.
    [[nodiscard]] float heightOf(const glm::uvec3& corners) const
    {
        return (heightOf(corners.x) + heightOf(corners.y) + heightOf(corners.z)) / 3.0F;
    }
    /// The triangle's normal, as long as twice its area; its component along `m_up` is what of the area faces up.
    [[nodiscard]] glm::dvec3 acrossOf(const glm::uvec3& corners) const
    {
        const glm::dvec3 a(m_source.positionsHd[corners.x]);
        return glm::cross(glm::dvec3(m_source.positionsHd[corners.y]) - a,
                          glm::dvec3(m_source.positionsHd[corners.z]) - a);
    }
    template<typename Visit>
    void eachTriangleOf(std::size_t part, const Visit& visit) const
    {
        for (std::size_t t = 0; t < m_ranges[part].triangles; ++t)
            visit(m_source.triangles[m_ranges[part].firstTriangle + t]);
    }
    [[nodiscard]] std::size_t withTheScalp(const std::vector<std::size_t>& candidates)
    {
        constexpr float kHeadM = 0.25F;
        constexpr float kOfAll = 0.6F;
        constexpr float kWithNeckM = 0.35F;
        float top = -1e30F;
        float bottom = 1e30F;
        for (const std::size_t part : candidates)
            for (std::size_t v = 0; v < m_ranges[part].vertices; ++v) {
                const float height = heightOf(static_cast<std::uint32_t>(m_ranges[part].firstVertex + v));
                top = std::max(top, height);
                bottom = std::min(bottom, height);
            }
        m_headFrom = top - kWithNeckM / m_metres;
        const float from = top - std::min(kHeadM / m_metres, kOfAll * (top - bottom));
        std::vector<double> areas(m_ranges.size(), 0.0);
        for (const std::size_t part : candidates)
            eachTriangleOf(part, [&](const glm::uvec3& corners) {
                if (heightOf(corners) >= from)
                    areas[part] += std::max(glm::dot(acrossOf(corners), glm::dvec3(m_up)), 0.0);
            });
        const auto most = [&areas](const std::vector<std::size_t>& parts) {
            return *std::ranges::max_element(parts, {}, [&areas](std::size_t part) { return areas[part]; });
        };
        const std::size_t best = most(candidates);
        // A body's shoulders may be more than the top of a small head; a name counts where the shape is no other's.
        constexpr double kEnough = 0.25;
        std::vector<std::size_t> heads;
        std::ranges::copy_if(candidates, std::back_inserter(heads), [&](std::size_t part) {
            return isNamedAsHead(m_source.parts[part]) && areas[part] > kEnough * areas[best];
        });
        return heads.empty() ? best : most(heads);
    }
    /// Whether most of it is as high as a head and its neck: what hangs together with a head below is the body.
    [[nodiscard]] bool isOfHead(std::size_t part) const
    {
        double above = 0.0;
        double all = 0.0;
        eachTriangleOf(part, [&](const glm::uvec3& corners) {
            const double area = glm::length(acrossOf(corners));
            all += area;
            above += heightOf(corners) >= m_headFrom ? area : 0.0;
        });
        return 2.0 * above >= all;
    }
    [[nodiscard]] GridCell cellOf(const glm::vec3& position)
    {
        if (m_cell == 0.0F) {
            const glm::vec3 size = sim::boundsOf(m_source).size();
            m_cell = std::max(1e-5F * std::max({size.x, size.y, size.z}), 1e-30F);
            m_least = sim::boundsOf(m_source).least;
        }
        const glm::vec3 cell = glm::round((position - m_least) / m_cell);
        return {static_cast<int>(cell.x), static_cast<int>(cell.y), static_cast<int>(cell.z)};
    }
    /// False where none hangs together with those that grow hair.
    bool addNeighbours(const std::vector<std::size_t>& candidates)
    {
        constexpr std::size_t kSeam = 4; // Vertices that two parts have in common at least.
        std::unordered_set<GridCell, GridCellHash> cells;
        for (std::size_t part = 0; part < m_ranges.size(); ++part)
            for (std::size_t v = 0; m_uses[part] == PartUse::Grows && v < m_ranges[part].vertices; ++v)
                cells.insert(cellOf(m_source.positionsHd[m_ranges[part].firstVertex + v]));
        bool any = false;
        for (const std::size_t part : candidates) {
            if (m_uses[part] == PartUse::Grows || !isOfHead(part))
                continue;
            std::size_t shared = 0;
            for (std::size_t v = 0; shared < kSeam && v < m_ranges[part].vertices; ++v)
                shared += cells.contains(cellOf(m_source.positionsHd[m_ranges[part].firstVertex + v])) ? 1 : 0;
            if (shared >= kSeam) {
                m_uses[part] = PartUse::Grows;
                any = true;
            }
        }
        return any;
    }

    const RiggedMesh& m_source;
    glm::vec3 m_up;
    float m_metres;
    std::vector<PartRange> m_ranges;
    std::vector<PartUse> m_uses;
    float m_headFrom = 0.0F; ///< Height, in the source's unit.
    float m_cell = 0.0F;
    glm::vec3 m_least{0.0F};
};

void append(RiggedMesh& to, const RiggedMesh& from, const PartRange& range)
{
    const auto first = static_cast<std::uint32_t>(to.positionsHd.size());
    const auto add = [&range](auto& all, const auto& some) {
        const auto begin = some.begin() + static_cast<std::ptrdiff_t>(range.firstVertex);
        all.insert(all.end(), begin, begin + static_cast<std::ptrdiff_t>(range.vertices));
    };
    add(to.positionsHd, from.positionsHd);
    add(to.normalsHd, from.normalsHd);
    add(to.uvs, from.uvs);
    if (!from.skeleton.empty())
        add(to.skeleton.weights, from.skeleton.weights);
    for (std::size_t t = 0; t < range.triangles; ++t)
        to.triangles.push_back(from.triangles[range.firstTriangle + t] - static_cast<std::uint32_t>(range.firstVertex) +
                               first);
}

/// Those that no part shows go.
void keepNamedTextures(RiggedMesh& mesh)
{
    std::vector<MeshTexture> kept;
    std::vector<std::int32_t> numbers(mesh.textures.size(), -1);
    for (MeshPart& part : mesh.parts) {
        if (part.texture < 0)
            continue;
        std::int32_t& number = numbers[static_cast<std::size_t>(part.texture)];
        if (number < 0) {
            number = static_cast<std::int32_t>(kept.size());
            kept.push_back(std::move(mesh.textures[static_cast<std::size_t>(part.texture)]));
        }
        part.texture = number;
    }
    mesh.textures = std::move(kept);
}

} // namespace

std::vector<PartUse> likelyUses(const RiggedMesh& source, const glm::vec3& up, float metresPerUnit)
{
    if (source.parts.size() <= 1)
        return std::vector<PartUse>(source.parts.size(), PartUse::Grows);
    return LikelyUses(source, up, metresPerUnit).find();
}

RiggedMesh arranged(const RiggedMesh& source)
{
    if (source.parts.empty())
        return source;
    const std::vector<PartRange> ranges = rangesOf(source);
    RiggedMesh made;
    made.skeleton.joints = source.skeleton.joints;
    made.told = source.told;
    made.textures = source.textures;
    std::vector<MeshPart> grown;
    for (const PartUse use : {PartUse::Grows, PartUse::Seen})
        for (std::size_t i = 0; i < ranges.size(); ++i) {
            if (source.parts[i].use != use)
                continue;
            append(made, source, ranges[i]);
            (use == PartUse::Grows ? grown : made.parts).push_back(source.parts[i]);
        }
    made.parts.insert(made.parts.begin(), withPackedLayouts(made, grown));
    keepNamedTextures(made);
    return made;
}

} // namespace hairpaint::model
