// A glTF or VRM file, text or binary, as tinygltf describes it, without its buffers (Khronos, glTF 2.0 specification).
#pragma once

#include "app/importer/vrm_bones.h"
#include "model/files/wire_format.h"

#include <tiny_gltf.h>
#include <tl/expected.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hairpaint::importer {

struct GltfFile
{
    struct Buffer
    {
        std::optional<std::string> uri; ///< None: the binary chunk, or what stands for decompressed data.
        std::size_t byteLength = 0;
    };

    struct Image
    {
        std::string uri; ///< Empty where it lies in a view.
        int view = -1;
    };

    /// Nodes, meshes, accessors, buffer views, skins, materials and textures; no buffers, images or animations.
    tinygltf::Model model;
    std::vector<Buffer> buffers;
    std::vector<Image> images;
    std::vector<std::byte> bytes;     ///< The whole file.
    std::span<const std::byte> chunk; ///< The binary chunk within `bytes`; empty where there is none.
    BoneNames bones;
    bool facesBack = false; ///< See vrm_bones.h.
};

/// Parses a file's bytes. The caller limits their size; JSON nested deeper than a glTF's own is left out. Refuses
/// versions before 2 with Reason::UnknownFormat.
[[nodiscard]] tl::expected<GltfFile, wire::Refusal> parsedGltf(std::vector<std::byte> bytes);

} // namespace hairpaint::importer
