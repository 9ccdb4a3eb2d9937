// Where the curves of a file stand on a head.
#pragma once

#include "model/importing/head_strands.h"

#include <optional>

namespace hairpaint::model {

/// What the user says of a file's space, above what the file says.
struct CurveSpaceChoice
{
    std::optional<float> metresPerUnit;
    std::optional<UpAxis> upAxis;
};

/// The unit and axes as they are told. Where nothing is, or roots so positioned are not on this head, the likeliest: of
/// usual units and both axes those that bring the roots to the skin, else turned, scaled and moved so that they fit.
/// Both may disagree, as another program's head does with this one. None where nothing does. About 0.2 s.
[[nodiscard]] std::optional<CurveTransform> fitCurves(const ForeignCurves& curves, const CurveSpaceChoice& choice,
                                                      const sim::Skin& skin);

/// Some programs store strands tip first: turns all round where their last points lie on the skin, and the first ones
/// clearly do not, in the unit and axes that are told or else in usual ones. About 0.2 s.
void turnTipFirst(ForeignCurves& curves, const CurveSpaceChoice& choice, const sim::Skin& skin);

/// How curves would lie on a head.
struct CurvePlacement
{
    CurveTransform transform;
    bool fits = false;      ///< Whether they would be taken so; else `transform` is what is told, in metres and y up.
    float rootsOffM = 0.0F; ///< Median distance of their roots from the skin.
};

/// At most some hundred strands, evenly taken, to look at and to be positioned quickly.
[[nodiscard]] ForeignCurves sampledCurves(const ForeignCurves& curves);
/// Up to 0.2 s for sampled curves of which nothing is told.
[[nodiscard]] CurvePlacement placementOf(const ForeignCurves& curves, const CurveSpaceChoice& choice,
                                         const sim::Skin& skin);

} // namespace hairpaint::model
