// What is dropped on the window, and the kind of a file that is dropped or named on the command line.
#pragma once

#include "model/project/map_spec.h"

#include <QImage>
#include <QString>
#include <QStringList>

class QMimeData;

namespace hairpaint::app {

enum class FileKind
{
    Project,
    Style,
    Head,
    Curves,
    Image ///< Whatever is none of the others.
};

/// What is dragged over the window; the first of the members that is set counts.
struct Dropped
{
    QStringList files;       ///< Paths of files on this machine.
    QImage picture;          ///< A picture, as browsers give it.
    bool isOnTheWeb = false; ///< Whether there is only a web address, from which nothing is fetched.
    [[nodiscard]] bool isNothing() const { return files.isEmpty() && picture.isNull() && !isOnTheWeb; }
};
[[nodiscard]] Dropped whatIsDropped(const QMimeData& data);

/// The kind of a file by its ending.
[[nodiscard]] FileKind fileKind(const QString& path);

/// What letting go of it will do, in a sentence; an image goes into `map`.
[[nodiscard]] QString dropText(FileKind kind, const model::MapSpec& map);
[[nodiscard]] QString dropText(const Dropped& dropped, const model::MapSpec& map);
/// What to do where only an address is dropped.
[[nodiscard]] QString webText();

} // namespace hairpaint::app
