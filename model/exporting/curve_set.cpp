// Which hairs are exported, how many points each has, and what is known of them.
#include "model/exporting/curve_set.h"

#include "model/exporting/curve_simplify.h"
#include "model/values/srgb.h"
#include "sim/base/parallel.h"
#include "sim/groom/even_subset.h"
#include "sim/groom/strand_curve.h"
#include "sim/groom/strand_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hairpaint::model {

namespace {

constexpr std::size_t kMeasuredAtOnce = 1U << 13U;
constexpr std::size_t kMeasuredAPiece = 256;

constexpr std::size_t kChannelValues = 256;
constexpr std::uint32_t kChannelMask = 0xFFU;

/// By the encoded channel.
const std::array<float, kChannelValues>& linearValues()
{
    static const std::array<float, kChannelValues> values = [] {
        std::array<float, kChannelValues> made{};
        for (std::size_t i = 0; i < kChannelValues; ++i)
            made[i] = linearFromSrgb(static_cast<float>(i) / 255.0F);
        return made;
    }();
    return values;
}

struct Bounds
{
    glm::vec3 least{std::numeric_limits<float>::max()};
    glm::vec3 greatest{std::numeric_limits<float>::lowest()};
    void add(const glm::vec3& point)
    {
        least = glm::min(least, point);
        greatest = glm::max(greatest, point);
    }
    void add(const Bounds& other)
    {
        least = glm::min(least, other.least);
        greatest = glm::max(greatest, other.greatest);
    }
};

std::size_t drawnIn(const std::vector<std::shared_ptr<const sim::Groom>>& grooms)
{
    std::size_t count = 0;
    for (const std::shared_ptr<const sim::Groom>& groom : grooms)
        count += groom->drawnCount;
    return count;
}

} // namespace

std::optional<CurveSet> CurveSet::of(std::shared_ptr<const sim::StrandFrame> frame, const CurveOptions& options,
                                     const Progress& progress)
{
    CurveSet set;
    set.m_frame = std::move(frame);
    set.addCurves(options);
    if (!set.measure(options.toleranceM, progress))
        return std::nullopt;
    set.linkGroups();
    return set;
}

void CurveSet::addCurves(const CurveOptions& options)
{
    std::uint32_t firstId = 0;
    for (std::size_t i = 0; i < m_frame->groups.size(); ++i) {
        const std::shared_ptr<const sim::Groom>& groom = m_frame->groups[i].groom;
        const auto wanted = std::ranges::find(options.groups, groom->groupId, &CurveGroupName::id);
        if (wanted == options.groups.end() || !groom->visible || groom->roots == nullptr)
            continue;
        m_groups.push_back({.id = groom->groupId, .name = wanted->name, .frameGroup = i, .firstId = firstId});
        m_grooms.push_back(groom);
        firstId += static_cast<std::uint32_t>(groom->roots->count());
    }
    const std::size_t all = drawnIn(m_grooms);
    if (options.hairs)
        m_grooms = sim::evenSubset(m_grooms, *options.hairs);
    const std::size_t left = drawnIn(m_grooms);
    m_thinning = left > 0 ? static_cast<float>(all) / static_cast<float>(left) : 1.0F;

    m_curves.reserve(left);
    for (std::uint32_t group = 0; group < m_groups.size(); ++group) {
        const sim::Groom& groom = *m_grooms[group];
        const std::size_t basisCount = groom.roots->basisSlot.size();
        for (const std::uint32_t slot : groom.roots->slotOfRank) {
            if (!groom.isDrawn(slot))
                continue;
            const int segments =
                std::max(1, sim::segmentsOf(groom.style(slot), groom.nodes, sim::coilsOf(groom.settings)));
            m_curves.push_back({.group = group,
                                .slot = slot,
                                .segments = static_cast<std::uint32_t>(segments),
                                .points = static_cast<std::uint32_t>(segments) + 1U});
            if (groom.roots->rankOfSlot[slot] < basisCount)
                m_guides.push_back({.group = group,
                                    .slot = slot,
                                    .segments = static_cast<std::uint32_t>(groom.nodes) - 1U,
                                    .points = static_cast<std::uint32_t>(groom.nodes)});
        }
    }
}

