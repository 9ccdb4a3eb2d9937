// Groups from elsewhere become a project's own.
#pragma once

#include "model/project/project.h"

namespace hairpaint::model {

/// Adds a group whose ids are nobody's yet.
void adoptGroup(Project& project, HairGroup group);

} // namespace hairpaint::model
