// What tools have in common.
#include "model/tools/tool.h"

#include "model/tools/cut_pieces.h"

namespace hairpaint::model {

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

std::vector<CutPiece> Tool::takeCutOff()
{
    return {};
}

} // namespace hairpaint::model
