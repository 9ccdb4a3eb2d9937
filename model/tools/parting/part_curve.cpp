// Hermite pieces brought to the skin.
#include "model/tools/parting/part_curve.h"

#include "sim/base/rounded.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hairpaint::model {

namespace {

constexpr float kSampleStepM = 0.003F;
constexpr int kMostSteps = 100;          ///< Limit on the samples of one piece of the curve.
constexpr float kSamePointM = 0.0005F;   ///< Points nearer than this are one.
constexpr float kZigzagSharpness = 0.9F; ///< 0: a sine; 1: straight lines with corners.

struct Knot
{
    sim::SurfacePoint point;
    std::size_t index = 0;
    glm::vec3 directionHd{0.0F}; ///< Unit, along the skin.
};

glm::vec3 alongSkin(glm::vec3 direction, glm::vec3 normal)
{
    const glm::vec3 along = direction - normal * glm::dot(direction, normal);
    const float length = glm::length(along);
    return length > 1e-6F ? along / length : glm::vec3(0.0F);
}

/// Through a point as a parabola through it and both neighbours goes; at the ends as one through the next two does.
void findDirections(std::vector<Knot>& knots)
{
    const std::size_t last = knots.size() - 1;
    const auto chord = [&](std::size_t i) { return knots[i + 1].point.positionHd - knots[i].point.positionHd; };
    for (std::size_t i = 1; i < last; ++i) {
        const float before = glm::length(chord(i - 1));
        const float after = glm::length(chord(i));
        knots[i].directionHd =
            alongSkin(chord(i - 1) * (after / before) + chord(i) * (before / after), knots[i].point.normalHd);
    }
    for (const bool first : {true, false}) {
        Knot& end = first ? knots.front() : knots.back();
        const std::size_t inner = first ? 1 : last - 1;
        const glm::vec3 direction = glm::normalize(chord(first ? 0 : last - 1));
        end.directionHd =
            alongSkin(last > 1 ? 2.0F * direction - knots[inner].directionHd : direction, end.point.normalHd);
    }
}

} // namespace

glm::vec3 PartCurve::Sample::rightHd() const
{
    return glm::cross(tangentHd, normalHd);
}

PartCurve::PartCurve(const sim::Skin& skin, std::span<const sim::SurfacePoint> points)
{
    std::vector<Knot> knots;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (knots.empty() || glm::distance(knots.back().point.positionHd, points[i].positionHd) > kSamePointM)
            knots.push_back({.point = points[i], .index = i});
    if (knots.size() < 2)
        return;
    findDirections(knots);
    const auto add = [this](const sim::SurfacePoint& point, std::size_t index) {
        m_samples.push_back({.positionHd = point.positionHd,
                             .normalHd = point.normalHd,
                             .uv = point.uv,
                             .mPerUv = 0.5F * (glm::length(point.dPduHd) + glm::length(point.dPdvHd)),
                             .point = index});
    };
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const Knot& from = knots[i];
        const Knot& to = knots[i + 1];
        const glm::vec3 chord = to.point.positionHd - from.point.positionHd;
        const float chordM = glm::length(chord);
        // As long as a circle's arc that turns as much between both ends.
        const float half = 0.5F * sim::acosRounded(std::clamp(glm::dot(from.directionHd, to.directionHd), -1.0F, 1.0F));
        const float arcM = chordM * (half > 0.01F ? half / sim::sinRounded(half) : 1.0F);
        const int steps = std::clamp(static_cast<int>(std::ceil(arcM / kSampleStepM)), 1, kMostSteps);
        add(from.point, from.index);
        for (int k = 1; k < steps; ++k) {
            const float t = static_cast<float>(k) / static_cast<float>(steps);
            const float s = 1.0F - t;
            const glm::vec3 point = from.point.positionHd * (s * s * (1.0F + 2.0F * t)) +
                                    to.point.positionHd * (t * t * (1.0F + 2.0F * s)) +
                                    (from.directionHd * (s * s * t) - to.directionHd * (t * t * s)) * arcM;
            add(skin.nearest(point), from.index);
        }
    }
    add(knots.back().point, knots.back().index);
    for (std::size_t i = 0; i < m_samples.size(); ++i) {
        const Sample& before = m_samples[i == 0 ? 0 : i - 1];
        const Sample& after = m_samples[std::min(i + 1, m_samples.size() - 1)];
        Sample& sample = m_samples[i];
        if (i > 0)
            sample.alongM = before.alongM + glm::distance(before.positionHd, sample.positionHd);
        sample.tangentHd = alongSkin(after.positionHd - before.positionHd, sample.normalHd);
    }
}

