// What the eye checks in hair, measured on exported strands. Hd is the world: the head stands still. All m but
// fractions.
#pragma once

#include "model/importing/strand_shape.h"
#include "sim/skin/skin.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

namespace hairpaint::test {

using Strands = std::vector<std::vector<glm::vec3>>;

/// 0 of none.
inline float quantileOf(std::vector<float> values, double fraction)
{
    if (values.empty())
        return 0.0F;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, at);
    return *at;
}

/// At a fraction of its points.
inline glm::vec3 pointAt(const std::vector<glm::vec3>& hair, float fraction)
{
    const float u = fraction * static_cast<float>(hair.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(u), hair.size() - 2);
    return glm::mix(hair[below], hair[below + 1], u - static_cast<float>(below));
}

/// Where a hair is so far along it.
inline glm::vec3 pointAfter(const std::vector<glm::vec3>& hair, float alongM)
{
    for (std::size_t i = 1; i < hair.size(); ++i) {
        const float lengthM = glm::distance(hair[i], hair[i - 1]);
        if (lengthM >= alongM)
            return glm::mix(hair[i - 1], hair[i], alongM / std::max(lengthM, 1e-9F));
        alongM -= lengthM;
    }
    return hair.back();
}

/// The fraction of hairs that the nearest other hair crosses from one side to the other; among every sixth hair with
/// another root within 8 mm.
inline double crossingFraction(const Strands& hairs)
{
    constexpr int kSamples = 24;
    constexpr float kAsideM = 0.0004F;
    int pairs = 0;
    int crossing = 0;
    for (std::size_t i = 0; i < hairs.size(); i += 6) {
        std::size_t nearest = i;
        float leastM = 0.008F;
        for (std::size_t j = 0; j < hairs.size(); ++j) {
            const float apartM = glm::distance(hairs[i].front(), hairs[j].front());
            if (j != i && apartM < leastM) {
                leastM = apartM;
                nearest = j;
            }
        }
        if (nearest == i)
            continue;
        bool left = false;
        bool right = false;
        for (int k = 1; k < kSamples; ++k) {
            const float s = static_cast<float>(k) / kSamples;
            const glm::vec3 at = pointAt(hairs[i], s);
            const glm::vec3 side = glm::cross(at, pointAt(hairs[i], s + 1.0F / kSamples) - at);
            const float asideM = glm::dot(pointAt(hairs[nearest], s) - at, side) / std::max(glm::length(side), 1e-9F);
            left = left || asideM > kAsideM;
            right = right || asideM < -kAsideM;
        }
        ++pairs;
        crossing += left && right ? 1 : 0;
    }
    return static_cast<double>(crossing) / std::max(pairs, 1);
}

/// Distance from the skin below which so many of the points over the upper head lie.
inline float coatM(const Strands& hairs, const sim::Skin& skin, double fraction)
{
    constexpr float kUpperHeadY = 0.05F;
    constexpr float kEachM = 0.01F;
    std::vector<float> heights;
    for (const std::vector<glm::vec3>& hair : hairs)
        for (int i = 1; i < 15; ++i) {
            const glm::vec3 p = pointAfter(hair, static_cast<float>(i) * kEachM);
            if (p == hair.back() || p.y < kUpperHeadY)
                break;
            heights.push_back(glm::distance(p, skin.nearest(p).positionHd));
        }
    return quantileOf(std::move(heights), fraction);
}

/// Height in which four fifths of the tips behind the back are, in the middle of its strips of 2 cm.
inline float tipSpreadM(const Strands& hairs)
{
    constexpr int kStrips = 8;
    constexpr float kStripM = 0.02F;
    std::array<std::vector<float>, kStrips> tips;
    for (const std::vector<glm::vec3>& hair : hairs) {
        const glm::vec3 tip = hair.back();
        const int strip = static_cast<int>(std::floor(tip.x / kStripM + 0.5F * kStrips));
        if (tip.z < -0.05F && strip >= 0 && strip < kStrips)
            tips[static_cast<std::size_t>(strip)].push_back(tip.y);
    }
    std::vector<float> spreads;
    for (const std::vector<float>& strip : tips)
        if (strip.size() > 20)
            spreads.push_back(quantileOf(strip, 0.9) - quantileOf(strip, 0.1));
    return quantileOf(std::move(spreads), 0.5);
}

