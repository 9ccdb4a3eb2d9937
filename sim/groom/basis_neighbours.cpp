// Nearest basis hairs by position and normal together, so that an ear does not follow the skull behind it.
#include "sim/groom/basis_neighbours.h"

#include "sim/base/parallel.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace hairpaint::sim {

namespace {

constexpr std::size_t kDimensions = 6;
/// One neighbour more than is kept: its distance is where the others' weights reach 0, so that weights change smoothly
/// from root to root although the neighbours are swapped.
constexpr std::size_t kFound = RootSet::kNeighbours + 1;
/// Opposite normals are as far apart as twice this many spacings of basis hairs.
constexpr float kNormalSpacings = 3.0F;
constexpr std::size_t kGrain = 2048;
constexpr std::size_t kRun = 16; ///< Slots one after another, hence near each other, that share a search.
constexpr std::size_t kMostCandidates = 128;

using SearchPoint = std::array<float, kDimensions>;

/// The distinct points of the basis hairs, and which stand on each. A tree of equal points has nothing to split: every
/// search would visit all of them. On a sound head each point has one hair, and the order is theirs.
struct BasisCloud
{
    explicit BasisCloud(const std::vector<SearchPoint>& pointOfBasis);

    std::vector<SearchPoint> points;
    std::vector<std::uint32_t> first; ///< [points + 1], into `basis`.
    std::vector<std::uint32_t> basis; ///< Indices of basis hairs, ascending within a point.

    /// The adaptor that nanoflann asks for.
    // The names are nanoflann's.
    [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
    [[nodiscard]] float kdtree_get_pt(std::size_t index, std::size_t dimension) const
    {
        return points[index][dimension];
    }
    template<class Box>
    bool kdtree_get_bbox(Box& /*box*/) const
    {
        return false;
    }
};

BasisCloud::BasisCloud(const std::vector<SearchPoint>& pointOfBasis)
{
    std::vector<std::uint32_t> order(pointOfBasis.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        return pointOfBasis[a] != pointOfBasis[b] ? pointOfBasis[a] < pointOfBasis[b] : a < b;
    });
    // Each group of equal points is named by its lowest basis hair.
    std::vector<std::uint32_t> leader(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        leader[order[i]] =
            i > 0 && pointOfBasis[order[i]] == pointOfBasis[order[i - 1]] ? leader[order[i - 1]] : order[i];
    std::vector<std::uint32_t> pointOfLeader(order.size());
    for (std::uint32_t i = 0; i < leader.size(); ++i)
        if (leader[i] == i) {
            pointOfLeader[i] = static_cast<std::uint32_t>(points.size());
            points.push_back(pointOfBasis[i]);
        }
    first.assign(points.size() + 1, 0);
    for (const std::uint32_t lead : leader)
        ++first[pointOfLeader[lead] + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    basis.resize(order.size());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::uint32_t i = 0; i < leader.size(); ++i)
        basis[next[pointOfLeader[leader[i]]]++] = i;
}

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, BasisCloud>, BasisCloud,
                                                 static_cast<int>(kDimensions), std::uint32_t>;

SearchPoint searchPointOf(const RootSet& roots, std::uint32_t slot, float normalScaleM)
{
    const glm::vec3 position = roots.positionHd[slot];
    const glm::vec3 normal = roots.normalHd[slot] * normalScaleM;
    return {position.x, position.y, position.z, normal.x, normal.y, normal.z};
}

struct Nearest
{
    std::array<std::uint32_t, kFound> basis{};
    std::array<float, kFound> distances{};
};

using NearestPoints = nanoflann::KNNResultSet<float, std::uint32_t>;

/// What a search finds within a distance of a point; it ends where that is too much to be worth comparing.
class Candidates
{
public:
    explicit Candidates(float squaredReach) : m_squaredReach(squaredReach) {}

    [[nodiscard]] bool tooMany() const { return m_count > kMostCandidates; }
    [[nodiscard]] std::span<const std::uint32_t> points() const { return std::span(m_points).first(m_count); }

