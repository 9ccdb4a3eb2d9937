// Units of length and axes of other programs, for dialogs that ask for them.
#pragma once

#include "model/project/project.h"

#include <QCoreApplication>
#include <QString>

#include <array>

namespace hairpaint::view {

struct LengthUnit
{
    const char* title;
    double metres;
};

inline constexpr std::array kLengthUnits{
    LengthUnit{QT_TRANSLATE_NOOP("LengthUnits", "Millimetres"), 0.001},
    LengthUnit{QT_TRANSLATE_NOOP("LengthUnits", "Centimetres"), 0.01},
    LengthUnit{QT_TRANSLATE_NOOP("LengthUnits", "Inches"), 0.0254},
    LengthUnit{QT_TRANSLATE_NOOP("LengthUnits", "Decimetres"), 0.1},
    LengthUnit{QT_TRANSLATE_NOOP("LengthUnits", "Metres"), 1.0},
};

[[nodiscard]] inline QString titleOf(const LengthUnit& unit)
{
    return QCoreApplication::translate("LengthUnits", unit.title);
}

[[nodiscard]] inline QString titleOf(model::UpAxis axis)
{
    return axis == model::UpAxis::Y ? QCoreApplication::translate("LengthUnits", "Y (glTF, Maya)")
                                    : QCoreApplication::translate("LengthUnits", "Z (Blender, 3ds Max)");
}

} // namespace hairpaint::view
