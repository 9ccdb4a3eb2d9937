// The encoded bytes of layers that have not changed since they were read or written.
// Any thread: one lock. Holds the tiles it knows, so that their addresses can't come back with other texels.
#pragma once

#include "model/files/png_codec.h"

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace hairpaint::model {

/// Remembers the encoded bytes of unchanged layers, so that saving again costs what changed. Give the same one to load
/// and to every save of one document.
class EncodedLayers
{
public:
    /// Known where every tile is the very tile that was inserted, or all texels have the one inserted value.
    [[nodiscard]] std::optional<PngFile> find(const sim::TiledRaster& raster);
    void insert(const sim::TiledRaster& raster, const PngFile& png);
    /// The one that has most tiles in common with a raster that is not known, for encodeLayer.
    [[nodiscard]] std::optional<EncodedLayer> nearest(const sim::TiledRaster& raster);
    /// Forgets what was neither found nor inserted since the last call.
    void dropUnused();

    /// Layers that were encoded, not found; for tests.
    [[nodiscard]] int misses() const { return m_misses; }

private:
    struct KnownLayer
    {
        EncodedLayer layer;
        std::optional<sim::Texel> uniform;
        bool used = true;
    };
    KnownLayer* entryOf(const sim::TiledRaster& raster, const std::optional<sim::Texel>& uniform);

    std::mutex m_mutex;
    std::vector<KnownLayer> m_entries;
    int m_misses = 0;
};

[[nodiscard]] std::shared_ptr<EncodedLayers> makeEncodedLayers();

} // namespace hairpaint::model
