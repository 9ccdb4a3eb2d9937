// Writing the subset of binary glTF that glb.h reads. Any thread.
#pragma once

#include "model/heads/rigged_mesh.h"
#include "sim/skin/mesh_texture.h"

#include <QByteArray>
#include <QJsonObject>

namespace hairpaint::model {

/// A file with the mesh's first part, the head, as its first mesh, and each further part as a mesh of its own. The same
/// mesh gives the same bytes.
[[nodiscard]] QByteArray glbFromMesh(const RiggedMesh& mesh);
/// The texture as a PNG of 8 bits a channel, without alpha where all of it is opaque.
[[nodiscard]] QByteArray pngOfTexture(const sim::MeshTexture& texture);
/// All of a binary glTF but its binary chunk's `binBytes` bytes, a multiple of 4, which follow.
[[nodiscard]] QByteArray glbHead(const QJsonObject& json, quint32 binBytes);

} // namespace hairpaint::model
