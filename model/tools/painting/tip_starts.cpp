// Dabs that each leave a value of their own.
#include "model/tools/painting/tip_starts.h"

#include "model/tools/strokes/dab_shape.h"
#include "model/values/texel_math.h"
#include "sim/groom/strand_look.h"

#include <algorithm>

namespace hairpaint::model {

std::optional<TipStarts> TipStarts::in(LiveEdit& edit, const ToolContext& context)
{
    if (context.target.map != MapKind::TipColour)
        return std::nullopt;
    TipStarts starts;
    const auto resolved = [&context](MapKind map) { return context.document.resolvedNow(context.target.group, map); };
    starts.m_start = resolved(MapKind::TipStart);
    starts.m_tip = resolved(MapKind::TipColour);
    starts.m_colour = resolved(MapKind::Colour);
    const HairGroup* group = context.document.project().group(context.target.group);
    const std::optional<std::size_t> layer = edit.also(context, context.layer(MapKind::TipStart));
    if (!layer || group == nullptr)
        return std::nullopt;
    starts.m_layer = *layer;
    starts.m_material = group->settings.material;
    starts.m_masks.emplace(edit.size(*layer), edit.spec(*layer).valueChannels);
    return starts;
}

void TipStarts::add(const LiveEdit& edit, const RootDab& dab)
{
    const glm::vec2 uv = dab.root.uv;
    float start = sim::tipStartOf(m_material, dab.fraction);
    if (m_tip->sampleNearest(uv) != m_colour->sampleNearest(uv))
        start = std::min(start, m_start->sampleScalar(uv));
    const sim::Texel value{unit16(start)};
    const auto lay = [&](const Dab& one) {
        Dab whole = onMapOf(one, edit.size(), edit.size(m_layer));
        whole.hardness = 1.0F;
        whole.strength = 1.0F;
        for (const sim::TexelRect& clip : edit.clips(m_layer))
            m_masks->add(whole, clip, value);
    };
    lay(dab.dab);
    if (dab.twin)
        lay(*dab.twin);
}

void TipStarts::show(LiveEdit& edit, bool erases)
{
    edit.update(
        m_masks->takeDirty(),
        [&](int tile, const sim::RasterTilePtr& before) {
            // How much of the colour there is stands in its own map.
            StrokeBuffer::MaskTile mask = *m_masks->mask(tile);
            for (std::uint16_t& texel : mask)
                texel = texel > 0 ? std::uint16_t{65535} : std::uint16_t{0};
            TilePaint paint{.erase = erases};
            paint.values = m_masks->values(tile);
            return paintTile(edit.spec(m_layer), before, mask, paint);
        },
        m_layer);
}

} // namespace hairpaint::model
