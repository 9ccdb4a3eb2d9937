// Distances over the skin by a graph of near roots; the means of those that are as far are the row.
#include "sim/groom/braid_row.h"

#include "sim/groom/unit_vector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace hairpaint::sim {

namespace {

constexpr std::size_t kPoints = 33;
constexpr std::size_t kBins = 14;
constexpr float kFar = std::numeric_limits<float>::max();

/// Which roots are near each other.
class RootGraph
{
public:
    explicit RootGraph(std::span<const glm::vec3> positionsHd) : m_positionsHd(positionsHd.begin(), positionsHd.end())
    {
        // In units of the mean distance of nearest roots: far enough that a strip of even roots holds together.
        constexpr float kReach = 4.0F;
        float sumM = 0.0F;
        for (std::size_t i = 0; i < m_positionsHd.size(); ++i) {
            float nearest = kFar;
            for (std::size_t k = 0; k < m_positionsHd.size(); ++k)
                if (k != i)
                    nearest = std::min(nearest, lengthOfVector(m_positionsHd[i] - m_positionsHd[k]));
            sumM += nearest < kFar ? nearest : 0.0F;
        }
        m_reachM = kReach * sumM / static_cast<float>(std::max<std::size_t>(m_positionsHd.size(), 1));
        bridge();
    }

    /// Lengths of the shortest paths over the graph from one root, by root; kFar where there is none.
    [[nodiscard]] std::vector<float> distancesFrom(std::size_t from) const
    {
        std::vector<float> distances(m_positionsHd.size(), kFar);
        using Step = std::pair<float, std::size_t>;
        std::priority_queue<Step, std::vector<Step>, std::greater<>> open;
        distances[from] = 0.0F;
        open.emplace(0.0F, from);
        while (!open.empty()) {
            const float soFar = open.top().first;
            const std::size_t at = open.top().second;
            open.pop();
            if (soFar > distances[at])
                continue;
            const auto step = [&](std::size_t next, float stepM) {
                if (soFar + stepM < distances[next]) {
                    distances[next] = soFar + stepM;
                    open.emplace(distances[next], next);
                }
            };
            for (std::size_t next = 0; next < m_positionsHd.size(); ++next)
                if (const float stepM = lengthOfVector(m_positionsHd[next] - m_positionsHd[at]); stepM <= m_reachM)
                    step(next, stepM);
            for (const Bridge& one : m_bridges) {
                if (one.from == at)
                    step(one.to, one.lengthM);
                if (one.to == at)
                    step(one.from, one.lengthM);
            }
        }
        return distances;
    }
    [[nodiscard]] std::span<const glm::vec3> positionsHd() const { return m_positionsHd; }

private:
    struct Bridge
    {
        std::size_t from = 0, to = 0;
        float lengthM = 0.0F;
    };

    /// Where hair is thin a strip falls apart; the shortest way between its pieces joins them.
    void bridge()
    {
        while (!m_positionsHd.empty()) {
            const std::vector<float> distances = distancesFrom(0);
            Bridge best{.lengthM = kFar};
            for (std::size_t from = 0; from < m_positionsHd.size(); ++from)
                for (std::size_t to = 0; distances[from] < kFar && to < m_positionsHd.size(); ++to)
                    if (distances[to] == kFar)
                        if (const float lengthM = lengthOfVector(m_positionsHd[to] - m_positionsHd[from]);
                            lengthM < best.lengthM)
                            best = {.from = from, .to = to, .lengthM = lengthM};
            if (best.lengthM == kFar)
                return;
            m_bridges.push_back(best);
        }
    }

    std::vector<glm::vec3> m_positionsHd;
    std::vector<Bridge> m_bridges;
    float m_reachM = 0.0F;
};

std::size_t furthest(std::span<const float> distances)
{
    std::size_t best = 0;
    for (std::size_t i = 0; i < distances.size(); ++i)
        if (distances[i] < kFar && distances[i] > distances[best])
            best = i;
    return best;
}

/// How early a row may begin there: greater the higher, and the further in front.
float beginning(glm::vec3 position)
{
    constexpr float kForward = 0.5F;
    return position.y + kForward * position.z;
}

/// Points evenly along a polyline.
std::vector<glm::vec3> evenly(std::span<const glm::vec3> line, std::size_t count)
{
    std::vector<float> upTo(line.size(), 0.0F);
    for (std::size_t i = 1; i < line.size(); ++i)
        upTo[i] = upTo[i - 1] + lengthOfVector(line[i] - line[i - 1]);
    std::vector<glm::vec3> points;
    std::size_t at = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const float wanted = upTo.back() * static_cast<float>(k) / static_cast<float>(count - 1);
        while (at + 2 < line.size() && upTo[at + 1] <= wanted)
            ++at;
        const float t = std::clamp((wanted - upTo[at]) / std::max(upTo[at + 1] - upTo[at], 1e-9F), 0.0F, 1.0F);
        points.push_back(line[at] + (line[at + 1] - line[at]) * t);
    }
    return points;
}

} // namespace

