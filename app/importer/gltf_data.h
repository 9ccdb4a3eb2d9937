// The numbers of a glTF: buffers, views of them, compressed or not, and accessors.
#pragma once

#include "app/importer/gltf_file.h"

#include <cstdint>
#include <functional>
#include <map>

namespace hairpaint::importer {

using BufferBytes = std::vector<std::byte>;
/// Reads the file that a URI names, where the URI holds no data itself; `uri`: as it stands in the glTF.
using BufferReader = std::function<tl::expected<BufferBytes, wire::Refusal>(const std::string& uri)>;

/// A buffer's bytes are fetched when a view of it is first asked for, so that what no mesh needs may be missing. Every
/// range is checked. Keeps the file by reference.
class GltfData
{
public:
    template<typename T>
    using Read = tl::expected<T, wire::Refusal>;
    using Bytes = std::span<const std::byte>;

    GltfData(const GltfFile& file, BufferReader reader) : m_file(file), m_reader(std::move(reader)) {}

    /// The bytes of a buffer view, decompressed where it is compressed (EXT_meshopt_compression).
    [[nodiscard]] Read<Bytes> view(int index);
    /// What a URI names, inside the file or beside it.
    [[nodiscard]] Read<BufferBytes> uri(const std::string& named) const;
    /// `components` numbers an element, by the accessor's normalization. At most `most` elements.
    [[nodiscard]] Read<std::vector<float>> floats(int accessor, int components, std::size_t most);
    /// The same of whole numbers, none of which is below 0.
    [[nodiscard]] Read<std::vector<std::uint32_t>> wholes(int accessor, int components, std::size_t most);
    /// The accessor of that index; null where there is none.
    [[nodiscard]] const tinygltf::Accessor* find(int accessor) const;

private:
    struct Elements; ///< Where an accessor's bytes lie.

    [[nodiscard]] Read<Bytes> buffer(int index);
    [[nodiscard]] Read<Bytes> decompressed(const tinygltf::Value& extension, int index);
    [[nodiscard]] Read<Elements> elements(int view, std::size_t offset, int componentType, int components,
                                          std::size_t count);
    template<typename Number, typename Convert>
    [[nodiscard]] Read<std::vector<Number>> numbers(int accessor, int components, std::size_t most,
                                                    const Convert& convert);

    const GltfFile& m_file;
    BufferReader m_reader;
    std::map<int, BufferBytes> m_buffers; ///< Buffers that were fetched, by index.
    std::map<int, BufferBytes> m_views;   ///< Views that were decompressed, by index.
};

/// A stored number of an accessor after the normalization for its component type.
[[nodiscard]] float normalizedNumber(float number, int componentType);

} // namespace hairpaint::importer
