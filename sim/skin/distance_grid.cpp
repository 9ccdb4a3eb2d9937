// Distances from the bounding tree, their signs by spreading from outside.
#include "sim/skin/distance_grid.h"

#include "sim/base/parallel.h"
#include "sim/skin/mesh_bounds.h"
#include "sim/skin/mesh_openings.h"
#include "sim/skin/skin.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr int kBlock = 8; ///< Nodes a side of what is looked at as a whole; even.
/// Nodes that are further from the skin get the mean of every other node around them, which are measured.
constexpr float kMeasuredCells = 2.0F;

GridLayout layoutAround(const HeadMesh& mesh)
{
    const MeshBounds bounds = boundsOf(mesh);
    const glm::vec3 extent = bounds.size() + 2.0F * DistanceGrid::kReachM;
    GridLayout layout{.cellM = DistanceGrid::kCellM};
    // Odd numbers: every other node is measured, the last one too.
    const auto countOf = [&](int axis) {
        return static_cast<std::size_t>(std::ceil(extent[axis] / (2.0F * layout.cellM))) * 2 + 1;
    };
    while (countOf(0) * countOf(1) * countOf(2) > DistanceGrid::kMostNodes &&
           layout.cellM <= DistanceGrid::kLargestCellM)
        layout.cellM *= 1.25F;
    for (int axis = 0; axis < 3; ++axis)
        layout.size[axis] = static_cast<int>(countOf(axis));
    layout.originHd = 0.5F * (bounds.least + bounds.greatest - glm::vec3(layout.size - 1) * layout.cellM);
    return layout;
}

/// The work on one grid.
class Builder
{
public:
    Builder(const HeadMesh& mesh, const GridLayout& layout)
        : m_layout(layout), m_skin(withOpeningsClosed(mesh)), m_distances(m_layout.nodeCount(), DistanceGrid::kReachM),
          m_signs(m_layout.nodeCount(), Sign::Unknown), m_blocks((m_layout.size + kBlock - 1) / kBlock)
    {}

    [[nodiscard]] bool measure(const std::function<bool(double)>& goesOn);
    void spreadFromOutside();
    void signTheRest();
    [[nodiscard]] std::vector<std::int8_t> values() const;
    [[nodiscard]] const GridLayout& layout() const { return m_layout; }

private:
    enum class Sign : std::uint8_t
    {
        Unknown,
        Outside,
        Inside
    };

    [[nodiscard]] std::size_t indexOf(const glm::ivec3& node) const
    {
        return (static_cast<std::size_t>(node.z) * static_cast<std::size_t>(m_layout.size.y) +
                static_cast<std::size_t>(node.y)) *
                   static_cast<std::size_t>(m_layout.size.x) +
               static_cast<std::size_t>(node.x);
    }
    [[nodiscard]] glm::vec3 positionOf(const glm::ivec3& node) const
    {
        return m_layout.originHd + m_layout.cellM * glm::vec3(node);
    }
    template<typename Visit>
    void eachNeighbour(const glm::ivec3& node, const Visit& visit) const;
    template<typename Visit>
    void eachNode(const Visit& visit) const;
    [[nodiscard]] float distanceTo(const glm::vec3& positionHd) const
    {
        return glm::distance(m_skin.nearest(positionHd).positionHd, positionHd);
    }
    void measureBlock(const glm::ivec3& block); ///< Every other node.
    void fillBlock(const glm::ivec3& block);    ///< Those between.
    [[nodiscard]] float meanAround(const glm::ivec3& node) const;

    GridLayout m_layout;
    Skin m_skin;
    std::vector<float> m_distances; ///< Without sign, cut off.
    std::vector<Sign> m_signs;
    glm::ivec3 m_blocks;
};

template<typename Visit>
void Builder::eachNeighbour(const glm::ivec3& node, const Visit& visit) const
{
    for (int axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1}) {
            glm::ivec3 beside = node;
            beside[axis] += step;
            if (beside[axis] >= 0 && beside[axis] < m_layout.size[axis])
                visit(beside);
        }
}

template<typename Visit>
void Builder::eachNode(const Visit& visit) const
{
    glm::ivec3 node;
    for (node.z = 0; node.z < m_layout.size.z; ++node.z)
        for (node.y = 0; node.y < m_layout.size.y; ++node.y)
            for (node.x = 0; node.x < m_layout.size.x; ++node.x)
                visit(node);
}

