// The short tapered hair that shows a direction, on the paper and on the head.
#pragma once

#include <QPainter>
#include <QPointF>

#include <array>

namespace hairpaint::view {

/// Root, middle and tip, px.
using HairSpine = std::array<QPointF, 3>;

inline constexpr double kTaperedHairPx = 19.0; ///< Length of a hair that lies flat.

/// A point at its tip, with a dark edge, so that it is seen on every colour; a dot where it is too short to be a hair.
/// The painter's pen must be Qt::NoPen.
void drawTaperedHair(QPainter& painter, const HairSpine& spine);

} // namespace hairpaint::view
