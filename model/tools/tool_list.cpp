// The tools, in tool-bar order.
#include "model/tools/tool_list.h"

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

std::vector<std::unique_ptr<Tool>> makeTools()
{
    std::vector<std::unique_ptr<Tool>> tools;
    tools.push_back(makeBrushTool());
    tools.push_back(makeEraserTool());
    tools.push_back(makeCombTool());
    tools.push_back(makePartTool());
    tools.push_back(makeGrabTool());
    tools.push_back(makeFingersTool());
    tools.push_back(makeScissorsTool());
    tools.push_back(makeGradientTool());
    tools.push_back(makeFillTool());
    tools.push_back(makeShapeTool());
    tools.push_back(makeSelectTool());
    tools.push_back(makePickerTool());
    return tools;
}

} // namespace hairpaint::model
