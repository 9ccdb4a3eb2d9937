// Projects of few hairs, for what does not hang on their number.
#pragma once

#include "model/files/project_file.h"

#include <algorithm>

namespace hairpaint::test {

/// The same with an eighth of the hairs and of the skeletons: windows and verbs get to their part of the work sooner.
inline model::Project thinned(model::Project project)
{
    constexpr int kFraction = 8;
    for (model::HairGroup& group : project.groups) {
        group.settings.greatestDensityPerM2 /= static_cast<float>(kFraction);
        group.settings.basisHairs /= kFraction;
    }
    return project;
}

/// A bald head with small maps and few candidates for hair, which would stand upright (how it lies is the dear part):
/// what is told of a project that never gets that far needs no more.
inline model::Project smallProject()
{
    model::Project project = model::newProject();
    project.groups = {model::makeGroup(project, project.groups.front().name, 256)};
    sim::TiledRaster& direction = project.groups.front().map(model::MapKind::Direction).layers.front().raster;
    direction = sim::TiledRaster(direction.size(), 3, {32768, 32768, 65535});
    return thinned(std::move(project));
}

/// Thins the project in that file; false where it can't be read or written.
inline bool thinOut(const QString& file)
{
    const model::Result<model::Project> project = model::loadProject(file);
    return project && model::saveProject(thinned(*project), file, {}).has_value();
}

} // namespace hairpaint::test
