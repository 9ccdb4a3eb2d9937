// Slower toward its end.
#include "view/head_area/camera_flight.h"

#include "view/head_area/head_camera.h"

#include <utility>

namespace hairpaint::view {

CameraFlight::CameraFlight(std::function<void(const rendering::Camera&)> move)
{
    constexpr int kFlightMs = 240;
    m_animation.setDuration(kFlightMs);
    m_animation.setEasingCurve(QEasingCurve::OutCubic);
    m_animation.setStartValue(0.0F);
    m_animation.setEndValue(1.0F);
    QObject::connect(&m_animation, &QVariantAnimation::valueChanged, &m_animation,
                     [this, move = std::move(move)](const QVariant& t) { move(between(m_from, m_to, t.toFloat())); });
}

void CameraFlight::start(const rendering::Camera& from, const rendering::Camera& to)
{
    m_animation.stop();
    m_from = from;
    m_to = to;
    m_animation.start();
}

} // namespace hairpaint::view
