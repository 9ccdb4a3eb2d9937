// The eraser's words.
#include "view/widgets/revealed_text.h"

#include "view/look/value_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace hairpaint::view {

bool erases(const EditorState& state)
{
    return state.tools().active().traits().erases;
}

QString revealedText(const EditorState& state)
{
    const model::HairGroup* group = state.document().project().group(state.target().group());
    if (group == nullptr || !erases(state))
        return {};
    const model::MapSpec& spec = model::mapSpec(state.target().map());
    const std::vector<model::Layer>& layers = group->map(spec.kind).layers;
    const auto active = std::ranges::find(layers, state.target().layer(), &model::Layer::id);
    const bool covers = std::any_of(layers.begin(), active,
                                    [](const model::Layer& layer) { return layer.visible && layer.opacity > 0; });
    if (covers)
        return QCoreApplication::translate("RevealedText", "reveals the layers below");
    if (spec.follows)
        return QCoreApplication::translate("RevealedText", "reveals the map %1")
            .arg(model::mapSpec(*spec.follows).titleText());
    const model::Head* head = state.document().project().head.get();
    if (spec.ofHead != nullptr && head != nullptr && spec.ofHead(*head) != nullptr)
        return QCoreApplication::translate("RevealedText", "reveals how hair naturally lies");
    return QCoreApplication::translate("RevealedText", "reveals %1, the default")
        .arg(valueText(group->settings, spec, valueOfTexel(spec, spec.defaultValue)));
}

} // namespace hairpaint::view
