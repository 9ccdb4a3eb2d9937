// The two maps of a parting, tile by tile.
#include "model/tools/parting/part_edit.h"

#include "sim/base/parallel.h"

#include <algorithm>
#include <utility>

namespace hairpaint::model {

bool PartEdit::begin(const ToolContext& context, const QString& title, std::function<bool()> stepBack)
{
    const Head* head = context.document.project().head.get();
    if (context.target.map != MapKind::Direction || head == nullptr || head->skin == nullptr)
        return false;
    if (!m_edit.begin(context, title, std::move(stepBack)))
        return false;
    m_edit.setText(title);
    if (m_frames == nullptr || !m_frames->isOf(head->skin))
        m_frames = std::make_unique<SkinFrames>(head->skin);
    m_before.emplace(context, *m_frames, m_edit.size());
    m_hair = context.document.resolvedNow(context.target.group, MapKind::Density);
    m_density.reset();
    return true;
}

void PartEdit::show(const PartCurve& curve, const std::vector<sim::SurfacePoint>& points, const ToolContext& context)
{
    const ToolSettings& settings = context.settings;
    PartLook look{.reachM = settings.partReachM,
                  .flatness = settings.flatness,
                  .gapM = settings.partGapM,
                  .zigzagM = settings.partZigzagM};
    PartCurve led = m_hair != nullptr ? ledToHairline(m_frames->skin(), points, *m_hair, look) : curve;
    const PartField field(*m_frames, std::move(led), look);
    showLaid(field);
    showGap(field, context);
}

void PartEdit::showTiles(const std::vector<int>& tiles, const LiveEdit::MakeTile& make, std::size_t layer)
{
    std::vector<sim::RasterTilePtr> made(tiles.size());
    sim::parallelFor(tiles.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            made[i] = make(tiles[i], m_edit.before(layer).tile(tiles[i]));
    });
    const auto take = [&](int index, const sim::RasterTilePtr& /*before*/) {
        return made[static_cast<std::size_t>(std::ranges::lower_bound(tiles, index) - tiles.begin())];
    };
    m_edit.replace(tiles, take, layer);
}

void PartEdit::showLaid(const PartField& field)
{
    const int size = m_edit.size();
    const auto make = [&](int index, const sim::RasterTilePtr& before) {
        PartField::LaidTile laid = field.laid(index, size);
        keepInside(m_edit.clips(), m_edit.before().tileRect(index), laid.mask);
        return paintTile(m_edit.spec(), m_before->under(index, before, laid.mask), laid.mask,
                         {.values = laid.values.data()});
    };
    const std::vector<int> tiles = field.laidTiles(size);
    for (const int tile : tiles)
        m_before->look(tile);
    showTiles(tiles, make, 0);
}

/// No hair is painted over what other layers leave there; a layer that adds to them only loses its own.
void PartEdit::showGap(const PartField& field, const ToolContext& context)
{
    if (context.settings.partGapM > 0.0F && !m_density)
        m_density = m_edit.also(context, context.layer(MapKind::Density));
    if (!m_density)
        return;
    const std::size_t layer = *m_density;
    const int size = m_edit.size(layer);
    const TilePaint none{.value = {}, .erase = m_edit.blend(layer) != BlendMode::Normal};
    const auto make = [&](int index, const sim::RasterTilePtr& before) {
        StrokeBuffer::MaskTile mask = field.gap(index, size);
        keepInside(m_edit.clips(layer), m_edit.before(layer).tileRect(index), mask);
        return paintTile(m_edit.spec(layer), before, mask, none);
    };
    showTiles(field.gapTiles(size), make, layer);
}

} // namespace hairpaint::model
