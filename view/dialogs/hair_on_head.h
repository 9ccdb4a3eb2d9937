// Hair of a file where it would come to lie on the head, so that a wrong unit or axis is seen at once.
#pragma once

#include "model/importing/curve_fit.h"
#include "sim/skin/head_mesh.h"
#include "view/dialogs/mesh_picture.h"

#include <QImage>
#include <QWidget>

#include <array>
#include <cstddef>

class QPainter;

namespace hairpaint::view {

/// From the front and from the head's left side. GUI thread.
class HairOnHead : public QWidget
{
    Q_OBJECT
public:
    /// Some hundred strands; both must outlive the widget.
    HairOnHead(const sim::HeadMesh& head, const model::ForeignCurves& curves, QWidget* parent = nullptr);
    void setTransform(const model::CurveTransform& transform);
    [[nodiscard]] QSize sizeHint() const override { return {400, 260}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Side
    {
        MeshFraming framing;
        QImage head;
    };
    void paintSide(QPainter& painter, const Side& side) const;
    /// Strands that are rooted on the eye's side of the head's middle, or the others.
    void paintStrands(QPainter& painter, const MeshFraming& framing, bool isNear) const;

    const sim::HeadMesh& m_head;
    const model::ForeignCurves& m_curves;
    model::CurveTransform m_transform;
    std::array<Side, 2> m_sides; ///< Made for the size and the screen that it is painted at.
};

} // namespace hairpaint::view
