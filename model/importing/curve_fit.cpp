// Told, tried, or fitted.
#include "model/importing/curve_fit.h"

#include "sim/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hairpaint::model {

namespace {

constexpr std::size_t kMostTried = 2000; ///< Roots.
constexpr float kOnSkinM = 0.015F;       ///< So near to it half of the roots must be.
constexpr std::array<float, 5> kUsualUnits{1.0F, 0.01F, 0.001F, 0.0254F, 0.1F};
constexpr int kFitRounds = 24;
constexpr std::size_t kMostSampled = 400; ///< Strands.

/// From a space with z up, the face toward -y, to ours.
glm::mat3 uprightFrom(UpAxis axis)
{
    if (axis == UpAxis::Y)
        return glm::mat3(1.0F);
    return {{1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -1.0F}, {0.0F, 1.0F, 0.0F}};
}

glm::mat3 quarterTurns(int count)
{
    constexpr std::array<float, 4> kCosines{1.0F, 0.0F, -1.0F, 0.0F};
    constexpr std::array<float, 4> kSines{0.0F, 1.0F, 0.0F, -1.0F};
    const auto i = static_cast<std::size_t>(count % 4);
    return {{kCosines[i], 0.0F, -kSines[i]}, {0.0F, 1.0F, 0.0F}, {kSines[i], 0.0F, kCosines[i]}};
}

std::size_t countOf(const ForeignCurves& curves)
{
    std::size_t count = 0;
    for (const ForeignStrands& strands : curves.groups)
        count += strands.count();
    return count;
}

/// Tries transforms of some of the roots.
class RootFit
{
public:
    RootFit(const ForeignCurves& curves, const sim::Skin& skin, bool ofTips = false) : m_skin(skin)
    {
        const std::size_t step = std::max<std::size_t>(countOf(curves) / kMostTried, 1);
        std::size_t number = 0;
        for (const ForeignStrands& strands : curves.groups)
            for (std::size_t i = 0; i < strands.count(); ++i)
                if (number++ % step == 0)
                    m_roots.push_back(ofTips ? strands.strand(i).back() : strands.strand(i).front());
    }

    [[nodiscard]] bool empty() const { return m_roots.empty(); }

    /// Half of the roots are no further from the skin.
    [[nodiscard]] float distanceM(const CurveTransform& transform) const
    {
        std::vector<float> distances(m_roots.size());
        sim::parallelFor(m_roots.size(), 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const glm::vec3 positionHd = transform.toHd(m_roots[i]);
                distances[i] = glm::distance(m_skin.nearest(positionHd).positionHd, positionHd);
            }
        });
        const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
        std::ranges::nth_element(distances, middle);
        return *middle;
    }

    /// Scaled and moved until the roots lie as near to the skin as they come: each round brings them to the nearest
    /// points (iterative closest points, Besl and McKay 1992, with a scale).
    [[nodiscard]] CurveTransform fitted(const glm::mat3& rotation) const
    {
        CurveTransform transform = roughly(rotation);
        std::vector<glm::vec3> nearest(m_roots.size());
        for (int round = 0; round < kFitRounds; ++round) {
            sim::parallelFor(m_roots.size(), 64, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                    nearest[i] = m_skin.nearest(transform.toHd(m_roots[i])).positionHd;
            });
            glm::vec3 middle(0.0F);
            glm::vec3 middleHd(0.0F);
            for (std::size_t i = 0; i < m_roots.size(); ++i) {
                middle += rotation * m_roots[i] / static_cast<float>(m_roots.size());
                middleHd += nearest[i] / static_cast<float>(m_roots.size());
            }
            float along = 0.0F;
            float square = 0.0F;
            for (std::size_t i = 0; i < m_roots.size(); ++i) {
                const glm::vec3 offset = rotation * m_roots[i] - middle;
                along += glm::dot(offset, nearest[i] - middleHd);
                square += glm::dot(offset, offset);
            }
            if (!(along > 0.0F) || !(square > 0.0F))
                break;
            transform.scaleM = along / square;
            transform.offsetHd = middleHd - middle * transform.scaleM;
        }
        return transform;
    }

private:
    /// The roots' box, as wide as a scalp, its top where the head's is.
    [[nodiscard]] CurveTransform roughly(const glm::mat3& rotation) const
    {
        glm::vec3 least(std::numeric_limits<float>::max());
        glm::vec3 greatest(std::numeric_limits<float>::lowest());
        for (const glm::vec3& root : m_roots) {
            least = glm::min(least, rotation * root);
            greatest = glm::max(greatest, rotation * root);
        }
        constexpr float kScalpWidthM = 0.155F;
        float topM = std::numeric_limits<float>::lowest();
        glm::vec3 top(0.0F);
        for (const glm::vec3& positionHd : m_skin.mesh().positionsHd)
            if (positionHd.y > topM) {
                topM = positionHd.y;
                top = positionHd;
            }
        CurveTransform transform{.rotation = rotation, .scaleM = kScalpWidthM / std::max(greatest.x - least.x, 1e-6F)};
        const glm::vec3 middle = 0.5F * (least + greatest);
        transform.offsetHd =
            glm::vec3(top.x, topM, top.z) - glm::vec3(middle.x, greatest.y, middle.z) * transform.scaleM;
        return transform;
    }

    const sim::Skin& m_skin;
    std::vector<glm::vec3> m_roots;
};

