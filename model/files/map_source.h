// What is read for a map: an image of all of it, or one a tile of the head's layout. Any thread.
#pragma once

#include "model/files/image_map.h"
#include "model/heads/uv_tiles.h"
#include "model/maps/image_reading.h"

#include <vector>

namespace hairpaint::model {

struct MapSource
{
    std::vector<ForeignImage> images; ///< At least one.
    /// By image: index of its cell in `tiles`; empty: the one image covers the whole map.
    std::vector<std::size_t> cells;
    UvTiles tiles;
    std::vector<int> leftOut; ///< Numbers of tiles that have files, but are none of the head's.
};

/// `path`: an image as imageForMap() reads it, or a pattern of tile_names.h. Errors: a sentence that names the file;
/// where no file is of a tile of the head's, or tiles can't be told apart by their numbers, too.
[[nodiscard]] Result<MapSource> mapSourceFrom(ImporterClient& client, const QString& path, const MapSpec& spec,
                                              const UvTiles& tiles, const Progress& progress = {});
/// What the images tell together.
[[nodiscard]] ImageReading readingOf(const MapSource& source, const MapSpec& spec);
/// As layerFromImage(); tiles at their cells, each texel that of its own point, and nothing where no tile was read.
/// `imageSize`: what `size` would be so that nothing is resampled.
[[nodiscard]] Result<ImageLayer> layerFromSource(const MapSource& source, const MapSpec& spec, bool grey, int size);
/// Both. `grey`: none leaves it to what the pixels tell, and to the map's scale where they tell both.
[[nodiscard]] Result<ImageLayer> layerFromPath(ImporterClient& client, const QString& path, const MapSpec& spec,
                                               std::optional<bool> grey, const UvTiles& tiles,
                                               std::vector<int>* leftOut = nullptr);
/// The part of a map's image that a cell shows, as large as imageSideFor() has it.
[[nodiscard]] ForeignImage imageOfCell(const ForeignImage& map, const UvTiles& tiles, std::size_t cell);
/// "tiles that the head has not are left out: 1005, 1006" as a clause after a file's name; empty where there are none.
[[nodiscard]] QString leftOutTiles(const std::vector<int>& numbers);

} // namespace hairpaint::model
