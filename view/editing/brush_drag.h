// The drags that change the brush itself, the same in both areas.
#pragma once

#include "view/editing/editor_state.h"
#include "view/editing/held_keys.h"
#include "view/editing/pointer.h"

namespace hairpaint::view {

/// Ctrl and the right button: sideways the size, up and down the hardness. O and the left button: sideways the opacity.
class BrushDrag
{
public:
    explicit BrushDrag(EditorState& state) : m_state(state) {}

    /// Whether this press begins one.
    [[nodiscard]] bool press(const PointerSample& sample, const HeldKeys& keys);
    void move(const PointerSample& sample);

private:
    EditorState& m_state;
    bool m_opacity = false;
    QPointF m_pressed;
    model::ToolSettings m_before;
};

/// "Size 3.2 cm, hardness 60 %, opacity 100 %", for the status bar.
[[nodiscard]] QString brushText(const model::ToolSettings& settings);

} // namespace hairpaint::view
