// Puts the parts together.
#include "view/editing/editor_state.h"

namespace hairpaint::view {

EditorState::EditorState(model::Document& document, QObject* parent) : QObject(parent), m_target(document)
{
    connect(&m_tools, &ToolBox::refused, this, &EditorState::refused);
    connect(&m_tools, &ToolBox::told, this, &EditorState::told);
}

} // namespace hairpaint::view
