// Moves the camera smoothly to another view.
#pragma once

#include "view/rendering/scene.h"

#include <QVariantAnimation>

#include <functional>

namespace hairpaint::view {

/// Takes a moment. GUI thread.
class CameraFlight
{
public:
    /// `move` gets each camera in between.
    explicit CameraFlight(std::function<void(const rendering::Camera&)> move);

    void start(const rendering::Camera& from, const rendering::Camera& to); ///< Ends the one before where it is.
    void stop() { m_animation.stop(); }
    [[nodiscard]] bool underWay() const { return m_animation.state() == QAbstractAnimation::Running; }

private:
    rendering::Camera m_from, m_to;
    QVariantAnimation m_animation;
};

} // namespace hairpaint::view
