// Previews put over committed content, and the commands that give the same.
#include "model/document/running_edit.h"
#include "model/document/paint_command.h"
#include "model/project/worn_on_ties.h"

#include <algorithm>
#include <utility>

namespace hairpaint::model {

namespace {

/// Whether both are of the same part of the content, whatever is done to it.
bool samePart(const Change& a, const Change& b)
{
    return a.aspect == b.aspect && a.group == b.group && a.map == b.map && a.layer == b.layer;
}

Change texelsOf(const LayerAddress& address)
{
    return {.aspect = Change::Aspect::Texels, .group = address.group, .map = address.map, .layer = address.layer};
}

} // namespace

bool covers(const Change& told, const Change& change)
{
    if (told.aspect == Change::Aspect::Everything)
        return true;
    return samePart(told, change) && (told.tiles.empty() || std::ranges::includes(told.tiles, change.tiles));
}

void RunningEdit::showPart(const Project& committed, ShownPart part)
{
    std::erase_if(parts, [&](const ShownPart& one) { return samePart(one.change, part.change); });
    parts.push_back(std::move(part));
    shown = committed;
    for (const ShownPart& one : parts)
        runFollowingTies(shown, one.edit);
    plainWorn = shown.worn;
    plainNextId = shown.nextId;
    for (const auto& [address, shownTiles] : tiles)
        if (Layer* layer = shown.layer(address.group, address.map, address.layer))
            for (const auto& [index, tile] : shownTiles)
                layer->raster.setTile(index, tile);
}

std::optional<Change> RunningEdit::showTiles(const LayerAddress& address, const LayerTiles& changed)
{
    Layer* layer = shown.layer(address.group, address.map, address.layer);
    if (layer == nullptr)
        return std::nullopt;
    Change change = texelsOf(address);
    change.tiles.reserve(changed.size());
    std::map<int, sim::RasterTilePtr>& shownTiles = tiles[address];
    for (const auto& [index, tile] : changed) {
        layer->raster.setTile(index, tile);
        shownTiles.insert_or_assign(index, tile);
        change.tiles.push_back(index);
    }
    std::ranges::sort(change.tiles);
    return change;
}

bool RunningEdit::followPatches(const ProjectPatches& before)
{
    if (!patches)
        patches = before;
    shown.worn = plainWorn;
    shown.nextId = plainNextId;
    patches->follow(shown, &before);
    return std::exchange(toldWorn, shown.worn) != shown.worn;
}

std::vector<Change> RunningEdit::changes() const
{
    std::vector<Change> all;
    for (const ShownPart& part : parts)
        all.push_back(part.change);
    if (patches && std::ranges::none_of(
                       parts, [](const ShownPart& part) { return part.change.aspect == Change::Aspect::Environment; }))
        all.push_back({.aspect = Change::Aspect::Environment});
    for (const auto& [address, shownTiles] : tiles) {
        Change change = texelsOf(address);
        for (const auto& [index, tile] : shownTiles)
            change.tiles.push_back(index);
        all.push_back(std::move(change));
    }
    return all;
}

CommandPtr RunningEdit::command(Document& document) const
{
    std::vector<LayerEdit> layers;
    for (const auto& [address, shownTiles] : tiles)
        layers.push_back({.address = address, .after = {shownTiles.begin(), shownTiles.end()}});
    return shownEditCommand(document, parts, std::move(layers), owner.text);
}

} // namespace hairpaint::model
