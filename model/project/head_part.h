// What a head's character has besides the skin that hair grows on: eyes, lashes, body, clothes.
#pragma once

#include "sim/skin/head_mesh.h"
#include "sim/skin/mesh_texture.h"

#include <memory>
#include <string>

namespace hairpaint::model {

/// Immutable once shared between threads.
struct HeadPart
{
    std::string name;       ///< UTF-8, at most 64 bytes, without control characters.
    glm::vec3 colour{0.8F}; ///< Linear, 0..1; times the texture.
    sim::TextureAlpha alpha = sim::TextureAlpha::Opaque;
    bool doubleSided = false;
    std::shared_ptr<const sim::MeshTexture> texture; ///< Null where it has none.
    std::shared_ptr<const sim::HeadMesh> mesh;       ///< In the head's own space: source or Hd. Its uvs are its own.
};

} // namespace hairpaint::model
