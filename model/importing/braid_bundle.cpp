// The mean over a bundle's strands, at the same distance from their tips, is its skeleton; how a strand's offset from
// the skeleton changes along it tells the kind of braid, and how far off the strands are its radius.
#include "model/importing/braid_bundle.h"

#include "sim/base/rounded.h"
#include "sim/groom/strand_curve.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hairpaint::model {

namespace {

struct Range
{
    float least;
    float most;
    [[nodiscard]] bool has(float value) const { return value >= least && value <= most; }
};

constexpr std::size_t kMostFollowedStrands = 384;
constexpr std::size_t kSteps = 256; ///< Number of samples along a bundle.
constexpr float kShortest = 0.2F;   ///< Fraction of the strands that may be shorter than the length that is examined.
constexpr float kTuft = 0.15F;      ///< Fraction of a braid at its end that is left out, since the braid opens there.
/// Fraction of a braid at its beginning that is left out, since the hairs gather there.
constexpr float kGathers = 0.1F;
constexpr float kParts = 1.8F; ///< The bundle ends where it is this many times as wide as usual,
constexpr float kTied = 0.6F; ///< or at its narrowest point before that, if less than this many times as wide as usual.
constexpr float kLeastBraided = 0.5F; ///< Least fraction of the examined length that a braid covers.
constexpr float kShortestBraidM = 0.03F;
// Measured in braids of our own kinds, whose hairs turn about the middle of their wisp. Weave, the fraction of the
// squared distances from the skeleton that is movement from side to side: .98 to 1 in plaits, .93 in twists.
// Steadiness, the part of the turning that is in one direction: .13 to .23 and .8. Swing, how many times as often
// strands cross in one direction as in the other: 2.0 to 2.1 and 1.1. Agreement of the positions, as axes: .24 to .31
// and .41. Where hairs do not turn in their wisp, as in files of former versions, these are .64 to .67 and .6, .53 and
// .75, 2.0 to 2.2 and 1.2, .33 and .57. Locks of ringlets come near plaits or twists, but their agreement is .7.
constexpr Range kWeaves{0.5F, 1.0F};
constexpr float kLeastTurns = 1.2F;
constexpr Range kPlaitSteadiness{0.08F, 0.65F};
constexpr Range kPlaitSwing{1.7F, 2.5F};
constexpr Range kPlaitAgreement{0.0F, 0.45F};
constexpr Range kTwistSteadiness{0.65F, 1.0F};
constexpr Range kTwistSwing{1.0F, 1.5F};
constexpr Range kTwistAgreement{0.34F, 0.62F};
// In a loc strands lie, or all turn in one direction, and stand all around: .98 to 1 and .02 to .08 in ours.
constexpr float kLies = 0.25F;
constexpr float kLocSteadiness = 0.9F;
constexpr float kLocAgreement = 0.2F;
constexpr float kGathered = 1.5F;    ///< Roots stand so many times as wide apart as the braid is.
constexpr float kLocGathered = 3.5F; ///< A lock comes near this.
constexpr float kWidestLocM = 8e-3F;
constexpr float kEvenLoc = 1.6F; ///< Widest to thinnest.

/// The positions of some strands at even distances from their tips.
class Bundle
{
public:
    Bundle(const ForeignStrands& strands, const CurveTransform& transform, const HeadStrands& onHead,
           const std::vector<std::uint32_t>& members)
    {
        std::vector<float> lengths;
        const std::size_t each = std::max<std::size_t>(members.size() / kMostFollowedStrands, 1);
        std::vector<std::vector<glm::vec3>> fromTip;
        for (std::size_t i = 0; i < members.size(); i += each) {
            const HeadStrand& strand = onHead.strands[members[i]];
            std::vector<glm::vec3>& points = fromTip.emplace_back();
            for (const glm::vec3& point : strands.strand(strand.source))
                points.push_back(transform.toHd(point));
            std::ranges::reverse(points);
            float lengthM = 0.0F;
            for (std::size_t p = 1; p < points.size(); ++p)
                lengthM += glm::distance(points[p - 1], points[p]);
            lengths.push_back(lengthM);
            m_rootsHd.push_back(strand.root.positionHd);
        }
        std::vector<float> sorted = lengths;
        const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(kShortest * static_cast<float>(sorted.size() - 1));
        std::ranges::nth_element(sorted, at);
        m_stepM = *at / static_cast<float>(kSteps - 1);
        m_samplesHd.reserve(fromTip.size() * kSteps);
        for (const std::vector<glm::vec3>& points : fromTip)
            addEven(points);
        m_count = fromTip.size();
    }

