// Turns the head.
#include "view/head_area/head_turn.h"

#include "view/head_area/head_camera.h"

#include <algorithm>

namespace hairpaint::view {

HeadTurn::HeadTurn(QObject* parent) : QObject(parent)
{
    constexpr int kTickMs = 8; // A step of the simulation.
    m_tick.setInterval(kTickMs);
    m_tick.setTimerType(Qt::PreciseTimer);
    connect(&m_tick, &QTimer::timeout, this, &HeadTurn::onTick);
}

void HeadTurn::setNeck(const sim::Neck& neck)
{
    if (neck == m_neck)
        return;
    m_neck = neck;
    if (m_angles != sim::NeckAngles{})
        setAngles(m_angles);
}

void HeadTurn::press()
{
    m_tick.stop();
    m_seconds.reset();
    m_held = true;
    m_before = m_angles;
}

void HeadTurn::drag(const rendering::Camera& camera, QPointF pixels)
{
    setAngles(turned(m_before, m_neck, camera, pixels));
}

void HeadTurn::release()
{
    m_held = false;
    turnBack();
}

void HeadTurn::play(sim::NeckMotion motion)
{
    if (!m_held)
        start(motion);
}

void HeadTurn::turnBack()
{
    if (!m_held && m_angles != sim::NeckAngles{})
        start(std::nullopt);
}

void HeadTurn::start(std::optional<sim::NeckMotion> motion)
{
    m_motion = motion;
    m_before = m_angles;
    m_seconds = 0.0;
    setPaused(m_paused);
}

void HeadTurn::setPaused(bool paused)
{
    m_paused = paused;
    if (m_paused || !m_seconds) {
        m_tick.stop();
    } else {
        m_sinceTick.start();
        m_tick.start();
    }
}

void HeadTurn::onTick()
{
    constexpr double kSecondsPerNs = 1e-9;
    const double passedSeconds = static_cast<double>(m_sinceTick.nsecsElapsed()) * kSecondsPerNs;
    m_sinceTick.start();
    advance(passedSeconds);
}

void HeadTurn::advance(double passedSeconds)
{
    if (!moving())
        return;
    const double seconds = *m_seconds + passedSeconds;
    m_seconds = seconds;
    sim::NeckAngles angles = sim::returning(m_before, seconds);
    if (m_motion) {
        const sim::NeckAngles more = sim::anglesAt(*m_motion, seconds);
        angles = {angles.yawRad + more.yawRad, angles.pitchRad + more.pitchRad};
    }
    // Both are over by then, and the head looks straight ahead.
    if (seconds >= std::max(m_motion ? sim::secondsOf(*m_motion) : 0.0, sim::kReturnSeconds)) {
        m_tick.stop();
        m_seconds.reset();
    }
    setAngles(angles);
}

void HeadTurn::setAngles(const sim::NeckAngles& angles)
{
    m_angles = angles;
    m_pose = sim::poseOn(m_neck, angles);
    Q_EMIT poseWanted(m_pose);
}

} // namespace hairpaint::view
