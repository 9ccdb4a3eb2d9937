// The edges of the uv layout, the paper's second layer, thinned where they would run together.
#pragma once

#include "sim/skin/head_mesh.h"

#include <QPainter>
#include <QRectF>

#include <array>
#include <vector>

namespace hairpaint::view {

/// Immutable. Making one, with a thinned mesh for every size of the map that needs one, takes some 100 ms for 100,000
/// triangles; any thread. The thinned mesh at spacing d: vertices at least d apart each own the vertices nearest to
/// them along the edges; owners that meet are joined.
class UvWireframe
{
public:
    explicit UvWireframe(const sim::HeadMesh& mesh);

    /// Draws on black in grey: island borders always, edges with about `kSpacingPx` between them, each as bright as
    /// wanted. `visiblePaper` bounds the work. Where lines cross they do not add up.
    void draw(QPainter& painter, const QTransform& paperToWidget, const QRectF& visiblePaper, int edge,
              int border) const;
    /// Edges shown at that size of the map, for tests.
    [[nodiscard]] std::size_t edgeCount(double pxPerPaper) const;

private:
    static constexpr double kSpacingPx = 15.0;
    static constexpr int kLevels = 9; ///< Level k has a spacing of 2^-(k + 2).
    struct Edge
    {
        unsigned a = 0, b = 0;
    };

    [[nodiscard]] bool tooFine(double spacing) const { return m_meanLength <= 0.7 * spacing; }
    [[nodiscard]] const std::vector<Edge>& edgesAt(double pxPerPaper) const;
    /// In which vertices are asked whether they are to own others: borders first, so that the thinned mesh reaches
    /// them, then without pattern.
    [[nodiscard]] std::vector<unsigned> seedOrder() const;
    [[nodiscard]] std::vector<unsigned> owners(double spacing, const std::vector<unsigned>& order) const;
    [[nodiscard]] std::vector<Edge> thinned(double spacing, const std::vector<unsigned>& order) const;
    void drawEdges(QPainter& painter, const std::vector<Edge>& edges, const QTransform& paperToWidget,
                   const QRectF& visiblePaper) const;

    std::vector<QPointF> m_paper; ///< [vertices]
    std::vector<Edge> m_edges;
    std::vector<Edge> m_borders;
    std::vector<bool> m_onBorder;           ///< [vertices]
    std::vector<unsigned> m_neighbourStart; ///< [vertices + 1]
    std::vector<unsigned> m_neighbours;
    double m_meanLength = 0.0;                        ///< Mean length of the edges, in paper units.
    std::array<std::vector<Edge>, kLevels> m_thinned; ///< Empty where the edges themselves are coarse enough.
};

} // namespace hairpaint::view
