// The library of styles: see the header.
#include "app/styles/library.h"

#include "model/disk/disk_sync.h"
#include "model/files/head_file.h"
#include "model/files/project_file.h"
#include "model/project/group_schema.h"
#include "model/project/hair_types.h"
#include "model/styles/style_folder.h"
#include "model/styles/style_use.h"
#include "model/values/names.h"
#include "model/values/search_text.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>

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
        model::makeNatural(group.settings);
        model::setHairType(group.settings, model::hairType("3B")); // The curls that paint on the curl map gives.
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
    if (QFileInfo(renamed).canonicalFilePath() != QFileInfo(path).canonicalFilePath() && !model::deleteFile(path))
        return model::failure(
            QCoreApplication::translate(
                "Library", "The style is now '%1', but its old file '%2' could not be removed; delete it by hand.")
                .arg(name, path));
    return {};
}

model::Result<void> changeStyle(const QString& path, const std::function<void(model::Preset&)>& change,
                                const model::Progress& progress)
{
    model::Result<model::Preset> preset = model::loadPreset(path);
    if (!preset)
        return tl::unexpected(preset.error());
    change(*preset);
    return model::savePreset(*preset, path, progress);
}

model::Result<bool> importStyle(const QString& path, const model::Progress& progress)
{
    model::Result<model::Preset> preset = model::loadPreset(path);
    if (!preset)
        return tl::unexpected(preset.error());
    const QString content = styleContentName(path);
    const QString wanted = preset->name;
    for (qsizetype number = 2; QFile::exists(ownStylePath(preset->name)); ++number) {
        if (styleContentName(ownStylePath(preset->name)) == content)
            return false;
        preset->name = model::numberedName(wanted, number);
    }
    if (!QDir().mkpath(ownPresetFolder()))
        return model::failure(
            QCoreApplication::translate("Library", "The folder '%1' could not be made; check that you may write there.")
                .arg(ownPresetFolder()));
    if (const model::Result<void> saved = model::savePreset(*preset, ownStylePath(preset->name), progress); !saved)
        return tl::unexpected(saved.error());
    return true;
}

model::Result<void> exportStyle(const QString& path, const QString& folder, const model::Progress& progress)
{
    const model::Result<model::Preset> preset = loadStyle(path);
    if (!preset)
        return tl::unexpected(preset.error());
    const QString base = QFileInfo(ownStylePath(preset->name)).completeBaseName();
    QString name = base;
    const auto inFolder = [&folder](const QString& one) {
        return QDir(folder).filePath(one + QStringLiteral(".hairpreset"));
    };
    for (int number = 2; QFile::exists(inFolder(name)); ++number)
        name = QStringLiteral("%1-%2").arg(base).arg(number);
    return model::savePreset(*preset, inFolder(name), progress);
}

namespace {

/// The tags of the folders and of the built-in styles, which a typed tag is recognised as in any language.
QStringList knownTags()
{
    QStringList tags;
    for (const model::PresetEntry& entry : model::listPresets({}))
        tags.append(entry.tags);
    for (const model::StyleFolder& folder : model::styleFolders())
        for (const char* tag : folder.tags)
            tags.append(QLatin1StringView(tag));
    tags.removeDuplicates();
    return tags;
}

} // namespace

QString shownTags(const QStringList& tags)
{
    QStringList shown;
    for (const QString& tag : tags)
        shown.append(model::shownName(tag));
    return shown.join(QStringLiteral(", "));
}

QStringList tagsFrom(const QString& text)
{
    const QStringList known = knownTags();
    QStringList tags;
    for (const QString& part : text.split(QLatin1Char(','))) {
        const QString tag = part.simplified();
        const QString form = model::searchForm(tag);
        const auto found = std::ranges::find_if(
            known, [&form](const QString& one) { return model::searchForm(model::shownName(one)) == form; });
        if (!tag.isEmpty())
            tags.append(found != known.end() ? *found : tag);
    }
    tags.removeDuplicates();
    return tags.mid(0, 32); // As many as a file may have.
}

} // namespace hairpaint::app
