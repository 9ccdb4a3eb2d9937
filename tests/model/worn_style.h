// A new project with one of the built-in styles on the bust.
#pragma once

#include "model/document/commands.h"
#include "model/document/document.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/styles/preset.h"

#include <utility>
#include <vector>

namespace hairpaint::test {

/// Read once a program.
inline const std::vector<model::Preset>& builtInStyles()
{
    static const std::vector<model::Preset> styles = [] {
        std::vector<model::Preset> read;
        for (const QString& path : model::builtInPresets())
            if (auto preset = model::loadPreset(path))
                read.push_back(std::move(*preset));
        return read;
    }();
    return styles;
}

/// At most `maxHairs` of the style named so in the strip. The first layer of each of its maps has its name.
inline model::Project wearing(const QString& style, int maxHairs)
{
    model::Project project = model::newProject();
    project.maxHairs = maxHairs;
    model::Document document(std::move(project));
    for (const model::Preset& preset : builtInStyles())
        if (preset.name == style)
            document.push(model::applyPresetCommand(document, preset));
    return document.project();
}

} // namespace hairpaint::test
