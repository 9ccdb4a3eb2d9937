// Tiles of the maps that a stroke of the fingers changes.
#include "model/tools/shaping/finger_maps.h"

#include "model/tools/lying/evened_hair.h"
#include "model/tools/strokes/dab_shape.h"
#include "model/values/texel_math.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr float kPuffed = 0.1F;       ///< What is left of hair's flatness where it is puffed up wholly.
constexpr float kPuffGel = 0.15F;     ///< What keeps it up.
constexpr float kGatherLean = 0.6F;   ///< How far hair at the rim leans over, flat hair being 1.
constexpr std::uint16_t kUnknown = 1; ///< A mean that was not asked for yet. Means are never so.

glm::vec2 centreUv(int x, int y, int size)
{
    const glm::vec2 position = (glm::vec2(x, y) + 0.5F) / static_cast<float>(size);
    return {position.x, 1.0F - position.y};
}

/// A short step on the skin in the frame of a point there.
glm::vec2 wayTo(const sim::SurfacePoint& point, glm::vec2 uv)
{
    const glm::vec2 step = uv - point.uv;
    return sim::SkinFrame::at(point).fromHd(point.dPduHd * step.x + point.dPdvHd * step.y);
}

} // namespace

bool FingerMaps::begin(const ToolContext& context, const QString& text, SkinFrames& frames)
{
    if (!m_edit.begin(context, text))
        return false;
    m_edit.setText(text);
    m_kind = context.settings.fingers;
    m_strength = unit16(context.settings.fingerStrength);
    m_frames = &frames;
    m_before.emplace(context, frames, m_edit.size());
    m_masks.emplace(m_edit.size());
    m_field.emplace(m_edit.size());
    m_density = context.document.resolvedNow(context.target.group, MapKind::Density);
    switch (m_kind) {
    case FingerKind::Puff:
        also(context, MapKind::Gel, unit16(kPuffGel));
        break;
    case FingerKind::Pinch:
        also(context, MapKind::Clump, std::uint16_t{65535});
        break;
    case FingerKind::Spread:
        also(context, MapKind::Clump, std::uint16_t{0});
        break;
    case FingerKind::Smooth:
        for (const MapKind map : {MapKind::Length, MapKind::Curl, MapKind::Frizz})
            also(context, map, std::nullopt);
        break;
    }
    return true;
}

void FingerMaps::also(const ToolContext& context, MapKind map, std::optional<std::uint16_t> target)
{
    std::shared_ptr<const sim::TiledRaster> before = context.document.resolvedNow(context.target.group, map);
    const std::optional<std::size_t> layer = m_edit.also(context, context.layer(map));
    if (!layer)
        return;
    Scalar scalar{.map = map,
                  .layer = *layer,
                  .masks = StrokeBuffer(m_edit.size(*layer)),
                  .before = std::move(before),
                  .target = target};
    if (!target)
        scalar.means.resize(static_cast<std::size_t>(m_edit.before(*layer).tileCount()));
    m_scalars.push_back(std::move(scalar));
}

void FingerMaps::add(const FingerDab& dab)
{
    const Dab brush = dabAt(SkinMetric::at(dab.centre), dab.centre.uv, dab.reachM, m_edit.size());
    for (const sim::TexelRect& clip : m_edit.clips())
        m_masks->add(dab.dab, clip);
    m_field->add(dab.dab, [&](int x, int y) -> std::optional<glm::vec2> {
        return directionAt(centreUv(x, y, m_edit.size()), dab, brush);
    });
    for (Scalar& scalar : m_scalars)
        addTo(scalar, dab.dab, brush);
}

void FingerMaps::addTo(Scalar& scalar, const Dab& dab, const Dab& brush)
{
    const int size = m_edit.size(scalar.layer);
    const Dab own = onMapOf(dab, m_edit.size(), size);
    for (const sim::TexelRect& clip : m_edit.clips(scalar.layer))
        scalar.masks.add(own, clip);
    if (scalar.target)
        return;
    const glm::vec2 reachUv = eveningReachUv(brush, m_edit.size());
    const float halfWidth = std::sqrt(own.c / std::max(own.a * own.c - own.b * own.b, 1e-12F));
    const float halfHeight = std::sqrt(own.a / std::max(own.a * own.c - own.b * own.b, 1e-12F));
    const auto edge = [size](float tx) { return static_cast<int>(std::clamp(tx, 0.0F, static_cast<float>(size))); };
    const int tilesAcross = size / kTile;
    for (int y = edge(own.yTx - halfHeight); y < edge(std::ceil(own.yTx + halfHeight)); ++y)
        for (int x = edge(own.xTx - halfWidth); x < edge(std::ceil(own.xTx + halfWidth)); ++x) {
            const int tileIndex = y / kTile * tilesAcross + x / kTile;
            std::vector<std::uint16_t>& tile = scalar.means[static_cast<std::size_t>(tileIndex)];
            if (tile.empty())
                tile.assign(sim::kTileTexels, kUnknown);
            const int texel = y % kTile * kTile + x % kTile;
            std::uint16_t& mean = tile[static_cast<std::size_t>(texel)];
            if (mean != kUnknown)
                continue;
            const std::uint16_t found = unit16(evenedScalar(*scalar.before, *m_density, centreUv(x, y, size), reachUv));
            mean = found == kUnknown ? std::uint16_t{0} : found;
        }
}

