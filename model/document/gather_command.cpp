// Hair gathered by one click: a patch painted where hair stands, and the tie put where it was clicked; or two, with a
// parting between them.
#include "model/document/gather_command.h"

#include "model/document/edit_command.h"
#include "model/document/paint_command.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hairpaint::model {

namespace {

/// Channels of a layer with one value: the index or value, then the coverage.
constexpr std::size_t kIndexChannels = 2;
constexpr float kPartingM = 0.0012F; ///< Half the width of a painted parting.
constexpr int kMostSkipped = 8;      ///< The most texels of a row that are skipped at once.
constexpr float kSidewaysM = 0.01F;  ///< A click nearer to the middle of the head is on neither side.

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

/// Texels of a layer along the middle of the head, without paint of the accessory map or without hair.
LayerTiles parted(const sim::TiledRaster& layer, const sim::Skin& skin, const sim::TiledRaster& density)
{
    LayerTiles tiles;
    sim::TiledRaster painted = layer;
    const auto size = static_cast<float>(painted.size());
    for (int index = 0; index < painted.tileCount(); ++index) {
        const sim::TexelRect rect = painted.tileRect(index);
        std::span<std::uint16_t> pixels;
        std::size_t texel = 0;
        for (int y = rect.y0; y < rect.y1; ++y)
            for (int x = rect.x0; x < rect.x1; ++x, ++texel) {
                const glm::vec2 uv((static_cast<float>(x) + 0.5F) / size, 1.0F - (static_cast<float>(y) + 0.5F) / size);
                // The rim around hair is painted, too.
                if (painted.texel(x, y)[0] == 0 && !(density.sampleScalar(uv) > 0.0F))
                    continue;
                const std::optional<sim::SurfacePoint> point = skin.atUv(uv);
                if (!point)
                    continue;
                // A line of texels, if no more, keeps two patches apart.
                const float texelM = std::max(glm::length(point->dPduHd), glm::length(point->dPdvHd)) / size;
                const float awayM = std::abs(point->positionHd.x) - std::max(kPartingM, 0.75F * texelM);
                if (awayM > 0.0F) {
                    // So far from the middle, the next few are no nearer.
                    const int skipped =
                        std::min({static_cast<int>(0.5F * awayM / texelM), kMostSkipped, rect.x1 - 1 - x});
                    x += skipped;
                    texel += static_cast<std::size_t>(skipped);
                    continue;
                }
                if (pixels.empty())
                    pixels = painted.writableTile(index);
                pixels[kIndexChannels * texel] = 0;
                pixels[kIndexChannels * texel + 1] = 65535;
            }
        if (pixels.empty())
            continue;
        painted.compact(index);
        tiles.emplace_back(index, painted.tile(index));
    }
    return tiles;
}

/// The thing of that kind which gathers the hair at a point; where no hair grows there, as at an ear, the nearest on
/// that side of the head. Null: none.
Worn* tieAt(Project& project, const ProjectPatches::Group* patches, const WornSpec& spec,
            const sim::SurfacePoint& point)
{
    if (patches == nullptr)
        return nullptr;
    if (const std::optional<std::size_t> patch = patches->labels.at(point.uv))
        if (Worn* there = project.wornThing(patches->things[*patch]); there != nullptr && there->kind == spec.kind)
            return there;
    Worn* nearest = nullptr;
    float nearestHd = std::numeric_limits<float>::max();
    for (const Id id : patches->things) {
        Worn* thing = project.wornThing(id);
        if (thing == nullptr || thing->kind != spec.kind || thing->shape.centreHd.x * point.positionHd.x <= 0.0F)
            continue;
        const float distanceHd = glm::distance(thing->shape.centreHd, point.positionHd);
        if (distanceHd < nearestHd) {
            nearestHd = distanceHd;
            nearest = thing;
        }
    }
    return nearest;
}

/// Where a tail stands on the left, and on the right: what was clicked and its mirror image, or beside the head where
/// that is in the middle.
std::optional<std::array<sim::SurfacePoint, 2>> onBothSides(const sim::Skin& skin, sim::SurfacePoint point)
{
    if (std::abs(point.positionHd.x) < kSidewaysM) {
        constexpr float kBesideM = 0.5F;
        constexpr float kFrontM = -0.01F; // Behind the ears.
        const glm::vec3 fromHd(kBesideM, point.positionHd.y, std::min(point.positionHd.z, kFrontM) * 0.5F);
        const auto beside = skin.pick({.originHd = fromHd, .directionHd = {-1.0F, 0.0F, 0.0F}});
        if (!beside)
            return std::nullopt;
        point = *beside;
    }
    const std::optional<sim::SurfacePoint> other = skin.mirrored(point, 0.02F);
    if (!other)
        return std::nullopt;
    return std::array{point, *other};
}

void placeByHand(Worn& tie, const sim::SurfacePoint& point)
{
    standOn(tie, point);
    tie.patch->placedByHand = true;
}

/// The painted layers, and the worn things that are after them.
CommandPtr tiedCommand(Document& document, Project&& after, std::vector<LayerEdit>&& layers, const QString& text)
{
    Change change;
    change.aspect = Change::Aspect::Environment;
    std::vector<ShownPart> parts;
    parts.push_back({change, [all = std::move(after.worn), nextId = after.nextId](Project& to) {
                         to.worn = all;
                         to.nextId = nextId;
                     }});
    return shownEditCommand(document, parts, std::move(layers), text);
}

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
    placeByHand(*after.wornThing(there->id), point);
    return tiedCommand(document, std::move(after), std::move(layers), text);
}

