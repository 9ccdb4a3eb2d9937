// The library of styles: see the header.
#include "app/styles/library.h"

#include "model/document/commands.h"
#include "model/files/head_file.h"
#include "model/files/project_file.h"
#include "model/project/group_schema.h"
#include "model/values/names.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

namespace hairpaint::app {

namespace {

const QString kBald = QStringLiteral("Bald");

} // namespace

QString ownPresetFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/styles");
}

model::Result<model::Preset> loadPresetNamed(const QString& nameOrPath)
{
    for (const model::PresetEntry& entry : model::listPresets(ownPresetFolder()))
        if (entry.name.compare(nameOrPath, Qt::CaseInsensitive) == 0 ||
            model::shownName(entry.name).compare(nameOrPath, Qt::CaseInsensitive) == 0 ||
            QFileInfo(entry.path).completeBaseName().compare(nameOrPath, Qt::CaseInsensitive) == 0)
            return model::loadPreset(entry.path);
    if (nameOrPath.endsWith(QStringLiteral(".hairpreset"), Qt::CaseInsensitive))
        return model::loadPreset(nameOrPath);
    return model::failure(QCoreApplication::translate(
                              "Library", "There is no style named '%1'; 'hairpaint presets' lists those there are.")
                              .arg(nameOrPath));
}

model::Project starterProject()
{
    model::Project project = model::newProject();
    const QStringList styles = model::builtInPresets();
    if (!styles.isEmpty())
        if (const model::Result<model::Preset> preset = model::loadPreset(styles.front()))
            model::applyPreset(project, *preset);
    // Calm, so that the first thing seen is the haircut. Where the wind is turned on it is a breath: enough to see that
    // hair lives, too little to skew the cut.
    project.wind.enabled = false;
    project.wind.velocity = glm::vec3(0.12F, 0.0F, 0.1F);
    return project;
}

model::Project baldProject()
{
    model::Project project = model::newProject();
    for (model::HairGroup& group : project.groups) {
        group.settings.variation = model::naturalVariation();
        model::setNaturalEnds(group.settings);
    }
    return project;
}

QString baldStylePath()
{
    return QStringLiteral(":/bald");
}

std::vector<model::PresetEntry> listStyles(QStringList* problems)
{
    std::vector<model::PresetEntry> entries = model::listPresets(ownPresetFolder(), problems);
    entries.insert(
        entries.begin(),
        {.path = baldStylePath(), .name = kBald, .tags = {}, .folder = QStringLiteral("built-in"), .picture = {}});
    return entries;
}

QString styleContentName(const QString& path)
{
    if (path == baldStylePath())
        return QStringLiteral("bald");
    QFile file(path);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (!file.open(QIODevice::ReadOnly) || !hash.addData(&file))
        return {};
    return QString::fromLatin1(hash.result().toHex());
}

model::Result<model::Preset> loadStyle(const QString& path)
{
    if (path == baldStylePath())
        return model::presetFrom(baldProject(), kBald);
    return model::loadPreset(path);
}

QString styleName(const QString& path)
{
    if (path == baldStylePath())
        return model::shownName(kBald);
    const model::Result<model::PresetEntry> entry = model::presetEntry(path);
    return entry ? model::shownName(entry->name) : QFileInfo(path).completeBaseName();
}

QString ownStylePath(const QString& name)
{
    // Letters and digits are a file name that every system takes.
    QString base;
    for (const QChar letter : name.toLower())
        base += letter.isLetterOrNumber() ? letter : QLatin1Char('-');
    return ownPresetFolder() + QLatin1Char('/') + (base.isEmpty() ? QStringLiteral("style") : base) +
           QStringLiteral(".hairpreset");
}

model::Result<void> renameStyle(const QString& path, const QString& name, const model::Progress& progress)
{
    model::Result<model::Preset> preset = model::loadPreset(path);
    if (!preset)
        return tl::unexpected(preset.error());
    preset->name = name;
    const QString renamed = ownStylePath(name);
    if (const model::Result<void> saved = model::savePreset(*preset, renamed, progress); !saved)
        return tl::unexpected(saved.error());
    // Where letters' case does not count the new file may be the old one.
    if (QFileInfo(renamed).canonicalFilePath() != QFileInfo(path).canonicalFilePath() && !QFile::remove(path))
        return model::failure(
            QCoreApplication::translate(
                "Library", "The style is now '%1', but its old file '%2' could not be removed; delete it by hand.")
                .arg(name, path));
    return {};
}

} // namespace hairpaint::app
