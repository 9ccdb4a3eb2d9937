// Writing the subset of binary glTF that glb.h reads. Any thread.
#pragma once

#include "model/heads/rigged_mesh.h"
#include "sim/skin/mesh_texture.h"

#include <QByteArray>
#include <QJsonObject>

namespace hairpaint::model {

/// Of a mesh whose first part is the head, with the parts after it as meshes of their own. The same mesh gives the same
/// bytes.
[[nodiscard]] QByteArray glbFromMesh(const RiggedMesh& mesh);
/// Of 8 bits a channel, without alpha where all of it is opaque.
[[nodiscard]] QByteArray pngOfTexture(const sim::MeshTexture& texture);
/// All of a binary glTF but its binary chunk's `binBytes` bytes, a multiple of 4, which follow.
[[nodiscard]] QByteArray glbHead(const QJsonObject& json, quint32 binBytes);

} // namespace hairpaint::model
