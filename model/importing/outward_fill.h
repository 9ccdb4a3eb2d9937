// Values where nobody painted, as those nearest to them have it.
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hairpaint::model {

/// `values`, `known`: [side][side], side a power of two. Where not known a value becomes the mean of known ones around,
/// of more of them the further they are (a pyramid of means: Gortler and others 1996, "pull-push"). Nothing happens
/// where none is known.
template<typename Value>
void fillOutward(std::size_t side, std::vector<Value>& values, const std::vector<std::uint8_t>& known)
{
    if (side == 1)
        return;
    const std::size_t half = side / 2;
    std::vector<Value> coarse(half * half, Value(0.0F));
    std::vector<std::uint8_t> coarseKnown(half * half);
    for (std::size_t y = 0; y < half; ++y)
        for (std::size_t x = 0; x < half; ++x) {
            float count = 0.0F;
            Value& mean = coarse[y * half + x];
            for (const std::size_t child : {2 * y * side + 2 * x, 2 * y * side + 2 * x + 1, (2 * y + 1) * side + 2 * x,
                                            (2 * y + 1) * side + 2 * x + 1})
                if (known[child] != 0) {
                    mean += values[child];
                    count += 1.0F;
                }
            if (count > 0.0F)
                mean /= count;
            coarseKnown[y * half + x] = count > 0.0F ? 1 : 0;
        }
    fillOutward(half, coarse, coarseKnown);
    const auto beside = [half](std::size_t at) {
        // The parent, and the next one on the child's own side.
        const std::size_t parent = at / 2;
        const std::size_t other = at % 2 == 0 ? (parent > 0 ? parent - 1 : 0) : std::min(parent + 1, half - 1);
        return std::pair(parent, other);
    };
    for (std::size_t y = 0; y < side; ++y)
        for (std::size_t x = 0; x < side; ++x) {
            if (known[y * side + x] != 0)
                continue;
            const auto [px, ox] = beside(x);
            const auto [py, oy] = beside(y);
            values[y * side + x] = coarse[py * half + px] * 0.5625F + coarse[py * half + ox] * 0.1875F +
                                   coarse[oy * half + px] * 0.1875F + coarse[oy * half + ox] * 0.0625F;
        }
}

} // namespace hairpaint::model