void Builder::measureBlock(const glm::ivec3& block)
{
    const glm::ivec3 first = block * kBlock;
    const glm::ivec3 end = glm::min(first + kBlock, m_layout.size);
    const glm::vec3 middle = 0.5F * (positionOf(first) + positionOf(end - 1));
    if (distanceTo(middle) > DistanceGrid::kReachM + glm::distance(middle, positionOf(first)))
        return; // All of it is further than the reach.
    glm::ivec3 node;
    for (node.z = first.z; node.z < end.z; node.z += 2)
        for (node.y = first.y; node.y < end.y; node.y += 2)
            for (node.x = first.x; node.x < end.x; node.x += 2)
                m_distances[indexOf(node)] = std::min(distanceTo(positionOf(node)), DistanceGrid::kReachM);
}

float Builder::meanAround(const glm::ivec3& node) const
{
    const glm::ivec3 low = node - node % 2;
    const glm::ivec3 high = node + node % 2;
    float sum = 0.0F;
    for (int corner = 0; corner < 8; ++corner)
        sum += m_distances[indexOf({(corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                                    (corner & 4) != 0 ? high.z : low.z})];
    return sum / 8.0F;
}

void Builder::fillBlock(const glm::ivec3& block)
{
    const glm::ivec3 first = block * kBlock;
    const glm::ivec3 end = glm::min(first + kBlock, m_layout.size);
    glm::ivec3 node;
    for (node.z = first.z; node.z < end.z; ++node.z)
        for (node.y = first.y; node.y < end.y; ++node.y)
            for (node.x = first.x; node.x < end.x; ++node.x) {
                if (node % 2 == glm::ivec3(0))
                    continue;
                const float mean = meanAround(node);
                m_distances[indexOf(node)] = mean > kMeasuredCells * m_layout.cellM
                                                 ? mean
                                                 : std::min(distanceTo(positionOf(node)), DistanceGrid::kReachM);
            }
}

bool Builder::measure(const std::function<bool(double)>& goesOn)
{
    const glm::ivec3 blocks = m_blocks;
    const auto layerSize = static_cast<std::size_t>(blocks.x) * static_cast<std::size_t>(blocks.y);
    const auto run = [&](int z, void (Builder::*work)(const glm::ivec3&)) {
        parallelFor(layerSize, 4, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                (this->*work)({static_cast<int>(i) % blocks.x, static_cast<int>(i) / blocks.x, z});
        });
    };
    // A layer is filled when the one behind it is measured, into which its last nodes' neighbours reach.
    for (int z = 0; z <= blocks.z; ++z) {
        if (goesOn && !goesOn(static_cast<double>(z) / (blocks.z + 1)))
            return false;
        if (z < blocks.z)
            run(z, &Builder::measureBlock);
        if (z > 0)
            run(z - 1, &Builder::fillBlock);
    }
    return true;
}

/// From a node that is further from the skin than the next one is from it, no skin lies between the two.
void Builder::spreadFromOutside()
{
    std::vector<glm::ivec3> front;
    eachNode([&](const glm::ivec3& node) {
        const bool onBorder =
            glm::any(glm::equal(node, glm::ivec3(0))) || glm::any(glm::equal(node, m_layout.size - 1));
        if (!onBorder)
            return;
        m_signs[indexOf(node)] = Sign::Outside;
        front.push_back(node);
    });
    while (!front.empty()) {
        const glm::ivec3 node = front.back();
        front.pop_back();
        if (m_distances[indexOf(node)] <= m_layout.cellM)
            continue;
        eachNeighbour(node, [&](const glm::ivec3& beside) {
            Sign& sign = m_signs[indexOf(beside)];
            if (sign != Sign::Unknown)
                return;
            sign = Sign::Outside;
            front.push_back(beside);
        });
    }
}

/// What was not reached is inside, or so near to the skin that its normal tells.
void Builder::signTheRest()
{
    std::vector<std::uint8_t> nearSkin(m_signs.size(), 0);
    for (std::size_t i = 0; i < m_signs.size(); ++i)
        nearSkin[i] = m_signs[i] == Sign::Unknown && m_distances[i] <= m_layout.cellM ? 1 : 0;
    for (std::size_t i = 0; i < m_signs.size(); ++i)
        if (m_signs[i] == Sign::Unknown && nearSkin[i] == 0)
            m_signs[i] = Sign::Inside;
    const glm::ivec3 size = m_layout.size;
    parallelFor(static_cast<std::size_t>(size.z), 1, [&](std::size_t begin, std::size_t end) {
        glm::ivec3 node;
        for (node.z = static_cast<int>(begin); node.z < static_cast<int>(end); ++node.z)
            for (node.y = 0; node.y < size.y; ++node.y)
                for (node.x = 0; node.x < size.x; ++node.x) {
                    const std::size_t index = indexOf(node);
                    if (nearSkin[index] == 0)
                        continue;
                    bool deep = false;
                    eachNeighbour(node, [&](const glm::ivec3& beside) {
                        const std::size_t other = indexOf(beside);
                        deep = deep || (nearSkin[other] == 0 && m_signs[other] == Sign::Inside);
                    });
                    const glm::vec3 positionHd = positionOf(node);
                    const SurfacePoint nearest = m_skin.nearest(positionHd);
                    const bool isBehind = glm::dot(positionHd - nearest.positionHd, nearest.normalHd) < 0.0F;
                    m_signs[index] = deep || isBehind ? Sign::Inside : Sign::Outside;
                }
    });
}

