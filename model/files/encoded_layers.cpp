// Finding encoded layers by the identity of their tiles.
#include "model/files/encoded_layers.h"

#include "model/files/project_file.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

int commonTiles(const sim::TiledRaster& a, const sim::TiledRaster& b)
{
    if (a.size() != b.size() || a.channels() != b.channels())
        return 0;
    int count = 0;
    for (int index = 0; index < a.tileCount(); ++index)
        count += a.tile(index) == b.tile(index) ? 1 : 0;
    return count;
}

} // namespace

EncodedLayers::KnownLayer* EncodedLayers::entryOf(const sim::TiledRaster& raster,
                                                  const std::optional<sim::Texel>& uniform)
{
    const auto found = std::ranges::find_if(m_entries, [&](const KnownLayer& entry) {
        const sim::TiledRaster& known = entry.layer.raster;
        return known.size() == raster.size() && known.channels() == raster.channels() && entry.uniform == uniform &&
               (uniform || commonTiles(known, raster) == raster.tileCount());
    });
    return found == m_entries.end() ? nullptr : &*found;
}

std::optional<PngFile> EncodedLayers::find(const sim::TiledRaster& raster)
{
    const std::optional<sim::Texel> uniform = raster.uniformValue();
    const std::scoped_lock lock(m_mutex);
    KnownLayer* entry = entryOf(raster, uniform);
    if (entry == nullptr) {
        ++m_misses;
        return std::nullopt;
    }
    entry->used = true;
    return entry->layer.png;
}

void EncodedLayers::insert(const sim::TiledRaster& raster, const PngFile& png)
{
    const std::optional<sim::Texel> uniform = raster.uniformValue();
    const std::scoped_lock lock(m_mutex);
    if (entryOf(raster, uniform) == nullptr)
        m_entries.push_back({.layer = {.raster = raster, .png = png}, .uniform = uniform});
}

std::optional<EncodedLayer> EncodedLayers::nearest(const sim::TiledRaster& raster)
{
    const std::scoped_lock lock(m_mutex);
    const KnownLayer* best = nullptr;
    int most = 0;
    for (const KnownLayer& entry : m_entries)
        if (const int count = commonTiles(entry.layer.raster, raster); count > most) {
            best = &entry;
            most = count;
        }
    return best != nullptr ? std::optional(best->layer) : std::nullopt;
}

void EncodedLayers::dropUnused()
{
    const std::scoped_lock lock(m_mutex);
    std::erase_if(m_entries, [](const KnownLayer& entry) { return !entry.used; });
    for (KnownLayer& entry : m_entries)
        entry.used = false;
}

std::shared_ptr<EncodedLayers> makeEncodedLayers()
{
    return std::make_shared<EncodedLayers>();
}

} // namespace hairpaint::model
