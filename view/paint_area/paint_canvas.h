// The picture of the paint area below rings and overlays: paper, painted map, hairs over directions, the head's
// shading, wireframe, landmarks.
#pragma once

#include "model/project/project.h"
#include "view/look/theme.h"
#include "view/paint_area/head_backdrop.h"
#include "view/paint_area/landmarks.h"
#include "view/paint_area/map_pyramid.h"
#include "view/paint_area/uv_transform.h"

#include <QFont>
#include <QImage>

#include <memory>
#include <vector>

namespace hairpaint::view {

/// Everything over the painted map is drawn once per look into one picture of the widget's size, so a dab costs its
/// own tiles and a copy. GUI thread.
class PaintCanvas
{
public:
    /// How the map is viewed; a change redraws the upper picture.
    struct Look
    {
        UvTransform transform;
        double devicePixelRatio = 1.0;
        bool nightPaper = true;
        bool wireframe = true;
        Theme theme;
        QFont font;
    };

    void setLandmarks(std::vector<Landmark> landmarks);
    void setBackdrop(BackdropPtr backdrop); ///< Null: neither shading nor wireframe.
    /// Returns the parts of the paper that changed.
    QList<QRectF> setMap(std::shared_ptr<const sim::TiledRaster> raster, const model::MapSpec& spec, bool nightPaper);
    [[nodiscard]] const MapPyramid& pyramid() const { return m_pyramid; }
    /// MapPyramid::refine.
    QList<QRectF> refine(double milliseconds) { return m_pyramid.refine(milliseconds); }
    /// How far what is drawn of a texel may reach beyond it, px.
    [[nodiscard]] int reachPx() const;
    void invalidate(); ///< To be called when what is shown has changed.

    void paint(QPainter& painter, const QRect& dirty, const Look& look);

private:
    void drawUpper(const Look& look);
    [[nodiscard]] QImage wireframePicture(const Look& look, QSize size);
    void drawLandmarks(QPainter& painter, const Look& look) const;

    MapPyramid m_pyramid;
    bool m_isField = false; ///< The map holds directions.
    BackdropPtr m_backdrop;
    QImage m_veil; ///< The backdrop's shading, as it is drawn over the map.
    std::vector<Landmark> m_landmarks;
    QImage m_upper;
    bool m_upperValid = false;
    bool m_veilIsNight = true;
    QColor m_veilOutside;
};

} // namespace hairpaint::view
