// Rows read and written alike, whatever they set.
#include "model/tools/tool_options.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

double ToolNumber::shownPerSi() const
{
    switch (unit) {
    case Unit::Percent:
    case Unit::Centimetres:
        return 100.0;
    case Unit::Millimetres:
        return 1000.0;
    }
    return 1.0;
}

QString ToolNumber::unitText() const
{
    switch (unit) {
    case Unit::Percent:
        break;
    case Unit::Centimetres:
        return QCoreApplication::translate("ToolOptions", "cm");
    case Unit::Millimetres:
        return QCoreApplication::translate("ToolOptions", "mm");
    }
    return QStringLiteral("%");
}

double optionOf(const ToolSettings& settings, const ToolOption& option)
{
    if (const auto* number = std::get_if<ToolNumber>(&option.kind))
        return static_cast<double>(settings.*number->field);
    if (const auto* one = std::get_if<ToolSwitch>(&option.kind))
        return settings.*one->field ? 1.0 : 0.0;
    if (const auto* choice = std::get_if<ToolChoice>(&option.kind))
        return choice->read(settings);
    return 0.0;
}

double standardOf(const ToolOption& option)
{
    if (const auto* number = std::get_if<ToolNumber>(&option.kind))
        return number->standard / number->shownPerSi();
    if (const auto* one = std::get_if<ToolSwitch>(&option.kind))
        return one->standard ? 1.0 : 0.0;
    if (const auto* choice = std::get_if<ToolChoice>(&option.kind))
        return choice->standard;
    return 0.0;
}

void putOption(ToolSettings& settings, const ToolOption& option, double value)
{
    if (!std::isfinite(value))
        return;
    if (const auto* number = std::get_if<ToolNumber>(&option.kind)) {
        const double perSi = number->shownPerSi();
        settings.*number->field =
            static_cast<float>(std::clamp(value, number->least / perSi, number->greatest / perSi));
    } else if (const auto* one = std::get_if<ToolSwitch>(&option.kind)) {
        settings.*one->field = value != 0.0;
    } else if (const auto* choice = std::get_if<ToolChoice>(&option.kind)) {
        choice->write(settings,
                      static_cast<int>(std::clamp(value, 0.0, static_cast<double>(choice->entries.size()) - 1.0)));
    }
}

} // namespace hairpaint::model
