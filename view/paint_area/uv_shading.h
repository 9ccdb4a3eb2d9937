// The head's own light and shade over its uv layout, so that a flat map shows where eyes, ears and crown are.
#pragma once

#include "sim/skin/head_mesh.h"

#include <QColor>
#include <QImage>

namespace hairpaint::view {

/// Format_RGBA8888, row 0 at v = 1: red = green = blue the shade (0 dark, 255 bright), alpha how much of the pixel lies
/// on an island. Diffuse light from the front and above, hollows darker.
[[nodiscard]] QImage bakeUvShading(const sim::HeadMesh& mesh, int side);

/// The same as a veil to lay over the painted map: it brightens night paper, darkens white paper, and turns what lies
/// off the islands toward `outside`. Format_ARGB32_Premultiplied.
[[nodiscard]] QImage shadingVeil(const QImage& shading, bool nightPaper, const QColor& outside);

} // namespace hairpaint::view
