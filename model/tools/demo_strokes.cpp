// What each stroke does to a hair, by when the pointer passes its root.
#include "model/tools/demo_strokes.h"

#include <QLineF>

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

/// As hair that nobody has combed: the same at every time.
double unruly(int column, int row)
{
    return DemoHair::kUpright + 0.9 * std::sin(12.9 * column + 7.3 * row);
}

double mixed(double from, double to, double fraction)
{
    return from + (to - from) * std::clamp(fraction, 0.0, 1.0);
}

/// How far a pointer that goes to the right has passed the root.
double passed(const DemoMoment& moment)
{
    return (moment.pointer.x() - moment.root.x()) / DemoMoment::kRingPx;
}

DemoHair combed(const DemoMoment& moment)
{
    constexpr double kLaid = -0.25;
    return {.angle = mixed(unruly(moment.column, moment.row), kLaid, passed(moment))};
}

DemoHair parted(const DemoMoment& moment)
{
    constexpr double kFallen = 1.25;
    constexpr double kReach = 0.4; // How far hair on either side falls, as a fraction of the area's width.
    const int fromMiddle = 2 * moment.column - (DemoMoment::kColumns - 1);
    const double side = fromMiddle < 0 ? -1.0 : fromMiddle > 0 ? 1.0 : 0.0;
    const double near = 1.0 - std::abs(moment.root.x() - moment.area.center().x()) / (kReach * moment.area.width());
    const double opened = std::clamp((moment.pointer.y() - moment.root.y()) / DemoMoment::kRingPx + 1.0, 0.0, 1.0);
    return {.angle = DemoHair::kUpright + side * kFallen * opened * std::clamp(near * 2.0, 0.0, 1.0),
            .lengthPx = side == 0.0 ? DemoHair::kLengthPx * (1.0 - opened) : DemoHair::kLengthPx};
}

DemoHair grabbed(const DemoMoment& moment)
{
    constexpr double kHand = 1.6; // Rings.
    const double apart = QLineF(moment.root, moment.start).length() / (kHand * DemoMoment::kRingPx);
    const double held = std::clamp(kHand - apart, 0.0, 1.0);
    const QPointF toTip = QPointF(0.0, -DemoHair::kLengthPx) + (moment.pointer - moment.start) * held;
    return {.angle = std::atan2(toTip.y(), toTip.x())};
}

DemoHair puffed(const DemoMoment& moment)
{
    constexpr double kLying = -0.3;
    constexpr double kPuffed = -1.1;
    return {.angle = mixed(kLying, kPuffed, passed(moment))};
}

DemoHair cut(const DemoMoment& moment)
{
    constexpr double kCut = 0.5;
    return {.lengthPx = passed(moment) > 0.0 ? DemoHair::kLengthPx * kCut : DemoHair::kLengthPx};
}

DemoHair graded(const DemoMoment& moment)
{
    constexpr double kShortestPx = 3.0;
    const double along = (moment.root.x() - moment.area.left()) / moment.area.width();
    return {.lengthPx = moment.done < 1.0 ? DemoHair::kLengthPx : mixed(kShortestPx, 1.5 * DemoHair::kLengthPx, along)};
}

} // namespace

const DemoStroke kCombDemo{.hair = combed};
const DemoStroke kPartDemo{.from = {0.5, 0.05}, .to = {0.5, 1.0}, .drawsLine = true, .hair = parted};
const DemoStroke kGrabDemo{.from = {0.35, 0.45}, .to = {0.62, 0.3}, .hair = grabbed};
const DemoStroke kFingersDemo{.hair = puffed};
const DemoStroke kScissorsDemo{.hair = cut};
const DemoStroke kGradientDemo{.drawsLine = true, .hair = graded};

} // namespace hairpaint::model
