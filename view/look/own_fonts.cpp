// Looks into one folder.
#include "view/look/own_fonts.h"

#include <QCoreApplication>
#include <QDir>
#include <QFontDatabase>
#include <QFontInfo>

namespace hairpaint::view {

namespace {

/// The boxes that are drawn without any have no name; families are listed even then: names that stand for others.
bool isThereAFont()
{
    return !QFontInfo(QFont()).family().isEmpty();
}

} // namespace

bool provideFonts()
{
    if (isThereAFont())
        return true;
    const QDir folder(QCoreApplication::applicationDirPath() + QStringLiteral("/../share/hairpaint/fonts"));
    for (const QString& file : folder.entryList({QStringLiteral("*.otf"), QStringLiteral("*.ttf")}, QDir::Files))
        QFontDatabase::addApplicationFont(folder.filePath(file));
    return isThereAFont();
}

} // namespace hairpaint::view
