// How the 3D area's pictures come to the screen.
#pragma once

namespace hairpaint::view {

/// Automatic: a QOpenGLWidget where a real GPU renders, else frames drawn on a thread of their own, read back and
/// painted.
enum class PresenterChoice
{
    Automatic,
    Gl,      ///< QOpenGLWidget
    Software ///< Read back and painted.
};

} // namespace hairpaint::view
