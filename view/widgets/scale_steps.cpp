// See the header.
#include "view/widgets/scale_steps.h"

#include "view/look/value_text.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace hairpaint::view {

std::vector<double> roundSteps(const sim::GroupSettings& settings, model::MapKind map)
{
    if (const auto offered = model::mapSpec(map).scale->steps)
        if (const std::span<const double> steps = offered(settings); !steps.empty())
            return {steps.begin(), steps.end()};
    constexpr int kMostSteps = 7;
    const ValueUnit unit = valueUnit(settings, map);
    const double range = unit.maximum - unit.minimum;
    std::vector<double> steps{unit.minimum};
    const double rough = range / (kMostSteps - 1);
    const double power = std::pow(10.0, std::floor(std::log10(std::max(rough, 1e-6))));
    double step = power * 10.0;
    for (const double nice : {1.0, 2.0, 2.5, 5.0}) {
        if (power * nice >= rough * 0.999) {
            step = power * nice;
            break;
        }
    }
    const double first = std::floor(unit.minimum / step) + 1.0;
    const int count = static_cast<int>(std::ceil(unit.maximum / step - 0.4 - first));
    for (int i = 0; i < count; ++i)
        steps.push_back((first + i) * step);
    steps.push_back(unit.maximum);
    return steps;
}

} // namespace hairpaint::view
