// Path, frames and widths of a strip.
#include "model/cards/card_strip.h"

#include "model/exporting/unit_vectors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr std::size_t kSamples = SampledHair::kSamples;
constexpr float kLeftOut = 0.05F; ///< Fraction of the hairs that is left outside, on each side.
constexpr float kOuter = 0.8F;    ///< Fraction of the hairs that lie under the strip.
constexpr float kNarrowestHalfM = 0.2e-3F;
constexpr float kShortestM = 0.2e-3F;
constexpr int kFrameRounds = 12;

using Vectors = std::array<glm::vec3, kSamples>;
using Numbers = std::array<float, kSamples>;

/// The value that this fraction of them stays under.
float quantile(std::vector<float>& values, float fraction)
{
    const auto at = static_cast<std::ptrdiff_t>(std::lround(fraction * static_cast<float>(values.size() - 1)));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

Vectors tangentsOf(const Vectors& path)
{
    Vectors tangents{};
    glm::vec3 last = unitOr(path.back() - path.front(), glm::vec3(0.0F, -1.0F, 0.0F));
    for (std::size_t i = 0; i < kSamples; ++i) {
        last = unitOr(path.at(std::min(i + 1, kSamples - 1)) - path.at(i > 0 ? i - 1 : 0), last);
        tangents.at(i) = last;
    }
    return tangents;
}

/// Both ends moved on, so that the strip covers hairs that begin before it or end after it.
void reachOut(const SampledHair& hair, const HairLock& lock, Vectors& path)
{
    const Vectors tangents = tangentsOf(path);
    std::vector<float> before;
    std::vector<float> after;
    before.reserve(lock.hairs.size());
    after.reserve(lock.hairs.size());
    for (const std::uint32_t i : lock.hairs) {
        const auto samples = hair.samples(i);
        before.push_back(glm::dot(path.front() - samples.front(), tangents.front()));
        after.push_back(glm::dot(samples.back() - path.back(), tangents.back()));
    }
    path.front() -= std::max(quantile(before, 1.0F - kLeftOut), 0.0F) * tangents.front();
    path.back() += std::max(quantile(after, 1.0F - kLeftOut), 0.5F * kShortestM) * tangents.back();
    if (glm::distance(path.front(), path.back()) < kShortestM)
        path.front() = path.back() - kShortestM * tangents.back();
}

/// Turned outward, with the least rotation from one cross-section to the next.
Vectors normalsOf(const Vectors& path, const Vectors& tangents, const HairField& field)
{
    const auto projected = [](const glm::vec3& vector, const glm::vec3& tangent) {
        return vector - glm::dot(vector, tangent) * tangent;
    };
    Vectors wanted{};
    Vectors normals{};
    for (std::size_t i = 0; i < kSamples; ++i)
        wanted.at(i) = projected(field.outward(path.at(i)), tangents.at(i));
    glm::vec3 last = anyAcross(tangents.front());
    const auto firstClear = std::ranges::find_if(wanted, [](const glm::vec3& v) { return glm::dot(v, v) > 0.01F; });
    if (firstClear != wanted.end())
        last = *firstClear;
    for (std::size_t i = 0; i < kSamples; ++i) {
        last = unitOr(projected(last, tangents.at(i)), anyAcross(tangents.at(i)));
        last = unitOr(last + wanted.at(i), last);
        normals.at(i) = last;
    }
    constexpr float kKept = 2.0F; ///< Weight of the neighbours' normals against 1 for the wanted normal.
    for (int round = 0; round < kFrameRounds; ++round)
        for (std::size_t i = 0; i < kSamples; ++i) {
            const glm::vec3 around = normals.at(i > 0 ? i - 1 : 0) + normals.at(std::min(i + 1, kSamples - 1));
            normals.at(i) = unitOr(projected(kKept * around + wanted.at(i), tangents.at(i)), normals.at(i));
        }
    return normals;
}

/// Moves the path to the middle of the hairs' breadth and to the outer side of their depth, where they are seen, and
/// tells how far they reach to each side of it.
Numbers halfWidthsOf(const SampledHair& hair, const HairLock& lock, const Vectors& sides, const Vectors& normals,
                     Vectors& path)
{
    Numbers widths{};
    Vectors shifts{};
    std::vector<float> across;
    std::vector<float> heights;
    for (std::size_t i = 0; i < kSamples; ++i) {
        across.clear();
        across.reserve(lock.hairs.size());
        heights.clear();
        heights.reserve(lock.hairs.size());
        for (const std::uint32_t h : lock.hairs) {
            const glm::vec3 away = hair.samples(h)[i] - lock.meanWo.at(i);
            across.push_back(glm::dot(away, sides.at(i)));
            heights.push_back(glm::dot(away, normals.at(i)));
        }
        const float low = quantile(across, kLeftOut);
        const float high = quantile(across, 1.0F - kLeftOut);
        shifts.at(i) = 0.5F * (low + high) * sides.at(i) + quantile(heights, kOuter) * normals.at(i);
        widths.at(i) = std::max(0.5F * (high - low), kNarrowestHalfM);
    }
    Numbers smooth{};
    for (std::size_t i = 0; i < kSamples; ++i) {
        const std::size_t before = i > 0 ? i - 1 : 0;
        const std::size_t after = std::min(i + 1, kSamples - 1);
        path.at(i) += 0.25F * (shifts.at(before) + shifts.at(after)) + 0.5F * shifts.at(i);
        smooth.at(i) = std::max({widths.at(before), widths.at(i), widths.at(after)});
    }
    return smooth;
}

} // namespace

