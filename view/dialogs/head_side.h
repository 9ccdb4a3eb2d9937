// A head seen from one side, with its landmarks, which may be dragged over the skin.
#pragma once

#include "model/project/project.h"
#include "view/dialogs/mesh_picture.h"
#include "view/rendering/standard_views.h"

#include <QImage>
#include <QWidget>

#include <memory>
#include <optional>

namespace hairpaint::view {

class HeadSide : public QWidget
{
    Q_OBJECT
public:
    /// The head has a skin.
    HeadSide(std::shared_ptr<const model::Head> head, const sim::HeadLandmarks& landmarks, QWidget* parent = nullptr);

    void setMovable(bool movable) { m_movable = movable; }
    void setSide(rendering::StandardView side); ///< Front, back, left, right or top.
    void setLandmarks(const sim::HeadLandmarks& landmarks);
    [[nodiscard]] const sim::HeadLandmarks& landmarks() const { return m_landmarks; }
    /// Position of a landmark in this widget; none where the head hides it.
    [[nodiscard]] std::optional<QPointF> positionOf(sim::HeadLandmark landmark) const;

    [[nodiscard]] QSize sizeHint() const override { return {320, 380}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 280}; }

Q_SIGNALS:
    void landmarkMoved(); ///< The user moved one; sent at every step of the drag.

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    [[nodiscard]] MeshFraming framing(QSize pixels) const;
    [[nodiscard]] std::optional<sim::HeadLandmark> landmarkAt(QPointF position) const;
    void drawLandmark(QPainter& painter, sim::HeadLandmark landmark) const;

    std::shared_ptr<const model::Head> m_head;
    sim::HeadLandmarks m_landmarks;
    glm::vec3 m_middleHd{0.0F}; ///< Middle of the landmarks at first, so that the picture rests while they move.
    float m_reachM = 0.1F;
    rendering::StandardView m_side = rendering::StandardView::Front;
    QImage m_picture;
    bool m_movable = false;
    std::optional<sim::HeadLandmark> m_dragged;
    QPointF m_grip; ///< From the pointer to the dragged landmark.
};

} // namespace hairpaint::view
