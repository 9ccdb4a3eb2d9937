// A new project with one of the built-in styles on the bust.
#pragma once

#include "model/document/document.h"
#include "model/document/group_commands.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/styles/preset.h"

#include <map>
#include <utility>

namespace hairpaint::test {

/// The built-in style named so in the strip; read once a program. Null: there is none.
inline const model::Preset* builtInStyle(const QString& name)
{
    static std::map<QString, model::Preset> read;
    if (const auto known = read.find(name); known != read.end())
        return &known->second;
    for (const model::PresetEntry& entry : model::listPresets({}))
        if (entry.name == name)
            if (auto preset = model::loadPreset(entry.path))
                return &read.emplace(name, std::move(*preset)).first->second;
    return nullptr;
}

/// At most `maxHairs` of the style named so in the strip. The first layer of each of its maps has its name.
inline model::Project wearing(const QString& style, int maxHairs)
{
    model::Project project = model::newProject();
    project.maxHairs = maxHairs;
    model::Document document(std::move(project));
    if (const model::Preset* preset = builtInStyle(style))
        document.push(model::applyPresetCommand(document, *preset));
    return document.project();
}

} // namespace hairpaint::test