/// In which curves may be told: as the user says, else as the file does, else all that are usual.
struct Spaces
{
    Spaces(const ForeignCurves& curves, const CurveSpaceChoice& choice)
    {
        if (const std::optional<UpAxis> axis = choice.upAxis ? choice.upAxis : curves.upAxis)
            axes = {*axis};
        if (const std::optional<float> unit = choice.metresPerUnit ? choice.metresPerUnit : curves.metresPerUnit)
            units = {*unit};
    }

    std::vector<UpAxis> axes{UpAxis::Y, UpAxis::Z};
    std::vector<float> units{kUsualUnits.begin(), kUsualUnits.end()}; ///< Metres.
};

} // namespace

std::optional<CurveTransform> fitCurves(const ForeignCurves& curves, const CurveSpaceChoice& choice,
                                        const sim::Skin& skin)
{
    const RootFit fit(curves, skin);
    if (fit.empty())
        return std::nullopt;
    const Spaces spaces(curves, choice);
    float leastM = kOnSkinM;
    std::optional<CurveTransform> best;
    const auto take = [&](const CurveTransform& transform) {
        const float distanceM = fit.distanceM(transform);
        if (distanceM < leastM) {
            leastM = distanceM;
            best = transform;
        }
    };
    for (const UpAxis up : spaces.axes)
        for (const float metres : spaces.units)
            take({.rotation = uprightFrom(up), .scaleM = metres});
    if (best || choice.metresPerUnit) // What the user tells counts.
        return best;
    for (const UpAxis up : spaces.axes)
        for (int turns = 0; turns < 4; ++turns)
            take(fit.fitted(quarterTurns(turns) * uprightFrom(up)));
    return best;
}

void turnTipFirst(ForeignCurves& curves, const CurveSpaceChoice& choice, const sim::Skin& skin)
{
    const RootFit roots(curves, skin);
    const RootFit tips(curves, skin, true);
    if (roots.empty())
        return;
    const Spaces spaces(curves, choice);
    float rootsM = std::numeric_limits<float>::max();
    float tipsM = std::numeric_limits<float>::max();
    for (const UpAxis up : spaces.axes)
        for (const float metres : spaces.units) {
            const CurveTransform transform{.rotation = uprightFrom(up), .scaleM = metres};
            rootsM = std::min(rootsM, roots.distanceM(transform));
            tipsM = std::min(tipsM, tips.distanceM(transform));
        }
    constexpr float kClearly = 0.25F;
    if (tipsM >= kOnSkinM || tipsM >= kClearly * rootsM)
        return;
    for (ForeignStrands& strands : curves.groups) {
        std::size_t begin = 0;
        for (std::size_t i = 0; i < strands.count(); ++i) {
            std::reverse(strands.points.begin() + static_cast<std::ptrdiff_t>(begin),
                         strands.points.begin() + static_cast<std::ptrdiff_t>(strands.ends[i]));
            begin = strands.ends[i];
            std::swap(strands.looks[i].rootWidth, strands.looks[i].tipWidth);
            std::swap(strands.looks[i].rootColour, strands.looks[i].tipColour);
        }
    }
}

ForeignCurves sampledCurves(const ForeignCurves& curves)
{
    ForeignCurves sample;
    sample.metresPerUnit = curves.metresPerUnit;
    sample.upAxis = curves.upAxis;
    const std::size_t step = std::max<std::size_t>((countOf(curves) + kMostSampled - 1) / kMostSampled, 1);
    std::size_t number = 0;
    for (const ForeignStrands& strands : curves.groups) {
        ForeignStrands& some = sample.groups.emplace_back();
        for (std::size_t i = 0; i < strands.count(); ++i) {
            if (number++ % step != 0)
                continue;
            const std::span<const glm::vec3> points = strands.strand(i);
            some.points.insert(some.points.end(), points.begin(), points.end());
            some.ends.push_back(static_cast<std::uint32_t>(some.points.size()));
            some.looks.push_back(strands.looks[i]);
        }
    }
    return sample;
}

CurvePlacement placementOf(const ForeignCurves& curves, const CurveSpaceChoice& choice, const sim::Skin& skin)
{
    ForeignCurves turned = curves;
    turnTipFirst(turned, choice, skin);
    CurvePlacement placement;
    if (const std::optional<CurveTransform> fitted = fitCurves(turned, choice, skin)) {
        placement = {.transform = *fitted, .fits = true};
    } else {
        placement.transform.rotation = uprightFrom(choice.upAxis.value_or(curves.upAxis.value_or(UpAxis::Y)));
        placement.transform.scaleM = choice.metresPerUnit.value_or(curves.metresPerUnit.value_or(1.0F));
    }
    if (const RootFit fit(turned, skin); !fit.empty())
        placement.rootsOffM = fit.distanceM(placement.transform);
    return placement;
}

} // namespace hairpaint::model
