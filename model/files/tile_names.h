// Images of which each is one tile of a layout, by their files' names: "head_density.1001.png" and
// "head_density.1002.png" are together "head_density.<UDIM>.png". Any thread.
#pragma once

#include "model/heads/uv_tiles.h"
#include "model/values/sentences.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace hairpaint::model {

/// The path with "<UDIM>" instead of its tile's number where that is one of the head's, unless the head's maps are
/// those of tile 1001 as they are; the path itself else.
[[nodiscard]] QString tilePatternOf(const QString& path, const UvTiles& tiles);
/// The same of many, each pattern once; files of a pattern whose tile the head has not are in it as well.
[[nodiscard]] QStringList tilePatternsOf(const QStringList& paths, const UvTiles& tiles);
/// Whether it is such a pattern, and no file that has that name.
[[nodiscard]] bool isTilePattern(const QString& path);
/// A pattern's name without folder, tile and ending, and any other path's.
[[nodiscard]] QString mapTitleOf(const QString& path);
/// "head_density.png" for tile 1002: "head_density.1002.png".
[[nodiscard]] QString nameOfTile(const QString& name, int number);

struct TileFile
{
    QString path;
    int number = kFirstUdim;
};
/// The files that a pattern stands for, by number. Errors: a clause where there is none.
[[nodiscard]] Checked<std::vector<TileFile>> tileFilesOf(const QString& pattern);

} // namespace hairpaint::model
