// The ellipsoids over the head under the pointer: chosen, moved and sized.
#pragma once

#include "model/document/edit_session.h"
#include "view/editing/pointer.h"
#include "view/head_area/collider_shape.h"

#include <cstddef>
#include <optional>

class QWidget;

namespace hairpaint::view {

class EditorState;
class HeadScene;

/// While colliders are shown, a press on an outline chooses that one and drags it in the plane of the screen (with
/// Shift: makes it larger or smaller), and one on an end of a chosen one's axis changes that radius (with Shift: all).
/// Each drag is one undo step, or none where it is cancelled. GUI thread; all that it is made of must outlive it.
class ColliderDrag
{
public:
    ColliderDrag(EditorState& editor, const HeadScene& scene, const QWidget& area)
        : m_editor(editor), m_scene(scene), m_area(area)
    {}

    [[nodiscard]] bool press(const PointerSample& sample); ///< Whether something was taken hold of.
    void move(const PointerSample& sample);
    void release() { m_edit.commit(); }
    void cancel() { m_edit.drop(); }
    /// Whether a press there would take hold of something.
    [[nodiscard]] bool reaches(QPointF position) const { return gripAt(position).has_value(); }

private:
    struct Grip
    {
        std::size_t index = 0;
        std::optional<int> end = {}; ///< Of an axis; none: the outline.
    };
    [[nodiscard]] std::optional<Grip> gripAt(QPointF position) const;
    [[nodiscard]] HeadSight sight() const;
    [[nodiscard]] sim::Ellipsoid moved(const PointerSample& sample) const;
    [[nodiscard]] sim::Ellipsoid sized(const PointerSample& sample) const;

    EditorState& m_editor;
    const HeadScene& m_scene;
    const QWidget& m_area;
    model::EditSession m_edit;
    Grip m_grip;
    PointerSample m_pressed;
    sim::Ellipsoid m_before;
};

} // namespace hairpaint::view
