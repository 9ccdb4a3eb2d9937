// A rasteriser of lines with width, with a depth of its own for every texel of the patch.
#include "model/cards/card_baker.h"

#include "model/values/srgb.h"
#include "sim/base/deterministic.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr float kLeastWidthPx = 1.5F; ///< Thinner lines would be alpha alone.
/// Cards are as dense as their hairs times this, since where they lie over each other gaps lie over gaps.
constexpr double kOverlap = 1.3;
constexpr float kChannelMost = 255.0F;

std::uint8_t channelOf(float value)
{
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * kChannelMost));
}

glm::u8vec3 vectorByte(const glm::vec3& v)
{
    return {channelOf(0.5F + 0.5F * v.x), channelOf(0.5F + 0.5F * v.y), channelOf(0.5F + 0.5F * v.z)};
}

/// sRGB as encoded, with the hair's own lightness.
glm::vec3 shownColour(const CurveSet& set, const Curve& curve, float fraction)
{
    const glm::vec3 linear = glm::min(set.lightness(curve) * set.linearColour(curve, fraction), glm::vec3(1.0F));
    return {srgbFromLinear(linear.r), srgbFromLinear(linear.g), srgbFromLinear(linear.b)};
}

/// A hair's point on the patch.
struct LinePoint
{
    glm::vec2 tx{0.0F}; ///< Texels from the patch's corner.
    float heightM = 0.0F;
    float fraction = 0.0F; ///< 0 at the root.
    float openness = 1.0F;
    glm::vec3 colour{0.0F};    ///< sRGB as encoded.
    glm::vec3 direction{0.0F}; ///< To the next point in the card's space, right, up, out; unit.
};

class PatchPainter
{
public:
    PatchPainter(const AtlasPatch& patch, CardImages& images, float depthRangeM)
        : m_patch(patch), m_images(images), m_depthRangeM(depthRangeM),
          m_heights(static_cast<std::size_t>(patch.width) * static_cast<std::size_t>(patch.height))
    {}

    void line(const LinePoint& from, const LinePoint& to, float widthPx, std::uint8_t id)
    {
        const float reach = 0.5F * widthPx + 0.5F;
        const glm::ivec2 least = glm::max(glm::ivec2(glm::floor(glm::min(from.tx, to.tx) - reach)), glm::ivec2(0));
        const glm::ivec2 most = glm::min(glm::ivec2(glm::ceil(glm::max(from.tx, to.tx) + reach)),
                                         glm::ivec2(m_patch.width, m_patch.height) - 1);
        const glm::vec2 along = to.tx - from.tx;
        const float square = glm::dot(along, along);
        const float inverse = square > 0.0F ? 1.0F / square : 0.0F;
        const glm::vec2 right =
            square > 0.0F ? glm::vec2(-along.y, along.x) / std::sqrt(square) : glm::vec2(1.0F, 0.0F);
        for (int y = least.y; y <= most.y; ++y)
            for (int x = least.x; x <= most.x; ++x) {
                const glm::vec2 away = glm::vec2(x, y) + 0.5F - from.tx;
                const float part = glm::clamp(glm::dot(away, along) * inverse, 0.0F, 1.0F);
                const float distance = glm::distance(away, part * along);
                const float cover = std::clamp(reach - distance, 0.0F, 1.0F);
                if (cover > 0.0F)
                    texel(x, y, cover, part, glm::dot(away, right) / reach, from, to, right, id);
            }
    }

private:
    void texel(int x, int y, float cover, float part, float aside, const LinePoint& from, const LinePoint& to,
               const glm::vec2& right, std::uint8_t id)
    {
        const std::size_t index = m_images.indexOf(m_patch.x + x, m_patch.y + y);
        float& height = m_heights[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_patch.width) +
                                  static_cast<std::size_t>(x)];
        const float own = glm::mix(from.heightM, to.heightM, part);
        const std::uint8_t alpha = channelOf(cover);
        std::uint8_t& before = m_images.alpha()[index];
        constexpr std::uint8_t kSolid = 128;
        const bool inFront = alpha >= kSolid ? before < kSolid || own > height : alpha > before;
        before = std::max(before, alpha);
        if (!inFront)
            return;
        height = own;
        // A hair is round: its normal leans to its sides. Rows count down, up is green.
        constexpr float kRound = 0.7F;
        const float lean = kRound * glm::clamp(aside, -1.0F, 1.0F);
        const glm::vec3 normal(lean * right.x, -lean * right.y, std::sqrt(1.0F - lean * lean));
        const float depth = m_depthRangeM > 0.0F ? 0.5F + 0.5F * own / m_depthRangeM : 0.5F;
        m_images.texels()[index] = {.colour = {channelOf(glm::mix(from.colour.r, to.colour.r, part)),
                                               channelOf(glm::mix(from.colour.g, to.colour.g, part)),
                                               channelOf(glm::mix(from.colour.b, to.colour.b, part))},
                                    .normal = vectorByte(normal),
                                    .flow = vectorByte(from.direction),
                                    .rootToTip = channelOf(glm::mix(from.fraction, to.fraction, part)),
                                    .strandId = id,
                                    .occlusion = channelOf(glm::mix(from.openness, to.openness, part)),
                                    .depth = channelOf(depth)};
    }

    const AtlasPatch& m_patch;
    CardImages& m_images;
    float m_depthRangeM;
    std::vector<float> m_heights;
};

