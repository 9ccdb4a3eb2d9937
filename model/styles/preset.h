// A hairstyle: what `.hairpreset` files hold and the style strip shows.
#pragma once

#include "model/project/project.h"
#include "model/styles/style_steps.h"

#include <QImage>
#include <QStringList>

namespace hairpaint::model {

/// One flattened raster a map (in a stack of one layer) and the settings, for one or more groups.
struct Preset
{
    QString name;
    QStringList tags;
    QString folder;                ///< "" for built-in ones; the user's own carry the file's path.
    std::vector<HairGroup> groups; ///< Ids are local to the preset.
    std::vector<Worn> worn;        ///< In the hair of these groups.
    /// On whose layout the maps lie; null where it is not known. Applied to a project on another head, the style is
    /// carried there (style_transfer.h).
    std::shared_ptr<const Head> head;
    std::vector<StyleStep> steps; ///< How it was made, from first to last; empty where nobody recorded it.
    QImage picture;               ///< 96 px and more a side; null where none was saved.
};

/// Whether anything of a map shows but what it starts from.
[[nodiscard]] bool isPainted(const MapStack& stack);
/// Flattens every stack of every group of a project.
[[nodiscard]] Preset presetFrom(const Project& project, const QString& name);

} // namespace hairpaint::model
