// Opens what can be read of a damaged project.
#pragma once

#include "model/project/project.h"
#include "model/values/error.h"
#include "model/values/progress.h"

#include <QStringList>

namespace hairpaint::model {

struct RepairedProject
{
    Project project;
    QStringList losses; ///< A sentence each; empty where nothing of the project was lost.
};

/// The file is only read. Entries are found wherever they lie; what is lost has its usual value, or nothing painted.
/// Fails for what is no project, was written by a newer program, or holds nothing that could be read. Any thread.
[[nodiscard]] Result<RepairedProject> repairProject(const QString& path, const Progress& progress = {});

} // namespace hairpaint::model
