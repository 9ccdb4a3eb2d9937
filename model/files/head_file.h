// Heads: the built-in one, and our exact subset of binary glTF that project files hold.
#pragma once

#include "model/error.h"
#include "model/project.h"

namespace hairpaint::model {

/// The frozen built-in head "bust-1" (resources/heads). Loaded once, then shared.
[[nodiscard]] std::shared_ptr<const Head> builtInHead();
[[nodiscard]] std::vector<sim::Ellipsoid> builtInEllipsoids();

/// A mesh of at most 2,000,000 vertices and 4,000,000 triangles from our subset of glb; every index and size is
/// checked.
[[nodiscard]] Result<sim::HeadMesh> readGlb(const QByteArray& glb, const QString& nameForErrors);
[[nodiscard]] QByteArray writeGlb(const sim::HeadMesh& mesh);

/// Applies scale and axis to a source mesh, centres nothing, and builds the skin.
[[nodiscard]] Result<std::shared_ptr<const Head>> makeHead(const QString& name, const QByteArray& sourceGlb,
                                                           float unitScale, UpAxis upAxis);

/// What scale and axis a mesh of unknown origin most likely has: the one under which it is about a head's size and
/// taller along the axis.
struct HeadGuess
{
    float unitScale = 1.0F;
    UpAxis upAxis = UpAxis::Y;
};
[[nodiscard]] HeadGuess guessHead(const sim::HeadMesh& source);

} // namespace hairpaint::model