CommandPtr gatherTwinsCommand(Document& document, Id groupId, const WornSpec& spec, const sim::SurfacePoint& point,
                              const std::vector<QRectF>& selected)
{
    document.endEdit();
    const Project& project = document.committed();
    const HairGroup* group = project.group(groupId);
    if (group == nullptr || project.head == nullptr || spec.patchStep == nullptr)
        return nullptr;
    const Layer* patches = paintedLayer(group->map(MapKind::Accessory));
    const Layer* density = paintedLayer(group->map(MapKind::Density));
    const auto points = onBothSides(*project.head->skin, point);
    if (patches == nullptr || density == nullptr || !points)
        return nullptr;
    // Hair that nothing gathers yet is painted, and all is parted along the middle.
    sim::TiledRaster painted = patches->raster;
    for (auto& [index, tile] : Gathering(document, *group, paletteIndexOf(spec), selected).over(painted))
        painted.setTile(index, std::move(tile));
    const sim::MapRaster hair = document.resolvedNow(groupId, MapKind::Density);
    for (auto& [index, tile] : parted(painted, *project.head->skin, *hair))
        painted.setTile(index, std::move(tile));
    std::vector<LayerEdit> layers;
    LayerTiles tiles;
    for (int index = 0; index < painted.tileCount(); ++index)
        if (painted.tile(index) != patches->raster.tile(index))
            tiles.emplace_back(index, painted.tile(index));
    layers.push_back({.address = {groupId, MapKind::Accessory, patches->id}, .after = std::move(tiles)});
    layers.push_back({.address = {groupId, MapKind::Density, density->id},
                      .after = parted(density->raster, *project.head->skin, *hair)});
    Project after = project;
    layIn(after, layers);
    ProjectPatches found = document.patches();
    found.follow(after, &document.patches());
    const ProjectPatches::Group* patched = found.group(groupId);
    const std::array ties{tieAt(after, patched, spec, (*points)[0]), tieAt(after, patched, spec, (*points)[1])};
    if (ties[0] == nullptr || ties[1] == nullptr || ties[0] == ties[1])
        return nullptr;
    for (std::size_t side = 0; side < ties.size(); ++side) {
        placeByHand(*ties.at(side), (*points).at(side));
    }
    return tiedCommand(document, std::move(after), std::move(layers),
                       wornText(QT_TRANSLATE_NOOP("Worn", "Gather hair into twin tails")));
}

} // namespace hairpaint::model
