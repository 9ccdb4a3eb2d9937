// Formats a map's value in the group's units.
#pragma once

#include "model/project/project.h"
#include "model/tools/tool_settings.h"

#include <QList>

namespace hairpaint::view {

/// How a scalar map's 0..1 is shown: model::MapScale at a group's settings.
struct ValueUnit
{
    QString unit; ///< "cm", translated.
    double minimum = 0.0;
    double maximum = 1.0;
    int decimals = 0;
};

[[nodiscard]] ValueUnit valueUnit(const sim::GroupSettings& settings, model::MapKind map);
/// From 0..1 to the shown number and back.
[[nodiscard]] double shownValue(const sim::GroupSettings& settings, model::MapKind map, double value);
[[nodiscard]] double mapValue(const sim::GroupSettings& settings, model::MapKind map, double shown);

/// "15 cm", "140 hairs/cm\u00b2", "plait", "#5a3822".
[[nodiscard]] QString valueText(const sim::GroupSettings& settings, const model::MapSpec& spec,
                                const model::PaintValue& value);
/// "0\u201330 cm"; empty for indices and colours.
[[nodiscard]] QString rangeText(const sim::GroupSettings& settings, const model::MapSpec& spec);
/// The colour that shows it.
[[nodiscard]] QColor valueColour(const model::MapSpec& spec, const model::PaintValue& value, bool nightPaper);
/// The value of one resolved texel.
[[nodiscard]] model::PaintValue valueOfTexel(const model::MapSpec& spec, const sim::Texel& texel);
/// The scale that is shown, from 0 to 1 in `steps` colours at even values.
[[nodiscard]] QList<QColor> scaleGradient(const model::MapSpec& spec, bool nightPaper, int steps = 65);

} // namespace hairpaint::view
