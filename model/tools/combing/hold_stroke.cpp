// Dabs on two maps, whose sizes may differ.
#include "model/tools/combing/hold_stroke.h"

#include "model/maps/compositor.h"
#include "model/tools/combing/hold.h"
#include "model/values/texel_math.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

constexpr float kHoldSpacing = 1.0F / 8.0F; ///< Distance between dabs, as a fraction of their diameter.
constexpr float kHoldLeastStepTx = 0.5F;
constexpr std::size_t kFurtherHairs = 1000; ///< Looking up so many takes less than a frame.

} // namespace

bool HoldStroke::begin(const ToolContext& context, const QString& step)
{
    const Head* head = context.document.project().head.get();
    if (context.hair == nullptr || head == nullptr || head->skin == nullptr)
        return false;
    const auto group = std::ranges::find_if(context.hair->groups, [&context](const sim::GroupFrame& one) {
        return one.groom != nullptr && one.groom->groupId == context.target.group;
    });
    if (group == context.hair->groups.end() || group->groom->roots->skin != head->skin)
        return false;
    const std::vector<LyingHair> hairs = lyingHairs(*group, context.hair->pose, context.hair->asleep);
    std::shared_ptr<const sim::TiledRaster> shownGel = context.document.resolvedNow(context.target.group, MapKind::Gel);
    if (hairs.empty() || !m_edit.begin(context, {}))
        return false;
    m_edit.setText(step);
    m_gel = m_edit.also(context, context.layer(MapKind::Gel));
    m_field.emplace(hairs, context.hair->asleep
                               ? std::vector<LyingHair>()
                               : hairsFurtherOn(*group, context.hair->pose, head->distances.get(), kFurtherHairs));
    m_shownGel = std::move(shownGel);
    m_masks.emplace(m_edit.size());
    if (m_gel)
        m_gelMasks.emplace(m_edit.size(*m_gel));
    m_path.emplace(head->skin.get(), context.settings.brushSizeM * kHoldSpacing,
                   kHoldLeastStepTx / static_cast<float>(m_edit.size()));
    m_roots.emplace(context, m_edit.size());
    return true;
}

void HoldStroke::moveTo(const ToolEvent& event, const ToolContext& context)
{
    if (event.hair) {
        m_path->lift();
        const RootDabs::Shape shape{.sizeM = context.settings.brushSizeM, .hardness = context.settings.hardness};
        for (const RootDab& one : m_roots->moveTo(*event.hair, context, shape, true)) {
            cover(one.dab);
            if (one.twin)
                cover(*one.twin);
        }
    } else {
        m_roots->lift();
        m_path->moveTo(event, [&](const BrushSample& sample) { dab(sample, context); });
    }
    show(context);
}

void HoldStroke::cover(const Dab& dab)
{
    for (const sim::TexelRect& clip : m_edit.clips())
        m_masks->add(dab, clip);
    if (!m_gel)
        return;
    const Dab onGel = onMapOf(dab, m_edit.size(), m_edit.size(*m_gel));
    for (const sim::TexelRect& clip : m_edit.clips(*m_gel))
        m_gelMasks->add(onGel, clip);
}

void HoldStroke::dab(const BrushSample& sample, const ToolContext& context)
{
    const float radiusM = 0.5F * context.settings.brushSizeM;
    const auto add = [&](const SkinMetric& metric, glm::vec2 uv) {
        const auto onMap = [&](StrokeBuffer& masks, int size, const std::vector<sim::TexelRect>& clips) {
            Dab dab = dabAt(metric, uv, radiusM, size);
            dab.hardness = context.settings.hardness;
            for (const sim::TexelRect& clip : clips)
                masks.add(dab, clip);
        };
        onMap(*m_masks, m_edit.size(), m_edit.clips());
        if (m_gel)
            onMap(*m_gelMasks, m_edit.size(*m_gel), m_edit.clips(*m_gel));
    };
    add(sample.metric, sample.uv);
    if (context.mirror && sample.point)
        if (const auto other = context.document.project().head->skin->mirrored(*sample.point))
            add(SkinMetric::at(*other), other->uv);
}

void HoldStroke::show(const ToolContext& context)
{
    const std::uint16_t opacity = unit16(context.settings.opacity);
    m_edit.update(m_masks->takeDirty(), [&](int index, const sim::RasterTilePtr& before) {
        return heldDirection(*m_field, m_edit.size(), index, before,
                             {.mask = m_masks->mask(index), .opacity = opacity});
    });
    if (!m_gel || !active())
        return;
    m_edit.update(
        m_gelMasks->takeDirty(),
        [&](int index, const sim::RasterTilePtr& before) {
            return heldGel(*m_field, *m_shownGel, context.settings.holdGel, index, before,
                           {.mask = m_gelMasks->mask(index), .opacity = opacity});
        },
        *m_gel);
}

void HoldStroke::cancel()
{
    m_edit.cancel();
    drop();
}

void HoldStroke::commit()
{
    m_edit.commit();
    drop();
}

void HoldStroke::drop()
{
    m_gel.reset();
    m_field.reset();
    m_shownGel.reset();
    m_masks.reset();
    m_gelMasks.reset();
    m_path.reset();
    m_roots.reset();
}

} // namespace hairpaint::model
