// What each hair keeps, and the length map that says so.
#include "model/tools/cutting/group_cut.h"

#include "sim/base/parallel.h"
#include "sim/base/rounded.h"
#include "sim/groom/strand_curve.h"

#include <algorithm>
#include <limits>

namespace hairpaint::model {

namespace {

constexpr std::size_t kCurvesAtOnce = 512;
constexpr float kLeastLengthM = 1e-6F; ///< Least length of hair that can be cut.
constexpr float kLeastSpan = 1e-4F;
constexpr float kStubbleM =
    1e-3F; ///< Well below it a fade's lengths differ almost evenly, so that it may end at nothing.
constexpr float kNowhere = std::numeric_limits<float>::max();

} // namespace

float GradedLengths::lengthM(glm::vec3 rootHd) const
{
    const float whole = fades ? topHd.y - bottomHd.y : glm::distance(topHd, bottomHd);
    const float here = fades ? topHd.y - rootHd.y : glm::distance(topHd, rootHd);
    const float down = here / std::max(whole, kLeastSpan);
    const float part = std::clamp((down - from) / std::max(to - from, kLeastSpan), 0.0F, 1.0F);
    if (!fades || part <= 0.0F || part >= 1.0F)
        return glm::mix(topM, bottomM, part);
    return (topM + kStubbleM) * sim::powRounded((bottomM + kStubbleM) / (topM + kStubbleM), part) - kStubbleM;
}

GroupCut::GroupCut(ToolContext& context, std::shared_ptr<const sim::StrandFrame> frame, const QString& text)
    : m_frame(std::move(frame))
{
    const auto found = std::ranges::find_if(m_frame->groups, [&context](const sim::GroupFrame& one) {
        return one.groom != nullptr && one.groom->groupId == context.target.group && !one.positions.empty();
    });
    if (found == m_frame->groups.end() || found->groom->drawnCount == 0)
        return;
    m_hair = &*found;
    sim::MapRaster length = context.document.resolvedNow(context.target.group, MapKind::Length);
    if (!m_edit.begin(context, text))
        return;
    m_edit.setText(text);
    m_before.emplace(context.document, context.target.group, groom().roots);
    m_lengths.emplace(*m_hair, std::move(length), *m_before);
    m_tips = CutTips::in(m_edit, context);
}

float GroupCut::longestM() const
{
    float longest = 0.0F;
    if (m_hair != nullptr)
        for (std::size_t slot = 0; slot < groom().roots->count(); ++slot)
            if (m_hair->isPositioned(slot))
                longest = std::max(longest, groom().style(slot).lengthM);
    return longest;
}

float GroupCut::lowestHd()
{
    if (m_hair == nullptr)
        return 0.0F;
    measureHeights();
    return *std::ranges::min_element(m_lowestHd);
}

std::pair<glm::vec3, glm::vec3> GroupCut::lowestAndHighestRoot() const
{
    glm::vec3 lowest(0.0F, kNowhere, 0.0F);
    glm::vec3 highest(0.0F, -kNowhere, 0.0F);
    if (m_hair != nullptr)
        for (std::size_t slot = 0; slot < groom().roots->count(); ++slot) {
            if (!m_hair->isPositioned(slot))
                continue;
            const glm::vec3 root = groom().roots->positionHd[slot];
            if (root.y < lowest.y)
                lowest = root;
            if (root.y > highest.y)
                highest = root;
        }
    return {lowest, highest};
}

void GroupCut::trim(float byM, float leastM)
{
    if (byM <= 0.0F)
        return cut({});
    cut([=](std::uint32_t /*slot*/, float lengthM) {
        return std::max(lengthM - byM, std::min(lengthM, leastM)) / lengthM;
    });
}

void GroupCut::grade(const GradedLengths& lengths)
{
    cut([&](std::uint32_t slot, float lengthM) { return lengths.lengthM(groom().roots->positionHd[slot]) / lengthM; });
}

void GroupCut::toLevel(float heightHd)
{
    if (!active())
        return;
    measureHeights();
    std::vector<float> kept(m_lowestHd.size(), 1.0F);
    forEachCurve([&](std::uint32_t slot) { return m_lowestHd[slot] < heightHd; },
                 [&](std::uint32_t slot, std::span<const glm::vec3> points) {
                     const auto below = std::ranges::find_if(points, [=](glm::vec3 p) { return p.y < heightHd; });
                     const auto i = static_cast<std::size_t>(below - points.begin());
                     if (i == points.size())
                         return;
                     float at = 0.0F;
                     if (i > 0)
                         at =
                             static_cast<float>(i - 1) + (points[i - 1].y - heightHd) / (points[i - 1].y - points[i].y);
                     kept[slot] = at / static_cast<float>(points.size() - 1);
                 });
    cut([&](std::uint32_t slot, float lengthM) {
        return kept[slot] < 1.0F ? kept[slot] * groom().style(slot).lengthM / lengthM : 1.0F;
    });
}

void GroupCut::cut(const std::function<float(std::uint32_t slot, float lengthM)>& keptOf)
{
    if (!active())
        return;
    std::vector<StrandCut> cuts;
    for (std::uint32_t slot = 0; keptOf && slot < groom().roots->count(); ++slot) {
        if (!m_hair->isPositioned(slot))
            continue;
        const sim::StrandStyle& style = groom().style(slot);
        const bool isBraided = style.braid != sim::BraidKind::None;
        const float lengthM = isBraided ? style.lengthM : m_before->at(slot);
        if (lengthM < kLeastLengthM)
            continue;
        if (const float kept = keptOf(slot, lengthM); kept < 1.0F)
            cuts.push_back({.slot = slot, .kept = isBraided ? kept : m_before->keptFor(slot, kept * lengthM)});
    }
    m_lengths->cut(cuts, false);
    m_edit.replace(m_lengths->tiles(), [this](int index, const sim::RasterTilePtr& before) {
        MaskTile mask = m_lengths->mask(index);
        keepInside(m_edit.clips(), m_edit.before().tileRect(index), mask);
        return paintTile(m_edit.spec(), before, mask, {.values = m_lengths->values(index)});
    });
    if (m_tips)
        m_tips->show(m_edit, *m_lengths);
}

void GroupCut::measureHeights()
{
    if (!m_lowestHd.empty())
        return;
    m_lowestHd.assign(groom().roots->count(), kNowhere);
    forEachCurve([](std::uint32_t) { return true; },
                 [this](std::uint32_t slot, std::span<const glm::vec3> points) {
                     m_lowestHd[slot] =
                         std::ranges::min_element(points, {}, [](glm::vec3 point) { return point.y; })->y;
                 });
}

void GroupCut::forEachCurve(const std::function<bool(std::uint32_t)>& wanted,
                            const std::function<void(std::uint32_t, std::span<const glm::vec3>)>& visit) const
{
    const sim::CurlSettings* coils = sim::coilsOf(groom().settings);
    const sim::HeadPose& pose = m_frame->pose;
    const glm::quat toHead = glm::conjugate(pose.rotation);
    const std::size_t count = groom().roots->count();
    sim::parallelFor((count + kCurvesAtOnce - 1) / kCurvesAtOnce, 1, [&](std::size_t begin, std::size_t end) {
        std::vector<glm::vec3> nodes(static_cast<std::size_t>(groom().nodes)), points;
        for (std::size_t slot = begin * kCurvesAtOnce; slot < std::min(count, end * kCurvesAtOnce); ++slot) {
            const auto number = static_cast<std::uint32_t>(slot);
            if (!m_hair->isPositioned(slot) || !wanted(number))
                continue;
            groom().blocks().read(m_hair->positions, groom().frameStrand(slot), nodes);
            for (glm::vec3& node : nodes)
                node = toHead * (node - pose.positionWo);
            const sim::StrandStyle& style = groom().style(slot);
            sim::evaluateStrand(nodes, sim::frameTangentHd(groom(), number), style,
                                sim::segmentsOf(style, groom().nodes, coils), points, coils);
            visit(number, points);
        }
    });
}

} // namespace hairpaint::model