std::vector<std::int8_t> Builder::values() const
{
    std::vector<std::int8_t> values(m_distances.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float units = std::round(m_distances[i] / DistanceGrid::kUnitM);
        values[i] = static_cast<std::int8_t>(m_signs[i] == Sign::Inside ? -units : units);
    }
    return values;
}

} // namespace

DistanceGrid::DistanceGrid(const GridLayout& layout, const std::vector<std::int8_t>& values)
    : m_layout(layout), m_pairs(values.size() + 1)
{
    const auto row = static_cast<std::size_t>(layout.size.x);
    const auto slice = row * static_cast<std::size_t>(layout.size.y);
    for (std::size_t i = 0; i < values.size(); ++i)
        m_pairs[i] = {values[i], values[i % slice + row < slice ? i + row : i]};
}

std::shared_ptr<const DistanceGrid> DistanceGrid::make(const HeadMesh& mesh, const std::function<bool(double)>& goesOn)
{
    const GridLayout layout = layoutAround(mesh);
    if (layout.cellM > kLargestCellM)
        return nullptr;
    Builder builder(mesh, layout);
    if (!builder.measure(goesOn))
        return nullptr;
    builder.spreadFromOutside();
    builder.signTheRest();
    return of(builder.layout(), builder.values());
}

std::shared_ptr<const DistanceGrid> DistanceGrid::of(const GridLayout& layout, const std::vector<std::int8_t>& values)
{
    const bool isEmpty = layout.size.x < 2 || layout.size.y < 2 || layout.size.z < 2 || !(layout.cellM > 0.0F);
    if (isEmpty || layout.nodeCount() != values.size())
        return nullptr;
    return std::shared_ptr<const DistanceGrid>(new DistanceGrid(layout, values));
}

std::optional<DistanceGrid::Sample> DistanceGrid::at(const glm::vec3& positionHd) const
{
    const glm::vec3 inCells = (positionHd - m_layout.originHd) / m_layout.cellM;
    // Also where the position is not a number.
    if (!glm::all(glm::greaterThanEqual(inCells, glm::vec3(0.0F))) ||
        !glm::all(glm::lessThan(inCells, glm::vec3(m_layout.size - 1))))
        return std::nullopt;
    const glm::ivec3 node(inCells); // No less than 0, so these are whole cells.
    const glm::vec3 t = inCells - glm::vec3(node);
    const auto row = static_cast<std::size_t>(m_layout.size.x);
    const auto slice = row * static_cast<std::size_t>(m_layout.size.y);
    const std::size_t first = static_cast<std::size_t>(node.z) * slice + static_cast<std::size_t>(node.y) * row +
                              static_cast<std::size_t>(node.x);
    std::array<float, 4> alongX{};
    std::array<float, 4> rise{};
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t at = first + (i & 1U) * row + (i >> 1U) * slice;
        rise[i] = static_cast<float>(m_pairs[at + 1].value - m_pairs[at].value);
        alongX[i] = static_cast<float>(m_pairs[at].value) + rise[i] * t.x;
    }
    const auto mix = [](float a, float b, float s) { return a + (b - a) * s; };
    const float low0 = mix(alongX[0], alongX[1], t.y);
    const float high0 = mix(alongX[2], alongX[3], t.y);
    const glm::vec3 slope(mix(mix(rise[0], rise[1], t.y), mix(rise[2], rise[3], t.y), t.z),
                          mix(alongX[1] - alongX[0], alongX[3] - alongX[2], t.z), high0 - low0);
    return Sample{.distanceM = kUnitM * mix(low0, high0, t.z), .gradient = slope * (kUnitM / m_layout.cellM)};
}

} // namespace hairpaint::sim
