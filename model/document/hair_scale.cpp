// The table of what can be scaled.
#include "model/document/hair_scale.h"

#include "model/project/group_schema.h"

#include <QCoreApplication>

#include <algorithm>

namespace hairpaint::model {

namespace {

constexpr double kLeastFactor = 0.1;
constexpr double kGreatestFactor = 10.0;

constexpr HairScale kHairScales[] = {
    {QT_TRANSLATE_NOOP("HairScale", "Length"), {"greatest_length_m", "shortest_length_m"}},
    {QT_TRANSLATE_NOOP("HairScale", "Density"), {"greatest_density_per_m2", nullptr}},
    {QT_TRANSLATE_NOOP("HairScale", "Curl size"), {"greatest_curl_radius_m", nullptr}},
};

} // namespace

QString HairScale::titleText() const
{
    return QCoreApplication::translate("HairScale", title);
}

HairScale::Limits HairScale::limits(const sim::GroupSettings& settings) const
{
    Limits limits{.least = kLeastFactor, .greatest = kGreatestFactor};
    bool isZero = true;
    for (const char* const key : ranges) {
        if (key == nullptr)
            continue;
        const GroupSetting& row = groupSetting(QLatin1StringView(key));
        const double value = row.read(settings);
        if (value <= 0.0)
            continue;
        isZero = false;
        limits.least = std::max(limits.least, row.least / value);
        limits.greatest = std::min(limits.greatest, row.greatest / value);
    }
    return isZero ? Limits{} : limits;
}

void HairScale::apply(sim::GroupSettings& settings, double factor) const
{
    for (const char* const key : ranges) {
        if (key == nullptr)
            continue;
        const GroupSetting& row = groupSetting(QLatin1StringView(key));
        row.write(settings, std::clamp(row.read(settings) * factor, row.least, row.greatest));
    }
}

std::span<const HairScale> hairScales()
{
    return kHairScales;
}

} // namespace hairpaint::model
