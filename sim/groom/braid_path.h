// The rest shape of a braided hair: over the scalp to its braid's centre, then along the centre's skeleton.
#pragma once

#include "sim/groom/braid_row.h"
#include "sim/groom/rest_shape.h"
#include "sim/groom/strand_style.h"

#include <span>

namespace hairpaint::sim {

/// The rope of a bun, wound about its tie: a kind that only styles have, no map.
inline constexpr BraidKind kCoilKind{8};

/// The node that stands on the centre's root: the first quarter of the skeleton gathers, the rest is the braid. The
/// same for all hairs, so that those of a braid share its nodes.
[[nodiscard]] int gatheringNode(int nodes);

/// Fills the nodes: evenly over the scalp from the root to a point `aboveM` over the centre's root, from there evenly
/// along `centreLengthM` of its normal. Returns the length of the part on the scalp, m.
[[nodiscard]] float braidRest(const RootFrame& root, const RootFrame& centre, float aboveM, float centreLengthM,
                              std::span<glm::vec3> nodesHd);

/// The path of a hair in a cornrow: it joins the row a little further on, the further the further away it grows,
/// follows it over the skin to the row's end and goes straight on from there. A tail of less than kLongestTuckedM stays
/// on the skin and slants under what lies there; a longer one is free.
struct CornrowJoin
{
    float scalpM = 0.0F;  ///< Length from the root to where it joins the row.
    float beforeM = 0.0F; ///< Length of the row before that point.
    float lengthM = 0.0F; ///< Length from that point to the tip.
    float start = 0.0F;   ///< Fraction of the skeleton where it joins the row,
    float end = 0.0F;     ///< and where it leaves the skin.
};
/// How far over the skin the middle of a cornrow runs, in its radii: its wisps reach 1.6 up and down.
inline constexpr float kCornrowAboveRadii = 1.2F;
inline constexpr float kLongestTuckedM = 0.03F;
[[nodiscard]] CornrowJoin cornrowRest(const RootFrame& root, const BraidRow& row, float radiusM, float tailM,
                                      std::span<glm::vec3> nodesHd);

/// Number of wisps of a kind: see BraidLacing.
[[nodiscard]] std::uint32_t wispCount(BraidKind kind);

/// Equation 3's radius r, m: the group's, but at most a quarter of the braid's length.
[[nodiscard]] float braidRadiusM(const GroupSettings& settings, float lengthM);
/// Half the thickness of a braid, m: how far its hairs are from its skeleton at most.
[[nodiscard]] float braidGirthM(BraidKind kind, float radiusM);
/// How far over the skin a braid begins, so that it is clear of it there, m.
[[nodiscard]] float braidBeginsAboveM(BraidKind kind, float radiusM);

/// Lengths of a braid and of a hair's path to it, m.
struct BraidMeasures
{
    float scalpM = 0.0F; ///< Length of the hair's own path over the scalp to the braid.
    float lengthM = 0.0F;
    float radiusM = 0.0F; ///< r of equation 3.
};
/// Sets where a hair of a braid runs in its wisp, which also depends on its frizz.
void placeInWisp(const GroupSettings& settings, const WispChance& chance, StrandStyle& style);
/// Makes a style that of a hair in a braid.
void applyBraid(const GroupSettings& settings, BraidKind kind, const WispChance& chance, const BraidMeasures& measures,
                StrandStyle& style);

} // namespace hairpaint::sim
