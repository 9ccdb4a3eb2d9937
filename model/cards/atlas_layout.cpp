// Shelves: the longest patches first, as many shelves as make texels of the wanted shape, each filled to its end.
#include "model/cards/atlas_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hairpaint::model {

namespace {

constexpr float kTexelLengths = 2.0F;  ///< How much longer than wide a texel is,
constexpr float kLeastPatchPx = 12.0F; ///< unless patches were narrower than that; mean, with the border.

struct Shelf
{
    std::size_t begin = 0; ///< In the order of heights.
    std::size_t end = 0;
    float width = 0.0F; ///< Sum of its patches'.
};

int borderOf(std::size_t patches, int sizePx)
{
    constexpr int kWidest = 4;
    const auto side = static_cast<int>(static_cast<float>(sizePx) / std::sqrt(static_cast<float>(patches)));
    return std::clamp(side / 24, 1, kWidest);
}

/// As many as asked, about equally wide together; fewer where there are fewer patches.
std::vector<Shelf> shelvesOf(std::span<const float> widths, std::size_t count)
{
    const float total = std::accumulate(widths.begin(), widths.end(), 0.0F);
    std::vector<Shelf> shelves;
    float before = 0.0F;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const float reached = before / total * static_cast<float>(count);
        if (shelves.empty() || reached >= static_cast<float>(shelves.size()))
            shelves.push_back({.begin = i, .end = i, .width = 0.0F});
        shelves.back().end = i + 1;
        shelves.back().width += widths[i];
        before += widths[i];
    }
    return shelves;
}

/// Borders of parts of a length, as whole numbers: each at least `least` long.
std::vector<int> edgesOf(std::span<const float> parts, int length, int least)
{
    const float total = std::accumulate(parts.begin(), parts.end(), 0.0F);
    std::vector<int> edges{0};
    edges.reserve(parts.size() + 1);
    float sum = 0.0F;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        sum += parts[i];
        const auto ideal = static_cast<int>(std::lround(static_cast<float>(length) * sum / total));
        const auto left = static_cast<int>(parts.size() - 1 - i);
        const int first = edges.back() + least;
        edges.push_back(std::clamp(ideal, first, std::max(first, length - left * least)));
    }
    return edges;
}

} // namespace

std::vector<AtlasPatch> packedAtlas(std::span<const PatchWish> wishes, int sizePx)
{
    std::vector<AtlasPatch> patches(wishes.size());
    if (wishes.empty())
        return patches;
    std::vector<std::size_t> order(wishes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t i) { return wishes[i].heightM; });
    // Hardly any card is so narrow that it may vanish.
    const float total = std::accumulate(wishes.begin(), wishes.end(), 0.0F,
                                        [](float sum, const PatchWish& wish) { return sum + wish.widthM; });
    const float narrowest = 0.3F * total / static_cast<float>(wishes.size());
    std::vector<float> widths;
    widths.reserve(wishes.size());
    for (const std::size_t i : order)
        widths.push_back(std::max(wishes[i].widthM, narrowest));

    const auto tallestOf = [&](const std::vector<Shelf>& shelves) {
        std::vector<float> heights;
        heights.reserve(shelves.size());
        for (const Shelf& shelf : shelves)
            heights.push_back(wishes[order[shelf.begin]].heightM);
        return heights;
    };
    std::vector<Shelf> shelves = shelvesOf(widths, 1);
    const auto most = std::min<std::size_t>(wishes.size(), static_cast<std::size_t>(sizePx) / 8);
    for (std::size_t count = 1; count <= most; ++count) {
        shelves = shelvesOf(widths, count);
        const std::vector<float> heights = tallestOf(shelves);
        const float height = std::accumulate(heights.begin(), heights.end(), 0.0F);
        const float width = std::accumulate(widths.begin(), widths.end(), 0.0F) / static_cast<float>(shelves.size());
        const auto widthPx = static_cast<float>(sizePx) * static_cast<float>(count) / static_cast<float>(wishes.size());
        if (height >= width * kTexelLengths && widthPx >= kLeastPatchPx)
            break;
    }
    const int border = borderOf(wishes.size(), sizePx);
    // Texels of the borders come on top of what patches divide among them.
    std::vector<float> heights = tallestOf(shelves);
    const float heightSum = std::accumulate(heights.begin(), heights.end(), 0.0F);
    const auto room = static_cast<float>(sizePx - 2 * border * static_cast<int>(shelves.size()));
    for (float& height : heights)
        height = height / heightSum * room + 2.0F * static_cast<float>(border);
    const std::vector<int> rows = edgesOf(heights, sizePx, 1 + 2 * border);
    for (std::size_t s = 0; s < shelves.size(); ++s) {
        const Shelf& shelf = shelves[s];
        const auto inside = static_cast<float>(sizePx) -
                            2.0F * static_cast<float>(border) * static_cast<float>(shelf.end - shelf.begin);
        std::vector<float> parts;
        parts.reserve(shelf.end - shelf.begin);
        for (std::size_t i = shelf.begin; i < shelf.end; ++i)
            parts.push_back(std::max(widths[i] / shelf.width * inside, 1.0F) + 2.0F * static_cast<float>(border));
        const std::vector<int> columns = edgesOf(parts, sizePx, 1 + 2 * border);
        for (std::size_t i = shelf.begin; i < shelf.end; ++i) {
            const std::size_t column = i - shelf.begin;
            patches[order[i]] = {.x = columns[column] + border,
                                 .y = rows[s] + border,
                                 .width = std::max(columns[column + 1] - columns[column] - 2 * border, 1),
                                 .height = std::max(rows[s + 1] - rows[s] - 2 * border, 1)};
        }
    }
    return patches;
}

float filledPart(std::span<const AtlasPatch> patches, int sizePx)
{
    double filled = 0.0;
    for (const AtlasPatch& patch : patches)
        filled += static_cast<double>(patch.width) * static_cast<double>(patch.height);
    return static_cast<float>(filled / (static_cast<double>(sizePx) * static_cast<double>(sizePx)));
}

} // namespace hairpaint::model