/// How many lines of which width cover a patch as a strip's hairs do.
struct LineCount
{
    std::size_t count = 0;
    float widthPx = kLeastWidthPx;
};

LineCount linesFor(const SampledHair& hair, const CardStrip& strip, const AtlasPatch& patch)
{
    double areaM2 = 0.0;
    double lengthM = 0.0;
    for (const std::uint32_t i : strip.hairs) {
        areaM2 += static_cast<double>(hair.lengthM[i]) * static_cast<double>(hair.widthM[i]);
        lengthM += static_cast<double>(hair.lengthM[i]);
    }
    const auto cardM2 = static_cast<double>(strip.areaM2());
    if (areaM2 <= 0.0 || lengthM <= 0.0 || cardM2 <= 0.0)
        return {.count = strip.hairs.size()};
    // Lines at least kLeastWidthPx wide, as many as have the hairs' area: where hairs overlap, each counts.
    const double meanLengthPx = lengthM / static_cast<double>(strip.hairs.size()) /
                                static_cast<double>(strip.lengthM()) * static_cast<double>(patch.height);
    const double wantedPx =
        kOverlap * areaM2 / cardM2 * static_cast<double>(patch.width) * static_cast<double>(patch.height);
    const double count = std::max(wantedPx / (meanLengthPx * static_cast<double>(kLeastWidthPx)), 1.0);
    if (count <= static_cast<double>(strip.hairs.size()))
        return {.count = static_cast<std::size_t>(std::lround(count))};
    return {.count = strip.hairs.size(),
            .widthPx = static_cast<float>(wantedPx / (meanLengthPx * static_cast<double>(strip.hairs.size())))};
}

/// How many lines of which width cover as much of the cap as its hairs do when they are seen from their side: from
/// above those that stand up would be dots.
LineCount linesOn(const ScalpCap& cap, const SampledHair& hair, const glm::vec2& metresPerTexel)
{
    double areaM2 = 0.0;
    double lengthPx = 0.0;
    for (const std::uint32_t i : cap.hairs) {
        areaM2 += static_cast<double>(hair.lengthM[i]) * static_cast<double>(hair.widthM[i]);
        const auto samples = hair.samples(i);
        lengthPx +=
            static_cast<double>(glm::length((cap.flat(samples.back()) - cap.flat(samples.front())) / metresPerTexel));
    }
    const auto hairs = static_cast<double>(cap.hairs.size());
    const double lengthEach = lengthPx / hairs;
    const double areaEach = kOverlap * areaM2 / hairs / static_cast<double>(metresPerTexel.x * metresPerTexel.y);
    // A line covers its length and half a width more on both sides.
    const double width = 0.5 * (std::sqrt(lengthEach * lengthEach + 4.0 * areaEach) - lengthEach);
    const auto least = static_cast<double>(kLeastWidthPx);
    if (width >= least)
        return {.count = cap.hairs.size(), .widthPx = static_cast<float>(width)};
    return {.count = static_cast<std::size_t>(std::ceil(hairs * areaEach / (least * (lengthEach + least))))};
}

