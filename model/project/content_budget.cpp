// Counting what a document holds.
#include "model/project/content_budget.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>

namespace hairpaint::model {

namespace {

struct ContentBudget
{
    Q_DECLARE_TR_FUNCTIONS(ContentBudget)
};

struct Counts
{
    std::size_t groups = 0;
    std::size_t layersInMap = 0; ///< The number of layers in the map that has most.
    std::size_t layers = 0;
};

Counts countsOf(const std::vector<HairGroup>& groups)
{
    Counts counts{.groups = groups.size()};
    for (const HairGroup& group : groups)
        for (const MapStack& stack : group.maps) {
            counts.layersInMap = std::max(counts.layersInMap, stack.layers.size());
            counts.layers += stack.layers.size();
        }
    return counts;
}

constexpr Counts kMostCounts{.groups = kMostGroups, .layersInMap = kMostLayersInMap, .layers = kMostLayers};

struct Texels
{
    qint64 all = 0;
    qint64 distinct = 0;
    std::size_t heldBytes = 0;
};

constexpr Texels kMostOfTexels{.all = kMostTexels, .distinct = kMostDistinctTexels, .heldBytes = kMostHeldBytes};

/// Exactly, tile by tile.
Texels texelsOf(const std::vector<HairGroup>& groups)
{
    std::set<std::tuple<int, int, sim::Texel>> uniform;
    Texels texels;
    for (const HairGroup& group : groups)
        for (const MapStack& stack : group.maps) {
            texels.all += qint64{stack.size} * stack.size * std::ssize(stack.layers);
            for (const Layer& layer : stack.layers) {
                const sim::TiledRaster& raster = layer.raster;
                texels.heldBytes += raster.byteCount();
                const std::optional<sim::Texel> value = raster.uniformValue();
                if (!value || uniform.emplace(raster.size(), raster.channels(), *value).second)
                    texels.distinct += qint64{raster.size()} * raster.size();
            }
        }
    return texels;
}

bool fits(const Counts& counts, const Counts& limit)
{
    return counts.groups <= limit.groups && counts.layersInMap <= limit.layersInMap && counts.layers <= limit.layers;
}

bool fits(const Texels& texels, const Texels& limit)
{
    return texels.all <= limit.all && texels.distinct <= limit.distinct && texels.heldBytes <= limit.heldBytes;
}

/// The limit, or what there is already where that is more.
Counts limitOrNow(const Counts& limit, const Counts& now)
{
    return {.groups = std::max(limit.groups, now.groups),
            .layersInMap = std::max(limit.layersInMap, now.layersInMap),
            .layers = std::max(limit.layers, now.layers)};
}

Texels limitOrNow(const Texels& limit, const Texels& now)
{
    return {.all = std::max(limit.all, now.all),
            .distinct = std::max(limit.distinct, now.distinct),
            .heldBytes = std::max(limit.heldBytes, now.heldBytes)};
}

} // namespace

bool paintingMayExceed(const std::vector<HairGroup>& groups)
{
    qint64 texels = 0;
    qint64 bytes = 0; // If every texel were painted.
    for (const HairGroup& group : groups)
        for (const MapStack& stack : group.maps)
            for (const Layer& layer : stack.layers) {
                // The stack's size: a map that is to be resized is measured before its layers are.
                const qint64 count = qint64{stack.size} * stack.size;
                texels += count;
                bytes += count * layer.raster.channels() * qint64{sizeof(std::uint16_t)};
            }
    return texels > kMostDistinctTexels || bytes > static_cast<qint64>(kMostHeldBytes);
}

bool countsExceed(const std::vector<HairGroup>& groups)
{
    return !fits(countsOf(groups), kMostCounts);
}

ContentExcess excessOf(const std::vector<HairGroup>& groups)
{
    if (countsExceed(groups))
        return ContentExcess::Groups;
    return paintingMayExceed(groups) && !fits(texelsOf(groups), kMostOfTexels) ? ContentExcess::Texels
                                                                               : ContentExcess::None;
}

ContentExcess excessOver(const std::vector<HairGroup>& before, const std::vector<HairGroup>& after)
{
    if (excessOf(after) == ContentExcess::None)
        return ContentExcess::None;
    if (!fits(countsOf(after), limitOrNow(kMostCounts, countsOf(before))))
        return ContentExcess::Groups;
    if (!fits(texelsOf(after), limitOrNow(kMostOfTexels, texelsOf(before))))
        return ContentExcess::Texels;
    return ContentExcess::None;
}

QString excessText(ContentExcess excess)
{
    if (excess == ContentExcess::Groups)
        return ContentBudget::tr("A project holds at most %1 groups, %2 layers in a map and %3 layers in all: remove "
                                 "some first.")
            .arg(kMostGroups)
            .arg(kMostLayersInMap)
            .arg(kMostLayers);
    if (excess == ContentExcess::Texels)
        return ContentBudget::tr("The project's maps would be larger than a project can be (%1 MiB painted): use fewer "
                                 "layers or smaller maps.")
            .arg(kMostHeldBytes >> 20U);
    return {};
}

} // namespace hairpaint::model
