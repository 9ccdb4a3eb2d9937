// Turns the head.
#include "view/head/head_turn.h"

#include "view/head/head_camera.h"

namespace hairpaint::view {

HeadTurn::HeadTurn()
{
    constexpr int kTurnBackMs = 500;
    m_turningBack.setDuration(kTurnBackMs);
    m_turningBack.setEasingCurve(QEasingCurve::InOutQuad);
    m_turningBack.setStartValue(0.0F);
    m_turningBack.setEndValue(1.0F);
    connect(&m_turningBack, &QVariantAnimation::valueChanged, this, [this](const QVariant& t) {
        m_pose.rotation = glm::slerp(m_before.rotation, glm::quat(1.0F, 0.0F, 0.0F, 0.0F), t.toFloat());
        Q_EMIT poseWanted(m_pose);
    });
}

void HeadTurn::press()
{
    m_turningBack.stop();
    m_before = m_pose;
}

void HeadTurn::drag(const rendering::Camera& camera, QPointF pixels)
{
    m_pose = turned(m_before, camera, pixels);
    Q_EMIT poseWanted(m_pose);
}

void HeadTurn::turnBack()
{
    if (m_pose == sim::HeadPose{})
        return;
    m_before = m_pose;
    m_turningBack.start();
}

} // namespace hairpaint::view
