// Texel by texel, from what the cut leaves of the length there.
#include "model/tools/cutting/cut_tips.h"

#include "model/values/srgb.h"
#include "model/values/texel_math.h"
#include "sim/groom/strand_look.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

/// The texel under the middle of another one, of a map of another size.
int scaled(int texel, int from, int to)
{
    return (2 * texel + 1) * to / (2 * from);
}

} // namespace

std::optional<CutTips> CutTips::in(LiveEdit& edit, const ToolContext& context)
{
    const HairGroup* group = context.document.project().group(context.target.group);
    const auto resolved = [&context](MapKind map) { return context.document.resolvedNow(context.target.group, map); };
    CutTips tips;
    tips.m_tip = resolved(MapKind::TipColour);
    tips.m_colour = resolved(MapKind::Colour);
    if (group == nullptr || *tips.m_tip == *tips.m_colour)
        return std::nullopt;
    tips.m_start = resolved(MapKind::TipStart);
    tips.m_material = group->settings.material;
    const std::optional<std::size_t> layer = edit.also(context, context.layer(MapKind::TipStart));
    if (!layer)
        return std::nullopt;
    tips.m_startLayer = *layer;
    tips.m_colourLayer = edit.also(context, context.layer(MapKind::TipColour));
    return tips;
}

void CutTips::show(LiveEdit& edit, const CutLengths& lengths)
{
    show(edit, m_startLayer, lengths, [this](int x, int y, float kept, std::uint16_t* value) {
        const float start = static_cast<float>(m_start->texel(x, y)[0]) / 65535.0F;
        const float from = m_material.tipFrom + (1.0F - m_material.tipFrom) * start;
        if (from <= 0.0F)
            return false; // Along the whole hair, before and after.
        *value = unit16(sim::tipStartOf(m_material, std::min(from / std::max(kept, 1e-6F), 1.0F)));
        return true;
    });
    if (!m_colourLayer)
        return;
    const int size = m_tip->size();
    show(edit, *m_colourLayer, lengths, [this, size](int x, int y, float kept, std::uint16_t* value) {
        const int startSize = m_start->size();
        const float start =
            static_cast<float>(m_start->texel(scaled(x, size, startSize), scaled(y, size, startSize))[0]) / 65535.0F;
        const float part = sim::tipMixOf(m_material, start).at(kept);
        const int rootSize = m_colour->size();
        const sim::Texel root = m_colour->texel(scaled(x, size, rootSize), scaled(y, size, rootSize));
        const sim::Texel tip = m_tip->texel(x, y);
        if (part >= 1.0F || tip == root)
            return false;
        for (std::size_t c = 0; c < 3; ++c) {
            const auto lightOf = [c](const sim::Texel& texel) {
                return linearFromSrgb(static_cast<float>(texel[c]) / 65535.0F);
            };
            value[c] = unit16(srgbFromLinear(glm::mix(lightOf(root), lightOf(tip), part)));
        }
        return true;
    });
}

void CutTips::show(LiveEdit& edit, std::size_t layer, const CutLengths& lengths, const CutTexel& cut)
{
    const sim::TiledRaster& map = edit.before(layer);
    const int size = map.size();
    // All tiles under the changed ones of the length map, whatever the sizes of both.
    std::vector<int> tiles;
    for (const int tile : lengths.tiles()) {
        const sim::TexelRect rect = lengths.tileRect(tile);
        for (int y = rect.y0 * size / lengths.size() / kTile; y <= (rect.y1 * size / lengths.size() - 1) / kTile; ++y)
            for (int x = rect.x0 * size / lengths.size() / kTile; x <= (rect.x1 * size / lengths.size() - 1) / kTile;
                 ++x)
                tiles.push_back(y * map.tilesAcross() + x);
    }
    std::ranges::sort(tiles);
    tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
    const auto channels = static_cast<std::size_t>(edit.spec(layer).valueChannels);
    edit.replace(
        tiles,
        [&](int tile, const sim::RasterTilePtr& before) {
            const sim::TexelRect rect = map.tileRect(tile);
            StrokeBuffer::MaskTile mask{};
            m_values.assign(sim::kTileTexels * channels, 0);
            std::size_t texel = 0;
            for (int y = rect.y0; y < rect.y1; ++y)
                for (int x = rect.x0; x < rect.x1; ++x, ++texel) {
                    const float kept = lengths.keptAt(scaled(x, size, lengths.size()), scaled(y, size, lengths.size()));
                    if (kept < 1.0F && cut(x, y, kept, m_values.data() + texel * channels))
                        mask[texel] = 65535;
                }
            keepInside(edit.clips(layer), rect, mask);
            TilePaint paint;
            paint.values = m_values.data();
            return paintTile(edit.spec(layer), before, mask, paint);
        },
        layer);
}

} // namespace hairpaint::model
