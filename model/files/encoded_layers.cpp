// Finding encoded layers by the identity of their tiles.
#include "model/files/encoded_layers.h"

#include "model/files/project_file.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

bool sameTiles(const sim::TiledRaster& a, const sim::TiledRaster& b)
{
    for (int index = 0; index < a.tileCount(); ++index)
        if (a.tile(index) != b.tile(index))
            return false;
    return true;
}

} // namespace

EncodedLayers::Entry* EncodedLayers::entryOf(const sim::TiledRaster& raster, const std::optional<sim::Texel>& uniform)
{
    const auto found = std::ranges::find_if(m_entries, [&](const Entry& entry) {
        return entry.raster.size() == raster.size() && entry.raster.channels() == raster.channels() &&
               entry.uniform == uniform && (uniform || sameTiles(entry.raster, raster));
    });
    return found == m_entries.end() ? nullptr : &*found;
}

std::optional<QByteArray> EncodedLayers::find(const sim::TiledRaster& raster)
{
    const std::optional<sim::Texel> uniform = raster.uniformValue();
    const std::scoped_lock lock(m_mutex);
    Entry* entry = entryOf(raster, uniform);
    if (entry == nullptr) {
        ++m_misses;
        return std::nullopt;
    }
    entry->used = true;
    return entry->bytes;
}

void EncodedLayers::insert(const sim::TiledRaster& raster, const QByteArray& bytes)
{
    const std::optional<sim::Texel> uniform = raster.uniformValue();
    const std::scoped_lock lock(m_mutex);
    if (entryOf(raster, uniform) == nullptr)
        m_entries.push_back({.raster = raster, .uniform = uniform, .bytes = bytes});
}

void EncodedLayers::dropUnused()
{
    const std::scoped_lock lock(m_mutex);
    std::erase_if(m_entries, [](const Entry& entry) { return !entry.used; });
    for (Entry& entry : m_entries)
        entry.used = false;
}

std::shared_ptr<EncodedLayers> makeEncodedLayers()
{
    return std::make_shared<EncodedLayers>();
}

} // namespace hairpaint::model
