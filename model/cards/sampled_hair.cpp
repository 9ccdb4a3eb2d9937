// Equal steps along each curve, and means of several of them.
#include "model/cards/sampled_hair.h"

#include "sim/base/parallel.h"

#include <algorithm>
#include <array>

namespace hairpaint::model {

namespace {

constexpr std::size_t kStepsPerSample = 4;
constexpr std::size_t kSteps = kStepsPerSample * (SampledHair::kSamples - 1);
constexpr std::size_t kHairsAtOnce = 1U << 14U;
constexpr std::size_t kGrain = 256;

/// Points equally far along the curve, kSteps + 1; the curve's length.
float stepAlong(std::span<const glm::vec3> points, std::vector<float>& along, std::array<glm::vec3, kSteps + 1>& steps)
{
    along.assign(1, 0.0F);
    for (std::size_t i = 1; i < points.size(); ++i)
        along.push_back(along.back() + glm::distance(points[i - 1], points[i]));
    const float length = along.back();
    std::size_t at = 1;
    for (std::size_t i = 0; i <= kSteps; ++i) {
        const float wanted = length * static_cast<float>(i) / static_cast<float>(kSteps);
        while (at + 1 < points.size() && along[at] < wanted)
            ++at;
        const float stretch = along[at] - along[at - 1];
        const float part = stretch > 0.0F ? glm::clamp((wanted - along[at - 1]) / stretch, 0.0F, 1.0F) : 0.0F;
        steps.at(i) = glm::mix(points[at - 1], points[at], part);
    }
    return length;
}

void averageAlong(const std::array<glm::vec3, kSteps + 1>& steps, std::span<glm::vec3> samples)
{
    samples.front() = steps.front();
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const std::size_t middle = i * kStepsPerSample;
        const std::size_t last = std::min(middle + kStepsPerSample / 2, kSteps);
        glm::vec3 sum(0.0F);
        std::size_t count = 0;
        for (std::size_t step = middle - kStepsPerSample / 2; step <= last; ++step, ++count)
            sum += steps.at(step);
        samples[i] = sum / static_cast<float>(count);
    }
}

} // namespace

std::optional<SampledHair> sampledHair(const CurveSet& set, const Progress& progress)
{
    SampledHair hair;
    const std::size_t all = set.curves().size();
    const std::size_t count = std::min(all, SampledHair::kMostHairs);
    const float others = count > 0 ? set.thinning() * static_cast<float>(all) / static_cast<float>(count) : 1.0F;
    hair.curve.resize(count);
    hair.lengthM.resize(count);
    hair.widthM.resize(count);
    hair.samplesWo.resize(count * SampledHair::kSamples);
    for (std::size_t first = 0; first < count; first += kHairsAtOnce) {
        if (progress && !progress(static_cast<double>(first) / static_cast<double>(count)))
            return std::nullopt;
        sim::parallelFor(std::min(kHairsAtOnce, count - first), kGrain, [&](std::size_t begin, std::size_t end) {
            CurveScratch scratch;
            std::vector<float> along;
            std::array<glm::vec3, kSteps + 1> steps{};
            for (std::size_t i = first + begin; i < first + end; ++i) {
                hair.curve[i] = static_cast<std::uint32_t>(i * all / count);
                const Curve& curve = set.curves()[hair.curve[i]];
                hair.lengthM[i] = stepAlong(set.points(curve, scratch), along, steps);
                hair.widthM[i] = set.width(curve, 0.0F) * others;
                averageAlong(steps,
                             std::span(hair.samplesWo).subspan(i * SampledHair::kSamples, SampledHair::kSamples));
            }
        });
    }
    return hair;
}

} // namespace hairpaint::model
