// A mesh seen from the front, which shows a wrong up axis.
#pragma once

#include "model/project/project.h"
#include "sim/skin/head_mesh.h"

#include <QImage>
#include <QWidget>

namespace hairpaint::view {

class MeshSilhouette : public QWidget
{
    Q_OBJECT
public:
    /// `mesh` must outlive the widget.
    explicit MeshSilhouette(const sim::HeadMesh& mesh, QWidget* parent = nullptr);
    void setUpAxis(model::UpAxis axis);
    [[nodiscard]] QSize sizeHint() const override { return {148, 180}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 140}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const sim::HeadMesh& m_mesh;
    QImage m_picture;
    model::UpAxis m_axis = model::UpAxis::Y;
};

} // namespace hairpaint::view
