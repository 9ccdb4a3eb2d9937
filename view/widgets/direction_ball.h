// A ball seen from the front whose handle is a direction: where the wind goes or the light comes from.
#pragma once

#include <QWidget>

#include <glm/glm.hpp>

namespace hairpaint::view {

/// Azimuth around y from +z toward +x, elevation above the horizon, rad. The near half is drawn solid, the far half
/// hollow; a drag keeps its half, a double-click turns to the other. Signals
/// as BarSlider's: changed while moving, then finished or cancelled once.
class DirectionBall : public QWidget
{
    Q_OBJECT
public:
    enum class Meaning
    {
        Toward, ///< An arrow from the middle outward.
        From    ///< A lamp that shines on the middle.
    };
    explicit DirectionBall(Meaning meaning, QWidget* parent = nullptr);
    [[nodiscard]] glm::vec3 direction() const { return m_direction; }
    void setDirection(glm::vec3 direction); ///< Unit. Tells nothing; ignored while the user is turning it.
    [[nodiscard]] bool editing() const { return m_editing; }
    [[nodiscard]] QSize sizeHint() const override { return {148, 148}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 120}; }

    [[nodiscard]] static glm::vec3 fromAngles(double azimuthRad, double elevationRad);
    [[nodiscard]] static double azimuthRad(glm::vec3 direction);
    [[nodiscard]] static double elevationRad(glm::vec3 direction);

Q_SIGNALS:
    void changed(glm::vec3 direction);
    void finished(glm::vec3 direction);
    void cancelled();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void begin();
    void moveTo(glm::vec3 direction);
    void finish();
    void cancel();
    [[nodiscard]] QRectF circle() const;
    [[nodiscard]] glm::vec3 at(QPointF position) const;
    void describe();

    Meaning m_meaning;
    glm::vec3 m_direction{0.0F, 0.0F, 1.0F};
    glm::vec3 m_before{0.0F, 0.0F, 1.0F};
    bool m_editing = false;
    bool m_dragging = false;
};

} // namespace hairpaint::view