bool CurveSet::measure(float toleranceM, const Progress& progress)
{
    std::vector<Bounds> bounds(m_groups.size());
    for (std::size_t first = 0; first < m_curves.size(); first += kMeasuredAtOnce) {
        if (progress && !progress(static_cast<double>(first) / static_cast<double>(m_curves.size())))
            return false;
        const std::size_t count = std::min(kMeasuredAtOnce, m_curves.size() - first);
        const std::size_t pieces = (count + kMeasuredAPiece - 1) / kMeasuredAPiece;
        std::vector<std::vector<std::uint16_t>> kept(pieces);
        std::vector<std::vector<Bounds>> found(pieces, std::vector<Bounds>(m_groups.size()));
        sim::parallelFor(pieces, 1, [&](std::size_t begin, std::size_t end) {
            CurveScratch scratch;
            std::vector<std::uint16_t> indices;
            for (std::size_t piece = begin; piece < end; ++piece) {
                const std::size_t last = std::min(count, (piece + 1) * kMeasuredAPiece);
                for (std::size_t i = piece * kMeasuredAPiece; i < last; ++i) {
                    Curve& curve = m_curves[first + i];
                    evaluate(curve, scratch);
                    Bounds& box = found[piece][curve.group];
                    std::ranges::for_each(scratch.skeletonWo, [&box](const glm::vec3& point) { box.add(point); });
                    std::ranges::for_each(scratch.evenWo, [&box](const glm::vec3& point) { box.add(point); });
                    if (toleranceM <= 0.0F)
                        continue;
                    keptPoints(scratch.evenWo, toleranceM, indices);
                    keepTaper(curve, indices);
                    curve.points = static_cast<std::uint32_t>(indices.size());
                    kept[piece].insert(kept[piece].end(), indices.begin(), indices.end());
                }
            }
        });
        for (std::size_t piece = 0; piece < pieces; ++piece) {
            m_kept.insert(m_kept.end(), kept[piece].begin(), kept[piece].end());
            for (std::size_t group = 0; group < m_groups.size(); ++group)
                bounds[group].add(found[piece][group]);
        }
    }
    for (std::size_t group = 0; group < m_groups.size(); ++group) {
        m_groups[group].leastWo = bounds[group].least;
        m_groups[group].greatestWo = bounds[group].greatest;
    }
    return !progress || progress(1.0);
}

void CurveSet::keepTaper(const Curve& curve, std::vector<std::uint16_t>& kept) const
{
    const float perTaper = sim::perTaperOf(material(curve), groom(curve).style(curve.slot).lengthM);
    // Between the first and the last, which are kept; the first of a hair without a taper.
    const auto begins = static_cast<std::uint16_t>(static_cast<float>(curve.segments) * (1.0F - 1.0F / perTaper));
    if (const auto at = std::ranges::lower_bound(kept, begins); *at != begins)
        kept.insert(at, begins);
}

void CurveSet::linkGroups()
{
    const auto number = [](std::vector<Curve>& curves) {
        std::uint64_t points = 0;
        for (Curve& curve : curves) {
            curve.firstPoint = points;
            points = curve.endPoint();
        }
    };
    number(m_curves);
    number(m_guides);
    for (std::uint32_t group = 0; group < m_groups.size(); ++group) {
        const auto own = [group](const std::vector<Curve>& curves) {
            return std::span<const Curve>(std::ranges::lower_bound(curves, group, {}, &Curve::group),
                                          std::ranges::upper_bound(curves, group, {}, &Curve::group));
        };
        CurveGroup& target = m_groups[group];
        target.curves = own(m_curves);
        target.guides = own(m_guides);
        glm::dvec3 sum(0.0);
        for (const Curve& curve : target.curves)
            sum += glm::dvec3(groom(curve).blocks().node(positions(curve), groom(curve).frameStrand(curve.slot), 0));
        if (!target.curves.empty())
            target.middleWo = glm::vec3(sum / static_cast<double>(target.curves.size()));
    }
}

void CurveSet::evaluate(const Curve& curve, CurveScratch& scratch) const
{
    const sim::Groom& groom = this->groom(curve);
    scratch.skeletonWo.resize(static_cast<std::size_t>(groom.nodes));
    groom.blocks().read(positions(curve), groom.frameStrand(curve.slot), scratch.skeletonWo);
    const glm::vec3 tangentWo = m_frame->pose.rotation * sim::frameTangentHd(groom, curve.slot);
    sim::evaluateStrand(scratch.skeletonWo, tangentWo, groom.style(curve.slot), static_cast<int>(curve.segments),
                        scratch.evenWo, sim::coilsOf(groom.settings));
}

