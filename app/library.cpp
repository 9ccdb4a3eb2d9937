// The library of styles: see the header.
#include "app/library.h"

#include "model/commands/commands.h"
#include "model/files/project_file.h"
#include "model/names.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStandardPaths>

namespace hairpaint::app {

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
    const std::vector<model::PresetEntry> entries = model::listPresets({});
    if (!entries.empty())
        if (const model::Result<model::Preset> preset = model::loadPreset(entries.front().path))
            model::applyPreset(project, *preset);
    project.wind.velocity = glm::vec3(1.2F, 0.0F, 0.5F);
    return project;
}

} // namespace hairpaint::app
