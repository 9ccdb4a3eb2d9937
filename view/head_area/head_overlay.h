// What lies over the drawn head: hairs that show directions, the active tool's outlines and those of
// what is worn.
#pragma once

#include "model/project/worn.h"
#include "model/tools/tool.h"
#include "view/head_area/falling_hair.h"
#include "view/head_area/worn_outline.h"
#include "view/look/tapered_hair.h"
#include "view/look/theme.h"
#include "view/rendering/scene.h"

#include <QImage>
#include <QVariantAnimation>
#include <QWidget>

#include <vector>

namespace hairpaint::view {

/// Lets every pointer event through. Hidden while there is nothing to show.
class HeadOverlay : public QWidget
{
    Q_OBJECT
public:
    HeadOverlay(const Theme& theme, QWidget* parent);

    void setTheme(const Theme& theme);
    /// Outlines on the uv as they lie on the skin; parts that face away are left out.
    void setShapes(const std::vector<model::OverlayShape>& shapes, const sim::Skin* skin,
                   const rendering::Camera& camera, const sim::HeadPose& pose);

    /// What a tool draws over the picture itself, in this widget's coordinates.
    void setPictureLine(model::PictureLine line);
    [[nodiscard]] const model::PictureLine& pictureLine() const { return m_pictureLine; }

    /// Hairs that can be bent by their nodes, the root's excepted.
    void setGuides(const std::vector<model::GuideStrand>& guides, const rendering::Camera& camera,
                   const sim::HeadPose& pose);
    /// In this widget's coordinates, from the root to the tip.
    [[nodiscard]] const std::vector<QPolygonF>& guides() const { return m_guides; }

    /// Cut hair, under every outline.
    void setFalling(std::vector<FallingLine> falling);
    [[nodiscard]] const std::vector<FallingLine>& falling() const { return m_falling; }

    /// The strands that the brush would work on, and its ring around the pointer, in this widget's coordinates.
    void setStrands(std::vector<QPolygonF> strands, const QRectF& ring);
    [[nodiscard]] const std::vector<QPolygonF>& strands() const { return m_strands; }

    /// Three ellipses for each, as wire: the far half is seen, too; the chosen one stands out, with its axes' ends.
    /// Without the ends where it is not in reach. None: nothing is shown.
    void setWorn(const std::vector<model::Worn>& worn, model::Id chosen, bool inReach, const HeadSight& sight);
    /// In this widget's coordinates.
    [[nodiscard]] const std::vector<QPolygonF>& wornOutlines() const { return m_wornOutlines; }

    /// Hairs that show a direction map, in this widget's coordinates: faint, under everything else.
    void setDirections(std::vector<HairSpine> hairs);
    [[nodiscard]] const std::vector<HairSpine>& directions() const { return m_directions; }
    /// Nearly gone, within 150 ms: while the hair below is what is looked at.
    void setDirectionsFaded(bool faded);
    [[nodiscard]] bool directionsFaded() const { return m_directionsFaded; }

    /// The brush's ring where the head hides it, in this widget's coordinates; empty where it is seen.
    void setGhost(const QPolygonF& ring);
    [[nodiscard]] const QPolygonF& ghost() const { return m_ghost; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void showIfNeeded();

    Theme m_theme;
    std::vector<QPolygonF> m_lines; ///< In this widget's coordinates, as the next two.
    QPolygonF m_handles;
    model::PictureLine m_pictureLine;
    std::vector<QPolygonF> m_guides;
    QPolygonF m_heldGuide; ///< The one of them that is bent.
    std::vector<FallingLine> m_falling;
    std::vector<QPolygonF> m_strands;
    QRectF m_strandRing; ///< A circle's.
    std::vector<QPolygonF> m_wornOutlines;
    std::vector<QPolygonF> m_chosen; ///< The chosen one's ellipses among them,
    QPolygonF m_chosenEnds;          ///< and the ends of its axes.
    QPolygonF m_ghost;
    std::vector<HairSpine> m_directions;
    bool m_directionsFaded = false;
    QVariantAnimation m_fading; ///< Its value is the directions' opacity.
    QImage m_directionsPicture; ///< This widget is painted with every frame below it.
};

} // namespace hairpaint::view
