// Rows by their keys.
#include "app/settings/tool_memory.h"

namespace hairpaint::app {

void recallToolOptions(const Settings& settings, view::EditorState& editor)
{
    model::ToolSettings wanted = editor.tools().settings();
    for (const auto& tool : editor.tools().all())
        for (const model::ToolOption* option : tool->options())
            if (const std::optional<double> value = settings.toolOption(QLatin1StringView(option->key)))
                putOption(wanted, *option, *value);
    editor.tools().setSettings(wanted);
}

void rememberToolOptions(Settings& settings, const view::EditorState& editor)
{
    for (const auto& tool : editor.tools().all())
        for (const model::ToolOption* option : tool->options())
            if (!std::holds_alternative<model::ToolValue>(option->kind))
                settings.setToolOption(QLatin1StringView(option->key), optionOf(editor.tools().settings(), *option));
}

} // namespace hairpaint::app