BraidRow rowAlong(const RootSet& roots, std::span<const std::uint32_t> slots)
{
    std::vector<glm::vec3> positionsHd;
    for (const std::uint32_t slot : slots.first(std::min(slots.size(), kMostRowPoints)))
        positionsHd.push_back(roots.positionHd[slot]);
    return rowAlong(*roots.skin, positionsHd, roots.tangentHd[slots.front()]);
}

BraidRow rowAlong(const Skin& skin, std::span<const glm::vec3> strip, glm::vec3 tangentHd)
{
    const RootGraph graph(strip.first(std::min(strip.size(), kMostRowPoints)));
    const std::span<const glm::vec3> positions = graph.positionsHd();
    std::size_t begin = furthest(graph.distancesFrom(0));
    const std::size_t end = furthest(graph.distancesFrom(begin));
    if (beginning(positions[end]) > beginning(positions[begin]))
        begin = end;
    const std::vector<float> distances = graph.distancesFrom(begin);
    const float longest = std::max(distances[furthest(distances)], 1e-6F);
    std::vector<glm::vec3> sums(kBins, glm::vec3(0.0F));
    std::vector<float> counts(kBins, 0.0F);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (!(distances[i] < kFar))
            continue;
        const auto bin = std::min(static_cast<std::size_t>(distances[i] / longest * kBins), kBins - 1);
        sums[bin] += positions[i];
        counts[bin] += 1.0F;
    }
    std::vector<glm::vec3> line;
    for (std::size_t bin = 0; bin < kBins; ++bin)
        if (counts[bin] > 0.0F)
            line.push_back(sums[bin] / counts[bin]);
    if (line.size() < 2)
        line = {positions[begin], positions[begin] + tangentHd * 1e-3F};
    // The strip ends half a bin beyond the means of the first bin and the last.
    const glm::vec3 first = line[0] + (line[0] - line[1]) * 0.5F;
    const glm::vec3 last = line.back() + (line.back() - line[line.size() - 2]) * 0.5F;
    line.insert(line.begin(), first);
    line.push_back(last);
    for (std::size_t i = 1; i + 1 < line.size(); ++i)
        line[i] = (line[i - 1] + line[i] * 2.0F + line[i + 1]) * 0.25F;

    BraidRow row;
    for (int pass = 0; pass < 2; ++pass) {
        row.pointsHd = evenly(line, kPoints);
        row.normalsHd.clear();
        for (glm::vec3& point : row.pointsHd) {
            const SurfacePoint on = skin.nearest(point);
            point = on.positionHd;
            row.normalsHd.push_back(on.normalHd);
        }
        line = row.pointsHd;
    }
    glm::vec3 side(0.0F);
    for (std::size_t i = 1; i < kPoints; ++i) {
        const glm::vec3 onward = row.pointsHd[i] - row.pointsHd[i - 1];
        row.lengthM += lengthOfVector(onward);
        side += glm::cross(row.normalsHd[i], onward);
    }
    row.sideHd = unitVectorOr(side, tangentHd);
    // Roots that lie evenly are a quarter of the width away from the middle.
    for (const glm::vec3& position : positions)
        row.widthM += 4.0F * nearestOnRow(row, position).asideM / static_cast<float>(positions.size());
    return row;
}

RowPoint nearestOnRow(const BraidRow& row, glm::vec3 positionHd)
{
    const float segmentM = row.lengthM / static_cast<float>(row.pointsHd.size() - 1);
    float nearest = kFar;
    float alongM = 0.0F;
    for (std::size_t i = 0; i + 1 < row.pointsHd.size(); ++i) {
        const glm::vec3 onward = row.pointsHd[i + 1] - row.pointsHd[i];
        const float t = std::clamp(
            glm::dot(positionHd - row.pointsHd[i], onward) / std::max(glm::dot(onward, onward), 1e-12F), 0.0F, 1.0F);
        const glm::vec3 away = row.pointsHd[i] + onward * t - positionHd;
        if (glm::dot(away, away) < nearest) {
            nearest = glm::dot(away, away);
            alongM = (static_cast<float>(i) + t) * segmentM;
        }
    }
    return {.alongM = alongM, .asideM = std::sqrt(nearest)};
}

glm::vec3 onRow(const BraidRow& row, float alongM, float aboveM)
{
    const auto last = row.pointsHd.size() - 1;
    const float at = std::max(alongM, 0.0F) / std::max(row.lengthM, 1e-6F) * static_cast<float>(last);
    const std::size_t i = std::min(static_cast<std::size_t>(at), last - 1);
    const float t = at - static_cast<float>(i);
    const float within = std::min(t, 1.0F); // Beyond its end the normal turns no further.
    const glm::vec3 normal =
        unitVectorOr(row.normalsHd[i] + (row.normalsHd[i + 1] - row.normalsHd[i]) * within, row.normalsHd[i]);
    return row.pointsHd[i] + (row.pointsHd[i + 1] - row.pointsHd[i]) * t + normal * aboveM;
}

} // namespace hairpaint::sim
