// Bisecting 2-means (Steinbach, Karypis and Kumar 2000) over the samples of hairs.
#include "model/cards/lock_tree.h"

#include "model/exporting/curve_simplify.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hairpaint::model {

namespace {

using Path = std::array<glm::vec3, SampledHair::kSamples>;

constexpr std::size_t kMostCompared = 2048; ///< Limit on the hairs of a lock that are compared to find its halves.
constexpr int kMeanRounds = 4;
constexpr float kAlikeM = 0.25e-3F; ///< A spread that needs no division.

float squaredAway(std::span<const glm::vec3> hair, std::span<const glm::vec3> path)
{
    // Several sums at once, which the compiler can keep in one register.
    constexpr std::size_t kSums = 8;
    static_assert(3 * SampledHair::kSamples % kSums == 0);
    const float* a = &hair.front().x;
    const float* b = &path.front().x;
    std::array<float, kSums> sums{};
    for (std::size_t i = 0; i < 3 * SampledHair::kSamples; i += kSums)
        for (std::size_t j = 0; j < kSums; ++j) {
            const float away = a[i + j] - b[i + j];
            sums[j] += away * away;
        }
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

class PathMean
{
public:
    void add(std::span<const glm::vec3> samples, float weight)
    {
        for (std::size_t i = 0; i < samples.size(); ++i)
            m_sum.at(i) += weight * samples[i];
        m_weight += weight;
    }
    [[nodiscard]] std::optional<Path> mean() const
    {
        if (m_weight <= 0.0F)
            return std::nullopt;
        Path path = m_sum;
        for (glm::vec3& sample : path)
            sample /= m_weight;
        return path;
    }

private:
    Path m_sum{};
    float m_weight = 0.0F;
};

struct DividedLock
{
    HairLock lock;
    double error = 0.0; ///< Weighed sum of squared distances.
    int triangles = 0;
};

class Divider
{
public:
    Divider(const SampledHair& hair, std::span<const float> weights) : m_hair(hair), m_weights(weights) {}

    [[nodiscard]] DividedLock dividedLock(std::vector<std::uint32_t> hairs)
    {
        DividedLock made;
        PathMean mean;
        for (const std::uint32_t i : hairs)
            mean.add(m_hair.samples(i), m_weights[i]);
        made.lock.meanWo = *mean.mean();
        double squares = 0.0;
        for (const std::uint32_t i : hairs) {
            const auto away = static_cast<double>(squaredAway(m_hair.samples(i), made.lock.meanWo));
            made.error += static_cast<double>(m_weights[i]) * away;
            squares += away;
        }
        made.lock.spreadM = static_cast<float>(
            std::sqrt(squares / (static_cast<double>(hairs.size()) * static_cast<double>(SampledHair::kSamples))));
        made.lock.hairs = std::move(hairs);
        stripSamples(made.lock, m_kept);
        made.triangles = 2 * (static_cast<int>(m_kept.size()) - 1);
        return made;
    }

    /// None where all hairs are alike.
    [[nodiscard]] std::optional<std::pair<DividedLock, DividedLock>> halves(const HairLock& lock)
    {
        Path left = samplesOf(farthestFrom(lock.meanWo, lock.hairs));
        Path right = samplesOf(farthestFrom(left, lock.hairs));
        const std::size_t step = (lock.hairs.size() + kMostCompared - 1) / kMostCompared;
        for (int round = 0; round < kMeanRounds; ++round) {
            PathMean leftMean;
            PathMean rightMean;
            for (std::size_t i = 0; i < lock.hairs.size(); i += step) {
                const auto samples = m_hair.samples(lock.hairs[i]);
                (isLeft(samples, left, right) ? leftMean : rightMean).add(samples, m_weights[lock.hairs[i]]);
            }
            left = leftMean.mean().value_or(left);
            right = rightMean.mean().value_or(right);
        }
        std::vector<std::uint32_t> leftHairs;
        std::vector<std::uint32_t> rightHairs;
        for (const std::uint32_t i : lock.hairs)
            (isLeft(m_hair.samples(i), left, right) ? leftHairs : rightHairs).push_back(i);
        if (leftHairs.empty() || rightHairs.empty())
            return std::nullopt;
        return std::pair(dividedLock(std::move(leftHairs)), dividedLock(std::move(rightHairs)));
    }

private:
    [[nodiscard]] static bool isLeft(std::span<const glm::vec3> samples, const Path& left, const Path& right)
    {
        return squaredAway(samples, left) <= squaredAway(samples, right);
    }
    [[nodiscard]] Path samplesOf(std::uint32_t hair) const
    {
        Path path{};
        std::ranges::copy(m_hair.samples(hair), path.begin());
        return path;
    }
    [[nodiscard]] std::uint32_t farthestFrom(const Path& path, const std::vector<std::uint32_t>& hairs) const
    {
        const std::size_t step = (hairs.size() + kMostCompared - 1) / kMostCompared;
        std::uint32_t farthest = hairs.front();
        float greatest = -1.0F;
        for (std::size_t i = 0; i < hairs.size(); i += step) {
            const float away = squaredAway(m_hair.samples(hairs[i]), path);
            if (away > greatest) {
                greatest = away;
                farthest = hairs[i];
            }
        }
        return farthest;
    }

    const SampledHair& m_hair;
    std::span<const float> m_weights;
    std::vector<std::uint16_t> m_kept;
};

} // namespace

void stripSamples(const HairLock& lock, std::vector<std::uint16_t>& kept)
{
    constexpr float kOfSpread = 0.3F;
    constexpr float kFinestM = 0.4e-3F;
    constexpr float kCoarsestM = 3e-3F;
    keptPoints(lock.meanWo, glm::clamp(kOfSpread * lock.spreadM, kFinestM, kCoarsestM), kept);
}

int stripTriangles(const HairLock& lock)
{
    std::vector<std::uint16_t> kept;
    stripSamples(lock, kept);
    return 2 * (static_cast<int>(kept.size()) - 1);
}

std::vector<HairLock> dividedIntoLocks(const SampledHair& hair, std::vector<std::vector<std::uint32_t>> sets,
                                       std::span<const float> weights, int triangles)
{
    constexpr int kMostRefusals = 16;
    Divider divider(hair, weights);
    const auto less = [](const DividedLock& a, const DividedLock& b) { return a.error < b.error; };
    std::vector<DividedLock> open;
    int used = 0;
    for (std::vector<std::uint32_t>& hairs : sets) {
        if (hairs.empty())
            continue;
        open.push_back(divider.dividedLock(std::move(hairs)));
        used += open.back().triangles;
    }
    std::ranges::make_heap(open, less);
    std::vector<HairLock> locks;
    for (int refusals = 0; !open.empty();) {
        std::ranges::pop_heap(open, less);
        DividedLock next = std::move(open.back());
        open.pop_back();
        if (next.lock.spreadM > kAlikeM && refusals < kMostRefusals) {
            auto halves = divider.halves(next.lock);
            const int more = halves ? halves->first.triangles + halves->second.triangles - next.triangles : 0;
            if (halves && used + more <= triangles) {
                used += more;
                for (DividedLock* half : {&halves->first, &halves->second}) {
                    open.push_back(std::move(*half));
                    std::ranges::push_heap(open, less);
                }
                continue;
            }
            ++refusals;
        }
        locks.push_back(std::move(next.lock));
    }
    return locks;
}

} // namespace hairpaint::model
