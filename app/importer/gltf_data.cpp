// Ranges are checked once an accessor, then its numbers are read.
#include "app/importer/gltf_data.h"

#include "app/importer/gltf_compression.h"
#include "app/importer/gltf_uri.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hairpaint::importer {

namespace {

tl::unexpected<wire::Refusal> malformed(const std::string& what)
{
    return tl::unexpected(wire::Refusal(wire::Reason::Malformed, what));
}

std::string named(const char* kind, int index)
{
    return std::string(kind) + ' ' + std::to_string(index);
}

/// 0 where there is no such type.
std::size_t bytesOf(int componentType)
{
    switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 2;
    case TINYGLTF_COMPONENT_TYPE_INT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return 4;
    case TINYGLTF_COMPONENT_TYPE_DOUBLE:
        return 8;
    default:
        return 0;
    }
}

template<typename Number>
double numberAt(const std::byte* bytes)
{
    Number number{};
    std::memcpy(&number, bytes, sizeof number);
    return static_cast<double>(number);
}

using NumberAt = double (*)(const std::byte*);
NumberAt numberReader(int componentType)
{
    switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return numberAt<std::int8_t>;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return numberAt<std::uint8_t>;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return numberAt<std::int16_t>;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return numberAt<std::uint16_t>;
    case TINYGLTF_COMPONENT_TYPE_INT:
        return numberAt<std::int32_t>;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return numberAt<std::uint32_t>;
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return numberAt<float>;
    default:
        return numberAt<double>;
    }
}

const tinygltf::Value* meshoptOf(const tinygltf::ExtensionMap& extensions)
{
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
        if (const auto found = extensions.find(name); found != extensions.end() && found->second.IsObject())
            return &found->second;
    return nullptr;
}

} // namespace

struct GltfData::Elements
{
    Bytes bytes;
    std::size_t stride = 0;
    std::size_t numberBytes = 0;
    NumberAt read = nullptr;
    [[nodiscard]] double number(std::size_t element, std::size_t component) const
    {
        return read(bytes.data() + element * stride + component * numberBytes);
    }
};

float normalizedNumber(float number, int componentType)
{
    switch (componentType) { // Khronos, glTF 2.0, section 3.6.2.2
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return std::max(number / 127.0F, -1.0F);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return number / 255.0F;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return std::max(number / 32767.0F, -1.0F);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return number / 65535.0F;
    default:
        return number;
    }
}

GltfData::Read<BufferBytes> GltfData::uri(const std::string& named) const
{
    if (!isDataUri(named))
        return m_reader(named);
    std::optional<BufferBytes> bytes = dataOfUri(named);
    if (!bytes)
        return malformed("data in it is no base64");
    return *std::move(bytes);
}

const tinygltf::Accessor* GltfData::find(int accessor) const
{
    const std::vector<tinygltf::Accessor>& all = m_file.model.accessors;
    return accessor >= 0 && static_cast<std::size_t>(accessor) < all.size() ? &all[static_cast<std::size_t>(accessor)]
                                                                            : nullptr;
}

GltfData::Read<GltfData::Bytes> GltfData::buffer(int index)
{
    if (index < 0 || static_cast<std::size_t>(index) >= m_file.buffers.size())
        return malformed(named("buffer", index) + " is named and does not exist");
    const GltfFile::Buffer& own = m_file.buffers[static_cast<std::size_t>(index)];
    if (!own.uri) {
        if (m_file.chunk.empty())
            return malformed(named("buffer", index) + " has no data");
        return m_file.chunk;
    }
    if (const auto known = m_buffers.find(index); known != m_buffers.end())
        return Bytes(known->second);
    Read<BufferBytes> bytes = [&]() -> Read<BufferBytes> {
        if (!isDataUri(*own.uri))
            return m_reader(*own.uri);
        std::optional<BufferBytes> data = dataOfUri(*own.uri);
        return data ? Read<BufferBytes>(std::move(*data)) : malformed(named("buffer", index) + " is no base64 data");
    }();
    if (!bytes)
        return tl::unexpected(bytes.error());
    return Bytes(m_buffers.emplace(index, std::move(*bytes)).first->second);
}

GltfData::Read<GltfData::Bytes> GltfData::decompressed(const tinygltf::Value& extension, int index)
{
    if (const auto known = m_views.find(index); known != m_views.end())
        return Bytes(known->second);
    const MeshoptView coded = meshoptView(extension);
    const Read<Bytes> all = buffer(coded.buffer);
    if (!all)
        return all;
    if (coded.byteOffset > all->size() || coded.byteLength > all->size() - coded.byteOffset)
        return malformed(named("buffer view", index) + " reaches beyond the end of its buffer");
    std::optional<BufferBytes> bytes = decodedMeshopt(coded, all->subspan(coded.byteOffset, coded.byteLength));
    if (!bytes)
        return tl::unexpected(wire::Refusal(wire::Reason::UndecodedCompression, "meshopt"));
    return Bytes(m_views.emplace(index, std::move(*bytes)).first->second);
}

