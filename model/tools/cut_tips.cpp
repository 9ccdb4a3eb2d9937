// Texel by texel, from what the cut leaves of the length there.
#include "model/tools/cut_tips.h"

#include "model/values/texel_math.h"
#include "sim/groom/strand_look.h"

#include <algorithm>

namespace hairpaint::model {

std::optional<CutTips> CutTips::in(LiveEdit& edit, const ToolContext& context)
{
    const HairGroup* group = context.document.project().group(context.target.group);
    const auto resolved = [&context](MapKind map) { return context.document.resolvedNow(context.target.group, map); };
    if (group == nullptr || *resolved(MapKind::TipColour) == *resolved(MapKind::Colour))
        return std::nullopt;
    CutTips tips;
    tips.m_start = resolved(MapKind::TipStart);
    tips.m_material = group->settings.material;
    const std::optional<std::size_t> layer = edit.also(context, context.layer(MapKind::TipStart));
    if (!layer)
        return std::nullopt;
    tips.m_layer = *layer;
    return tips;
}

void CutTips::show(LiveEdit& edit, const CutLengths& lengths)
{
    const int size = m_start->size();
    const auto scaled = [](int texel, int from, int to) { return (2 * texel + 1) * to / (2 * from); };
    // All tiles under the changed ones of the length map, whatever the sizes of both.
    std::vector<int> tiles;
    for (const int tile : lengths.tiles()) {
        const sim::TexelRect rect = lengths.tileRect(tile);
        for (int y = rect.y0 * size / lengths.size() / kTile; y <= (rect.y1 * size / lengths.size() - 1) / kTile; ++y)
            for (int x = rect.x0 * size / lengths.size() / kTile; x <= (rect.x1 * size / lengths.size() - 1) / kTile;
                 ++x)
                tiles.push_back(y * m_start->tilesAcross() + x);
    }
    std::ranges::sort(tiles);
    tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
    edit.replace(
        tiles,
        [&](int tile, const sim::RasterTilePtr& before) {
            const sim::TexelRect rect = m_start->tileRect(tile);
            StrokeBuffer::MaskTile mask{};
            m_values.assign(sim::kTileTexels, 0);
            std::size_t texel = 0;
            for (int y = rect.y0; y < rect.y1; ++y)
                for (int x = rect.x0; x < rect.x1; ++x, ++texel) {
                    const float kept = lengths.keptAt(scaled(x, size, lengths.size()), scaled(y, size, lengths.size()));
                    if (kept >= 1.0F)
                        continue;
                    const float start = static_cast<float>(m_start->texel(x, y)[0]) / 65535.0F;
                    const float from = m_material.tipFrom + (1.0F - m_material.tipFrom) * start;
                    if (from <= 0.0F)
                        continue; // Along the whole hair, before and after.
                    m_values[texel] = unit16(sim::tipStartOf(m_material, std::min(from / std::max(kept, 1e-6F), 1.0F)));
                    mask[texel] = 65535;
                }
            keepInside(edit.clips(m_layer), rect, mask);
            TilePaint paint;
            paint.values = m_values.data();
            return paintTile(edit.spec(m_layer), before, mask, paint);
        },
        m_layer);
}

} // namespace hairpaint::model