float PartCurve::mPerUv() const
{
    float sum = 0.0F;
    for (const Sample& sample : m_samples)
        sum += sample.mPerUv;
    return m_samples.empty() ? 0.0F : sum / static_cast<float>(m_samples.size());
}

std::optional<PartCurve::Near> PartCurve::nearest(glm::vec3 positionHd) const
{
    std::optional<Near> found;
    for (std::size_t i = 0; i + 1 < m_samples.size(); ++i) {
        const glm::vec3 from = m_samples[i].positionHd;
        const glm::vec3 piece = m_samples[i + 1].positionHd - from;
        const float t =
            std::clamp(glm::dot(positionHd - from, piece) / std::max(glm::dot(piece, piece), 1e-12F), 0.0F, 1.0F);
        const float distanceM = glm::distance(positionHd, from + piece * t);
        if (!found || distanceM < found->distanceM)
            found = Near{.point = m_samples[i].point, .distanceM = distanceM};
    }
    return found;
}

std::vector<sim::SurfacePoint> pointsToHairline(const sim::Skin& skin, const PartCurve& curve, bool atEnd,
                                                const sim::TiledRaster& density)
{
    constexpr float kStepM = 0.005F;
    constexpr int kFurthestSteps = 15; // 7.5 cm.
    constexpr float kBare = 0.05F;
    constexpr float kTowardFace = 0.2F; // Least z of the curve's direction at an end that points toward the face.
    std::vector<sim::SurfacePoint> points;
    if (curve.empty())
        return points;
    const PartCurve::Sample& end = atEnd ? curve.samples().back() : curve.samples().front();
    glm::vec3 directionHd = atEnd ? end.tangentHd : -end.tangentHd;
    if (directionHd.z < kTowardFace || density.sampleScalar(end.uv) < kBare)
        return points;
    glm::vec3 at = end.positionHd;
    for (int steps = 0; steps < kFurthestSteps; ++steps) {
        const sim::SurfacePoint next = skin.nearest(at + directionHd * kStepM);
        const glm::vec3 step = next.positionHd - at;
        if (glm::length(step) < 0.5F * kStepM)
            break; // The skin's own edge.
        directionHd = alongSkin(step, next.normalHd);
        at = next.positionHd;
        points.push_back(next);
        if (density.sampleScalar(next.uv) < kBare)
            return points;
    }
    return {};
}

Zigzag::Zigzag(float amplitudeM, float lengthM)
    : m_amplitudeM(amplitudeM),
      m_perM(std::numbers::pi_v<float> * std::max(std::round(lengthM / (0.5F * kWaveM)), 1.0F) /
             std::max(lengthM, kSamePointM))
{}

Zigzag::Offset Zigzag::at(float alongM) const
{
    if (m_amplitudeM <= 0.0F)
        return {};
    const float scale = m_amplitudeM / sim::asinRounded(kZigzagSharpness);
    const float sine = kZigzagSharpness * sim::sinRounded(m_perM * alongM);
    const float cosine = kZigzagSharpness * sim::cosRounded(m_perM * alongM);
    return {.lateralM = scale * sim::asinRounded(sine),
            .slope = scale * m_perM * cosine / std::sqrt(1.0F - sine * sine)};
}

} // namespace hairpaint::model
