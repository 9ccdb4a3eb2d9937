// Which map an image is of, by its file's name.
#pragma once

#include "model/project/project.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <span>

namespace hairpaint::model {

struct NamedMap
{
    /// Index into `groups` of the group whose name the file's name begins with; none without such.
    std::optional<std::size_t> group;
    MapKind kind = MapKind::Density;
};

/// "Scalp-density.png" as the program writes it, "head_density.tif", "length.0001.exr", "Tip Colour (2).png". The last
/// name of a map in it counts; whatever follows that is a number or a version. None where it names no map.
[[nodiscard]] std::optional<NamedMap> mapNamedBy(const QString& path, std::span<const HairGroup> groups);

/// Endings of images in lower case, without the dot, that file dialogs and folders of maps offer.
[[nodiscard]] const QStringList& imageEndings();

} // namespace hairpaint::model
