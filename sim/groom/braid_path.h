// The rest shape of a braided hair: over the scalp to its braid's centre, then along the centre's skeleton.
#pragma once

#include "sim/groom/braid_row.h"
#include "sim/groom/rest_shape.h"
#include "sim/groom/strand_style.h"

#include <span>

namespace hairpaint::sim {

/// Of styles alone, beside those that are painted: the rope of a bun, wound about its tie.
inline constexpr BraidKind kCoilKind{8};

/// The node that stands on the centre's root: the first quarter of the skeleton gathers, the rest is the braid. The
/// same for all hairs, so that those of a braid share its nodes.
[[nodiscard]] int gatheringNode(int nodes);

/// Fills the nodes: evenly over the scalp from the root to a point `aboveM` over the centre's root, from there evenly
/// along `centreLengthM` of its normal. Returns the length of the part on the scalp, m.
[[nodiscard]] float braidRest(const RootFrame& root, const RootFrame& centre, float aboveM, float centreLengthM,
                              std::span<glm::vec3> nodesHd);

/// The same of a hair of a cornrow: it joins that a little further on, and then keeps over the skin to its end and
/// straight on.
struct CornrowJoin
{
    float scalpM = 0.0F;  ///< To where it joins,
    float beforeM = 0.0F; ///< of the row before that,
    float lengthM = 0.0F; ///< and from there to the tip.
    float end = 0.0F;     ///< Fraction of the skeleton at the row's end.
};
/// How far over the skin the middle of a cornrow runs, in its radii: its wisps reach 1.6 up and down.
inline constexpr float kCornrowAboveRadii = 1.2F;
[[nodiscard]] CornrowJoin cornrowRest(glm::vec3 rootHd, const BraidRow& row, float radiusM, float tailM,
                                      std::span<glm::vec3> nodesHd);

/// Of a kind: see BraidLacing.
[[nodiscard]] std::uint32_t wispCount(BraidKind kind);

/// Equation 3's radius r, m: the group's; that of a short braid is smaller.
[[nodiscard]] float braidRadiusM(const GroupSettings& settings, float lengthM);
/// Half the thickness of a braid, m: how far its hairs are from its skeleton at most.
[[nodiscard]] float braidGirthM(BraidKind kind, float radiusM);
/// How far over the skin a braid begins, so that it is clear of it there, m.
[[nodiscard]] float braidBeginsAboveM(BraidKind kind, float radiusM);

/// What a braid is to its hairs, m.
struct BraidMeasures
{
    float scalpM = 0.0F; ///< Of the hair's own path to it,
    float lengthM = 0.0F;
    float radiusM = 0.0F; ///< r of equation 3.
};
/// Where a hair of a braid runs in its wisp: also by its frizz.
void placeInWisp(const GroupSettings& settings, const WispChance& chance, StrandStyle& style);
/// Makes a style that of a hair in a braid.
void applyBraid(const GroupSettings& settings, BraidKind kind, const WispChance& chance, const BraidMeasures& measures,
                StrandStyle& style);

} // namespace hairpaint::sim
