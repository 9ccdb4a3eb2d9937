// Hairs summed in cells of the layout; cells with few of them take from ever coarser ones.
#include "model/tools/lying/lying_hair.h"

#include "model/values/polyline.h"
#include "sim/base/parallel.h"
#include "sim/skin/skin_frame.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr float kAlongM = 0.02F;
constexpr float kAlongPart = 1.0F / 3.0F;
constexpr std::size_t kFurtherGrain = 64;
constexpr float kOverSkinM = 0.015F; ///< So far over the skin hair is laid.
constexpr float kEnoughHairs = 6.0F; ///< A cell with so many needs no coarser one.
constexpr int kCoarsestCells = 16;
constexpr float kAsGrownM = 0.003F; ///< A hair whose nodes are no further from its rest shape lies as it grows.
constexpr float kFew = 0.2F;        ///< Fraction of the hair in a cell that is left out of account.

bool isFar(const sim::DistanceGrid& distances, const glm::vec3& positionHd)
{
    const std::optional<sim::DistanceGrid::Sample> sample = distances.at(positionHd);
    return sample && sample->distanceM > kOverSkinM + 0.5F * distances.layout().cellM;
}

/// For each solved hair of a group that is at rest, what holds it.
std::vector<HeldBy> heldAtRest(const sim::GroupFrame& group, const sim::HeadPose& pose)
{
    const sim::Groom& groom = *group.groom;
    const sim::StrandBlocks blocks = groom.blocks();
    const glm::quat toHead = glm::conjugate(pose.rotation);
    const std::vector<std::uint32_t>& slots = groom.roots->basisSlot;
    std::vector<HeldBy> held(slots.size(), HeldBy::Weight);
    std::vector<glm::vec3> nodes(static_cast<std::size_t>(groom.nodes));
    std::vector<glm::vec3> rest(nodes.size());
    for (std::size_t basis = 0; basis < slots.size(); ++basis) {
        if (!group.isPositioned(slots[basis]))
            continue;
        blocks.read(group.positions, groom.frameStrand(slots[basis]), nodes);
        blocks.read(groom.basis->restPositions, basis, rest);
        float furthestM = 0.0F;
        for (std::size_t node = 1; node < nodes.size(); ++node)
            furthestM = std::max(furthestM, glm::distance(toHead * (nodes[node] - pose.positionWo), rest[node]));
        if (furthestM <= kAsGrownM)
            held[basis] = HeldBy::Gel;
    }
    return held;
}

/// Sums of hairs in a square of cells.
struct Sums
{
    int side;
    std::vector<glm::vec4> cells; ///< Direction, length, count; summed.

    explicit Sums(int cellsAcross)
        : side(cellsAcross), cells(static_cast<std::size_t>(cellsAcross) * static_cast<std::size_t>(cellsAcross))
    {}
    [[nodiscard]] glm::vec4& cell(int x, int y)
    {
        return cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x)];
    }
    [[nodiscard]] const glm::vec4& cell(int x, int y) const
    {
        return cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x)];
    }
    /// Calls `use(cell, weight)` for the four cells around a uv, by how near they are; those outside are left out.
    template<typename Use>
    static void around(int side, glm::vec2 uv, const Use& use)
    {
        const glm::vec2 position = uv * static_cast<float>(side) - 0.5F;
        const glm::ivec2 corner(glm::floor(position));
        const glm::vec2 fraction = position - glm::vec2(corner);
        for (int k = 0; k < 4; ++k) {
            const glm::ivec2 at = corner + glm::ivec2(k % 2, k / 2);
            if (at.x >= 0 && at.y >= 0 && at.x < side && at.y < side)
                use(at, (k % 2 == 0 ? 1.0F - fraction.x : fraction.x) * (k / 2 == 0 ? 1.0F - fraction.y : fraction.y));
        }
    }
    [[nodiscard]] glm::vec4 at(glm::vec2 uv) const
    {
        glm::vec4 sum(0.0F);
        around(side, uv, [&](glm::ivec2 at, float weight) { sum += cell(at.x, at.y) * weight; });
        return sum;
    }
};

Sums coarser(const Sums& fine)
{
    Sums coarse(fine.side / 2);
    for (int y = 0; y < fine.side; ++y)
        for (int x = 0; x < fine.side; ++x)
            coarse.cell(x / 2, y / 2) += fine.cell(x, y);
    return coarse;
}

