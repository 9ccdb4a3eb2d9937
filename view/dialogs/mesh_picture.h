// Small pictures of a mesh for dialogs, without OpenGL.
#pragma once

#include "sim/skin/head_mesh.h"
#include "sim/skin/skin.h"

#include <QImage>
#include <QPointF>
#include <QSize>

class QPainter;
class QRect;

namespace hairpaint::view {

/// How a mesh lies in a picture: seen from afar, so without perspective. Pixels have their origin at the top left.
struct MeshFraming
{
    glm::mat3 axes{1.0F}; ///< Columns: the directions to the picture's right, up, and toward the eye; orthonormal.
    glm::vec3 middle{0.0F};
    glm::vec2 middlePx{0.0F};
    float pixelsPerUnit = 1.0F; ///< Pixels that a unit of the mesh covers.

    /// The box around all of the mesh fills 88 % of the picture.
    [[nodiscard]] static MeshFraming around(const sim::HeadMesh& mesh, const glm::mat3& axes, QSize pixels);

    /// z: nearness to the eye, in pixels.
    [[nodiscard]] glm::vec3 toPicture(const glm::vec3& position) const;
    [[nodiscard]] sim::RayHd rayThrough(QPointF px) const;
};

/// Faces shaded by their slope, in the theme's colours; transparent around the mesh. Takes about 20 ns a triangle and
/// 5 ns a pixel.
[[nodiscard]] QImage meshPicture(const sim::HeadMesh& mesh, const MeshFraming& framing, QSize pixels);

/// The panel on which such a picture lies, with its border.
void paintPicturePanel(QPainter& painter, const QRect& area);

} // namespace hairpaint::view