    // The names are nanoflann's; newer versions ask for more of them.
    [[nodiscard]] std::size_t size() const { return m_count; }
    [[nodiscard]] bool empty() const { return m_count == 0; }
    [[nodiscard]] static bool full() { return true; }
    [[nodiscard]] float worstDist() const { return m_squaredReach; }
    static void sort() {}
    bool addPoint(float square, std::uint32_t point)
    {
        if (square >= m_squaredReach)
            return true;
        if (m_count < kMostCandidates)
            m_points[m_count] = point;
        return ++m_count <= kMostCandidates;
    }

private:
    float m_squaredReach;
    std::size_t m_count = 0;
    std::array<std::uint32_t, kMostCandidates> m_points; // Written where read.
};

class BasisSearch
{
public:
    explicit BasisSearch(const std::vector<SearchPoint>& pointOfBasis)
        : m_cloud(pointOfBasis),
          m_tree(static_cast<int>(kDimensions), m_cloud, nanoflann::KDTreeSingleIndexAdaptorParams(8))
    {}

    /// The nearest of each of at most kRun points.
    void find(std::span<const SearchPoint> run, std::span<Nearest> nearest) const;

private:
    [[nodiscard]] static float squareOf(const SearchPoint& a, const SearchPoint& b);
    [[nodiscard]] Candidates candidatesFor(std::span<const SearchPoint> run) const;
    [[nodiscard]] Nearest basisOn(const std::array<std::uint32_t, kFound>& points,
                                  const std::array<float, kFound>& squares, std::size_t pointCount) const;