/// Cells with less than enough hairs are filled up from the coarser ones, which are full already.
void fillUp(Sums& fine, const Sums& coarse)
{
    for (int y = 0; y < fine.side; ++y)
        for (int x = 0; x < fine.side; ++x) {
            glm::vec4& own = fine.cell(x, y);
            const float missing = kEnoughHairs - own.w;
            if (missing <= 0.0F)
                continue;
            const glm::vec2 uv = (glm::vec2(x, y) + 0.5F) / static_cast<float>(fine.side);
            const glm::vec4 from = coarse.at(uv);
            if (from.w > 0.0F)
                own += from * (missing / from.w);
        }
}

/// How much hair there is in a square of cells, all of it and what counts against it.
struct Amounts
{
    std::vector<glm::vec2> cells = std::vector<glm::vec2>(std::size_t{LyingField::kNearCells} * LyingField::kNearCells);

    void add(glm::vec2 uv, glm::vec2 amount)
    {
        const glm::ivec2 at = glm::clamp(glm::ivec2(uv * static_cast<float>(LyingField::kNearCells)), glm::ivec2(0),
                                         glm::ivec2(LyingField::kNearCells - 1));
        cells[index(at.x, at.y)] += amount;
    }
    /// 1 where hair is in the cell or in one beside it, and little of that counts against it.
    [[nodiscard]] std::vector<float> near() const
    {
        std::vector<float> near(cells.size());
        for (int y = 0; y < LyingField::kNearCells; ++y)
            for (int x = 0; x < LyingField::kNearCells; ++x) {
                glm::vec2 sum(0.0F);
                for (int k = 0; k < 9; ++k)
                    sum += cells[index(std::clamp(x + k % 3 - 1, 0, LyingField::kNearCells - 1),
                                       std::clamp(y + k / 3 - 1, 0, LyingField::kNearCells - 1))];
                near[index(x, y)] = sum.x > 0.0F && sum.y <= kFew * sum.x ? 1.0F : 0.0F;
            }
        return near;
    }
    [[nodiscard]] static std::size_t index(int x, int y)
    {
        return static_cast<std::size_t>(y) * LyingField::kNearCells + static_cast<std::size_t>(x);
    }
};

} // namespace

std::vector<LyingHair> lyingHairs(const sim::GroupFrame& group, const sim::HeadPose& pose, bool atRest)
{
    std::vector<LyingHair> hairs;
    if (group.groom == nullptr || group.positions.empty())
        return hairs;
    const sim::Groom& groom = *group.groom;
    const sim::RootSet& roots = *groom.roots;
    const sim::StrandBlocks blocks = groom.blocks();
    const glm::quat toHead = glm::conjugate(pose.rotation);
    hairs.reserve(groom.drawnCount);
    const std::vector<HeldBy> held = atRest ? heldAtRest(group, pose) : std::vector<HeldBy>();
    std::vector<glm::vec3> nodes(static_cast<std::size_t>(groom.nodes));
    for (std::size_t slot = 0; slot < roots.count(); ++slot) {
        if (!group.isPositioned(slot))
            continue;
        blocks.read(group.positions, groom.frameStrand(slot), nodes);
        const float alongM = std::min(kAlongM, groom.style(slot).lengthM * kAlongPart);
        const glm::vec3 directionHd = toHead * (pointAlong(nodes, alongM) - nodes.front());
        const float length = glm::length(directionHd);
        if (!(length > 1e-6F))
            continue;
        const auto root = static_cast<std::uint32_t>(slot);
        hairs.push_back({.uv = roots.uv[slot],
                         .direction = roots.frame(root).fromHd(directionHd / length),
                         .heldBy = atRest ? held[roots.neighbours[slot].front()] : HeldBy::Direction});
    }
    return hairs;
}