    /// What it is; None where it is no braid.
    [[nodiscard]] std::optional<FoundBraid> braid()
    {
        findSkeleton();
        const std::size_t end = endOfBundle();
        FoundBraid braid;
        for (std::size_t step = 1; step <= end; ++step)
            braid.lengthM += glm::distance(m_skeletonHd[step - 1], m_skeletonHd[step]);
        if (static_cast<float>(end) < kLeastBraided * static_cast<float>(kSteps) || braid.lengthM < kShortestBraidM)
            return std::nullopt;
        const auto part = [end](float of) { return static_cast<std::size_t>(of * static_cast<float>(end)); };
        m_first = part(kTuft);
        m_end = end - part(kGathers);
        findAcross();
        return isOf(braid) ? std::optional(std::move(braid)) : std::nullopt;
    }

private:
    [[nodiscard]] const glm::vec3& sample(std::size_t strand, std::size_t step) const
    {
        return m_samplesHd[strand * kSteps + step];
    }
    [[nodiscard]] const glm::vec2& across(std::size_t strand, std::size_t step) const
    {
        return m_across[strand * kSteps + step];
    }

    void addEven(const std::vector<glm::vec3>& points)
    {
        std::size_t segment = 1;
        float passedM = 0.0F;
        for (std::size_t step = 0; step < kSteps; ++step) {
            const float atM = m_stepM * static_cast<float>(step);
            float lengthM = glm::distance(points[segment - 1], points[segment]);
            while (segment + 1 < points.size() && passedM + lengthM < atM) {
                passedM += lengthM;
                ++segment;
                lengthM = glm::distance(points[segment - 1], points[segment]);
            }
            const float along = lengthM > 0.0F ? std::clamp((atM - passedM) / lengthM, 0.0F, 1.0F) : 0.0F;
            m_samplesHd.push_back(glm::mix(points[segment - 1], points[segment], along));
        }
    }

    /// The mean, a little smoothed, and how wide the bundle is.
    void findSkeleton()
    {
        constexpr std::size_t kSmooth = 4;
        std::array<glm::vec3, kSteps> means{};
        for (std::size_t step = 0; step < kSteps; ++step) {
            for (std::size_t i = 0; i < m_count; ++i)
                means[step] += sample(i, step);
            means[step] /= static_cast<float>(m_count);
            float squares = 0.0F;
            for (std::size_t i = 0; i < m_count; ++i) {
                const glm::vec3 off = sample(i, step) - means[step];
                squares += glm::dot(off, off);
            }
            m_widthM[step] = std::sqrt(squares / static_cast<float>(m_count));
        }
        for (std::size_t step = 0; step < kSteps; ++step) {
            const std::size_t reach = std::min({kSmooth, step, kSteps - 1 - step});
            glm::vec3 sum(0.0F);
            for (std::size_t near = step - reach; near <= step + reach; ++near)
                sum += means[near];
            m_skeletonHd[step] = sum / static_cast<float>(2 * reach + 1);
        }
    }

    /// The last step at which the strands are together.
    [[nodiscard]] std::size_t endOfBundle() const
    {
        constexpr std::size_t kUsual = kSteps * 3 / 5;
        std::array<float, kUsual> sorted{};
        std::copy_n(m_widthM.begin(), kUsual, sorted.begin());
        std::ranges::nth_element(sorted, sorted.begin() + kUsual / 2);
        const float usualM = sorted[kUsual / 2];
        std::size_t end = kSteps / 10;
        while (end + 1 < kSteps && m_widthM[end + 1] <= kParts * usualM)
            ++end;
        const auto narrow = std::min_element(m_widthM.begin() + static_cast<std::ptrdiff_t>(end / 2),
                                             m_widthM.begin() + static_cast<std::ptrdiff_t>(end + 1));
        return *narrow < kTied * usualM ? static_cast<std::size_t>(narrow - m_widthM.begin()) : end;
    }

