// Which uvs a glTF's base colour is painted on.
#pragma once

#include <tiny_gltf.h>

#include <glm/glm.hpp>

#include <vector>

namespace hairpaint::importer {

/// A texture's set of uvs and their transform, with v down (Khronos, KHR_texture_transform).
struct TextureSpace
{
    int set = 0;
    glm::vec2 offset{0.0F};
    glm::vec2 scale{1.0F};
    float rotation = 0.0F; ///< Radians.
};

/// The first set as it is where the material has no texture, or there is none.
[[nodiscard]] TextureSpace textureSpaceOf(const tinygltf::Model& model, int material);
/// uvs as they lie on the texture. One that is repeated over the mesh is not followed: each copy would be painted on.
[[nodiscard]] std::vector<glm::vec2> transformed(std::vector<glm::vec2> uvs, const TextureSpace& space);

} // namespace hairpaint::importer
