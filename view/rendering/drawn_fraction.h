// How many of a group's hairs are drawn, as wider ones, where all could not be told apart.
#pragma once

#include "sim/groom/groom.h"
#include "view/rendering/frame_constants.h"

namespace hairpaint::rendering {

inline constexpr float kFadingPart = 0.15F; ///< Hairs that thin out instead of vanishing, over those drawn whole.

/// Width of a group's hairs where the hair is nearest, samples.
[[nodiscard]] float hairWidthSp(const sim::StrandMaterial& material, const FrameConstants& constants);
/// The fraction of hairs of that width that are wide enough to be told apart, each on its own.
[[nodiscard]] float fractionThatTells(float widthSp);
/// At least `fraction` and those that fade, in steps, so that lists are not made anew whenever the camera moves a
/// little.
[[nodiscard]] float listedDetail(float fraction);
/// Samples that a metre covers where the hair is nearest.
[[nodiscard]] float samplesPerM(const FrameConstants& constants);

/// Number of a group's hairs that are enough to fill the opacity grids: the nearer the eye, the more, since the voxels
/// are the smaller. `fine`: a picture to be kept.
[[nodiscard]] std::size_t hairsForGrids(const FrameConstants& constants, bool fine);

/// How far a drawn curve may lie beside the true one: in pictures at rest, whose samples are half as wide as pixels,
/// and in moving ones.
inline constexpr float kFineToleranceSp = 0.4F;
inline constexpr float kMovingToleranceSp = 0.5F;

/// How what lies behind other hair is drawn.
struct DepthOfCoat
{
    float undrawnCoverings; ///< Coverings of hair in front from which on nothing is drawn.
    /// Those must lie in each column of the grid around a point, not only interpolated between them: hair that looks
    /// out beside a dense lock is drawn. A seventh slower.
    bool inEveryColumn;
    float widest;        ///< Greatest width of hidden hair where fewer strands stand for more, samples.
    float leastFraction; ///< Least fraction of hidden hair that is drawn.
};
/// Fraction of the drawn hairs, themselves `fraction` of all, that is left where others hide them by half and more.
[[nodiscard]] float deepFraction(const DepthOfCoat& depth, float widthSp, float fraction);

} // namespace hairpaint::rendering
