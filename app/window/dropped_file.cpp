// Endings and sentences.
#include "app/window/dropped_file.h"

#include "model/importing/curve_reader.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>

namespace hairpaint::app {

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

} // namespace hairpaint::app
