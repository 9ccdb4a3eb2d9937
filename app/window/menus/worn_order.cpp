// What is looked for most comes first: see the header.
#include "app/window/menus/worn_order.h"

namespace hairpaint::app {

namespace {

enum class Part
{
    Ties,
    Adornments,
    Head
};

Part partOf(const model::WornSpec& spec)
{
    if (spec.tie)
        return Part::Ties;
    return spec.ofHead ? Part::Head : Part::Adornments;
}

} // namespace

std::vector<const model::WornSpec*> wornInMenus()
{
    std::vector<const model::WornSpec*> ordered;
    ordered.reserve(model::wornSpecs().size() + 2);
    for (const Part part : {Part::Ties, Part::Adornments, Part::Head}) {
        if (!ordered.empty())
            ordered.push_back(nullptr);
        for (const model::WornSpec& spec : model::wornSpecs())
            if (partOf(spec) == part)
                ordered.push_back(&spec);
    }
    return ordered;
}

} // namespace hairpaint::app
