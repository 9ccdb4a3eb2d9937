// Amounts taken from and put on a group's range.
#include "model/tools/value_amounts.h"

#include <cmath>
#include <utility>

namespace hairpaint::model {

ValueAmounts::Amount ValueAmounts::amountOf(const MapSpec& spec, const sim::GroupSettings& group,
                                            const PaintValue& value)
{
    return {.number = spec.scale->amount(group, static_cast<double>(value.scalar)),
            .unit = spec.scale->common == nullptr ? spec.scale->unit(group) : QString()};
}

bool ValueAmounts::follow(const MapSpec& spec, const sim::GroupSettings& group, const Amount& amount, float& scalar)
{
    constexpr double kRounding = 1e-6; // There and back again is no change.
    if (spec.scale->common == nullptr && spec.scale->unit(group) != amount.unit)
        return true;
    const double fraction = spec.scale->fraction(group, amount.number);
    if (std::abs(fraction - static_cast<double>(scalar)) > kRounding)
        scalar = static_cast<float>(fraction);
    return std::abs(spec.scale->amount(group, fraction) - amount.number) <= kRounding * (1.0 + std::abs(amount.number));
}

void ValueAmounts::take(const sim::GroupSettings& group, const ToolSettings& settings)
{
    for (const MapSpec& spec : mapSpecs())
        if (spec.scale != nullptr)
            m_pairs.at(static_cast<std::size_t>(spec.kind)) = {amountOf(spec, group, settings.value(spec.kind)),
                                                               amountOf(spec, group, settings.secondValue(spec.kind))};
}

void ValueAmounts::takeChanges(const sim::GroupSettings& group, const ToolSettings& before,
                               const ToolSettings& settings)
{
    for (const MapSpec& spec : mapSpecs()) {
        if (spec.scale == nullptr)
            continue;
        const PaintValue& first = settings.value(spec.kind);
        const PaintValue& second = settings.secondValue(spec.kind);
        const float firstBefore = before.value(spec.kind).scalar;
        const float secondBefore = before.secondValue(spec.kind).scalar;
        Pair& pair = m_pairs.at(static_cast<std::size_t>(spec.kind));
        if (first.scalar == secondBefore && second.scalar == firstBefore && first.scalar != second.scalar) {
            std::swap(pair.first, pair.second); // Those beyond the range too.
            continue;
        }
        if (first.scalar != firstBefore)
            pair.first = amountOf(spec, group, first);
        if (second.scalar != secondBefore)
            pair.second = amountOf(spec, group, second);
    }
}

std::vector<MapKind> ValueAmounts::putOn(const sim::GroupSettings& group, ToolSettings& settings) const
{
    std::vector<MapKind> beyond;
    for (const MapSpec& spec : mapSpecs()) {
        if (spec.scale == nullptr)
            continue;
        const Pair& pair = m_pairs.at(static_cast<std::size_t>(spec.kind));
        if (!follow(spec, group, pair.first, settings.value(spec.kind).scalar))
            beyond.push_back(spec.kind);
        follow(spec, group, pair.second, settings.secondValue(spec.kind).scalar);
    }
    return beyond;
}

} // namespace hairpaint::model
