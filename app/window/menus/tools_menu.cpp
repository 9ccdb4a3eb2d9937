// The Tools menu: see the header.
#include "app/window/menus/tools_menu.h"

#include "app/window/physical_keys.h"
#include "view/widgets/value_pair.h"

#include <algorithm>

namespace hairpaint::app {

namespace {

void changeBrushSize(view::EditorState& editor, float factor)
{
    model::ToolSettings settings = editor.tools().settings();
    settings.brushSizeM = std::clamp(settings.brushSizeM * factor, 0.001F, 0.3F);
    editor.tools().setSettings(settings);
}

/// What is seen, the skin, the hair, and so on.
void changeTouch(view::EditorState& editor)
{
    model::ToolSettings settings = editor.tools().settings();
    model::putOption(settings, model::kTouchOption,
                     (static_cast<int>(settings.touch) + 1) % static_cast<int>(model::kTouchKinds.size()));
    editor.tools().setSettings(settings);
}

} // namespace

ToolsMenu::ToolsMenu(const QString& title, ActionSet& actions, view::EditorState& editor, QWidget* parent)
    : QMenu(title, parent)
{
    for (const auto& tool : editor.tools().all()) {
        const char* name = tool->name();
        const auto choose = [&editor, tool = tool->id(), goesBack = tool->traits().erases] {
            if (goesBack)
                editor.tools().toggle(tool);
            else
                editor.tools().choose(tool);
        };
        actions.add(*this, {{QByteArray("tool.") + name, tool->title(), {tool->traits().key}, choose, name}});
    }
    addSeparator();
    actions.add(*this,
                {{"tool.swapValues", tr("S&wap values"), {Qt::Key_X}, [&editor] { view::swapValues(editor); }},
                 {"tool.resetValues", tr("&Reset values"), {Qt::Key_D}, [&editor] { view::resetValues(editor); }},
                 {"tool.touch", tr("Wor&k on hair or skin"), {Qt::Key_T}, [&editor] { changeTouch(editor); }},
                 {"tool.smaller",
                  tr("S&maller brush"),
                  {usualKey(PhysicalKey::BracketLeft)},
                  [&editor] { changeBrushSize(editor, 1.0F / 1.15F); }},
                 {"tool.larger", tr("&Larger brush"), {usualKey(PhysicalKey::BracketRight)}, [&editor] {
                      changeBrushSize(editor, 1.15F);
                  }}});
}

} // namespace hairpaint::app
