// Maps as image files, one or many.
#pragma once

#include "model/heads/uv_tiles.h"
#include "model/project/project.h"
#include "model/values/error.h"
#include "model/values/progress.h"

#include <QStringList>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hairpaint::model {

/// Kinds of file that maps are written as; the first unless something else is wanted.
struct MapImageFormat
{
    const char* suffix; ///< "png"
    bool hasDepths;     ///< 8 or 16 bits a channel; else it has a depth of its own, which loses nothing.
};
[[nodiscard]] std::span<const MapImageFormat> mapImageFormats();
[[nodiscard]] QStringList mapImageSuffixes();
/// Null where there is none of that suffix.
[[nodiscard]] const MapImageFormat* findMapImageFormat(const QString& suffix);

struct MapImageOptions
{
    const MapImageFormat* format = &mapImageFormats().front();
    int bits = 16;     ///< 8 or 16
    bool grey = false; ///< The value as brightness instead of a colour of the scale, where a grey can tell it.
    std::optional<UvTiles> tiles = {}; ///< An image a tile of the head's, in its own layout; none: one a map.
};

/// A map that is to be written.
struct WantedMap
{
    QString group; ///< Its name.
    MapKind kind = MapKind::Density;
    std::shared_ptr<const sim::TiledRaster> resolved;
};

/// "Scalp-density.png" and so on, of tiles "Scalp-density.1001.png": map after map, names that every system takes, no
/// two alike.
[[nodiscard]] QStringList mapImageNames(std::span<const WantedMap> maps, const MapImageOptions& options);

/// All into a folder that is there, under these names; none where one of them fails or `progress` cancels, or where
/// several cells come from one tile. Any thread.
[[nodiscard]] Result<void> writeMapImages(std::span<const WantedMap> maps, const QString& folder,
                                          const MapImageOptions& options, const Progress& progress = {});

} // namespace hairpaint::model
