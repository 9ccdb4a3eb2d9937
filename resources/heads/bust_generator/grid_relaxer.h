// Evens out a polar grid on the bust's surface, denser where there is detail.
//
// Jacobi steps of a weighted tangential Laplacian, each followed by a projection onto the surface. The weights of the
// two grid directions come from the mean ring radius and spacing, so that the grid keeps its overall layout.
#pragma once

#include "polar_grid.h"

namespace hairpaint::heads {

class GridRelaxer
{
public:
    explicit GridRelaxer(PolarGrid& grid);

    void measureRings();
    // step: the fraction of the distance to the neighbours' mean, 0 to 1.
    void relax(int iterations, float step, const ShapeOptions& options);

private:
    glm::vec3 relaxedPoint(const PolarGrid& old, int ring, int column, float step, const ShapeOptions& options) const;
    void relaxPole(const ShapeOptions& options);
    float density(int ring, int column) const;

    PolarGrid& m_grid;
    std::vector<float> m_density;
    std::vector<float> m_alongRing;  // by ring
    std::vector<float> m_acrossRing; // by ring, for the edges to the ring before
};

// Grid to final size: relaxed without ears, then with the ears grown step by step. 160 columns by 256 rings.
PolarGrid bustGrid();

} // namespace hairpaint::heads
