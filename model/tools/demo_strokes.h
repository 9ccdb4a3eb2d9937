// What the window shows of tools that words do not explain: one stroke over rows of hairs seen from the side.
#pragma once

#include <QPointF>
#include <QRectF>

#include <numbers>

namespace hairpaint::model {

/// A hair from its root on, px: where it points and how long it is.
struct DemoHair
{
    static constexpr double kUpright = -std::numbers::pi / 2.0;
    static constexpr double kLengthPx = 17.0;
    double angle = kUpright; ///< Radians from the right, downwards.
    double lengthPx = kLengthPx;
};

/// One hair's root at one moment of the stroke. Positions in px of the picture.
struct DemoMoment
{
    static constexpr int kColumns = 15;
    static constexpr double kRingPx = 15.0; ///< Radius of the pointer's ring.
    QRectF area;                            ///< The area that the roots cover.
    double done = 0.0;                      ///< Fraction of the stroke that is done, 0..1.
    QPointF start;                          ///< Where the stroke began.
    QPointF pointer;
    int column = 0; ///< Column of the root from the left, below kColumns.
    int row = 0;    ///< Row of the root from the top.
    QPointF root;
};

/// A tool's demonstration stroke (ToolTraits::demo).
struct DemoStroke
{
    QPointF from{0.02, 0.55}; ///< Start of the stroke, as fractions of the area; `to`: its end.
    QPointF to{1.0, 0.55};
    bool drawsLine = false; ///< From `from` to the pointer, instead of a ring.
    DemoHair (*hair)(const DemoMoment& moment) = nullptr;
};

extern const DemoStroke kCombDemo;
extern const DemoStroke kPartDemo;
extern const DemoStroke kGrabDemo;
extern const DemoStroke kFingersDemo;
extern const DemoStroke kScissorsDemo;
extern const DemoStroke kGradientDemo;

} // namespace hairpaint::model
