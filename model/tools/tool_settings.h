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
    Lay,    ///< Lays it along the stroke.
    Lift,   ///< Raises it, or lowers it, in the direction in which it lies.
    Smooth, ///< As its neighbours lie.
    Noise,
    Whorl, ///< Lays it in a spiral around the pointer.
    Hold   ///< As it lies now, with gel.
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

/// What D sets the values of all maps to: 15 of 30 cm, a plait, chestnut, ...; and the ones that X swaps in.
[[nodiscard]] std::array<PaintValue, kMapKindCount> firstPaintValues();
[[nodiscard]] std::array<PaintValue, kMapKindCount> secondPaintValues();

/// Ranges, and what new ones have, are in the rows of the tools (ToolOption).
struct ToolSettings
{
    ToolSettings(); ///< As the rows have it.

    float brushSizeM = 0.0F; ///< Diameter on the skin.
    float hardness = 0.0F;
    float opacity = 0.0F; ///< Of the whole stroke.
    bool pressureSize = false;
    bool pressureOpacity = false;
    float fillTolerance = 0.0F;
    ShapeKind shape{};
    GradientKind gradient{};
    CombKind comb{};
    TouchKind touch{};
    float flatness = 0.0F;    ///< Of combed hair: 0 stands upright, 1 lies flat.
    float partReachM = 0.0F;  ///< To either side of a parting.
    float partGapM = 0.0F;    ///< The width in which a parting has no hair.
    float partZigzagM = 0.0F; ///< How far it leaves its curve.
    float holdGel = 0.0F;     ///< Hair that is held as it lies gets at least so much gel,
    float grabGel = 0.0F;     ///< and hair that is pulled so much.
    FingerKind fingers{};
    float fingerStrength = 0.0F; ///< Of what a stroke could do.
    GrabKind grab{};
    float lift = 0.0F; ///< From hair as it lies to upright, or to flat below 0.
    CutKind cut{};
    bool cutThrough = false;                                           ///< Cut what the head hides, too.
    float cutFraction = 0.0F;                                          ///< Of the hairs that are crossed.
    float cutRaggedM = 0.0F;                                           ///< How far from the line each of them is cut.
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
