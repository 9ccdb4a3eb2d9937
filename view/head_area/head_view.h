// The 3D area: hair in motion on the head, orbited, painted and blown upon.
#pragma once

#include "model/project/project.h"
#include "sim/motion/neck_motion.h"
#include "sim/motion/strand_frame.h"
#include "view/editing/painted_area.h"
#include "view/head_area/camera_flight.h"
#include "view/head_area/presenter_choice.h"
#include "view/head_area/shot.h"
#include "view/look/theme.h"
#include "view/rendering/backend.h"
#include "view/rendering/scene.h"
#include "view/rendering/standard_views.h"

#include <memory>
#include <optional>

namespace hairpaint::model {
struct Change;
}

namespace hairpaint::view {

class HeadCover;
class HeadFrames;
class HeadPointer;
class HeadScene;
class HeadTurn;

/// Needs no OpenGL: without a GPU our own renderer draws. The window's actions call the slots;
/// Space, H, O, Esc, Enter and the Weather overlay's keys are read here.
class HeadView : public PaintedArea
{
    Q_OBJECT
public:
    HeadView(EditorState& state, const Theme& theme, PresenterChoice choice = PresenterChoice::Automatic,
             QWidget* parent = nullptr);
    ~HeadView() override;

    void setTheme(const Theme& theme);
    /// Hair of a project that was closed is not shown.
    void setFrame(std::shared_ptr<const sim::StrandFrame> frame);

    /// Shows cards instead of the hair, until the hair changes; null: the hair again.
    void showCards(std::shared_ptr<const rendering::CardSet> cards);
    [[nodiscard]] bool cardsShown() const;

    [[nodiscard]] const rendering::Camera& camera() const;
    void setCamera(const rendering::Camera& camera);
    void setView(rendering::StandardView view); ///< Turns there in a moment.

    /// What is shown at present, without rings, for pictures drawn elsewhere.
    [[nodiscard]] rendering::Scene pictureScene() const;
    /// The skin that a position in this widget shows, hair ignored; none where the ray misses the head.
    [[nodiscard]] std::optional<sim::SurfacePoint> skinAt(QPointF position) const;
    /// Where a point of the head lies in this widget; none behind the eye.
    [[nodiscard]] std::optional<QPointF> positionOf(glm::vec3 positionHd) const;
    /// What draws, for the status bar and bug reports: the GPU's name or our own; empty until the first frame.
    [[nodiscard]] QString rendererDescription() const;

    [[nodiscard]] bool weatherShown() const;
    /// Whether more is to be drawn without anybody's doing: a picture is asked for, the camera is moving,
    /// or what is shown counts as still in a moment and is drawn finer.
    [[nodiscard]] bool awake() const;
    /// Whether a still picture is being made finer just now.
    [[nodiscard]] bool refining() const;

    /// The hair shows that map's colours at present; none: its own. With the direction map directions are drawn, too.
    void setLookedAt(std::optional<model::MapKind> map);

    /// Where what is put on goes: where the brush was last; none without a head.
    [[nodiscard]] std::optional<sim::SurfacePoint> pointForWorn() const;

    [[nodiscard]] QSize sizeHint() const override;

public Q_SLOTS:
    void resetCamera(); ///< Also ends a motion of the head.
    void fit();         ///< Shows the head with all of its hair, from where the camera looks now.
    /// The head goes through it once, so that the hair swings; not while it is dragged. Outside undo.
    void moveHead(hairpaint::sim::NeckMotion motion);
    void turnToBrush(); ///< Turns the camera to the skin where the brush was last, in whichever area.
    void addWorn(hairpaint::model::WornKind kind);         ///< Adds it where the brush was last, and chooses it.
    void addWornThing(const hairpaint::model::Worn& worn); ///< Chooses it, too.
    void mirrorWorn();                                     ///< Adds a copy of the chosen one on the other side.
    void addTwinTails();                                   ///< Adds ties there and on the other side.
    void removeWorn();                                     ///< Removes the chosen one.
    void setHairPaused(bool paused);                       ///< Says so over the picture.
    void setWeatherShown(bool shown);                      ///< F7: the paper's keys for wind and light.

Q_SIGNALS:
    void puffWanted(glm::vec3 centreWo, glm::vec3 velocity, float radiusM);
    void poseWanted(const hairpaint::sim::HeadPose& pose);
    /// `done`: false while it is being changed (a preview), true for the last one (one undo step).
    void lightWanted(const hairpaint::model::LightSettings& light, bool done);
    void windWanted(const hairpaint::sim::Wind& wind, bool done);
    void ownHairShown(); ///< The hair of a project that was opened is on the screen now.
    void frameDrawn(const hairpaint::rendering::FrameStatistics& statistics);
    void glUnavailable(const QString& reason); ///< The graphics card can't draw; our own renderer goes on.
    void statusText(const QString& text);
    void viewTurned(); ///< A drag turned the view.
    void contextMenuWanted(const QPoint& globalPosition);
    void weatherShownChanged(bool shown);
    void cardsShownChanged(bool shown);

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void connectParts();
    void onDocumentChanged(const model::Change& change);
    void refreshHead();
    void refreshEnvironment();
    void refreshRings();
    void follow(const Sight& sight);
    void refreshSigns();
    void animateTo(const std::optional<rendering::Camera>& camera);
    void layOut();

    void pointerPressed(const PointerSample& sample) override;
    void pointerMoved(const PointerSample& sample) override;
    void pointerReleased(const PointerSample& sample) override;

    EditorState& m_state;
    HeadTurn* m_turn; ///< A child.

    std::unique_ptr<HeadScene> m_scene;
    std::unique_ptr<HeadPointer> m_pointer;
    std::unique_ptr<HeadCover> m_cover;
    std::unique_ptr<HeadFrames> m_frames;
    CameraFlight m_flight;
    std::uint64_t m_firstRevision = 0; ///< First revision of the document that belongs to the open project.
    bool m_ownHairAwaited = false;     ///< The opened project's hair has not been on the screen yet.
    bool m_paused = false;
};

} // namespace hairpaint::view
