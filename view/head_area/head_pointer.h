// What the pointer does over the 3D area: strokes, orbits, pans, turns the head or the light, changes the brush or what
// is worn, blows.
#pragma once

#include "model/project/project.h"
#include "view/editing/brush_drag.h"
#include "view/editing/held_keys.h"
#include "view/editing/pointer.h"
#include "view/head_area/head_stroke.h"
#include "view/head_area/puff_gesture.h"
#include "view/head_area/worn_drag.h"
#include "view/rendering/scene.h"

#include <QObject>

#include <optional>

class QWidget;

namespace hairpaint::view {

class EditorState;
class HeadScene;
class HeadTurn;

/// One drag at a time, chosen by its press: button, modifiers, held keys, and whether there is skin below. Without a
/// drag the pointer hovers. GUI thread; all that it is made of must outlive it.
class HeadPointer : public QObject
{
    Q_OBJECT
public:
    /// Positions are in `area`, whose cursor this sets.
    HeadPointer(EditorState& editor, const HeadScene& scene, HeadTurn& turn, QWidget& area);

    void press(const PointerSample& sample);
    void move(const PointerSample& sample);
    void release(const PointerSample& sample);
    void leave();
    /// A picture from that camera is shown: what lies under a pointer that rests is another where the camera is.
    void follow(const rendering::Camera& camera);
    /// A key of the active tool, or Esc in a drag that it ends; false leaves it to others.
    bool handleKey(Qt::Key key, Qt::KeyboardModifiers modifiers);

    [[nodiscard]] bool dragging() const { return m_drag != Drag::None; }
    /// The light while it is dragged; the document's follows when the drag ends.
    [[nodiscard]] std::optional<model::LightSettings> draggedLight() const;
    void updateCursor();

Q_SIGNALS:
    void cameraWanted(const hairpaint::rendering::Camera& camera);
    void lightDragged(); ///< draggedLight() is another one, or none where Esc ended it.
    /// `done`: false while it is being changed (a preview), true for the last one (one undo step).
    void lightWanted(const hairpaint::model::LightSettings& light, bool done);
    void puffWanted(glm::vec3 centreWo, glm::vec3 velocity, float radiusM);
    void statusText(const QString& text);
    void viewTurned(); ///< A drag that turned the view has ended.
    void contextMenuWanted(const QPoint& globalPosition);

private:
    enum class Drag
    {
        None,
        Stroke,
        Picture,
        Orbit,
        Pan,
        Light,
        Turn,
        Brush,
        Worn
    };

    [[nodiscard]] Drag dragOf(const PointerSample& pressed);
    void dragLight(QPointF pixels);
    [[nodiscard]] bool grabs() const; ///< The active tool takes hold of hair.
    void hoverAt(const PointerSample& sample);
    void blowAt(const PointerSample& sample);

    EditorState& m_editor;
    const HeadScene& m_scene;
    HeadTurn& m_turn;
    QWidget& m_area;
    HeldKeys m_keys;
    HeadStroke m_stroke;
    BrushDrag m_brushDrag;
    WornDrag m_wornDrag;
    bool m_overWorn = false;
    std::optional<PointerSample> m_hovering; ///< Where, while the pointer is over the area.
    rendering::Camera m_shownCamera;
    PuffGesture m_puffs;

    Drag m_drag = Drag::None;
    PointerSample m_pressed;
    std::optional<model::GrabbedHair> m_grabbed; ///< By the press, where the tool grabs.
    rendering::Camera m_cameraBefore;
    model::LightSettings m_lightBefore;
    model::LightSettings m_light; ///< The light being dragged.
};

} // namespace hairpaint::view
