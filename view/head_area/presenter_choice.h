// How the 3D area's pictures come to the screen.
#pragma once

namespace hairpaint::view {

/// Automatic: a QOpenGLWidget where a real GPU renders, else frames that our own software draws on a thread of theirs.
enum class PresenterChoice
{
    Automatic,
    Gl,      ///< QOpenGLWidget
    Software ///< Our own, without OpenGL.
};

} // namespace hairpaint::view