std::span<const glm::vec3> CurveSet::points(const Curve& curve, CurveScratch& scratch) const
{
    evaluate(curve, scratch);
    if (m_kept.empty())
        return scratch.evenWo;
    scratch.keptWo.clear();
    scratch.keptWo.reserve(curve.points);
    for (std::uint32_t i = 0; i < curve.points; ++i)
        scratch.keptWo.push_back(scratch.evenWo[m_kept[curve.firstPoint + i]]);
    return scratch.keptWo;
}

std::span<const glm::vec3> CurveSet::guidePoints(const Curve& guide, CurveScratch& scratch) const
{
    const sim::Groom& groom = this->groom(guide);
    scratch.skeletonWo.resize(static_cast<std::size_t>(groom.nodes));
    groom.blocks().read(positions(guide), groom.frameStrand(guide.slot), scratch.skeletonWo);
    return scratch.skeletonWo;
}

float CurveSet::fraction(const Curve& curve, std::uint32_t i) const
{
    const std::uint32_t at = m_kept.empty() ? i : m_kept[curve.firstPoint + i];
    return static_cast<float>(at) / static_cast<float>(curve.segments);
}

float CurveSet::opacity(const Curve& curve, float fraction) const
{
    const sim::StrandMaterial& material = this->material(curve);
    return sim::thinnedAt(material, sim::perTaperOf(material, groom(curve).style(curve.slot).lengthM), fraction);
}

float CurveSet::width(const Curve& curve, float fraction) const
{
    return groom(curve).style(curve.slot).width * material(curve).widthM * opacity(curve, fraction);
}

glm::vec3 CurveSet::linearColour(const Curve& curve, float fraction) const
{
    const sim::StrandStyle& style = groom(curve).style(curve.slot);
    const std::array<float, kChannelValues>& linear = linearValues();
    const float tip = sim::tipMixOf(material(curve), style.tipStart).at(fraction);
    const auto channel = [&](unsigned shift) {
        return glm::mix(linear[(style.rootColour >> shift) & kChannelMask],
                        linear[(style.tipColour >> shift) & kChannelMask], tip);
    };
    return {channel(0), channel(8), channel(16)};
}

glm::vec3 CurveSet::encodedColour(const Curve& curve, float fraction) const
{
    const sim::StrandStyle& style = groom(curve).style(curve.slot);
    const glm::vec3 linear = linearColour(curve, fraction);
    const auto channel = [&](unsigned shift, float mixed) {
        const std::uint32_t root = (style.rootColour >> shift) & kChannelMask;
        const std::uint32_t tip = (style.tipColour >> shift) & kChannelMask;
        return root == tip ? static_cast<float>(root) / 255.0F : srgbFromLinear(mixed);
    };
    return {channel(0, linear.r), channel(8, linear.g), channel(16, linear.b)};
}

float CurveSet::lightness(const Curve& curve) const
{
    constexpr float kStops = 3.0F; // As the hair is drawn on the screen.
    return std::exp2(kStops * groom(curve).style(curve.slot).variation * material(curve).colourVariation);
}

float CurveSet::roughness(const Curve& curve) const
{
    return sim::roughnessOf(material(curve), groom(curve).style(curve.slot).gloss);
}

std::uint32_t CurveSet::id(const Curve& curve) const
{
    return m_groups[curve.group].firstId + groom(curve).roots->rankOfSlot[curve.slot];
}

glm::vec2 CurveSet::rootUv(const Curve& curve) const
{
    return groom(curve).roots->uv[curve.slot];
}

const sim::StrandMaterial& CurveSet::material(const Curve& curve) const
{
    return groom(curve).settings.material;
}

const sim::PhysicsSettings& CurveSet::physics(std::size_t group) const
{
    return m_grooms[group]->settings.physics;
}

const sim::RootSet& CurveSet::roots(const Curve& curve) const
{
    return *groom(curve).roots;
}

const sim::Skin* CurveSet::skin() const
{
    return m_grooms.empty() ? nullptr : m_grooms.front()->roots->skin.get();
}

} // namespace hairpaint::model
