// Edges of a mesh over uv, and coarser meshes that stand for them.
#include "view/paint_area/uv_wireframe.h"

#include "sim/base/parallel.h"
#include "view/paint_area/uv_transform.h"

#include <QHash>
#include <QLineF>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <queue>
#include <tuple>

namespace hairpaint::view {

namespace {

constexpr unsigned kNobody = 0xFFFFFFFFU;

std::uint64_t edgeKey(unsigned a, unsigned b)
{
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32U) | std::max(a, b);
}

/// An order without pattern that is the same every time.
std::uint64_t shuffled(std::uint64_t x)
{
    x ^= x >> 33U;
    x *= 0xFF51AFD7ED558CCDULL;
    x ^= x >> 33U;
    x *= 0xC4CEB9FE1A85EC53ULL;
    return x ^ (x >> 33U);
}

/// Spacing of a level's edges, in paper units.
double spacingOf(std::size_t level)
{
    return std::ldexp(1.0, -static_cast<int>(level + 2));
}

double distance(QPointF a, QPointF b)
{
    const QPointF between = b - a;
    return std::sqrt(QPointF::dotProduct(between, between)); // No need of hypot's care: paper is about 1 wide.
}

} // namespace

UvWireframe::UvWireframe(const sim::HeadMesh& mesh)
{
    m_paper.reserve(mesh.uvs.size());
    for (const glm::vec2& uv : mesh.uvs)
        m_paper.push_back(UvTransform::paperOf(uv));

    std::vector<std::uint64_t> keys;
    keys.reserve(3 * mesh.triangles.size());
    for (const glm::uvec3& triangle : mesh.triangles) {
        for (int i = 0; i < 3; ++i)
            keys.push_back(edgeKey(triangle[i], triangle[(i + 1) % 3]));
    }
    std::ranges::sort(keys);
    m_onBorder.assign(m_paper.size(), false);
    m_neighbourStart.assign(m_paper.size() + 1, 0);
    double total = 0.0;
    for (std::size_t i = 0; i < keys.size();) {
        std::size_t end = i + 1;
        while (end < keys.size() && keys[end] == keys[i])
            ++end;
        const Edge edge{static_cast<unsigned>(keys[i] >> 32U), static_cast<unsigned>(keys[i])};
        m_edges.push_back(edge);
        total += distance(m_paper[edge.a], m_paper[edge.b]);
        ++m_neighbourStart[edge.a + 1];
        ++m_neighbourStart[edge.b + 1];
        if (end - i == 1) {
            m_borders.push_back(edge);
            m_onBorder[edge.a] = m_onBorder[edge.b] = true;
        }
        i = end;
    }
    m_meanLength = m_edges.empty() ? 1.0 : total / static_cast<double>(m_edges.size());
    std::partial_sum(m_neighbourStart.begin(), m_neighbourStart.end(), m_neighbourStart.begin());
    m_neighbours.resize(2 * m_edges.size());
    std::vector<unsigned> next(m_neighbourStart.begin(), m_neighbourStart.end() - 1);
    for (const Edge& edge : m_edges) {
        m_neighbours[next[edge.a]++] = edge.b;
        m_neighbours[next[edge.b]++] = edge.a;
    }
    if (!tooFine(spacingOf(0) * std::numbers::sqrt2))
        return;
    const std::vector<unsigned> order = seedOrder();
    sim::parallelFor(m_thinned.size(), 1, [this, &order](std::size_t begin, std::size_t end) {
        for (std::size_t level = begin; level < end; ++level)
            // Drawn up to half a level apart from its own spacing.
            if (const double spacing = spacingOf(level); tooFine(spacing * std::numbers::sqrt2))
                m_thinned[level] = thinned(spacing, order);
    });
}

std::vector<unsigned> UvWireframe::seedOrder() const
{
    using Place = std::tuple<bool, std::uint64_t, unsigned>;
    std::vector<Place> places;
    places.reserve(m_paper.size());
    for (unsigned i = 0; i < m_paper.size(); ++i)
        places.emplace_back(!m_onBorder[i], shuffled(i), i);
    std::ranges::sort(places);
    std::vector<unsigned> order;
    order.reserve(places.size());
    for (const auto& [inside, chance, vertex] : places)
        order.push_back(vertex);
    return order;
}

