// How the head is turned on its neck: by a drag, by a motion that it goes through, and back.
#pragma once

#include "sim/motion/neck_motion.h"
#include "view/rendering/scene.h"

#include <QElapsedTimer>
#include <QObject>
#include <QPointF>
#include <QTimer>

#include <optional>

namespace hairpaint::view {

/// No turn stays: a head that is let go comes back in about half a second, so that the hair swings. GUI thread.
class HeadTurn : public QObject
{
    Q_OBJECT
public:
    explicit HeadTurn(QObject* parent = nullptr);

    /// The pose asked for last; the simulation follows.
    [[nodiscard]] const sim::HeadPose& pose() const { return m_pose; }
    void setNeck(const sim::Neck& neck); ///< For another head, or one whose landmarks were moved.

    void press(); ///< A drag begins; ends whatever motion there is.
    /// `pixels` since the drag's start.
    void drag(const rendering::Camera& camera, QPointF pixels);
    void release(); ///< The head comes back.
    /// Goes through a motion once, from however the head is turned now; nothing while it is held by a drag.
    void play(sim::NeckMotion motion);
    void turnBack(); ///< Ends a motion: the head comes back from where it is; nothing while it is held by a drag.
    void setPaused(bool paused); ///< While paused, as the hair is, a motion and the return wait.
    /// The motion or the return goes on by so much time, as it does by itself in real time; nothing while it waits.
    void advance(double passedSeconds);
    /// Whether a motion or the return goes on; false while they wait.
    [[nodiscard]] bool moving() const { return m_tick.isActive(); }

Q_SIGNALS:
    void poseWanted(const hairpaint::sim::HeadPose& pose);

private:
    void onTick();
    void start(std::optional<sim::NeckMotion> motion);
    void setAngles(const sim::NeckAngles& angles);

    sim::Neck m_neck;
    sim::NeckAngles m_angles;
    sim::NeckAngles m_before; ///< Where the drag, the motion or the return began.
    sim::HeadPose m_pose;
    std::optional<sim::NeckMotion> m_motion; ///< Added to the return.
    std::optional<double> m_seconds;         ///< Since the motion or the return began; none where there is neither.
    QElapsedTimer m_sinceTick;
    QTimer m_tick;
    bool m_paused = false;
    bool m_held = false;
};

} // namespace hairpaint::view
