// Looks into one folder.
#include "view/look/own_fonts.h"

#include <QCoreApplication>
#include <QDir>
#include <QFontDatabase>

namespace hairpaint::view {

bool provideFonts()
{
    if (!QFontDatabase::families().isEmpty())
        return true;
    const QDir folder(QCoreApplication::applicationDirPath() + QStringLiteral("/../share/hairpaint/fonts"));
    for (const QString& file : folder.entryList({QStringLiteral("*.otf"), QStringLiteral("*.ttf")}, QDir::Files))
        QFontDatabase::addApplicationFont(folder.filePath(file));
    return !QFontDatabase::families().isEmpty();
}

} // namespace hairpaint::view
