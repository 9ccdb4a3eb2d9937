// The lay's own rule for long hair, texel by texel.
#include "model/tools/lying/fallen_hair.h"

#include "sim/groom/growth_direction.h"
#include "sim/groom/strand_style.h"

#include <algorithm>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr int kTileSide = sim::TiledRaster::kTileSize;

} // namespace

FallenHair::FallenHair(const ToolContext& context, SkinFrames& frames, int size)
    : FallenHair({}, context.document.project().head->naturalDirection,
                 context.document.resolvedNow(context.target.group, MapKind::Direction),
                 context.document.resolvedNow(context.target.group, MapKind::Length), frames, size)
{
    if (const HairGroup* group = context.document.project().group(context.target.group))
        m_settings = group->settings;
}

FallenHair::FallenHair(const sim::GroupSettings& settings, sim::MapRaster natural, sim::MapRaster direction,
                       sim::MapRaster length, SkinFrames& frames, int size)
    : m_frames(&frames), m_size(size), m_tilesAcross((size + kTileSide - 1) / kTileSide), m_settings(settings),
      m_natural(std::move(natural)), m_direction(std::move(direction)), m_length(std::move(length)),
      m_tiles(static_cast<std::size_t>(m_tilesAcross) * static_cast<std::size_t>(m_tilesAcross))
{}

glm::vec2 FallenHair::toldAt(glm::vec2 uv) const
{
    return m_direction ? sim::directionAt(*m_direction, uv) : glm::vec2(0.0F);
}

glm::vec2 FallenHair::at(glm::vec2 uv)
{
    return fallenAt(uv).value_or(toldAt(uv));
}

std::optional<glm::vec2> FallenHair::fallenAt(glm::vec2 uv)
{
    constexpr float kOtherwise = 1e-3F;
    if (!m_natural || !m_direction || !m_length)
        return std::nullopt;
    const float falls = sim::fallFraction(sim::lengthOf(m_settings, m_length->sampleScalar(uv)));
    if (falls <= 0.0F)
        return std::nullopt;
    const auto entry = [](float fraction) {
        return std::clamp(static_cast<int>(fraction * SkinFrames::kSize), 0, SkinFrames::kSize - 1);
    };
    const std::optional<FramedPoint>& point = m_frames->point(entry(uv.x), entry(1.0F - uv.y));
    if (!point)
        return std::nullopt;
    const glm::vec2 told = toldAt(uv);
    const glm::vec2 natural = sim::directionAt(*m_natural, uv);
    const glm::vec3 lies = sim::growthDirections(told, &natural, point->positionHd, point->frame).of(falls);
    const glm::vec2 inFrame = point->frame.fromHd(lies);
    return glm::length(inFrame - told) > kOtherwise ? std::optional(inFrame) : std::nullopt;
}

void FallenHair::look(int tileIndex)
{
    std::optional<Texels>& texels = m_tiles[static_cast<std::size_t>(tileIndex)];
    if (texels)
        return;
    texels.emplace(sim::kTileTexels);
    const int left = tileIndex % m_tilesAcross * kTileSide;
    const int top = tileIndex / m_tilesAcross * kTileSide;
    auto texel = texels->begin();
    for (int y = top; y < top + kTileSide; ++y)
        for (int x = left; x < left + kTileSide; ++x, ++texel) {
            const glm::vec2 uv = (glm::vec2(x, y) + 0.5F) / static_cast<float>(m_size);
            if (const std::optional<glm::vec2> fallen = fallenAt({uv.x, 1.0F - uv.y}))
                *texel = sim::texelOfDirection(*fallen);
        }
}

sim::RasterTilePtr FallenHair::under(int tileIndex, const sim::RasterTilePtr& before,
                                     const StrokeBuffer::MaskTile& mask) const
{
    constexpr std::size_t kChannels = 3; // Channels of a direction layer: two of the direction, and coverage.
    const std::optional<Texels>& texels = m_tiles[static_cast<std::size_t>(tileIndex)];
    if (!texels)
        return before;
    sim::RasterTile tile;
    for (std::size_t i = 0; i < texels->size(); ++i) {
        const std::optional<sim::Texel>& lies = (*texels)[i];
        if (!lies || mask[i] == 0)
            continue;
        if (tile.pixels.empty())
            tile.pixels = sim::expanded(*before, static_cast<int>(kChannels));
        tile.pixels[i * kChannels] = (*lies)[0];
        tile.pixels[i * kChannels + 1] = (*lies)[1];
        tile.pixels[i * kChannels + 2] = 65535;
    }
    return tile.pixels.empty() ? before : std::make_shared<const sim::RasterTile>(std::move(tile));
}

} // namespace hairpaint::model
