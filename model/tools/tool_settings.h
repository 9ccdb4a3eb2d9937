// The settings that tools share: what is painted and how large, hard and strong the brush is.
#pragma once

#include "model/project/map_spec.h"

#include <array>

namespace hairpaint::model {

enum class ShapeKind : std::uint8_t
{
    Rectangle,
    Ellipse,
    Polygon
};
/// What a stroke of the comb does to hair.
enum class CombKind : std::uint8_t
{
    Lay,    ///< Lays hair along the stroke.
    Lift,   ///< Raises or lowers hair in the direction in which it lies.
    Smooth, ///< Lays hair as its neighbours lie.
    Noise,
    Whorl, ///< Lays hair in a spiral around the pointer.
    Hold   ///< Keeps hair as it lies now, with gel.
};
/// What fingers do to hair.
enum class FingerKind : std::uint8_t
{
    Puff,   ///< Lift it off the skin.
    Pinch,  ///< Gather it to the middle of the stroke.
    Spread, ///< Part it from each other, away from the middle.
    Smooth  ///< Even it out.
};
/// What grabbing takes hold of.
enum class GrabKind : std::uint8_t
{
    Hair,
    Guides ///< Single hairs, bent node by node; those around follow.
};
/// What the scissors follow.
enum class CutKind : std::uint8_t
{
    Line,
    Freehand,
    Lasso
};
/// What a brush over the 3D area works on.
enum class TouchKind : std::uint8_t
{
    Seen, ///< The skin where it, or hair about its own root, is seen; strands where they hang over other skin, or none.
    Skin,
    Hair
};
enum class GradientKind : std::uint8_t
{
    Linear,
    Radial
};

/// What maps are painted with at first: half of the length's range, a plait, chestnut, ...; and the ones that X swaps
/// in.
[[nodiscard]] std::array<PaintValue, kMapKindCount> firstPaintValues();
[[nodiscard]] std::array<PaintValue, kMapKindCount> secondPaintValues();

/// The ranges and the values of new settings are in the tools' rows (ToolOption).
struct ToolSettings
{
    ToolSettings(); ///< Sets all values as the rows have them.

    float brushSizeM = 0.0F; ///< Diameter on the skin.
    float hardness = 0.0F;
    float opacity = 0.0F; ///< Opacity of the whole stroke, 0..1.
    bool pressureSize = false;
    bool pressureOpacity = false;
    float fillTolerance = 0.0F;
    ShapeKind shape{};
    GradientKind gradient{};
    CombKind comb{};
    TouchKind touch{};
    float flatness = 0.0F;    ///< Flatness of combed hair: at 0 it stands upright, at 1 it lies flat.
    float partReachM = 0.0F;  ///< Reach to either side of a parting.
    float partGapM = 0.0F;    ///< The width in which a parting has no hair.
    float partZigzagM = 0.0F; ///< How far it leaves its curve.
    float holdGel = 0.0F;     ///< Least gel of hair that the comb holds, 0..1.
    float grabGel = 0.0F;     ///< Gel of hair that was grabbed, 0..1.
    FingerKind fingers{};
    float fingerStrength = 0.0F; ///< Strength of a stroke of the fingers, 0..1.
    GrabKind grab{};
    float lift = 0.0F; ///< How far the comb raises hair: at 1 upright, at 0 as it lies, at -1 flat.
    CutKind cut{};
    bool cutThrough = false;  ///< Cut what the head hides, too.
    float cutFraction = 0.0F; ///< Fraction of the crossed hairs that is cut.
    float cutRaggedM = 0.0F;  ///< Greatest distance of a hair's cut from the line.
    std::array<PaintValue, kMapKindCount> values = firstPaintValues(); ///< What each map is painted with.
    std::array<PaintValue, kMapKindCount> secondValues =
        secondPaintValues(); ///< What X swaps in; the far end of gradients.
    [[nodiscard]] PaintValue& value(MapKind map) { return values[static_cast<std::size_t>(map)]; }
    [[nodiscard]] PaintValue& secondValue(MapKind map) { return secondValues[static_cast<std::size_t>(map)]; }
    [[nodiscard]] const PaintValue& value(MapKind map) const { return values[static_cast<std::size_t>(map)]; }
    [[nodiscard]] const PaintValue& secondValue(MapKind map) const
    {
        return secondValues[static_cast<std::size_t>(map)];
    }
    friend bool operator==(const ToolSettings&, const ToolSettings&) = default;
};

} // namespace hairpaint::model
