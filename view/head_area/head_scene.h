// What the 3D area's scene holds: head, hair, camera, light and the brush's rings.
#pragma once

#include "model/project/project.h"
#include "model/tools/tool.h"
#include "sim/motion/strand_frame.h"
#include "sim/skin/skin.h"
#include "view/picking/strand_pick.h"
#include "view/rendering/scene.h"
#include "view/rendering/standard_views.h"

#include <QPointF>
#include <QPolygonF>
#include <QRgb>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

class QWidget;

namespace hairpaint::view {

class EditorState;
class HeadTurn;

/// Takes over what the document and the editor hold when it is told to, and answers what lies where in a view of the
/// size of `area`. GUI thread; all that it is made of must outlive it.
class HeadScene
{
public:
    HeadScene(EditorState& editor, const HeadTurn& turn, const QWidget& area);

    [[nodiscard]] const rendering::Scene& scene() const { return m_scene; }
    [[nodiscard]] rendering::Scene withoutRings() const;

    [[nodiscard]] const rendering::Camera& camera() const { return m_scene.camera; }
    void setCamera(const rendering::Camera& camera) { m_scene.camera = camera; }
    /// Cameras that show the head with all of its hair; none without a head.
    [[nodiscard]] std::optional<rendering::Camera> cameraFor(rendering::StandardView view) const;
    [[nodiscard]] std::optional<rendering::Camera> fittingCamera() const; ///< Looks from where the camera looks now.
    /// A camera that sees where the brush was last, in whichever area; none before the brush was anywhere.
    [[nodiscard]] std::optional<rendering::Camera> cameraAtBrush() const;

    /// Where the brush was last, or what the middle of the area shows; none off the head.
    [[nodiscard]] std::optional<sim::SurfacePoint> pointForWorn() const;

    /// The document's head; null without one.
    [[nodiscard]] const sim::Skin* skin() const;
    [[nodiscard]] bool hasHead() const { return m_scene.head != nullptr; }
    bool refreshHead(); ///< Returns whether another head is shown now; it is bald then.

    /// Whether that hair has its roots on the document's head.
    [[nodiscard]] bool isOnHead(const sim::StrandFrame& hair) const;
    void setHair(std::shared_ptr<const sim::StrandFrame> hair) { m_scene.hair = std::move(hair); }
    /// Shows cards instead of the hair; null: the hair again.
    void setCards(std::shared_ptr<const rendering::CardSet> cards) { m_scene.cards = std::move(cards); }
    /// Where the head stands in the frame that is shown.
    [[nodiscard]] sim::HeadPose shownPose() const;

    /// Skin, worn things and background of the project, under a light that may be turning into another.
    void setEnvironment(const model::Project& project, const model::LightSettings& light);

    bool refreshRings(); ///< Returns whether a ring was shown or is now.
    /// The ring of a brush in the paint area, in px, where the head hides it; empty where it does not.
    [[nodiscard]] QPolygonF hiddenRing() const;

    /// The solids of what is worn and drawn, in the project's order; the head's own parts follow.
    [[nodiscard]] const std::vector<rendering::Solid>& solids() const { return m_scene.solids; }
    /// The skin that a position of the area shows, hair ignored; none where the ray misses the head.
    [[nodiscard]] std::optional<sim::SurfacePoint> skinAt(QPointF position) const;
    /// Size of a pixel of the area on the skin there, m; limited where the skin is seen from the side.
    [[nodiscard]] float pixelAt(const sim::SurfacePoint& point) const;
    /// The active group's hair that a position of the area shows; none where none is near.
    [[nodiscard]] std::optional<model::GrabbedHair> hairAt(QPointF position) const;
    /// The node under the pointer of the hairs that the active tool offers to be bent.
    [[nodiscard]] std::optional<model::GrabbedHair> guideNodeAt(QPointF position) const;
    /// The active group's hair as the area shows it.
    [[nodiscard]] const model::SeenHair& seen() const { return m_seen; }
    /// Where the active tool is to work on the strands that a position shows, and not on the skin there; as far away as
    /// `began`, where the stroke began on hair.
    [[nodiscard]] std::optional<model::OverHair> overHair(QPointF position,
                                                          const std::optional<model::OverHair>& began = {}) const;
    /// The strands that the brush would work on, some of them where they are many, as they are drawn.
    [[nodiscard]] std::vector<QPolygonF> strandsUnder(const model::OverHair& hair) const;
    /// Where a position of the area lies that is as far away as a point of the head.
    [[nodiscard]] glm::vec3 besideHd(glm::vec3 positionHd, QPointF position) const;
    /// Where a point of the head lies in the area; none behind the eye.
    [[nodiscard]] std::optional<QPointF> positionOf(glm::vec3 positionHd) const;

private:
    [[nodiscard]] PictureSource pictureSource() const;

    EditorState& m_editor;
    const HeadTurn& m_turn;
    const QWidget& m_area;
    rendering::Scene m_scene;
    std::optional<sim::SurfacePoint> m_brush;  ///< Where the brush was last.
    std::weak_ptr<const sim::Skin> m_solidsOn; ///< The skin that the solids were made for.
    StrandPick m_seen;
};

} // namespace hairpaint::view
