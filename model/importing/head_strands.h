// Foreign strands as they stand on a head, in the terms of its maps.
#pragma once

#include "model/importing/foreign_curves.h"
#include "model/importing/strand_shape.h"
#include "model/values/progress.h"
#include "sim/groom/groom.h"
#include "sim/skin/distance_grid.h"
#include "sim/skin/skin.h"

#include <optional>
#include <vector>

namespace hairpaint::model {

/// What brings a file's points to the head: positionHd = rotated(point) * scaleM + offsetHd.
struct CurveTransform
{
    glm::mat3 rotation{1.0F};
    float scaleM = 1.0F; ///< Metres per unit of the file.
    glm::vec3 offsetHd{0.0F};

    [[nodiscard]] glm::vec3 toHd(const glm::vec3& point) const { return rotation * point * scaleM + offsetHd; }
};

/// How hair runs over a point of the skin.
struct SkinDirection
{
    glm::vec3 positionHd{0.0F};
    glm::vec3 normalHd{0.0F};
    glm::vec3 directionHd{0.0F}; ///< Unit.
};

struct HeadStrand
{
    SkinDirection root; ///< The root; its direction is that to the point 2 cm along, or a third along short hair.
    StrandShape shape;
    std::uint32_t points = 2;                    ///< Number of points that the file gives it.
    StrandLook look;                             ///< Widths in m.
    float held = 0.0F;                           ///< 0..1: how much it stands where gravity would lay it down.
    std::uint32_t source = 0;                    ///< Its number in the file's group.
    sim::BraidKind braid = sim::BraidKind::None; ///< The braid that it belongs to; its length is then the braid's.
};

struct HeadStrands
{
    std::vector<HeadStrand> strands;
    std::vector<SkinDirection> further; ///< How some of them lie on the skin further along their length.
    /// Median height over the skin at which strands begin to lie, m; 0 where none does.
    float heightM = 0.0F;
    float braidRadiusM = 0.0F;  ///< Median radius of the braids; 0 without braids.
    float braidSpacingM = 0.0F; ///< Distance between braids, as in GroupSettings::braidSpacingM.
    /// Distance between patches of roots, where each braid has a patch of its own, m; 0 where patches are not apart.
    float braidGapM = 0.0F;
};

/// Strands whose roots are further from the skin than `kFurthestRootM`, or that have no length, are left out. None
/// where `progress` cancels. `distances` of that skin may be null. Uses parallelFor.
inline constexpr float kFurthestRootM = 0.03F;
[[nodiscard]] std::optional<HeadStrands> strandsOnHead(const ForeignStrands& strands, const CurveTransform& transform,
                                                       const sim::Skin& skin, const sim::DistanceGrid* distances,
                                                       const Progress& progress = {});

} // namespace hairpaint::model