GltfData::Read<GltfData::Bytes> GltfData::view(int index)
{
    if (index < 0 || static_cast<std::size_t>(index) >= m_file.model.bufferViews.size())
        return malformed(named("buffer view", index) + " is named and does not exist");
    const tinygltf::BufferView& own = m_file.model.bufferViews[static_cast<std::size_t>(index)];
    if (const tinygltf::Value* extension = meshoptOf(own.extensions))
        return decompressed(*extension, index);
    const Read<Bytes> all = buffer(own.buffer);
    if (!all)
        return all;
    if (own.byteOffset > all->size() || own.byteLength > all->size() - own.byteOffset)
        return malformed(named("buffer view", index) + " reaches beyond the end of its buffer of " +
                         std::to_string(all->size()) + " bytes");
    return all->subspan(own.byteOffset, own.byteLength);
}

GltfData::Read<GltfData::Elements> GltfData::elements(int view, std::size_t offset, int componentType, int components,
                                                      std::size_t count)
{
    const std::size_t numberBytes = bytesOf(componentType);
    if (numberBytes == 0)
        return malformed("its numbers have a type that glTF does not know");
    const Read<Bytes> all = this->view(view);
    if (!all)
        return tl::unexpected(all.error());
    const std::size_t element = numberBytes * static_cast<std::size_t>(components);
    const std::size_t told = m_file.model.bufferViews[static_cast<std::size_t>(view)].byteStride;
    const std::size_t stride = told == 0 ? element : told;
    const std::size_t there = offset <= all->size() ? all->size() - offset : 0;
    if (count > 0 && (there < element || (there - element) / stride < count - 1))
        return malformed(named("buffer view", view) + " holds less than its " + std::to_string(count) + " elements");
    return Elements{.bytes = all->subspan(count > 0 ? offset : 0),
                    .stride = stride,
                    .numberBytes = numberBytes,
                    .read = numberReader(componentType)};
}

template<typename Number, typename Convert>
GltfData::Read<std::vector<Number>> GltfData::numbers(int index, int components, std::size_t most,
                                                      const Convert& convert)
{
    const tinygltf::Accessor* const accessor = find(index);
    if (accessor == nullptr)
        return malformed(named("accessor", index) + " is named and does not exist");
    if (tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor->type)) != components)
        return malformed(named("accessor", index) + " is not of the type that its use asks for");
    if (accessor->count > most)
        return tl::unexpected(wire::Reason::TooLarge);
    const auto perElement = static_cast<std::size_t>(components);
    std::vector<Number> numbers;
    const auto copied = [&](const Elements& from, std::size_t element, std::size_t to) {
        for (std::size_t i = 0; i < perElement; ++i)
            numbers[to * perElement + i] = convert(from.number(element, i), *accessor);
    };
    if (accessor->bufferView >= 0) {
        const Read<Elements> all =
            elements(accessor->bufferView, accessor->byteOffset, accessor->componentType, components, accessor->count);
        if (!all)
            return tl::unexpected(all.error());
        numbers.resize(accessor->count * perElement);
        for (std::size_t i = 0; i < accessor->count; ++i)
            copied(*all, i, i);
    } else {
        numbers.resize(accessor->count * perElement);
    }
    if (!accessor->sparse.isSparse)
        return numbers;
    const auto& sparse = accessor->sparse;
    if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0)
        return malformed(named("accessor", index) + " has changes at indices that do not exist");
    const auto count = static_cast<std::size_t>(sparse.count);
    const Read<Elements> where =
        elements(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
                 sparse.indices.componentType, 1, count);
    if (!where)
        return tl::unexpected(where.error());
    const Read<Elements> what = elements(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset),
                                         accessor->componentType, components, count);
    if (!what)
        return tl::unexpected(what.error());
    for (std::size_t i = 0; i < count; ++i) {
        const double at = where->number(i, 0);
        if (!(at >= 0.0 && at < static_cast<double>(accessor->count)))
            return malformed(named("accessor", index) + " has changes at indices that do not exist");
        copied(*what, i, static_cast<std::size_t>(at));
    }
    return numbers;
}

GltfData::Read<std::vector<float>> GltfData::floats(int accessor, int components, std::size_t most)
{
    return numbers<float>(accessor, components, most, [](double number, const tinygltf::Accessor& own) {
        const auto value = static_cast<float>(number);
        return own.normalized ? normalizedNumber(value, own.componentType) : value;
    });
}

GltfData::Read<std::vector<std::uint32_t>> GltfData::wholes(int accessor, int components, std::size_t most)
{
    return numbers<std::uint32_t>(accessor, components, most, [](double number, const tinygltf::Accessor&) {
        constexpr double kMost = 4294967295.0;
        return static_cast<std::uint32_t>(number >= 0.0 && number <= kMost ? number : kMost);
    });
}

} // namespace hairpaint::importer
