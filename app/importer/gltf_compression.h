// Compressed glTF: EXT_meshopt_compression (Kapoulkine 2021) by meshoptimizer, KHR_draco_mesh_compression (Khronos
// 2018) by Draco.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tinygltf {
class Value;
}

namespace hairpaint::importer {

/// A compressed buffer view, as its extension tells it.
struct MeshoptView
{
    int buffer = -1;
    std::size_t byteOffset = 0, byteLength = 0; ///< Range of the compressed bytes in the buffer.
    std::size_t count = 0, stride = 0;          ///< Elements, and the bytes of each.
    std::string mode, filter;
};

[[nodiscard]] MeshoptView meshoptView(const tinygltf::Value& extension);
/// The decoded bytes; none where they can't be decoded.
[[nodiscard]] std::optional<std::vector<std::byte>> decodedMeshopt(const MeshoptView& view,
                                                                   std::span<const std::byte> coded);

/// Points and triangles.
struct DracoMesh
{
    std::size_t vertices = 0;
    std::vector<std::uint32_t> indices; ///< Indices of vertices, three a triangle.
    struct Attribute
    {
        int components = 0;
        bool isNormalized = false; ///< Whether the numbers are normalized already.
        std::vector<float> numbers;
    };
    std::map<int, Attribute> attributes; ///< By Draco's ids.
};

/// The attributes of those ids; none where it can't be decoded, or is larger.
[[nodiscard]] std::optional<DracoMesh> decodedDraco(std::span<const std::byte> coded, const std::vector<int>& ids,
                                                    std::size_t mostVertices, std::size_t mostTriangles);

} // namespace hairpaint::importer
