// Rows of a line's edges.
#include "view/picking/line_rows.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

constexpr float kRowPx = 8.0F;
constexpr std::size_t kMostRows = 2048;

} // namespace

LineRows::LineRows(std::span<const QPointF> points, bool closed)
{
    for (std::size_t i = 1; i < points.size(); ++i)
        m_edges.push_back({pictureVec(points[i - 1]), pictureVec(points[i])});
    if (closed && points.size() > 2 && points.front() != points.back())
        m_edges.push_back({pictureVec(points.back()), pictureVec(points.front())});
    for (const Edge& edge : m_edges) {
        m_box.add(edge.from);
        m_box.add(edge.to);
    }
    if (m_edges.empty())
        return;
    m_rows.resize(std::min(kMostRows, static_cast<std::size_t>((m_box.bottom - m_box.top) / kRowPx) + 1));
    for (std::size_t i = 0; i < m_edges.size(); ++i) {
        const Edge& edge = m_edges[i];
        const auto [first, end] = rowsOf(std::min(edge.from.y, edge.to.y), std::max(edge.from.y, edge.to.y));
        for (std::size_t row = first; row < end; ++row) {
            m_rows[row].left = std::min({m_rows[row].left, edge.from.x, edge.to.x});
            m_rows[row].right = std::max({m_rows[row].right, edge.from.x, edge.to.x});
            m_rows[row].edges.push_back(static_cast<std::uint32_t>(i));
        }
    }
}

std::pair<std::size_t, std::size_t> LineRows::rowsOf(float top, float bottom) const
{
    if (bottom < m_box.top || top > m_box.bottom || m_rows.empty())
        return {0, 0};
    const auto rowOf = [this](float y) {
        return std::min(static_cast<std::size_t>(std::max(y - m_box.top, 0.0F) / kRowPx), m_rows.size() - 1);
    };
    return {rowOf(top), rowOf(bottom) + 1};
}

bool LineRows::mayMeet(const PictureBox& box) const
{
    if (!box.meets(m_box))
        return false;
    const auto [first, end] = rowsOf(box.top, box.bottom);
    return std::any_of(m_rows.begin() + static_cast<std::ptrdiff_t>(first),
                       m_rows.begin() + static_cast<std::ptrdiff_t>(end),
                       [&box](const Row& row) { return row.left <= box.right && box.left <= row.right; });
}

std::optional<float> LineRows::firstMeeting(glm::vec2 from, glm::vec2 to) const
{
    const auto [first, end] = rowsOf(std::min(from.y, to.y), std::max(from.y, to.y));
    const float left = std::min(from.x, to.x);
    const float right = std::max(from.x, to.x);
    std::optional<float> met;
    for (std::size_t row = first; row < end; ++row) {
        if (m_rows[row].left > right || m_rows[row].right < left)
            continue;
        for (const std::uint32_t i : m_rows[row].edges) {
            const glm::vec2 segment = to - from;
            const glm::vec2 edge = m_edges[i].to - m_edges[i].from;
            const float area = crossed(segment, edge);
            if (std::abs(area) < 1e-12F)
                continue;
            const glm::vec2 apart = m_edges[i].from - from;
            const float along = crossed(apart, edge) / area;
            const float alongEdge = crossed(apart, segment) / area;
            if (along >= 0.0F && along <= 1.0F && alongEdge >= 0.0F && alongEdge <= 1.0F)
                met = std::min(met.value_or(along), along);
        }
    }
    return met;
}

bool LineRows::contains(glm::vec2 point) const
{
    const auto [first, end] = rowsOf(point.y, point.y);
    bool inside = false;
    for (std::size_t row = first; row < end; ++row) {
        for (const std::uint32_t i : m_rows[row].edges) {
            const Edge& edge = m_edges[i];
            if ((edge.from.y > point.y) == (edge.to.y > point.y))
                continue;
            const float x =
                edge.from.x + (edge.to.x - edge.from.x) * ((point.y - edge.from.y) / (edge.to.y - edge.from.y));
            if (x > point.x)
                inside = !inside;
        }
    }
    return inside;
}

} // namespace hairpaint::view
