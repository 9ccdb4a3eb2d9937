// What the 3D area remembers between events.
#pragma once

#include "view/brush_drag.h"
#include "view/editor_state.h"
#include "view/head/frame_presenter.h"
#include "view/head/head_camera.h"
#include "view/head/head_overlay.h"
#include "view/head/puff_gesture.h"
#include "view/head/stillness.h"
#include "view/head/view_signs.h"
#include "view/head_view.h"
#include "view/held_keys.h"
#include "view/pointer.h"
#include "view/weather_overlay.h"

#include <QBasicTimer>
#include <QElapsedTimer>
#include <QVariantAnimation>

namespace hairpaint::view {

struct HeadView::State
{
    enum class Drag
    {
        None,
        Stroke,
        Orbit,
        Pan,
        Light,
        Turn,
        Brush
    };

    State(EditorState& editorState, const Theme& startTheme, QObject* parent)
        : editor(editorState), theme(startTheme), keys({Qt::Key_Space, Qt::Key_H, Qt::Key_O}, parent)
    {}

    EditorState& editor;
    Theme theme;
    HeldKeys keys;
    FramePresenter* presenter = nullptr; ///< A child; null where nothing can be drawn.
    HeadOverlay* overlay = nullptr;      ///< Children.
    WeatherOverlay* weather = nullptr;
    ViewSigns* signs = nullptr;

    rendering::Scene scene; ///< Its camera is the view's.
    QVariantAnimation turning;
    QVariantAnimation turningBack; ///< Of the head.
    sim::HeadPose pose;            ///< The one asked for last.

    QBasicTimer drawSoon;
    QElapsedTimer sinceDraw;
    QBasicTimer settle; ///< When it fires the picture has been still for a moment: it is refined from then on.
    bool still = false; ///< What is shown stays as it is, though hair may go on moving by less than a pixel.
    bool paused = false;
    bool refining = false;
    Stillness stillness;

    std::optional<sim::SurfacePoint> brush; ///< Where it was last.

    Drag drag = Drag::None;
    PointerSample pressed;
    PointerSample strokeAt; ///< Where the stroke got to.
    rendering::Camera cameraBefore;
    sim::HeadPose poseBefore;
    model::LightSettings lightBefore;
    model::LightSettings light; ///< While it is dragged.
    BrushDrag brushDrag{editor};
    glm::vec2 lastUv{0.0F};
    PuffGesture puffs;

    /// Where the head stands in the frame that is shown.
    [[nodiscard]] sim::HeadPose shownPose() const { return scene.hair ? scene.hair->pose : pose; }
    [[nodiscard]] const sim::Skin* skin() const
    {
        const std::shared_ptr<const model::Head>& head = editor.document().project().head;
        return head ? head->skin.get() : nullptr;
    }
};

} // namespace hairpaint::view
