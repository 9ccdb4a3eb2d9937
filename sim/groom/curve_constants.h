// Numbers of the strand's curve. Shaders have them too: resources/shaders/embed.cmake makes a line of GLSL of each that
// begins with "inline constexpr float".
#pragma once

namespace hairpaint::sim {

/// Fraction of the strand, from the root, over which the curl's radius grows from 0.
inline constexpr float kCurlEaseFraction = 0.25F;
/// A coil in real units grows over so much of the hair, or a quarter of a turn or so many of its radii if that is more:
/// no sooner than the hair has left the skin as far.
inline constexpr float kCoilEaseM = 0.01F;
inline constexpr float kCoilEaseRadii = 6.0F;
/// No hair is straight at its root over more of its length than this.
inline constexpr float kMostStraightFraction = 0.25F;
/// From this length on, weight uncoils a hair as far as its group says; shorter ones in proportion.
inline constexpr float kUncoiledM = 0.25F;
/// How much farther out a hair runs, in radii, in the middle of a turn that it leaps over.
inline constexpr float kSkipLeap = 0.3F;
inline constexpr float kFullTurn = 6.2831853F;
/// Factors that make numbers of their own of a hair's chance and of a lock's phase; the third is the golden section,
/// which spreads the turns that are leapt over evenly.
inline constexpr float kOwnPhaseFactor = 61.7F;
inline constexpr float kOwnSkipFactor = 37.3F;
inline constexpr float kGoldenSection = 0.618034F;
inline constexpr float kHandFactor = 5.77F;
inline constexpr float kSwitchFactor = 2.39F;

/// Part of a turn of the braid over which its wisps part where it begins, and the fraction of r that they begin with:
/// they come to it over the span before, since so many hairs never pass through one point.
inline constexpr float kBraidEaseTurns = 0.5F;
inline constexpr float kBraidFirstFraction = 0.25F;
/// The same of a wisp's radius: there they are one bundle, as thick as its hairs are, and no gap is between them.
inline constexpr float kWispFirstFraction = 0.7F;
/// A plait of three: a wisp's radius in units of r. The middles of its wisps come as near as 1.13 r to each other and
/// the nearest of them is never further than 1.26 r, so wisps touch everywhere and none is in another.
inline constexpr float kWispRadiusFraction = 0.62F;
/// The wisps of a twist run round its middle at this distance and have this radius, in units of r; a loc is one wisp.
inline constexpr float kTwistFraction = 0.6F;
inline constexpr float kTwistWispFraction = 0.65F;
inline constexpr float kLocWispFraction = 0.9F;
/// Flat plaits of more wisps and a fishtail: how far from the middle wisps run along the braid's width and through its
/// thickness, and their radius, in units of r.
inline constexpr float kFourWide = 1.3F;
inline constexpr float kFourThick = 0.75F;
inline constexpr float kFourWisp = 0.43F;
inline constexpr float kFiveWide = 1.5F;
inline constexpr float kFiveThick = 0.75F;
inline constexpr float kFiveWisp = 0.335F;
inline constexpr float kFishtailWisps = 9.0F;
inline constexpr float kFishtailWide = 1.0F;
inline constexpr float kFishtailThick = 0.9F;
inline constexpr float kFishtailWisp = 0.215F;
/// A coil, which a bun is: a rope wound about a dome. Length of the meridian of the dome on which the rope's middle
/// lies, in units of the path's radius at its foot; how far apart turns lie over that, in the rope's radii.
inline constexpr float kCoilMeridian = 1.45F;
inline constexpr float kCoilApart = 1.6F;
/// The dome's height in the same units.
inline constexpr float kCoilHeight = 0.95F;
/// Turns from the axis out to the foot, and the part of its radius that the rope has on the axis.
inline constexpr float kCoilEaseTurns = 0.4F;
inline constexpr float kCoilFirstWisp = 0.6F;
/// Fraction over which it ends in the axis, the part of its radius there, and how far it is tucked in, in its radii.
inline constexpr float kCoilEndFraction = 0.25F;
inline constexpr float kCoilTipWisp = 0.9F;
inline constexpr float kCoilTucked = 0.4F;
/// How far its hairs turn about its middle in a turn of it, in turns.
inline constexpr float kCoilTwist = 0.9F;
/// How far the hairs of a wisp turn about its middle in a turn of the braid, in turns.
inline constexpr float kWispTwist = 0.3F;
/// A wisp's greatest radius along the braid, in turns of it, so that three, or two, of them fill a turn.
inline constexpr float kPlaitRoomTurns = 0.2F;
inline constexpr float kTwistRoomTurns = 0.3F;
/// Last fraction of the braid, a tuft like a paint brush: its wisps become one, which opens over kTuftOpens of it to
/// kTuftWispFraction of their radius and narrows to kTuftTipFraction; each hair ends by chance within the last
/// kTuftUneven of it.
inline constexpr float kTuftFraction = 0.12F;
inline constexpr float kTuftOpens = 0.65F;
inline constexpr float kTuftWispFraction = 1.25F;
inline constexpr float kTuftTipFraction = 0.6F;
inline constexpr float kTuftUneven = 0.6F;
inline constexpr float kOwnEndFactor = 83.9F;
/// Fraction of the braid before the tuft where it is drawn together as by a tie: there the wisps close up to
/// kTieBraidFraction of r, and each to kTieWispFraction of its radius.
inline constexpr float kTieFraction = 0.05F;
inline constexpr float kTieBraidFraction = 0.2F;
inline constexpr float kTieWispFraction = 0.5F;

/// Frizz: a hair strays by no more than this fraction of its length, and once in so many metres and so many times as it
/// strays far, so that its length stays within some per cent of its skeleton's.
inline constexpr float kMostFrizzFraction = 0.1F;
inline constexpr float kFrizzWaveM = 0.015F;
inline constexpr float kFrizzWaveRadii = 10.0F;
/// The finer wave on it, in waves of the first, and its part of the whole.
inline constexpr float kFrizzFiner = 2.3F;
inline constexpr float kFrizzFinePart = 0.4F;

} // namespace hairpaint::sim
