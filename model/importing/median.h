// The middle one of some values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hairpaint::model {

/// The median of at least one value; for an even number the upper of the two in the middle. Reorders `values`.
[[nodiscard]] inline float medianOf(std::vector<float>& values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

} // namespace hairpaint::model