float CardStrip::greatestWidthM() const
{
    return 2.0F * std::ranges::max_element(nodes, {}, &StripNode::halfWidthM)->halfWidthM;
}

float CardStrip::areaM2() const
{
    float area = 0.0F;
    for (std::size_t i = 1; i < nodes.size(); ++i)
        area += (nodes[i].alongM - nodes[i - 1].alongM) * (nodes[i].halfWidthM + nodes[i - 1].halfWidthM);
    return area;
}

StripPoint StripProjector::next(const glm::vec3& pointWo)
{
    const std::vector<StripNode>& nodes = m_strip.nodes;
    const auto measured = [&](std::size_t segment, float& square, float& part) {
        const StripNode& from = nodes[segment];
        const glm::vec3 along = nodes[segment + 1].middleWo - from.middleWo;
        const float length = glm::dot(along, along);
        part = length > 0.0F ? glm::dot(pointWo - from.middleWo, along) / length : 0.0F;
        const glm::vec3 away = pointWo - (from.middleWo + glm::clamp(part, 0.0F, 1.0F) * along);
        square = glm::dot(away, away);
    };
    float nearest = 0.0F;
    float part = 0.0F;
    measured(m_segment, nearest, part);
    for (std::size_t tried = m_segment + 1; tried + 1 < nodes.size() && tried <= m_segment + 2; ++tried) {
        float square = 0.0F;
        float otherPart = 0.0F;
        measured(tried, square, otherPart);
        if (square < nearest) {
            nearest = square;
            part = otherPart;
            m_segment = tried;
        }
    }
    // Past its ends the strip goes straight on.
    const float least = m_segment == 0 ? -1.0F : 0.0F;
    const float most = m_segment + 2 == nodes.size() ? 2.0F : 1.0F;
    part = glm::clamp(part, least, most);
    const float within = glm::clamp(part, 0.0F, 1.0F);
    const StripNode& from = nodes[m_segment];
    const StripNode& to = nodes[m_segment + 1];
    const glm::vec3 away = pointWo - glm::mix(from.middleWo, to.middleWo, part);
    return {.across = glm::dot(away, glm::mix(from.sideWo, to.sideWo, within)) /
                      glm::mix(from.halfWidthM, to.halfWidthM, within),
            .alongM = glm::mix(from.alongM, to.alongM, part),
            .heightM = glm::dot(away, glm::mix(from.normalWo, to.normalWo, within))};
}

CardStrip stripOf(const SampledHair& hair, const HairLock& lock, const HairField& field)
{
    Vectors path = lock.meanWo;
    reachOut(hair, lock, path);
    const Vectors tangents = tangentsOf(path);
    const Vectors normals = normalsOf(path, tangents, field);
    Vectors sides{};
    for (std::size_t i = 0; i < kSamples; ++i)
        sides.at(i) = glm::cross(normals.at(i), tangents.at(i));
    const Numbers widths = halfWidthsOf(hair, lock, sides, normals, path);

    CardStrip strip;
    std::vector<std::uint16_t> kept;
    stripSamples(lock, kept);
    strip.nodes.reserve(kept.size());
    for (const std::uint16_t i : kept) {
        StripNode node{.middleWo = path.at(i),
                       .sideWo = sides.at(i),
                       .normalWo = normals.at(i),
                       .halfWidthM = widths.at(i),
                       .alongM = 0.0F};
        if (!strip.nodes.empty())
            node.alongM = strip.nodes.back().alongM +
                          std::max(glm::distance(strip.nodes.back().middleWo, node.middleWo), 1e-3F * kShortestM);
        strip.nodes.push_back(node);
        strip.openness += field.openness(node.middleWo) / static_cast<float>(kept.size());
    }
    strip.hairs = lock.hairs;
    return strip;
}

} // namespace hairpaint::model
