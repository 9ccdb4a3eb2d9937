// What one BasisCurves of USD says, and the strands that it makes (openusd.org, "UsdGeomBasisCurves").
#pragma once

#include "model/importing/foreign_curves.h"

#include <QString>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hairpaint::model {

/// A value of curves: one for all, a curve, a point, or an end of a segment.
struct UsdPrimvar
{
    std::vector<float> values;
    std::vector<float> indices; ///< Where there are some: which of the values each one has.
    std::string_view interpolation;
    [[nodiscard]] bool isTold() const { return !values.empty(); }
};

/// What one BasisCurves says.
struct UsdCurves
{
    std::vector<float> counts;
    std::vector<float> points;
    std::map<std::string, UsdPrimvar, std::less<>> primvars; ///< By name, without "primvars:".
    std::string_view wrap = "nonperiodic";
    std::string_view type = "cubic"; ///< Unless told.
    std::string_view basis = "bezier";
    QString groupName;
};

/// A group for each group id; none where its counts do not agree. Strands that are none are kept, for the caller.
[[nodiscard]] std::optional<std::vector<ForeignStrands>> strandsOf(const UsdCurves& curves);

} // namespace hairpaint::model