/// Chooses `count` of the hairs by chance, the same ones each time, each with the number that it was drawn by.
std::vector<std::pair<std::uint64_t, std::uint32_t>> chosenOf(const CurveSet& set, const SampledHair& hair,
                                                              std::span<const std::uint32_t> hairs, std::size_t count)
{
    constexpr std::uint64_t kChance = 0x63617264; // "card"
    std::vector<std::pair<std::uint64_t, std::uint32_t>> chosen;
    chosen.reserve(hairs.size());
    for (const std::uint32_t i : hairs)
        chosen.emplace_back(sim::hash64(kChance, set.id(set.curves()[hair.curve[i]])), i);
    std::ranges::sort(chosen);
    chosen.resize(std::min(chosen.size(), count));
    return chosen;
}

/// Where a curve's points lie on a patch: made anew for each curve, called with each of its points, root first.
template<typename Project>
void drawHairs(const CurveSet& set, const SampledHair& hair, const HairField& field,
               std::span<const std::uint32_t> hairs, const LineCount& lines, const glm::vec2& metresPerTexel,
               const Project& project, PatchPainter& painter)
{
    CurveScratch scratch;
    std::vector<LinePoint> points;
    const auto chosen = chosenOf(set, hair, hairs, lines.count);
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        const auto& [hash, i] = chosen[k];
        const Curve& curve = set.curves()[hair.curve[i]];
        const std::span<const glm::vec3> own = set.points(curve, scratch);
        // Where hair thins out toward its tip, so many lines end.
        const float rootOpacity = set.opacity(curve, 0.0F);
        const float endsBelow = rootOpacity * (static_cast<float>(k) + 0.5F) / static_cast<float>(chosen.size());
        auto toLine = project();
        points.clear();
        points.reserve(own.size());
        for (std::uint32_t p = 0; p < own.size(); ++p) {
            const float fraction = set.fraction(curve, p);
            if (p > 1 && set.opacity(curve, fraction) < endsBelow)
                break;
            LinePoint point = toLine(own[p]);
            point.fraction = fraction;
            point.openness = std::sqrt(field.openness(own[p]));
            point.colour = shownColour(set, curve, fraction);
            points.push_back(point);
        }
        const std::uint8_t id = channelOf(sim::unitFloat(sim::hash64(hash, 1)));
        for (std::size_t p = 0; p + 1 < points.size(); ++p) {
            const glm::vec2 step = (points[p + 1].tx - points[p].tx) * metresPerTexel;
            const glm::vec3 direction(step.x, -step.y, points[p + 1].heightM - points[p].heightM);
            const float length = glm::length(direction);
            points[p].direction = length > 0.0F ? direction / length : glm::vec3(0.0F, -1.0F, 0.0F);
            painter.line(points[p], points[p + 1], lines.widthPx, id);
        }
    }
}

} // namespace

void bakeCard(const CurveSet& set, const SampledHair& hair, const HairField& field, const CardStrip& strip,
              const AtlasPatch& patch, CardImages& images)
{
    PatchPainter painter(patch, images, 0.5F * strip.greatestWidthM());
    const glm::vec2 sizePx(patch.width, patch.height);
    const auto project = [&] {
        return [&, projector = StripProjector(strip)](const glm::vec3& pointWo) mutable {
            const StripPoint point = projector.next(pointWo);
            return LinePoint{.tx = sizePx * glm::vec2(0.5F + 0.5F * point.across, point.alongM / strip.lengthM()),
                             .heightM = point.heightM};
        };
    };
    const glm::vec2 metresPerTexel = glm::vec2(strip.areaM2() / strip.lengthM(), strip.lengthM()) / sizePx;
    drawHairs(set, hair, field, strip.hairs, linesFor(hair, strip, patch), metresPerTexel, project, painter);
}

void bakeCap(const CurveSet& set, const SampledHair& hair, const HairField& field, const ScalpCap& cap,
             const AtlasPatch& patch, CardImages& images)
{
    PatchPainter painter(patch, images, kShortestOnStripsM);
    const glm::vec2 sizePx(patch.width, patch.height);
    const auto project = [&] {
        return [&](const glm::vec3& pointWo) {
            return LinePoint{.tx = sizePx * cap.uv(cap.flat(pointWo)),
                             .heightM = glm::distance(pointWo, cap.middleWo) - cap.radiusM};
        };
    };
    const glm::vec2 metresPerTexel = (cap.greatestM - cap.leastM) / sizePx;
    drawHairs(set, hair, field, cap.hairs, linesOn(cap, hair, metresPerTexel), metresPerTexel, project, painter);
}

} // namespace hairpaint::model