std::vector<unsigned> UvWireframe::owners(double spacing, const std::vector<unsigned>& order) const
{
    QMultiHash<qint64, unsigned> grid;
    const auto cell = [spacing](QPointF p, int dx, int dy) {
        return (static_cast<qint64>(std::floor(p.x() / spacing)) + dx) * 1'000'003 +
               static_cast<qint64>(std::floor(p.y() / spacing)) + dy;
    };
    std::vector<unsigned> seeds;
    for (const unsigned vertex : order) {
        bool free = true;
        for (int k = 0; k < 9 && free; ++k) {
            const auto [begin, end] = grid.equal_range(cell(m_paper[vertex], k % 3 - 1, k / 3 - 1));
            free = std::none_of(begin, end,
                                [&](unsigned other) { return distance(m_paper[vertex], m_paper[other]) < spacing; });
        }
        if (free) {
            grid.insert(cell(m_paper[vertex], 0, 0), vertex);
            seeds.push_back(vertex);
        }
    }

    // Dijkstra from all seeds at once; parts without a seed (small islands close to others) own themselves.
    using Reached = std::pair<double, unsigned>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
    std::vector<double> best(m_paper.size(), 1e9);
    std::vector<unsigned> owner(m_paper.size(), kNobody);
    for (const unsigned seed : seeds) {
        best[seed] = 0.0;
        owner[seed] = seed;
        queue.emplace(0.0, seed);
    }
    while (!queue.empty()) {
        const auto [reached, vertex] = queue.top();
        queue.pop();
        if (reached > best[vertex])
            continue;
        for (unsigned k = m_neighbourStart[vertex]; k < m_neighbourStart[vertex + 1]; ++k) {
            const unsigned other = m_neighbours[k];
            const double length = reached + distance(m_paper[vertex], m_paper[other]);
            if (length < best[other]) {
                best[other] = length;
                owner[other] = owner[vertex];
                queue.emplace(length, other);
            }
        }
    }
    return owner;
}

std::vector<UvWireframe::Edge> UvWireframe::thinned(double spacing, const std::vector<unsigned>& order) const
{
    const std::vector<unsigned> owner = owners(spacing, order);
    std::vector<std::uint64_t> keys;
    for (const Edge& edge : m_edges) {
        const unsigned a = owner[edge.a];
        const unsigned b = owner[edge.b];
        // Where both lie on the border the border itself is drawn.
        if (a != b && a != kNobody && b != kNobody && !(m_onBorder[a] && m_onBorder[b]))
            keys.push_back(edgeKey(a, b));
    }
    std::ranges::sort(keys);
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    std::vector<Edge> edges;
    edges.reserve(keys.size());
    for (const std::uint64_t key : keys)
        edges.push_back({static_cast<unsigned>(key >> 32U), static_cast<unsigned>(key)});
    return edges;
}

const std::vector<UvWireframe::Edge>& UvWireframe::edgesAt(double pxPerPaper) const
{
    const double spacing = kSpacingPx / pxPerPaper;
    const int level = std::clamp(static_cast<int>(std::lround(-std::log2(spacing))) - 2, 0, kLevels - 1);
    const std::vector<Edge>& edges = m_thinned[static_cast<std::size_t>(level)];
    return tooFine(spacing) && !edges.empty() ? edges : m_edges;
}

std::size_t UvWireframe::edgeCount(double pxPerPaper) const
{
    return edgesAt(pxPerPaper).size();
}

void UvWireframe::drawEdges(QPainter& painter, const std::vector<Edge>& edges, const QTransform& paperToWidget,
                            const QRectF& visiblePaper) const
{
    QList<QLineF> lines;
    for (const Edge& edge : edges) {
        const QPointF a = m_paper[edge.a];
        const QPointF b = m_paper[edge.b];
        const bool outside =
            std::max(a.x(), b.x()) < visiblePaper.left() || std::min(a.x(), b.x()) > visiblePaper.right() ||
            std::max(a.y(), b.y()) < visiblePaper.top() || std::min(a.y(), b.y()) > visiblePaper.bottom();
        if (!outside)
            lines.push_back(QLineF(paperToWidget.map(a), paperToWidget.map(b)));
    }
    painter.drawLines(lines);
}

void UvWireframe::draw(QPainter& painter, const QTransform& paperToWidget, const QRectF& visiblePaper, int edge,
                       int border) const
{
    const double pxPerPaper = std::sqrt(std::abs(paperToWidget.determinant()));
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(edge, edge, edge), 1.0));
    drawEdges(painter, edgesAt(pxPerPaper), paperToWidget, visiblePaper);
    painter.setPen(QPen(QColor(border, border, border), 1.25));
    drawEdges(painter, m_borders, paperToWidget, visiblePaper);
    painter.restore();
}

} // namespace hairpaint::view