/// How far the outline seen from behind lies below a straight line between two of its points, above the ears.
inline float dentM(const Strands& hairs)
{
    constexpr int kColumns = 21;
    constexpr float kColumnM = 0.004F;
    constexpr std::size_t kStrays = 20; ///< Hairs that are higher than the outline.
    std::array<std::vector<float>, kColumns> tops;
    for (const std::vector<glm::vec3>& hair : hairs) {
        std::array<float, kColumns> top{};
        for (std::size_t i = 1; i < hair.size(); ++i) {
            const int steps = static_cast<int>(std::abs(hair[i].x - hair[i - 1].x) / (0.5F * kColumnM)) + 1;
            for (int k = 0; k < steps; ++k) {
                const glm::vec3 p = glm::mix(hair[i - 1], hair[i], static_cast<float>(k) / static_cast<float>(steps));
                const int column = static_cast<int>(std::floor(p.x / kColumnM + 0.5F * kColumns));
                if (column >= 0 && column < kColumns)
                    top[static_cast<std::size_t>(column)] = std::max(top[static_cast<std::size_t>(column)], p.y);
            }
        }
        for (std::size_t column = 0; column < kColumns; ++column)
            if (top[column] > 0.0F)
                tops[column].push_back(top[column]);
    }
    std::array<float, kColumns> outline{};
    for (std::size_t column = 0; column < kColumns; ++column)
        if (tops[column].size() > kStrays) {
            std::ranges::nth_element(tops[column], tops[column].begin() + kStrays, std::greater<>());
            outline[column] = tops[column][kStrays];
        }
    float deepestM = 0.0F;
    for (std::size_t at = 1; at + 1 < kColumns; ++at)
        for (std::size_t left = 0; left < at; ++left)
            for (std::size_t right = at + 1; right < kColumns; ++right) {
                const float s = static_cast<float>(at - left) / static_cast<float>(right - left);
                deepestM = std::max(deepestM, glm::mix(outline[left], outline[right], s) - outline[at]);
            }
    return deepestM;
}

/// A parting in the middle, from the hairline to the crown.
struct PartMeasures
{
    float gapM = 0.0F;            ///< Width in which roots are less than half as dense as beside it.
    float turnsDegreesACm = 0.0F; ///< Mean change of the line's direction.
    float crossingACm = 0.0F;     ///< Hairs of one side that lie to the other.
};
inline PartMeasures partOf(const Strands& hairs)
{
    constexpr float kFromZ = -0.06F;
    constexpr int kCm = 11;
    constexpr float kBesideM = 0.006F;
    constexpr float kBinM = 0.00025F;
    constexpr int kBins = 24; ///< On each side.
    constexpr float kAlongM = 0.015F;
    struct Root
    {
        float xM;
        float toM; ///< To the side, over kAlongM.
    };
    std::array<std::vector<Root>, kCm> roots;
    std::array<int, kBins> counts{};
    for (const std::vector<glm::vec3>& hair : hairs) {
        const glm::vec3 root = hair.front();
        const int cm = static_cast<int>(std::floor((root.z - kFromZ) * 100.0F));
        if (root.y < 0.06F || std::abs(root.x) > kBesideM || cm < 0 || cm >= kCm)
            continue;
        roots[static_cast<std::size_t>(cm)].push_back({root.x, pointAfter(hair, kAlongM).x - root.x});
        ++counts[std::min(static_cast<std::size_t>(std::abs(root.x) / kBinM), std::size_t{kBins - 1})];
    }
    PartMeasures found;
    const double beside = std::accumulate(counts.begin() + kBins / 2, counts.end(), 0.0) / (0.5 * kBins);
    for (int bin = 0; bin < kBins && counts[static_cast<std::size_t>(bin)] < 0.5 * beside; ++bin)
        found.gapM = 2.0F * kBinM * static_cast<float>(bin + 1);
    std::vector<float> line;
    int crossing = 0;
    for (std::vector<Root>& of : roots) {
        // Where the fewest lie to the other side.
        std::ranges::sort(of, {}, &Root::xM);
        int wrong = static_cast<int>(std::ranges::count_if(of, [](const Root& root) { return root.toM < 0.0F; }));
        int least = wrong;
        float atM = -kBesideM;
        for (const Root& root : of) {
            wrong += root.toM < 0.0F ? -1 : 1;
            if (wrong < least) {
                least = wrong;
                atM = root.xM;
            }
        }
        line.push_back(atM);
        crossing += least;
    }
    for (std::size_t i = 2; i < line.size(); ++i) {
        const auto direction = [&](std::size_t k) { return std::atan((line[k] - line[k - 1]) / 0.01F); };
        found.turnsDegreesACm += glm::degrees(std::abs(direction(i) - direction(i - 1))) / static_cast<float>(kCm - 2);
    }
    found.crossingACm = static_cast<float>(crossing) / kCm;
    return found;
}

