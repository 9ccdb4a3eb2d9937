// Counting what a document holds.
#include "model/content_budget.h"

#include <QCoreApplication>

#include <iterator>
#include <set>
#include <tuple>

namespace hairpaint::model {

namespace {

struct ContentBudget
{
    Q_DECLARE_TR_FUNCTIONS(ContentBudget)
};

/// Exactly, tile by tile.
bool texelsExceed(const std::vector<HairGroup>& groups)
{
    std::set<std::tuple<int, int, sim::Texel>> uniform;
    qint64 distinct = 0;
    std::size_t bytes = 0;
    for (const HairGroup& group : groups)
        for (const MapStack& stack : group.maps)
            for (const Layer& layer : stack.layers) {
                const sim::TiledRaster& raster = layer.raster;
                bytes += raster.byteCount();
                const std::optional<sim::Texel> value = raster.uniformValue();
                if (!value || uniform.emplace(raster.size(), raster.channels(), *value).second)
                    distinct += qint64{raster.size()} * raster.size();
            }
    return distinct > kMostDistinctTexels || bytes > kMostHeldBytes;
}

} // namespace

bool paintingMayExceed(const std::vector<HairGroup>& groups)
{
    qint64 texels = 0;
    qint64 bytes = 0; // If every texel were painted.
    for (const HairGroup& group : groups)
        for (const MapStack& stack : group.maps)
            for (const Layer& layer : stack.layers) {
                const qint64 count = qint64{layer.raster.size()} * layer.raster.size();
                texels += count;
                bytes += count * layer.raster.channels() * qint64{sizeof(std::uint16_t)};
            }
    return texels > kMostDistinctTexels || bytes > static_cast<qint64>(kMostHeldBytes);
}

ContentExcess excessOf(const std::vector<HairGroup>& groups)
{
    std::size_t layers = 0;
    qint64 texels = 0;
    bool fits = groups.size() <= static_cast<std::size_t>(kMostGroups);
    for (const HairGroup& group : groups)
        for (const MapStack& stack : group.maps) {
            layers += stack.layers.size();
            texels += qint64{stack.size} * stack.size * std::ssize(stack.layers);
            fits = fits && stack.layers.size() <= static_cast<std::size_t>(kMostLayersInMap);
        }
    if (!fits || layers > static_cast<std::size_t>(kMostLayers))
        return ContentExcess::Groups;
    if (texels > kMostTexels || (paintingMayExceed(groups) && texelsExceed(groups)))
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
