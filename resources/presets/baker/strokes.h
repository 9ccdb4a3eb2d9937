// Strokes that several styles have in common.
#pragma once

#include "recording.h"

#include <vector>

namespace hairpaint::presets {

/// Entries of the braid map's palette.
inline constexpr int kPlait = 1;
inline constexpr int kLoc = 3;
inline constexpr int kFishtail = 6;
inline constexpr int kCornrow = 7;
/// Entries of the accessory map's palette.
inline constexpr int kPonytail = 1;
inline constexpr int kBun = 2;

/// From a value toward another, a step apart.
[[nodiscard]] std::vector<float> evenly(float from, float to, float step);

/// All around the head along its ridge, from the front over its left back to the front.
[[nodiscard]] Recording::Points aroundTop(const Recording& user);
/// Around the hair of the head's left, a few mm out, but for a parting of that half width.
[[nodiscard]] Recording::Points aroundLeft(const Recording& user, float fromMiddleM);
/// Regions reach out over both sides' hairlines, so that no hair there hangs loose.
void outToHairline(Recording& user, MapKind map, const PaintValue& value);
/// From the forehead over the head and down its back.
[[nodiscard]] Recording::Points overMiddle(const Recording& user);
/// No hair along it, of that width: hair between two regions would hang loose. Down the back is its lower half, where
/// the layout has a seam, which regions keep up to a texel away from.
void shaveMiddle(Recording& user, float widthM);
void shaveDownTheBack(Recording& user);

/// Cuts hair so that it ends at a height when it falls down the sides of the head, but for what is longer than it may
/// or shorter than it can be.
void cutToLine(Recording& user, float lineHeightM, float shortestM);
/// The back above its ridge, cut ever longer up to the crown, so that it ends in a soft line above the nape.
void taperBack(Recording& user, float ridgeM, float crownM);
/// Scissors over the comb: `ridgeM` where clippers stop, ever longer up to the crown.
void graduate(Recording& user, float ridgeM, float crownM);
/// Clippers from the nape and the ears up.
void fade(Recording& user, float lowestM, float ridgeM);
/// Hair at the front, over the forehead.
void front(Recording& user, MapKind map, const PaintValue& value, float sizeM);
/// Over the middle, from the forehead to behind the crown.
void partInTheMiddle(Recording& user, const Parting& parting);

/// Hair at the forehead off the face and over the ears.
void combOffFace(Recording& user);
/// From the corners of the forehead down before the ears.
void combBeforeEars(Recording& user);

/// A fringe, combed over the forehead and cut there.
struct Fringe
{
    float lengthM = 0.055F; ///< Length of the hair at the hairline.
    float depthM = 0.035F;  ///< Depth of the fringe from there back.
    float halfM = 0.036F;   ///< Half its width.
    float longerM = 0.0F;   ///< How much longer the hair at its sides is.
    float flatness = 0.85F;
};
void cutFringe(Recording& user, const Fringe& fringe);

} // namespace hairpaint::presets
