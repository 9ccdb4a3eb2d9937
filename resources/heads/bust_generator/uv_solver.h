// Flattens the bust's left half: the crown stays at the origin, the middle line on u = 0, the rim is free.
//
// Minimises the symmetric Dirichlet energy of the map to a wanted local scale, with an area term on the scalp, by
// projected Newton steps; no step is longer than 0.8 of the distance to the first flipped triangle. Source: Smith and
// Schaefer, Bijective Parameterization with Free Boundaries (2015); Teran et al., Robust Quasistatic Finite Elements
// (2005) for the projection.
#pragma once

#include <vector>

#include "bust_mesh.h"

namespace hairpaint::heads {

// How a triangle should be laid out.
struct UvGoal
{
    double scale;      // uv length per metre, relative to the other triangles'
    double weight;     // per square metre
    double areaWeight; // of the area term, 0 for none
};

struct UvReport
{
    double energy = 0.0;
    double scalpAreaRatio = 0.0;   // greatest over least uv area per square metre on the scalp
    double scalpAreaRatio99 = 0.0; // the same, half a percent of the scalp left out at either end
    double scalpStretch = 0.0;     // worst ratio of the singular values on the scalp
    double scalpStretch99 = 0.0;   // 99 % of the scalp are below
    double scalpFraction = 0.0;    // of the used uv area
};

// Crown at the origin, rings at their mean distance along the skin: no flips, and no good elsewhere.
std::vector<glm::dvec2> polarUvs(const PolarGrid& grid, const HalfMesh& half);

// Overwrites its input. Stops after the iterations or when the energy falls by less than 1e-6 of itself.
double improveUvs(HalfMesh& half, const std::vector<UvGoal>& goals, int iterations);

// The bust's whole layout: goals by region, then rounds that weigh up what is still stretched on the scalp. The result
// fits the square of half width 0.485 around the origin.
UvReport layOutBust(const PolarGrid& grid, HalfMesh& half);

UvReport measured(const HalfMesh& half);

} // namespace hairpaint::heads
