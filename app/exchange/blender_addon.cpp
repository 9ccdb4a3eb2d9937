// Where Blender keeps what is the user's: docs.blender.org, "Blender's Directory Layout".
#include "app/exchange/blender_addon.h"

#include "model/disk/atomic_file.h"
#include "model/values/sentences.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QVersionNumber>

namespace hairpaint::app {

namespace {

const QString& addonsPart()
{
    static const QString part = QStringLiteral("/scripts/addons");
    return part;
}

QString blenderFolder()
{
#ifdef Q_OS_WIN
    return qEnvironmentVariable("APPDATA") + QStringLiteral("/Blender Foundation/Blender");
#else
    return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) + QStringLiteral("/blender");
#endif
}

} // namespace

QString blenderAddonName()
{
    return QStringLiteral("hair_paint_import.py");
}

QStringList blenderAddonFolders()
{
    const QVersionNumber first(3, 4);
    QStringList folders;
    const QDir folder(blenderFolder());
    for (const QString& version : folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot))
        if (const auto number = QVersionNumber::fromString(version); number.segmentCount() == 2 && number >= first)
            folders += folder.filePath(version) + addonsPart();
    return folders;
}

QString blenderVersionOf(const QString& addonFolder)
{
    return addonFolder.chopped(addonsPart().size()).section(QLatin1Char('/'), -1);
}

model::Result<void> installBlenderAddon(const QString& addonFolder, const model::Progress& progress)
{
    QDir().mkpath(addonFolder); // Where it can't be, writing says so.
    return saveBlenderAddon(QDir(addonFolder).filePath(blenderAddonName()), progress);
}

model::Result<void> saveBlenderAddon(const QString& path, const model::Progress& progress)
{
    QFile script(QStringLiteral(":/blender/") + blenderAddonName());
    const QByteArray text = script.open(QIODevice::ReadOnly) ? script.readAll() : QByteArray();
    Q_ASSERT(!text.isEmpty());
    return model::writeWanted(path, text, progress);
}

} // namespace hairpaint::app