std::vector<LyingHair> hairsFurtherOn(const sim::GroupFrame& group, const sim::HeadPose& pose,
                                      const sim::DistanceGrid* distances, std::size_t most)
{
    if (group.groom == nullptr || group.positions.empty())
        return {};
    const sim::Groom& groom = *group.groom;
    const sim::RootSet& roots = *groom.roots;
    const sim::StrandBlocks blocks = groom.blocks();
    const glm::quat toHead = glm::conjugate(pose.rotation);
    const std::size_t step = std::max<std::size_t>(groom.drawnCount / std::max<std::size_t>(most, 1), 1);
    std::vector<std::size_t> slots;
    std::size_t number = 0;
    for (std::size_t slot = 0; slot < roots.count(); ++slot)
        if (group.isPositioned(slot) && number++ % step == 0)
            slots.push_back(slot);
    const auto nodeCount = static_cast<std::size_t>(groom.nodes);
    std::vector<std::optional<LyingHair>> found(slots.size() * nodeCount);
    sim::parallelFor(slots.size(), kFurtherGrain, [&](std::size_t begin, std::size_t end) {
        std::vector<glm::vec3> nodes(nodeCount);
        for (std::size_t i = begin; i < end; ++i) {
            blocks.read(group.positions, groom.frameStrand(slots[i]), nodes);
            for (std::size_t node = 1; node + 1 < nodeCount; ++node) {
                const glm::vec3 positionHd = toHead * (nodes[node] - pose.positionWo);
                if (distances != nullptr && isFar(*distances, positionHd))
                    continue;
                const glm::vec3 directionHd = toHead * (nodes[node + 1] - nodes[node - 1]);
                const float length = glm::length(directionHd);
                const sim::SurfacePoint under = roots.skin->nearest(positionHd);
                if (length > 1e-6F && glm::distance(under.positionHd, positionHd) < kOverSkinM)
                    found[i * nodeCount + node] =
                        LyingHair{.uv = under.uv, .direction = sim::SkinFrame::at(under).fromHd(directionHd / length)};
            }
        }
    });
    std::vector<LyingHair> hairs;
    for (const std::optional<LyingHair>& hair : found)
        if (hair)
            hairs.push_back(*hair);
    return hairs;
}

LyingField::LyingField(std::span<const LyingHair> hairs, std::span<const LyingHair> further)
{
    std::vector<Sums> levels{Sums(kCells)};
    Amounts all;
    Amounts roots;
    for (const std::span<const LyingHair> some : {hairs, further})
        for (const LyingHair& hair : some) {
            Sums::around(kCells, hair.uv, [&](glm::ivec2 at, float weight) {
                levels.front().cell(at.x, at.y) +=
                    glm::vec4(hair.direction, glm::length(hair.direction), 1.0F) * weight;
            });
            all.add(hair.uv, {1.0F, hair.heldBy != HeldBy::Direction ? 1.0F : 0.0F});
            if (some.data() == hairs.data())
                roots.add(hair.uv, {1.0F, hair.heldBy == HeldBy::Weight ? 1.0F : 0.0F});
        }
    m_near = all.near();
    m_nearRoots = roots.near();
    while (levels.back().side > kCoarsestCells)
        levels.push_back(coarser(levels.back()));
    for (std::size_t i = levels.size() - 1; i-- > 0;)
        fillUp(levels[i], levels[i + 1]);
    const Sums& sums = levels.front();
    m_cells.reserve(sums.cells.size());
    for (const glm::vec4& sum : sums.cells)
        m_cells.push_back(sum.w > 0.0F ? glm::vec3(sum) / sum.w : glm::vec3(0.0F, 0.0F, -1.0F));
}

float LyingField::nearness(glm::vec2 uv) const
{
    return softly(m_near, uv);
}

float LyingField::nearnessOfRoots(glm::vec2 uv) const
{
    return softly(m_nearRoots, uv);
}

float LyingField::softly(const std::vector<float>& cells, glm::vec2 uv)
{
    float sum = 0.0F;
    float weights = 0.0F;
    Sums::around(kNearCells, uv, [&](glm::ivec2 at, float weight) {
        sum += weight * cells[static_cast<std::size_t>(at.y) * kNearCells + static_cast<std::size_t>(at.x)];
        weights += weight;
    });
    const float near = weights > 0.0F ? sum / weights : 0.0F;
    return near * near * (3.0F - 2.0F * near);
}

std::optional<glm::vec2> LyingField::at(glm::vec2 uv) const
{
    glm::vec3 sum(0.0F);
    float weights = 0.0F;
    Sums::around(kCells, uv, [&](glm::ivec2 at, float weight) {
        const glm::vec3& cell = m_cells[static_cast<std::size_t>(at.y) * kCells + static_cast<std::size_t>(at.x)];
        if (cell.z < 0.0F)
            return;
        sum += cell * weight;
        weights += weight;
    });
    if (!(weights > 0.0F))
        return std::nullopt;
    // The mean direction with the mean length: where hair turns, the mean alone would stand up.
    const glm::vec3 mean = sum / weights;
    const float length = glm::length(glm::vec2(mean));
    return length > 1e-4F ? glm::vec2(mean) * (mean.z / length) : glm::vec2(0.0F);
}

} // namespace hairpaint::model
