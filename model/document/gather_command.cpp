// Hair gathered by one click: a patch painted where hair stands, and the tie put where it was clicked.
#include "model/document/gather_command.h"

#include "model/document/edit_command.h"
#include "model/document/paint_command.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr std::size_t kIndexChannels = 2; ///< Of a layer: index and coverage.

std::uint16_t paletteIndexOf(const WornSpec& spec)
{
    const std::span<const PaletteEntry> palette = mapSpec(MapKind::Accessory).palette;
    const auto found = std::ranges::find_if(palette, [&spec](const PaletteEntry& entry) {
        return QLatin1StringView(entry.id) == QLatin1StringView(spec.id);
    });
    return static_cast<std::uint16_t>(found - palette.begin());
}

const Layer* paintedLayer(const MapStack& stack)
{
    const auto found = std::ranges::find_if(stack.layers.rbegin(), stack.layers.rend(), [](const Layer& layer) {
        return layer.visible && !layer.locked && layer.opacity >= 0.5F;
    });
    return found != stack.layers.rend() ? &*found : nullptr;
}

bool isSelected(const std::vector<QRectF>& selected, double u, double v)
{
    return selected.empty() ||
           std::ranges::any_of(selected, [u, v](const QRectF& rect) { return rect.contains(u, v); });
}

/// What is to be gathered: hair that nothing gathers yet, and the texels just around it.
class Gathering
{
public:
    Gathering(Document& document, const HairGroup& group, std::uint16_t index, const std::vector<QRectF>& selected)
        : m_density(document.resolvedNow(group.id, MapKind::Density)),
          m_worn(document.resolvedNow(group.id, MapKind::Accessory)), m_index(index), m_selected(selected)
    {}

    [[nodiscard]] LayerTiles over(const sim::TiledRaster& layer) const
    {
        LayerTiles tiles;
        sim::TiledRaster painted = layer;
        for (int index = 0; index < painted.tileCount(); ++index) {
            if (!paint(painted, index))
                continue;
            painted.compact(index);
            tiles.emplace_back(index, painted.tile(index));
        }
        return tiles;
    }

private:
    [[nodiscard]] bool takes(int x, int y, int size) const
    {
        if (m_worn->size() == size && m_worn->texel(x, y)[0] != 0)
            return false;
        const float u = (static_cast<float>(x) + 0.5F) / static_cast<float>(size);
        const float v = 1.0F - (static_cast<float>(y) + 0.5F) / static_cast<float>(size);
        // Hair whose root lies at the rim reads a texel beyond it.
        const float reach = 1.5F / static_cast<float>(std::min(size, m_density->size()));
        return isSelected(m_selected, static_cast<double>(u), static_cast<double>(v)) &&
               std::max({m_density->sampleScalar({u, v}), m_density->sampleScalar({u + reach, v}),
                         m_density->sampleScalar({u - reach, v}), m_density->sampleScalar({u, v + reach}),
                         m_density->sampleScalar({u, v - reach})}) > 0.0F;
    }

    bool paint(sim::TiledRaster& painted, int index) const
    {
        const sim::TexelRect rect = painted.tileRect(index);
        std::span<std::uint16_t> pixels;
        std::size_t texel = 0;
        for (int y = rect.y0; y < rect.y1; ++y)
            for (int x = rect.x0; x < rect.x1; ++x, ++texel) {
                if (!takes(x, y, painted.size()))
                    continue;
                if (pixels.empty())
                    pixels = painted.writableTile(index);
                pixels[kIndexChannels * texel] = m_index;
                pixels[kIndexChannels * texel + 1] = 65535;
            }
        return !pixels.empty();
    }

    sim::MapRaster m_density, m_worn;
    std::uint16_t m_index;
    const std::vector<QRectF>& m_selected;
};

} // namespace

CommandPtr gatherCommand(Document& document, Id groupId, const WornSpec& spec, const sim::SurfacePoint& point,
                         const std::vector<QRectF>& selected)
{
    document.endEdit();
    const Project& project = document.committed();
    const HairGroup* group = project.group(groupId);
    if (group == nullptr || project.head == nullptr || spec.patchStep == nullptr)
        return nullptr;
    const QString text = wornText(spec.patchStep);
    // A click on hair that is gathered already takes its tie there.
    std::vector<LayerEdit> layers;
    Project after = project;
    const ProjectPatches::Group* patches = document.patches().group(groupId);
    std::optional<std::size_t> patch = patches != nullptr ? patches->labels.at(point.uv) : std::nullopt;
    const Worn* there = patch ? project.wornThing(patches->things[*patch]) : nullptr;
    ProjectPatches found = document.patches();
    if (there == nullptr || there->kind != spec.kind) {
        const Layer* layer = paintedLayer(group->map(MapKind::Accessory));
        if (layer == nullptr)
            return nullptr;
        LayerTiles tiles = Gathering(document, *group, paletteIndexOf(spec), selected).over(layer->raster);
        if (tiles.empty())
            return nullptr;
        layers.push_back({.address = {groupId, MapKind::Accessory, layer->id}, .after = std::move(tiles)});
        layIn(after, layers);
        found.follow(after, &document.patches());
        patches = found.group(groupId);
        // The hair that was painted need not grow where the tie is to be.
        const auto isNew = [&](const Worn& one) { return one.patch && project.wornThing(one.id) == nullptr; };
        patch = patches != nullptr ? patches->labels.at(point.uv) : std::nullopt;
        there = patch ? after.wornThing(patches->things[*patch]) : nullptr;
        if (there == nullptr || !isNew(*there)) {
            const auto made = std::ranges::find_if(after.worn, isNew);
            there = made != after.worn.end() ? &*made : nullptr;
        }
    }
    if (there == nullptr)
        return nullptr;
    Worn* tie = after.wornThing(there->id);
    standOn(*tie, point);
    tie->patch->placedByHand = true;
    Change change;
    change.aspect = Change::Aspect::Environment;
    std::vector<ShownPart> parts;
    parts.push_back({change, [all = std::move(after.worn), nextId = after.nextId](Project& to) {
                         to.worn = all;
                         to.nextId = nextId;
                     }});
    return shownEditCommand(document, parts, std::move(layers), text);
}

} // namespace hairpaint::model
