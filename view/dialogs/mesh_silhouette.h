// A mesh seen from the front beside a person, so that a wrong axis or unit is seen at once.
#pragma once

#include "model/project/project.h"
#include "sim/skin/head_mesh.h"

#include <QImage>
#include <QWidget>

class QPainter;

namespace hairpaint::view {

class MeshSilhouette : public QWidget
{
    Q_OBJECT
public:
    /// `mesh` must outlive the widget.
    explicit MeshSilhouette(const sim::HeadMesh& mesh, QWidget* parent = nullptr);
    void setUpAxis(model::UpAxis axis);
    /// The person is drawn at the mesh's scale, as high as the mesh at the top; none where it is 0.
    void setMetresPerUnit(double metres);
    [[nodiscard]] QSize sizeHint() const override { return {212, 180}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {180, 140}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// `top`: the middle of the person's crown, px.
    void paintPerson(QPainter& painter, QPointF top, double pixelsPerMetre) const;

    const sim::HeadMesh& m_mesh;
    QImage m_picture;
    double m_pixelsPerUnit = 1.0; ///< Scale of the picture, in points of the widget.
    double m_meshTop = 0.0;       ///< The mesh's upper end in it.
    double m_metresPerUnit = 0.0;
    model::UpAxis m_axis = model::UpAxis::Y;
};

} // namespace hairpaint::view
