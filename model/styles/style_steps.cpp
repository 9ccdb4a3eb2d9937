// Steps in a row count as one: see the header.
#include "model/styles/style_steps.h"

namespace hairpaint::model {

void addStep(std::vector<StyleStep>& steps, const QString& tool, const QString& on)
{
    if (!steps.empty() && steps.back().tool == tool && steps.back().on == on)
        ++steps.back().count;
    else
        steps.push_back({.tool = tool, .on = on});
}

} // namespace hairpaint::model
