// What is worn, under the pointer: chosen, moved and sized.
#pragma once

#include "model/document/edit_session.h"
#include "model/project/worn.h"
#include "view/editing/pointer.h"
#include "view/head_area/worn_outline.h"

#include <vector>

class QWidget;

namespace hairpaint::view {

class EditorState;
class HeadScene;

/// The worn things whose outlines are shown: all while colliders are shown, else the chosen one.
[[nodiscard]] std::vector<model::Worn> outlinedWorn(const EditorState& editor);

/// Whether a thing that is drawn lies behind the head, where no hand reaches it: skin is seen before all of it.
[[nodiscard]] bool isBehindHead(const model::Worn& worn, const HeadScene& scene, const HeadSight& sight);

/// A press on an outline, or on a body that is drawn, chooses that thing and drags it in the plane of the screen, or
/// over the skin where it stands on it (with Shift: makes it larger or smaller), one on the handle off it turns it
/// (with Shift: about itself), and one on an end of a chosen one's axis changes what WornSpec::handles says.
/// One elsewhere lets go of what is chosen and drawn. Each drag is one undo step, or none where it is cancelled. GUI
/// thread; all that it is made of must outlive it.
class WornDrag
{
public:
    WornDrag(EditorState& editor, const HeadScene& scene, const QWidget& area)
        : m_editor(editor), m_scene(scene), m_area(area)
    {}

    [[nodiscard]] bool press(const PointerSample& sample); ///< Returns whether something was taken hold of.
    void move(const PointerSample& sample);
    void release() { m_edit.commit(); }
    void cancel() { m_edit.drop(); }
    /// Whether a press there would take hold of something.
    [[nodiscard]] bool reaches(QPointF position) const { return gripAt(position).id != 0; }

private:
    static constexpr int kNoEnd = -1;
    struct Grip
    {
        model::Id id = 0; ///< 0: nothing is held.
        int end = kNoEnd; ///< Number of a WornHandle; kNoEnd: the outline or the body.
    };
    [[nodiscard]] Grip gripAt(QPointF position) const;
    [[nodiscard]] model::Id bodyAt(QPointF position) const; ///< 0 where none is before the skin.
    [[nodiscard]] HeadSight sight() const;
    [[nodiscard]] bool isShiftHeld() const { return m_pressed.modifiers.testFlag(Qt::ShiftModifier); }
    void show(const char* step, const model::Worn& now);
    [[nodiscard]] model::Worn overSkin(const PointerSample& sample);
    [[nodiscard]] model::Worn turned(const PointerSample& sample) const;
    [[nodiscard]] sim::Ellipsoid moved(const PointerSample& sample) const;
    [[nodiscard]] sim::Ellipsoid sized(const PointerSample& sample) const;

    EditorState& m_editor;
    const HeadScene& m_scene;
    const QWidget& m_area;
    model::EditSession m_edit;
    Grip m_grip;
    PointerSample m_pressed;
    model::Worn m_before;
    std::optional<sim::SurfacePoint> m_over; ///< Point of the skin to which it was dragged last.
};

} // namespace hairpaint::view
