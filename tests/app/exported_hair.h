// Hair of styles as `hairpaint export` writes it, made in this process: a start of the program for each shape would
// load the head and grow the hair once more.
#pragma once

#include "app/headless/settled_hair.h"
#include "app/styles/library.h"
#include "model/files/project_file.h"
#include "model/formats/export_format.h"
#include "model/styles/preset.h"
#include "model/styles/style_use.h"
#include "tests/app/program.h"

namespace hairpaint::test {

using Strands = std::vector<std::vector<glm::vec3>>;

/// As `hairpaint new --preset NAME` makes it; none where there is no such style.
inline std::optional<model::Project> styledProject(const QString& name)
{
    const model::Result<model::Preset> preset = app::loadPresetNamed(name);
    if (!preset)
        return std::nullopt;
    model::Project project = model::newProject();
    model::applyPreset(project, *preset);
    return project;
}

/// A frame of the project's hair written to `file` and read back; `hairs`: as with --hairs. Empty where it can't be
/// written.
inline Strands exportedHair(const model::Project& project, const std::shared_ptr<const sim::StrandFrame>& frame,
                            const QString& file, std::optional<std::size_t> hairs)
{
    model::ExportRequest request{.format = &model::exportFormats().front(), .target = &model::exportTargets().front()};
    for (const model::HairGroup& group : project.groups)
        request.curves.groups.push_back({.id = group.id, .name = group.name});
    request.curves.hairs = hairs;
    return model::exportHair(frame, request, file) ? readHair(file) : Strands();
}
inline Strands exportedHair(const app::SettledHair& hair, const QString& file,
                            std::optional<std::size_t> hairs = std::nullopt)
{
    return exportedHair(hair.project(), hair.frame(), file, hairs);
}

} // namespace hairpaint::test
