// The best of some moves of each patch's alpha.
#include "model/exporting/cards/alpha_coverage.h"

#include "model/exporting/cards/card_settings.h"
#include "sim/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr int kLevels = 3; ///< That are heeded; further ones are a few texels of a card.
constexpr float kOpaque = 255.0F;

struct Plane
{
    int width = 0;
    int height = 0;
    std::vector<float> values;
};

Plane alphaPlane(const std::vector<std::uint8_t>& alpha, int sizePx, const AtlasPatch& patch)
{
    Plane plane{.width = patch.width, .height = patch.height, .values = {}};
    plane.values.reserve(static_cast<std::size_t>(patch.width) * static_cast<std::size_t>(patch.height));
    for (int y = patch.y; y < patch.y + patch.height; ++y)
        for (int x = patch.x; x < patch.x + patch.width; ++x)
            plane.values.push_back(
                static_cast<float>(alpha[static_cast<std::size_t>(y) * static_cast<std::size_t>(sizePx) +
                                         static_cast<std::size_t>(x)]) /
                kOpaque);
    return plane;
}

Plane halved(const Plane& plane)
{
    Plane half{.width = std::max(plane.width / 2, 1), .height = std::max(plane.height / 2, 1), .values = {}};
    half.values.reserve(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    const auto at = [&plane](int x, int y) {
        return plane
            .values[static_cast<std::size_t>(std::min(y, plane.height - 1)) * static_cast<std::size_t>(plane.width) +
                    static_cast<std::size_t>(std::min(x, plane.width - 1))];
    };
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x)
            half.values.push_back(
                0.25F * (at(2 * x, 2 * y) + at(2 * x + 1, 2 * y) + at(2 * x, 2 * y + 1) + at(2 * x + 1, 2 * y + 1)));
    return half;
}

float coverageOf(const Plane& plane)
{
    const auto hair = std::ranges::count_if(plane.values, [](float alpha) { return alpha >= kCardCutoff; });
    return static_cast<float>(hair) / static_cast<float>(plane.values.size());
}

/// How far alpha goes to the cutoff, 0..1.
struct Move
{
    float raised = 0.0F;  ///< What lies below it.
    float lowered = 0.0F; ///< What lies above it.
};

std::uint8_t moved(std::uint8_t alpha, const Move& move)
{
    const float cutoff = kCardCutoff * kOpaque;
    const auto value = static_cast<float>(alpha);
    if (value >= cutoff)
        return static_cast<std::uint8_t>(std::ceil(value - move.lowered * (value - cutoff)));
    return static_cast<std::uint8_t>(value + move.raised * (cutoff - 1.0F - value));
}

/// How much the first levels' coverage differs from `wanted` once alpha is moved: sum of squares.
float awayAfter(const Plane& plane, const Move& move, float wanted)
{
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i)
        table.at(i) = static_cast<float>(moved(static_cast<std::uint8_t>(i), move)) / kOpaque;
    Plane level = plane;
    for (float& value : level.values)
        value = table.at(static_cast<std::size_t>(std::lround(value * kOpaque)));
    float sum = 0.0F;
    for (int i = 0; i < kLevels; ++i) {
        level = halved(level);
        const float away = coverageOf(level) - wanted;
        sum += away * away;
    }
    return sum;
}

Move bestMove(const Plane& plane)
{
    constexpr int kSteps = 5;
    constexpr float kFarthest = 0.8F; // Programs that blend need some of the rest.
    const float wanted = coverageOf(plane);
    Move best;
    float least = awayAfter(plane, best, wanted);
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const int raise = i / kSteps;
        const int lower = i % kSteps;
        const Move move{.raised = kFarthest * static_cast<float>(raise) / static_cast<float>(kSteps - 1),
                        .lowered = kFarthest * static_cast<float>(lower) / static_cast<float>(kSteps - 1)};
        const float away = awayAfter(plane, move, wanted);
        if (away < least) {
            least = away;
            best = move;
        }
    }
    return best;
}

} // namespace

float alphaCoverage(const std::vector<std::uint8_t>& alpha, int sizePx, const AtlasPatch& patch, int level)
{
    Plane plane = alphaPlane(alpha, sizePx, patch);
    for (int i = 0; i < level; ++i)
        plane = halved(plane);
    return coverageOf(plane);
}

void keepAlphaCoverage(std::vector<std::uint8_t>& alpha, int sizePx, std::span<const AtlasPatch> patches)
{
    sim::parallelFor(patches.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const AtlasPatch& patch = patches[i];
            const Move move = bestMove(alphaPlane(alpha, sizePx, patch));
            for (int y = patch.y; y < patch.y + patch.height; ++y)
                for (int x = patch.x; x < patch.x + patch.width; ++x) {
                    std::uint8_t& value = alpha[static_cast<std::size_t>(y) * static_cast<std::size_t>(sizePx) +
                                                static_cast<std::size_t>(x)];
                    value = moved(value, move);
                }
        }
    });
}

} // namespace hairpaint::model
