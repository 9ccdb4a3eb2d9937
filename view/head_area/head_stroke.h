// A stroke of the active tool over the head's skin, over the strands that are seen, or with hair in the hand.
#pragma once

#include "model/tools/tool.h"
#include "view/editing/pointer.h"

#include <optional>

namespace hairpaint::view {

class EditorState;
class HeadScene;

/// Where the ray misses the skin between two events, or goes on behind, the stroke breaks: the tool gets the last point
/// before, then none, then the first point after. GUI thread; all that it is made of must outlive it.
class HeadStroke
{
public:
    HeadStroke(EditorState& editor, const HeadScene& scene) : m_editor(editor), m_scene(scene) {}

    /// Where there is skin, or with hair in the hand.
    void press(const PointerSample& sample, const std::optional<model::GrabbedHair>& grabbed);
    void move(const PointerSample& sample); ///< Nothing where the tool has ended the stroke.
    void release(const PointerSample& sample);

private:
    [[nodiscard]] model::ToolEvent toolEvent(const PointerSample& sample,
                                             const std::optional<sim::SurfacePoint>& point);
    /// The tool works on the strands that are seen there, where it does.
    [[nodiscard]] std::optional<model::ToolEvent> strandsEvent(const PointerSample& sample);
    [[nodiscard]] model::HairEvent hairEvent(const PointerSample& sample) const; ///< With hair in the hand.

    EditorState& m_editor;
    const HeadScene& m_scene;
    PointerSample m_at; ///< Last sample of the stroke.
    glm::vec2 m_lastUv{0.0F};
    std::optional<model::OverHair> m_began;      ///< Where the stroke first went over strands.
    bool m_overHair = false;                     ///< The last event went over strands.
    std::optional<model::GrabbedHair> m_grabbed; ///< It goes where the pointer goes, over skin and beside it.
};

} // namespace hairpaint::view
