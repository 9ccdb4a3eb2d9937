// Endings and sentences.
#include "app/window/dropped_file.h"

#include "model/importing/curve_reader.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QMimeData>
#include <QUrl>

namespace hairpaint::app {

Dropped whatIsDropped(const QMimeData& data)
{
    Dropped dropped;
    const QList<QUrl> urls = data.urls();
    for (const QUrl& url : urls)
        if (url.isLocalFile())
            dropped.files += url.toLocalFile();
    if (dropped.files.isEmpty() && data.hasImage())
        dropped.picture = qvariant_cast<QImage>(data.imageData());
    dropped.isOnTheWeb = dropped.files.isEmpty() && dropped.picture.isNull() && !urls.isEmpty();
    return dropped;
}

FileKind fileKind(const QString& path)
{
    static const QStringList kHeads = {QStringLiteral("glb"), QStringLiteral("gltf"), QStringLiteral("obj"),
                                       QStringLiteral("fbx"), QStringLiteral("ply"),  QStringLiteral("dae"),
                                       QStringLiteral("3ds"), QStringLiteral("x3d"),  QStringLiteral("vrm")};
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix == QLatin1String("hairpaint"))
        return FileKind::Project;
    if (suffix == QLatin1String("hairpreset"))
        return FileKind::Style;
    if (model::curveFileEndings().contains(suffix))
        return FileKind::Curves;
    return kHeads.contains(suffix) ? FileKind::Head : FileKind::Image;
}

QString dropText(FileKind kind, const model::MapSpec& map)
{
    switch (kind) {
    case FileKind::Project:
        return QCoreApplication::translate("Drop", "Let go to open the project");
    case FileKind::Style:
        return QCoreApplication::translate("Drop", "Let go to apply the style");
    case FileKind::Head:
        return QCoreApplication::translate("Drop", "Let go to import the head");
    case FileKind::Curves:
        return QCoreApplication::translate("Drop", "Let go to import the hair");
    case FileKind::Image:
        break;
    }
    return QCoreApplication::translate("Drop", "Let go to load the image into %1").arg(map.titleText());
}

QString dropText(const Dropped& dropped, const model::MapSpec& map)
{
    if (dropped.isOnTheWeb)
        return webText();
    return dropText(dropped.files.isEmpty() ? FileKind::Image : fileKind(dropped.files.front()), map);
}

QString webText()
{
    return QCoreApplication::translate("Drop",
                                       "Only an address was dropped: copy the picture itself, and paste it here");
}

} // namespace hairpaint::app
