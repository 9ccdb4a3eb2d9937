// New ids for all that has one.
#include "model/styles/group_adoption.h"

namespace hairpaint::model {

void adoptGroup(Project& project, HairGroup group)
{
    group.id = project.takeId();
    for (SharedStack& stack : group.maps)
        for (Layer& layer : stack.write().layers)
            layer.id = project.takeId();
    project.groups.push_back(std::move(group));
}

} // namespace hairpaint::model