    /// Where strands are across the skeleton, in axes that are carried along it without turning round it.
    void findAcross()
    {
        m_across.assign(m_count * kSteps, glm::vec2(0.0F));
        glm::vec3 x(0.0F);
        for (std::size_t step = m_first; step < m_end; ++step) {
            const glm::vec3 onward = m_skeletonHd[step + 1] - m_skeletonHd[step - 1];
            const glm::vec3 along = onward / std::max(glm::length(onward), 1e-9F);
            if (step == m_first)
                x = std::abs(along.x) < 0.7F ? glm::vec3(1.0F, 0.0F, 0.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
            x -= along * glm::dot(x, along);
            x /= std::max(glm::length(x), 1e-9F);
            const glm::vec3 y = glm::cross(along, x);
            for (std::size_t i = 0; i < m_count; ++i) {
                const glm::vec3 off = sample(i, step) - m_skeletonHd[step];
                m_across[i * kSteps + step] = {glm::dot(off, x), glm::dot(off, y)};
            }
        }
    }

    /// How strands go from side to side: the fraction of their squared distances from the skeleton that this makes, and
    /// its root mean square.
    struct Weave
    {
        float fraction = 0.0F;
        float distanceM = 0.0F;
    };
    [[nodiscard]] Weave weave() const
    {
        double squares = 0.0;
        double within = 0.0;
        const auto steps = static_cast<float>(m_end - m_first);
        for (std::size_t i = 0; i < m_count; ++i) {
            glm::vec2 sum(0.0F);
            float own = 0.0F;
            for (std::size_t step = m_first; step < m_end; ++step) {
                sum += across(i, step);
                own += glm::dot(across(i, step), across(i, step));
            }
            squares += own;
            within += own - glm::dot(sum, sum) / steps;
        }
        return {.fraction = static_cast<float>(within / std::max(squares, 1e-12)),
                .distanceM = static_cast<float>(
                    std::sqrt(squares / (static_cast<double>(m_count) * static_cast<double>(steps))))};
    }

    /// How often a strand goes round the skeleton in the mean, to and fro, and all in all.
    struct Turning
    {
        float anyTurns = 0.0F;
        float steadiness = 0.0F; ///< 0..1.
    };
    [[nodiscard]] Turning turning(float distanceM) const
    {
        float any = 0.0F;
        float one = 0.0F;
        for (std::size_t i = 0; i < m_count; ++i) {
            glm::vec2 last(0.0F);
            float round = 0.0F;
            for (std::size_t step = m_first; step < m_end; ++step) {
                const glm::vec2 at = across(i, step);
                if (glm::length(at) < 0.3F * distanceM)
                    continue;
                if (last != glm::vec2(0.0F)) {
                    const float angle = sim::atan2Rounded(last.x * at.y - last.y * at.x, glm::dot(last, at));
                    any += std::abs(angle);
                    round += angle;
                }
                last = at;
            }
            one += std::abs(round);
        }
        return {.anyTurns = any / glm::two_pi<float>() / static_cast<float>(m_count),
                .steadiness = one / std::max(any, 1e-6F)};
    }

    /// How much more often strands cross the skeleton in the direction in which they do most than in that in which they
    /// do least: in a plait they go up and down twice while they go to and fro.
    [[nodiscard]] float swing(float distanceM) const
    {
        constexpr int kDirections = 12;
        std::size_t least = std::numeric_limits<std::size_t>::max();
        std::size_t most = 0;
        for (int direction = 0; direction < kDirections; ++direction) {
            const float angle = glm::pi<float>() * static_cast<float>(direction) / kDirections;
            const glm::vec2 axis(sim::cosRounded(angle), sim::sinRounded(angle));
            std::size_t count = 0;
            for (std::size_t i = 0; i < m_count; ++i) {
                float side = 0.0F;
                for (std::size_t step = m_first; step < m_end; ++step) {
                    const float off = glm::dot(across(i, step), axis);
                    if (std::abs(off) < 0.2F * distanceM)
                        continue;
                    count += off * side < 0.0F ? 1 : 0;
                    side = off;
                }
            }
            least = std::min(least, count);
            most = std::max(most, count);
        }
        return static_cast<float>(most) / static_cast<float>(std::max<std::size_t>(least, 1));
    }

    /// How far strands stand at two opposite sides: 1 where exactly, 0 where all around.
    [[nodiscard]] float opposition() const
    {
        float sum = 0.0F;
        for (std::size_t step = m_first; step < m_end; ++step) {
            glm::vec2 axis(0.0F);
            float squares = 0.0F;
            for (std::size_t i = 0; i < m_count; ++i) {
                const glm::vec2 at = across(i, step);
                axis += glm::vec2(at.x * at.x - at.y * at.y, 2.0F * at.x * at.y);
                squares += glm::dot(at, at);
            }
            sum += glm::length(axis) / std::max(squares, 1e-12F);
        }
        return sum / static_cast<float>(m_end - m_first);
    }

    [[nodiscard]] float rootsWidthM() const
    {
        glm::vec3 middle(0.0F);
        for (const glm::vec3& root : m_rootsHd)
            middle += root / static_cast<float>(m_count);
        float squares = 0.0F;
        for (const glm::vec3& root : m_rootsHd)
            squares += glm::dot(root - middle, root - middle);
        return std::sqrt(squares / static_cast<float>(m_count));
    }

    /// Fills kind and radius. Mean squares of distances, in units of the radius: of a wisp's path, and of a hair in
    /// its wisp, half its square.
    [[nodiscard]] bool isOf(FoundBraid& braid) const
    {
        const auto [fraction, distanceM] = weave();
        const auto radiusBy = [distance = distanceM](float path, float wisp) {
            return distance / std::sqrt(path + 0.5F * wisp * wisp);
        };
        const float gathered = rootsWidthM() / std::max(distanceM, 1e-6F);
        const auto [anyTurns, steadiness] = turning(distanceM);
        const float agreement = opposition();
        if (kWeaves.has(fraction) && anyTurns >= kLeastTurns && gathered >= kGathered) {
            const float swings = swing(distanceM);
            if (kPlaitSteadiness.has(steadiness) && kPlaitSwing.has(swings) && kPlaitAgreement.has(agreement)) {
                braid.kind = sim::BraidKind::Plait;
                braid.radiusM = radiusBy(1.0F, sim::kWispRadiusFraction);
                return true;
            }
            if (kTwistSteadiness.has(steadiness) && kTwistSwing.has(swings) && kTwistAgreement.has(agreement)) {
                braid.kind = sim::BraidKind::Twist;
                braid.radiusM = radiusBy(sim::kTwistFraction * sim::kTwistFraction, sim::kTwistWispFraction);
                return true;
            }
        }
        const bool isOneWisp = fraction < kLies || (steadiness > kLocSteadiness && agreement < kLocAgreement);
        const auto [thinnest, widest] = std::minmax_element(m_widthM.begin() + static_cast<std::ptrdiff_t>(m_first),
                                                            m_widthM.begin() + static_cast<std::ptrdiff_t>(m_end));
        braid.kind = sim::BraidKind::Loc;
        braid.radiusM = radiusBy(0.0F, sim::kLocWispFraction);
        return isOneWisp && distanceM < kWidestLocM && *widest < kEvenLoc * *thinnest && gathered > kLocGathered;
    }

    float m_stepM = 0.0F;
    std::size_t m_count = 0;
    std::size_t m_first = 0;            ///< Steps at which it is a whole braid,
    std::size_t m_end = 0;              ///< and one behind.
    std::vector<glm::vec3> m_samplesHd; ///< [strands][kSteps].
    std::vector<glm::vec3> m_rootsHd;
    std::vector<glm::vec2> m_across; ///< [strands][kSteps], m.
    std::array<glm::vec3, kSteps> m_skeletonHd{};
    std::array<float, kSteps> m_widthM{};
};

} // namespace

std::optional<FoundBraid> braidOf(const ForeignStrands& strands, const CurveTransform& transform,
                                  const HeadStrands& onHead, const std::vector<std::uint32_t>& members)
{
    std::optional<FoundBraid> braid = Bundle(strands, transform, onHead, members).braid();
    if (braid)
        braid->strands = members;
    return braid;
}

} // namespace hairpaint::model
