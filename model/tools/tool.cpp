// What tools have in common.
#include "model/tools/tool.h"

namespace hairpaint::model {

namespace {

/// The text of the first of the tool's choices that has one; empty where none has.
QString saidByChoice(const Tool& tool, const ToolSettings& settings, const char* ToolChoice::Item::*words)
{
    for (const ToolOption* option : tool.options())
        if (const auto* choice = std::get_if<ToolChoice>(&option->kind))
            if (const char* said = choice->chosen(settings).*words; *said != '\0')
                return Tool::tr(said);
    return {};
}

} // namespace

QString Tool::hintFor(const ToolSettings& settings) const
{
    const QString said = saidByChoice(*this, settings, &ToolChoice::Item::hint);
    return said.isEmpty() ? hint() : said;
}

QString Tool::stepFor(const ToolSettings& settings) const
{
    return saidByChoice(*this, settings, &ToolChoice::Item::step);
}

LayerAddress ToolContext::layer(MapKind map) const
{
    LayerAddress address{.group = target.group, .map = map};
    if (map == target.map)
        address.layer = target.layer;
    else if (activeLayer != nullptr)
        address.layer = activeLayer(map);
    else if (const HairGroup* group = document.project().group(target.group);
             group != nullptr && !group->map(map).layers.empty())
        address.layer = group->map(map).layers.back().id;
    return address;
}

} // namespace hairpaint::model