/// The fraction of squares of 3 mm around the crown, seen from above, that no hair passes.
inline double bareFraction(const Strands& hairs, const glm::vec3& crown)
{
    constexpr int kSquares = 20; ///< Across: 6 cm.
    constexpr float kSquareM = 0.003F;
    std::array<int, std::size_t{kSquares} * kSquares> passed{};
    for (const std::vector<glm::vec3>& hair : hairs)
        for (std::size_t i = 1; i < hair.size(); ++i)
            for (int k = 0; k < 8; ++k) {
                const glm::vec3 p = glm::mix(hair[i - 1], hair[i], static_cast<float>(k) * 0.125F) - crown;
                const int x = static_cast<int>(std::floor(p.x / kSquareM)) + kSquares / 2;
                const int z = static_cast<int>(std::floor(p.z / kSquareM)) + kSquares / 2;
                if (p.y > -0.02F && x >= 0 && x < kSquares && z >= 0 && z < kSquares)
                    ++passed[static_cast<std::size_t>(z) * kSquares + static_cast<std::size_t>(x)];
            }
    return static_cast<double>(std::ranges::count_if(passed, [](int times) { return times < 3; })) /
           static_cast<double>(passed.size());
}

/// Coils as an import finds them.
struct CurlMeasures
{
    std::size_t coils = 0;  ///< Hairs of more than a turn.
    float diameterM = 0.0F; ///< Medians.
    float pitchM = 0.0F;
    double rightHanded = 0.0; ///< Fraction of them.
};
inline CurlMeasures curlOf(const Strands& hairs)
{
    model::StrandScratch scratch;
    std::vector<float> diameters;
    std::vector<float> pitches;
    int right = 0;
    for (const std::vector<glm::vec3>& hair : hairs) {
        const model::StrandShape shape = model::measureStrand(hair, scratch);
        if (shape.turns < 1.0F)
            continue;
        diameters.push_back(2.0F * shape.radiusM);
        pitches.push_back(shape.lengthM / shape.turns);
        const std::vector<glm::vec3>& even = scratch.evenHd;
        const float step = 1.0F / static_cast<float>(even.size() - 1);
        float turning = 0.0F;
        glm::vec3 before(0.0F);
        for (std::size_t k = 4; k + 4 < even.size(); ++k) {
            const float s = static_cast<float>(k) * step;
            const glm::vec3 off = even[k] - pointAt(scratch.axisHd, s);
            const glm::vec3 onward =
                pointAt(scratch.axisHd, s + 4.0F * step) - pointAt(scratch.axisHd, s - 4.0F * step);
            turning += glm::dot(glm::cross(before, off), onward);
            before = off;
        }
        right += turning > 0.0F ? 1 : 0;
    }
    return {.coils = diameters.size(),
            .diameterM = quantileOf(diameters, 0.5),
            .pitchM = quantileOf(pitches, 0.5),
            .rightHanded = static_cast<double>(right) / std::max<double>(static_cast<double>(diameters.size()), 1.0)};
}

} // namespace hairpaint::test