/// What a dab makes of the hair at a texel, in its frame.
glm::vec2 FingerMaps::directionAt(glm::vec2 uv, const FingerDab& dab, const Dab& brush)
{
    const glm::vec2 was = m_before->at(uv);
    if (m_kind == FingerKind::Puff)
        return was * kPuffed;
    if (m_kind == FingerKind::Smooth)
        return evenedDirection(*m_frames, *m_before, uv, eveningReachUv(brush, m_edit.size()));
    glm::vec2 gather(0.0F);
    glm::vec2 heading(0.0F);
    if (dab.gatherHd) {
        const sim::SkinFrame frame = m_frames->at(uv).value_or(sim::SkinFrame::at(dab.centre));
        gather = frame.fromHd(*dab.gatherHd);
        heading = frame.fromHd(dab.headingHd);
    } else {
        gather = wayTo(dab.centre, uv) / -dab.reachM;
        heading = sim::SkinFrame::at(dab.centre).fromHd(dab.headingHd);
    }
    // Along the stroke nothing is gathered: the fingers go there themselves.
    if (const float length = glm::length(heading); length > 0.1F)
        gather -= heading / length * glm::dot(gather, heading / length);
    const float far = glm::length(gather);
    if (far > 1.0F)
        gather /= far;
    const glm::vec2 lean = gather * (m_kind == FingerKind::Pinch ? kGatherLean : -kGatherLean);
    const glm::vec2 now = was + lean;
    const float flatness = std::max(glm::length(was), glm::length(lean));
    const float length = glm::length(now);
    return length > 1e-4F ? now * (flatness / length) : was;
}

void FingerMaps::show()
{
    m_edit.update(m_masks->takeDirty(),
                  [this](int tile, const sim::RasterTilePtr& before) { return direction(tile, before); });
    for (Scalar& scalar : m_scalars)
        m_edit.update(
            scalar.masks.takeDirty(),
            [&](int tile, const sim::RasterTilePtr& before) { return scalarTile(scalar, tile, before); }, scalar.layer);
}

sim::RasterTilePtr FingerMaps::direction(int tile, const sim::RasterTilePtr& before)
{
    const std::vector<std::uint16_t> values = m_field->values(tile);
    const StrokeBuffer::MaskTile& mask = *m_masks->mask(tile);
    m_before->look(tile);
    return paintTile(m_edit.spec(), m_before->under(tile, before, mask), mask,
                     {.values = values.data(), .opacity = m_strength});
}

sim::RasterTilePtr FingerMaps::scalarTile(const Scalar& scalar, int tile, const sim::RasterTilePtr& before) const
{
    const MapSpec& spec = m_edit.spec(scalar.layer);
    StrokeBuffer::MaskTile mask = *scalar.masks.mask(tile);
    if (!scalar.target)
        return paintTile(spec, before, mask,
                         {.values = scalar.means[static_cast<std::size_t>(tile)].data(), .opacity = m_strength});
    if (scalar.map == MapKind::Gel) { // Hair that has more keeps it.
        const sim::TexelRect rect = scalar.before->tileRect(tile);
        std::size_t texel = 0;
        for (int y = rect.y0; y < rect.y1; ++y)
            for (int x = rect.x0; x < rect.x1; ++x, ++texel)
                if (scalar.before->texel(x, y)[0] >= *scalar.target)
                    mask[texel] = 0;
    }
    return paintTile(spec, before, mask, {.value = {*scalar.target}, .opacity = m_strength});
}

void FingerMaps::commit()
{
    m_edit.commit();
    drop();
}

void FingerMaps::cancel()
{
    m_edit.cancel();
    drop();
}

void FingerMaps::drop()
{
    m_before.reset();
    m_masks.reset();
    m_field.reset();
    m_density.reset();
    m_scalars.clear();
}

} // namespace hairpaint::model