    BasisCloud m_cloud;
    Tree m_tree;
};

float BasisSearch::squareOf(const SearchPoint& a, const SearchPoint& b)
{
    float sum = 0.0F;
    for (std::size_t i = 0; i < kDimensions; ++i)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

/// Who is among the nearest of one of the run is no farther from the run's middle than the nearest of the middle and
/// twice the run's radius (triangle inequality).
Candidates BasisSearch::candidatesFor(std::span<const SearchPoint> run) const
{
    SearchPoint middle{};
    for (const SearchPoint& point : run)
        for (std::size_t i = 0; i < kDimensions; ++i)
            middle[i] += point[i] / static_cast<float>(run.size());
    float squaredRadius = 0.0F;
    for (const SearchPoint& point : run)
        squaredRadius = std::max(squaredRadius, squareOf(point, middle));
    std::array<std::uint32_t, kFound> points{};
    std::array<float, kFound> squares{};
    const std::size_t count = m_tree.knnSearch(middle.data(), kFound, points.data(), squares.data());
    constexpr float kRoundingMargin = 1.001F;
    const float reach = kRoundingMargin * (std::sqrt(squares[count - 1]) + 2.0F * std::sqrt(squaredRadius));
    Candidates candidates(std::max(reach * reach, std::numeric_limits<float>::min()));
    m_tree.findNeighbors(candidates, middle.data(), {});
    return candidates;
}

void BasisSearch::find(std::span<const SearchPoint> run, std::span<Nearest> nearest) const
{
    const Candidates candidates = candidatesFor(run);
    for (std::size_t i = 0; i < run.size(); ++i) {
        std::array<std::uint32_t, kFound> points{};
        std::array<float, kFound> squares{};
        NearestPoints found(kFound);
        found.init(points.data(), squares.data());
        if (candidates.tooMany())
            m_tree.findNeighbors(found, run[i].data(), {});
        else
            for (const std::uint32_t point : candidates.points())
                found.addPoint(squareOf(run[i], m_cloud.points[point]), point);
        nearest[i] = basisOn(points, squares, found.size());
    }
}

/// From the nearest on. With fewer basis hairs than neighbours the last is repeated, and weighs nothing.
Nearest BasisSearch::basisOn(const std::array<std::uint32_t, kFound>& points, const std::array<float, kFound>& squares,
                             std::size_t pointCount) const
{
    Nearest nearest;
    std::size_t count = 0;
    for (std::size_t k = 0; k < pointCount; ++k)
        for (std::uint32_t i = m_cloud.first[points[k]]; i < m_cloud.first[points[k] + 1] && count < kFound; ++i) {
            nearest.basis[count] = m_cloud.basis[i];
            nearest.distances[count++] = std::sqrt(squares[k]);
        }
    for (std::size_t k = count; k < kFound; ++k) {
        nearest.basis[k] = nearest.basis[count - 1];
        nearest.distances[k] = nearest.distances[count - 1];
    }
    return nearest;
}

/// Shepard's weights as Franke and Nielson 1980 bound them: ((R - d) / (R d))^2, with R the distance of the next one.
std::array<float, RootSet::kNeighbours> weightsOf(const std::array<float, kFound>& distances)
{
    std::array<float, RootSet::kNeighbours> weights{};
    const float reach = distances[kFound - 1];
    float sum = 0.0F;
    for (std::size_t k = 0; k < weights.size(); ++k) {
        const float fraction = (reach - distances[k]) / std::max(distances[k], 1e-4F * reach + 1e-12F);
        weights[k] = fraction * fraction;
        sum += weights[k];
    }
    if (!(sum > 1e-6F)) {
        weights = {1.0F, 0.0F, 0.0F};
        return weights;
    }
    for (float& weight : weights)
        weight /= sum;
    return weights;
}

void follow(RootSet& roots, std::uint32_t slot, const Nearest& nearest)
{
    std::array<std::uint32_t, RootSet::kNeighbours> kept{};
    std::copy_n(nearest.basis.begin(), kept.size(), kept.begin());
    if (roots.rankOfSlot[slot] >= roots.basisSlot.size()) {
        roots.neighbours[slot] = kept;
        roots.weights[slot] = weightsOf(nearest.distances);
        return;
    }
    // A basis hair follows itself, also where another stands on the same spot.
    const auto own = static_cast<std::uint32_t>(std::lower_bound(roots.basisSlot.begin(), roots.basisSlot.end(), slot) -
                                                roots.basisSlot.begin());
    const auto at = std::find(kept.begin(), kept.end() - 1, own);
    std::copy_backward(kept.begin(), at, at + 1);
    kept[0] = own;
    roots.neighbours[slot] = kept;
    roots.weights[slot] = {1.0F, 0.0F, 0.0F};
}

} // namespace

void findBasisNeighbours(RootSet& roots)
{
    roots.neighbours.assign(roots.count(), {});
    roots.weights.assign(roots.count(), {});
    const std::size_t basisCount = roots.basisSlot.size();
    if (basisCount == 0)
        return;
    const float spacingM = std::sqrt(static_cast<float>(roots.skin->areaM2()) / static_cast<float>(basisCount));
    const float normalScaleM = kNormalSpacings * spacingM;
    std::vector<SearchPoint> pointOfBasis;
    pointOfBasis.reserve(basisCount);
    for (const std::uint32_t slot : roots.basisSlot)
        pointOfBasis.push_back(searchPointOf(roots, slot, normalScaleM));
    const BasisSearch search(pointOfBasis);

    parallelFor(roots.count(), kGrain, [&](std::size_t begin, std::size_t end) {
        std::array<SearchPoint, kRun> points{};
        std::array<Nearest, kRun> nearest{};
        for (std::size_t first = begin; first < end; first += kRun) {
            const std::size_t count = std::min(kRun, end - first);
            for (std::size_t i = 0; i < count; ++i)
                points[i] = searchPointOf(roots, static_cast<std::uint32_t>(first + i), normalScaleM);
            search.find(std::span(points).first(count), nearest);
            for (std::size_t i = 0; i < count; ++i)
                follow(roots, static_cast<std::uint32_t>(first + i), nearest[i]);
        }
    });
}

std::vector<std::uint32_t> nearestLeaders(const RootSet& roots, std::size_t leaderCount)
{
    std::vector<std::uint32_t> leaders;
    for (std::uint32_t i = 0; i < roots.basisSlot.size(); ++i)
        if (roots.rankOfSlot[roots.basisSlot[i]] < leaderCount)
            leaders.push_back(i);
    const float spacingM = std::sqrt(static_cast<float>(roots.skin->areaM2()) / static_cast<float>(leaders.size()));
    const float normalScaleM = kNormalSpacings * spacingM;
    std::vector<SearchPoint> points;
    points.reserve(leaders.size());
    for (const std::uint32_t leader : leaders)
        points.push_back(searchPointOf(roots, roots.basisSlot[leader], normalScaleM));
    const BasisSearch search(points);
    std::vector<std::uint32_t> nearestOf(roots.basisSlot.size());
    parallelFor(nearestOf.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        std::array<SearchPoint, kRun> run{};
        std::array<Nearest, kRun> nearest{};
        for (std::size_t first = begin; first < end; first += kRun) {
            const std::size_t count = std::min(kRun, end - first);
            for (std::size_t i = 0; i < count; ++i)
                run[i] = searchPointOf(roots, roots.basisSlot[first + i], normalScaleM);
            search.find(std::span(run).first(count), nearest);
            for (std::size_t i = 0; i < count; ++i)
                nearestOf[first + i] = leaders[nearest[i].basis[0]];
        }
    });
    for (const std::uint32_t leader : leaders) // Also where two stand on one spot.
        nearestOf[leader] = leader;
    return nearestOf;
}

} // namespace hairpaint::sim
