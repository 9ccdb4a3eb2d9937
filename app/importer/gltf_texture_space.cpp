// The extension's matrix, translation * rotation * scale.
#include "app/importer/gltf_texture_space.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::importer {

namespace {

void readPair(const tinygltf::Value& object, const char* key, glm::vec2& pair)
{
    if (!object.Has(key) || object.Get(key).ArrayLen() != 2)
        return;
    for (int i = 0; i < 2; ++i)
        if (const tinygltf::Value& number = object.Get(key).Get(i); number.IsNumber())
            pair[i] = static_cast<float>(number.GetNumberAsDouble());
}

/// The longer side of what they cover.
float extentOf(const std::vector<glm::vec2>& uvs)
{
    glm::vec2 least(0.0F);
    glm::vec2 greatest(0.0F);
    for (const glm::vec2& uv : uvs) {
        least = &uv == &uvs.front() ? uv : glm::min(least, uv);
        greatest = &uv == &uvs.front() ? uv : glm::max(greatest, uv);
    }
    return std::max(greatest.x - least.x, greatest.y - least.y);
}

} // namespace

TextureSpace textureSpaceOf(const tinygltf::Model& model, int material)
{
    TextureSpace space;
    if (material < 0 || static_cast<std::size_t>(material) >= model.materials.size())
        return space;
    const tinygltf::TextureInfo& texture =
        model.materials[static_cast<std::size_t>(material)].pbrMetallicRoughness.baseColorTexture;
    if (texture.index < 0)
        return space;
    space.set = std::max(texture.texCoord, 0);
    const auto extension = texture.extensions.find("KHR_texture_transform");
    if (extension == texture.extensions.end() || !extension->second.IsObject())
        return space;
    const tinygltf::Value& told = extension->second;
    readPair(told, "offset", space.offset);
    readPair(told, "scale", space.scale);
    if (told.Has("rotation") && told.Get("rotation").IsNumber())
        space.rotation = static_cast<float>(told.Get("rotation").GetNumberAsDouble());
    if (told.Has("texCoord") && told.Get("texCoord").IsInt())
        space.set = std::max(told.Get("texCoord").GetNumberAsInt(), 0);
    return space;
}

std::vector<glm::vec2> transformed(std::vector<glm::vec2> uvs, const TextureSpace& space)
{
    constexpr float kWhole = 1.001F;
    const bool isPlain = space.offset == glm::vec2(0.0F) && space.scale == glm::vec2(1.0F) && space.rotation == 0.0F;
    if (isPlain)
        return uvs;
    const float c = std::cos(space.rotation);
    const float s = std::sin(space.rotation);
    std::vector<glm::vec2> onTexture;
    onTexture.reserve(uvs.size());
    for (const glm::vec2& uv : uvs) {
        const glm::vec2 scaled = space.scale * uv;
        onTexture.push_back(space.offset + glm::vec2(c * scaled.x + s * scaled.y, c * scaled.y - s * scaled.x));
    }
    return extentOf(onTexture) > kWhole && extentOf(uvs) <= kWhole ? uvs : onTexture;
}

} // namespace hairpaint::importer
