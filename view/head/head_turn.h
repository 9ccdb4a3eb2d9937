// The head's pose: turned by a drag, and back.
#pragma once

#include "sim/motion/strand_frame.h"
#include "view/rendering/scene.h"

#include <QObject>
#include <QPointF>
#include <QVariantAnimation>

namespace hairpaint::view {

/// GUI thread.
class HeadTurn : public QObject
{
    Q_OBJECT
public:
    HeadTurn();

    /// The one asked for last; the simulation follows.
    [[nodiscard]] const sim::HeadPose& pose() const { return m_pose; }
    void press(); ///< A drag begins; ends turning back.
    /// `pixels` since the drag's start.
    void drag(const rendering::Camera& camera, QPointF pixels);
    void turnBack(); ///< To where it looks straight ahead, in a moment; nothing where nobody turned it.
    [[nodiscard]] bool turningBack() const { return m_turningBack.state() == QAbstractAnimation::Running; }

Q_SIGNALS:
    void poseWanted(const hairpaint::sim::HeadPose& pose);

private:
    sim::HeadPose m_pose;
    sim::HeadPose m_before; ///< Where the drag or the turning back began.
    QVariantAnimation m_turningBack;
};

} // namespace hairpaint::view
