// A line or an outline over the 3D area's picture, as strands meet it.
#pragma once

#include "view/picking/hair_boxes.h"

#include <QPointF>

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace hairpaint::view {

/// Its edges are found by rows of the picture, so that a long freehand line costs little more than a straight one.
class LineRows
{
public:
    LineRows(std::span<const QPointF> points, bool closed);

    [[nodiscard]] const PictureBox& box() const { return m_box; } ///< Box around the whole line.
    [[nodiscard]] bool mayMeet(const PictureBox& box) const;
    /// Where a segment first meets it, 0..1 along the segment.
    [[nodiscard]] std::optional<float> firstMeeting(glm::vec2 from, glm::vec2 to) const;
    /// Whether a closed line contains a point, by the even-odd rule.
    [[nodiscard]] bool contains(glm::vec2 point) const;

private:
    struct Edge
    {
        glm::vec2 from, to;
    };
    struct Row
    {
        float left = 1e9F, right = -1e9F;
        std::vector<std::uint32_t> edges = {};
    };
    /// First row, and the one behind the last.
    [[nodiscard]] std::pair<std::size_t, std::size_t> rowsOf(float top, float bottom) const;

    std::vector<Edge> m_edges;
    std::vector<Row> m_rows;
    PictureBox m_box;
};

} // namespace hairpaint::view
