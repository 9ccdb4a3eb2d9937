// The best of some moves of each patch's alpha.
#include "model/cards/alpha_coverage.h"

#include "model/exporting/card_settings.h"
#include "sim/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr int kLevels = 3; ///< That are heeded; further ones are a few texels of a card.
constexpr float kOpaque = 255.0F;
constexpr std::uint16_t kBorder = 256; ///< Beyond every alpha: what no move changes.

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
    half.values.resize(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    const auto width = static_cast<std::size_t>(plane.width);
    const std::size_t beside = plane.width > 1 ? 1 : 0;
    const std::size_t below = plane.height > 1 ? width : 0;
    float* out = half.values.data();
    for (int y = 0; y < half.height; ++y) {
        const float* in = plane.values.data() + 2 * static_cast<std::size_t>(y) * width;
        for (int x = 0; x < half.width; ++x, in += 2)
            *out++ = 0.25F * (in[0] + in[beside] + in[below] + in[below + beside]);
    }
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

/// A patch with what lies around it up to whole texels of the last level: nothing on its border, then more like itself.
struct Surrounded
{
    int width = 0;
    int height = 0;
    std::vector<std::uint16_t> alpha;    ///< 0..255, or kBorder.
    std::array<Plane, kLevels> inside{}; ///< By level: 1 where a texel's middle lies in the patch.
};

Surrounded surrounded(const std::vector<std::uint8_t>& alpha, int sizePx, const AtlasPatch& patch)
{
    constexpr int kStep = 1 << kLevels;
    const int left = patch.x / kStep * kStep;
    const int top = patch.y / kStep * kStep;
    const auto reach = [](int from, int end) { return (end - from + kStep - 1) / kStep * kStep; };
    Surrounded made;
    made.width = reach(left, patch.x + patch.width);
    made.height = reach(top, patch.y + patch.height);
    made.alpha.reserve(static_cast<std::size_t>(made.width) * static_cast<std::size_t>(made.height));
    // Beyond the border the patch is seen as in a mirror.
    const auto mirrored = [](int at, int length) {
        const int away = at < 0 ? -2 - at : at > length ? 2 * length - at : at;
        return at == -1 || at == length ? -1 : std::clamp(away, 0, length - 1);
    };
    for (int y = 0; y < made.height; ++y)
        for (int x = 0; x < made.width; ++x) {
            const int ownX = mirrored(left + x - patch.x, patch.width);
            const int ownY = mirrored(top + y - patch.y, patch.height);
            made.alpha.push_back(
                ownX < 0 || ownY < 0
                    ? kBorder
                    : alpha[static_cast<std::size_t>(patch.y + ownY) * static_cast<std::size_t>(sizePx) +
                            static_cast<std::size_t>(patch.x + ownX)]);
        }
    for (int level = 0; level < kLevels; ++level) {
        const int side = 2 << level;
        Plane& inside = made.inside.at(static_cast<std::size_t>(level));
        inside = {.width = made.width / side, .height = made.height / side, .values = {}};
        for (int y = 0; y < inside.height; ++y)
            for (int x = 0; x < inside.width; ++x) {
                const int atX = left + x * side + side / 2 - patch.x;
                const int atY = top + y * side + side / 2 - patch.y;
                inside.values.push_back(atX >= 0 && atX < patch.width && atY >= 0 && atY < patch.height ? 1.0F : 0.0F);
            }
    }
    return made;
}

float coverageInside(const Plane& plane, const Plane& inside)
{
    float hair = 0.0F;
    float all = 0.0F;
    for (std::size_t i = 0; i < plane.values.size(); ++i) {
        hair += plane.values[i] >= kCardCutoff ? inside.values[i] : 0.0F;
        all += inside.values[i];
    }
    return all > 0.0F ? hair / all : 0.0F;
}

/// How much the first levels' coverage differs from `wanted` once alpha is moved: sum of squares.
float awayAfter(const Surrounded& patch, const Move& move, float wanted)
{
    std::array<float, kBorder + 1> table{}; // The border has none.
    for (std::size_t i = 0; i < kBorder; ++i)
        table.at(i) = static_cast<float>(moved(static_cast<std::uint8_t>(i), move)) / kOpaque;
    Plane level{.width = patch.width, .height = patch.height, .values = std::vector<float>(patch.alpha.size())};
    std::ranges::transform(patch.alpha, level.values.begin(), [&table](std::uint16_t alpha) { return table[alpha]; });
    float sum = 0.0F;
    for (const Plane& inside : patch.inside) {
        level = halved(level);
        const float away = coverageInside(level, inside) - wanted;
        sum += away * away;
    }
    return sum;
}

Move bestMove(const Surrounded& patch, float wanted)
{
    constexpr int kSteps = 5;
    constexpr float kFarthest = 0.8F; // Programs that blend need some of the rest.
    Move best;
    float least = awayAfter(patch, best, wanted);
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const int raise = i / kSteps;
        const int lower = i % kSteps;
        const Move move{.raised = kFarthest * static_cast<float>(raise) / static_cast<float>(kSteps - 1),
                        .lowered = kFarthest * static_cast<float>(lower) / static_cast<float>(kSteps - 1)};
        const float away = awayAfter(patch, move, wanted);
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
            const Move move = bestMove(surrounded(alpha, sizePx, patch), coverageOf(alphaPlane(alpha, sizePx, patch)));
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
