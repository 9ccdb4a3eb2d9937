// What the decoders do not check themselves is checked before.
#include "app/importer/gltf_compression.h"

#include <draco/compression/decode.h>
#include <meshoptimizer.h>
#include <tiny_gltf.h>

#include <limits>

namespace hairpaint::importer {

namespace {

std::size_t sizeIn(const tinygltf::Value& object, const char* key)
{
    const tinygltf::Value value = object.Has(key) ? object.Get(key) : tinygltf::Value();
    return value.IsInt() && value.GetNumberAsInt() > 0 ? static_cast<std::size_t>(value.GetNumberAsInt()) : 0;
}

std::string textIn(const tinygltf::Value& object, const char* key)
{
    const tinygltf::Value value = object.Has(key) ? object.Get(key) : tinygltf::Value();
    return value.IsString() ? value.Get<std::string>() : std::string();
}

bool filtered(const MeshoptView& view, std::vector<std::byte>& bytes)
{
    if (view.filter.empty() || view.filter == "NONE")
        return true;
    if (view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8))
        meshopt_decodeFilterOct(bytes.data(), view.count, view.stride);
    else if (view.filter == "QUATERNION" && view.stride == 8)
        meshopt_decodeFilterQuat(bytes.data(), view.count, view.stride);
    else if (view.filter == "EXPONENTIAL" && view.stride % 4 == 0)
        meshopt_decodeFilterExp(bytes.data(), view.count, view.stride);
    else
        return false;
    return true;
}

} // namespace

MeshoptView meshoptView(const tinygltf::Value& extension)
{
    MeshoptView view;
    if (extension.Has("buffer") && extension.Get("buffer").IsInt())
        view.buffer = extension.Get("buffer").GetNumberAsInt();
    view.byteOffset = sizeIn(extension, "byteOffset");
    view.byteLength = sizeIn(extension, "byteLength");
    view.count = sizeIn(extension, "count");
    view.stride = sizeIn(extension, "byteStride");
    view.mode = textIn(extension, "mode");
    view.filter = textIn(extension, "filter");
    return view;
}

std::optional<std::vector<std::byte>> decodedMeshopt(const MeshoptView& view, std::span<const std::byte> coded)
{
    constexpr std::size_t kMostBytes = 1U << 28U;
    constexpr std::size_t kWidest = 256;
    if (view.stride == 0 || view.stride > kWidest || view.count == 0 || view.count > kMostBytes / view.stride)
        return std::nullopt;
    const auto* from = reinterpret_cast<const unsigned char*>(coded.data());
    const bool isOfIndices = view.stride == 2 || view.stride == 4;
    std::vector<std::byte> bytes(view.count * view.stride);
    int problem = -1;
    if (view.mode == "ATTRIBUTES" && view.stride % 4 == 0)
        problem = meshopt_decodeVertexBuffer(bytes.data(), view.count, view.stride, from, coded.size());
    else if (view.mode == "TRIANGLES" && isOfIndices && view.count % 3 == 0)
        problem = meshopt_decodeIndexBuffer(bytes.data(), view.count, view.stride, from, coded.size());
    else if (view.mode == "INDICES" && isOfIndices)
        problem = meshopt_decodeIndexSequence(bytes.data(), view.count, view.stride, from, coded.size());
    if (problem != 0 || !filtered(view, bytes))
        return std::nullopt;
    return bytes;
}

std::optional<DracoMesh> decodedDraco(std::span<const std::byte> coded, const std::vector<int>& ids,
                                      std::size_t mostVertices, std::size_t mostTriangles)
{
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(coded.data()), coded.size());
    draco::Decoder decoder;
    const auto type = draco::Decoder::GetEncodedGeometryType(&buffer);
    if (!type.ok() || type.value() != draco::TRIANGULAR_MESH)
        return std::nullopt;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok() || decoded.value() == nullptr)
        return std::nullopt;
    const draco::Mesh& mesh = *decoded.value();
    if (mesh.num_points() > mostVertices || mesh.num_faces() > mostTriangles)
        return std::nullopt;
    DracoMesh result{.vertices = mesh.num_points(), .indices = {}, .attributes = {}};
    result.indices.reserve(3 * static_cast<std::size_t>(mesh.num_faces()));
    for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face)
        for (const draco::PointIndex& point : mesh.face(face)) {
            if (point >= mesh.num_points())
                return std::nullopt;
            result.indices.push_back(point.value());
        }
    for (const int id : ids) {
        const draco::PointAttribute* const own =
            id < 0 ? nullptr : mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
        constexpr int kMostComponents = 4;
        if (own == nullptr || own->num_components() < 1 || own->num_components() > kMostComponents)
            return std::nullopt;
        const int components = own->num_components();
        DracoMesh::Attribute& attribute = result.attributes[id];
        attribute = {.components = components,
                     .isNormalized = own->normalized(),
                     .numbers = std::vector<float>(result.vertices * static_cast<std::size_t>(components))};
        for (std::size_t point = 0; point < result.vertices; ++point) {
            const draco::AttributeValueIndex value =
                own->mapped_index(draco::PointIndex(static_cast<std::uint32_t>(point)));
            float* const to = attribute.numbers.data() + point * static_cast<std::size_t>(components);
            if (value.value() >= own->size() || !own->ConvertValue(value, static_cast<std::int8_t>(components), to))
                return std::nullopt;
        }
    }
    return result;
}

} // namespace hairpaint::importer
