// The reader goes by what the file is named.
#include "app/importer/mesh_import.h"

#include "app/importer/assimp_scene.h"
#include "app/importer/gltf_scene.h"
#include "app/importer/scene_flattener.h"
#include "app/importer/texture_input.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace hairpaint::importer {

namespace {

bool isGltf(const std::string& path)
{
    constexpr std::array<std::string_view, 3> kEndings = {".gltf", ".glb", ".vrm"};
    const auto same = [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? char(b - 'A' + 'a') : b); };
    return std::ranges::any_of(kEndings, [&](std::string_view ending) {
        return path.size() >= ending.size() &&
               std::equal(ending.begin(), ending.end(), path.end() - static_cast<std::ptrdiff_t>(ending.size()), same);
    });
}

tl::expected<ForeignScene, wire::Refusal> readScene(const std::string& path)
{
    if (!isGltf(path))
        return readByAssimp(path);
    tl::expected<ForeignScene, wire::Refusal> scene = readGltf(path);
    const bool isOld = !scene && scene.error().reason == wire::Reason::UnknownFormat;
    return isOld ? readByAssimp(path) : std::move(scene);
}

} // namespace

tl::expected<model::RiggedMesh, wire::Refusal> readMesh(const std::string& path, bool needsUvs)
{
    const tl::expected<ForeignScene, wire::Refusal> scene = readScene(path);
    if (!scene)
        return tl::unexpected(scene.error());
    tl::expected<model::RiggedMesh, wire::Refusal> mesh = flattened(*scene, needsUvs);
    if (mesh)
        decodeTextures(*mesh, scene->images);
    return mesh;
}

} // namespace hairpaint::importer
