// Attributes by their accessors, or decompressed by Draco.
#include "app/importer/gltf_primitive.h"

#include "app/importer/gltf_compression.h"
#include "app/importer/gltf_texture_space.h"
#include "app/importer/smooth_normals.h"
#include "sim/skin/head_limits.h"

#include <cmath>

namespace hairpaint::importer {

namespace {

template<typename T>
using Read = tl::expected<T, wire::Refusal>;

constexpr std::size_t kMostIndices = 3ULL * sim::kMostTriangles;

tl::unexpected<wire::Refusal> badPrimitive(const char* what)
{
    return tl::unexpected(wire::Refusal(wire::Reason::Malformed, what));
}

int numberOr(const std::map<std::string, int>& members, const std::string& name)
{
    const auto found = members.find(name);
    return found == members.end() ? -1 : found->second;
}

class PrimitiveReader
{
public:
    PrimitiveReader(GltfData& data, const GltfFile& file, const tinygltf::Primitive& primitive)
        : m_data(data), m_file(file), m_primitive(primitive)
    {}

    Read<SceneMesh> read(const GltfSkin* skin, const std::vector<double>& morphs);

private:
    [[nodiscard]] Read<void> decompress();
    /// `components` numbers a vertex; empty where the primitive has no such attribute.
    [[nodiscard]] Read<std::vector<float>> attribute(const std::string& name, int components);
    template<glm::length_t N>
    [[nodiscard]] Read<std::vector<glm::vec<N, float>>> vectors(const std::string& name);
    [[nodiscard]] Read<void> readPositions(SceneMesh& mesh, const std::vector<double>& morphs);
    [[nodiscard]] Read<void> readTriangles(SceneMesh& mesh);
    [[nodiscard]] Read<void> readUvs(SceneMesh& mesh);
    [[nodiscard]] Read<void> readWeights(SceneMesh& mesh, const GltfSkin& skin);

    GltfData& m_data;
    const GltfFile& m_file;
    const tinygltf::Primitive& m_primitive;
    std::optional<DracoMesh> m_draco{};
    std::map<std::string, int> m_dracoIds{};
    std::size_t m_vertices = 0;
};

Read<void> PrimitiveReader::decompress()
{
    const auto extension = m_primitive.extensions.find("KHR_draco_mesh_compression");
    if (extension == m_primitive.extensions.end())
        return {};
    const tinygltf::Value& told = extension->second;
    const auto undecoded = tl::unexpected(wire::Refusal(wire::Reason::UndecodedCompression, "Draco"));
    if (!told.Has("bufferView") || !told.Get("bufferView").IsInt() || !told.Has("attributes"))
        return undecoded;
    const Read<GltfData::Bytes> coded = m_data.view(told.Get("bufferView").GetNumberAsInt());
    if (!coded)
        return tl::unexpected(coded.error());
    std::vector<int> ids;
    for (const std::string& name : told.Get("attributes").Keys())
        if (const tinygltf::Value& id = told.Get("attributes").Get(name); id.IsInt()) {
            m_dracoIds[name] = id.GetNumberAsInt();
            ids.push_back(id.GetNumberAsInt());
        }
    m_draco = decodedDraco(*coded, ids, sim::kMostVertices, sim::kMostTriangles);
    return m_draco ? Read<void>() : undecoded;
}

Read<std::vector<float>> PrimitiveReader::attribute(const std::string& name, int components)
{
    const int accessor = numberOr(m_primitive.attributes, name);
    if (accessor < 0)
        return {};
    const int id = m_draco ? numberOr(m_dracoIds, name) : -1;
    if (id < 0)
        return m_data.floats(accessor, components, sim::kMostVertices);
    DracoMesh::Attribute& own = m_draco->attributes.at(id);
    if (own.components != components)
        return badPrimitive("its compressed numbers are not of the type that its use asks for");
    const tinygltf::Accessor* const told = m_data.find(accessor);
    if (told != nullptr && told->normalized && !own.isNormalized)
        for (float& number : own.numbers)
            number = normalizedNumber(number, told->componentType);
    return std::move(own.numbers);
}

template<glm::length_t N>
Read<std::vector<glm::vec<N, float>>> PrimitiveReader::vectors(const std::string& name)
{
    const Read<std::vector<float>> numbers = attribute(name, N);
    if (!numbers)
        return tl::unexpected(numbers.error());
    std::vector<glm::vec<N, float>> values(numbers->size() / N);
    for (std::size_t i = 0; i < values.size(); ++i)
        for (glm::length_t axis = 0; axis < N; ++axis)
            values[i][axis] = (*numbers)[i * N + static_cast<std::size_t>(axis)];
    if (!values.empty() && m_vertices != 0 && values.size() != m_vertices)
        return tl::unexpected(wire::Refusal(wire::Reason::Malformed, name + " and POSITION differ in their number"));
    return values;
}

Read<void> PrimitiveReader::readPositions(SceneMesh& mesh, const std::vector<double>& morphs)
{
    Read<std::vector<glm::vec3>> positions = vectors<3>("POSITION");
    if (!positions)
        return tl::unexpected(positions.error());
    mesh.positions = std::move(*positions);
    m_vertices = mesh.positions.size();
    for (std::size_t i = 0; i < morphs.size() && i < m_primitive.targets.size(); ++i) {
        const int accessor = numberOr(m_primitive.targets[i], "POSITION");
        if (morphs[i] == 0.0 || accessor < 0)
            continue;
        const Read<std::vector<float>> moves = m_data.floats(accessor, 3, sim::kMostVertices);
        if (!moves)
            return tl::unexpected(moves.error());
        for (std::size_t v = 0; v < m_vertices && 3 * v + 2 < moves->size(); ++v)
            mesh.positions[v] +=
                static_cast<float>(morphs[i]) * glm::vec3((*moves)[3 * v], (*moves)[3 * v + 1], (*moves)[3 * v + 2]);
    }
    return {};
}

Read<void> PrimitiveReader::readTriangles(SceneMesh& mesh)
{
    std::vector<std::uint32_t> indices;
    if (m_draco) {
        indices = std::move(m_draco->indices);
    } else if (m_primitive.indices >= 0) {
        Read<std::vector<std::uint32_t>> read = m_data.wholes(m_primitive.indices, 1, kMostIndices);
        if (!read)
            return tl::unexpected(read.error());
        indices = std::move(*read);
    } else {
        for (std::size_t i = 0; i < m_vertices; ++i)
            indices.push_back(static_cast<std::uint32_t>(i));
    }
    for (const std::uint32_t index : indices)
        if (index >= m_vertices)
            return badPrimitive("its triangles name vertices that do not exist");
    // Draco decompresses strips to triangles.
    const int mode = m_draco ? TINYGLTF_MODE_TRIANGLES : m_primitive.mode;
    if (mode == TINYGLTF_MODE_TRIANGLES)
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
            mesh.triangles.emplace_back(indices[i], indices[i + 1], indices[i + 2]);
    else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP)
        for (std::size_t i = 0; i + 2 < indices.size(); ++i)
            mesh.triangles.emplace_back(indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]);
    else if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
        for (std::size_t i = 1; i + 1 < indices.size(); ++i)
            mesh.triangles.emplace_back(indices[i], indices[i + 1], indices[0]);
    return {};
}

Read<void> PrimitiveReader::readUvs(SceneMesh& mesh)
{
    const TextureSpace space = textureSpaceOf(m_file.model, m_primitive.material);
    const std::string wanted = "TEXCOORD_" + std::to_string(space.set);
    const bool isThere = m_primitive.attributes.contains(wanted);
    Read<std::vector<glm::vec2>> uvs = vectors<2>(isThere ? wanted : "TEXCOORD_0");
    if (!uvs)
        return tl::unexpected(uvs.error());
    mesh.uvs = isThere ? transformed(std::move(*uvs), space) : std::move(*uvs);
    for (glm::vec2& uv : mesh.uvs)
        uv.y = 1.0F - uv.y;
    return {};
}

Read<void> PrimitiveReader::readWeights(SceneMesh& mesh, const GltfSkin& skin)
{
    mesh.bones = skin.bones;
    for (int set = 0; m_primitive.attributes.contains("JOINTS_" + std::to_string(set)); ++set) {
        const Read<std::vector<float>> joints = attribute("JOINTS_" + std::to_string(set), 4);
        if (!joints)
            return tl::unexpected(joints.error());
        const Read<std::vector<float>> weights = attribute("WEIGHTS_" + std::to_string(set), 4);
        if (!weights)
            return tl::unexpected(weights.error());
        for (std::size_t i = 0; i < joints->size() && i < weights->size() && i / 4 < m_vertices; ++i) {
            const float slot = (*joints)[i];
            if (!((*weights)[i] > 0.0F) || !(slot >= 0.0F && slot < static_cast<float>(skin.slots.size())))
                continue;
            const std::int32_t bone = skin.slots[static_cast<std::size_t>(slot)];
            if (bone >= 0)
                mesh.weights.push_back({.vertex = static_cast<std::uint32_t>(i / 4),
                                        .bone = static_cast<std::uint32_t>(bone),
                                        .weight = (*weights)[i]});
        }
    }
    return {};
}

Read<SceneMesh> PrimitiveReader::read(const GltfSkin* skin, const std::vector<double>& morphs)
{
    SceneMesh mesh;
    mesh.material = m_primitive.material;
    if (m_primitive.mode >= 0 && m_primitive.mode < TINYGLTF_MODE_TRIANGLES)
        return mesh; // Points and lines.
    if (const Read<void> decoded = decompress(); !decoded)
        return tl::unexpected(decoded.error());
    if (const Read<void> read = readPositions(mesh, morphs); !read)
        return tl::unexpected(read.error());
    if (const Read<void> read = readTriangles(mesh); !read)
        return tl::unexpected(read.error());
    if (const Read<void> read = readUvs(mesh); !read)
        return tl::unexpected(read.error());
    Read<std::vector<glm::vec3>> normals = vectors<3>("NORMAL");
    if (!normals)
        return tl::unexpected(normals.error());
    mesh.normals = normals->empty() ? smoothNormals(mesh.positions, mesh.triangles) : std::move(*normals);
    if (skin != nullptr)
        if (const Read<void> read = readWeights(mesh, *skin); !read)
            return tl::unexpected(read.error());
    return mesh;
}

} // namespace

Read<SceneMesh> gltfPrimitive(GltfData& data, const GltfFile& file, const tinygltf::Primitive& primitive,
                              const GltfSkin* skin, const std::vector<double>& morphs)
{
    return PrimitiveReader(data, file, primitive).read(skin, morphs);
}

} // namespace hairpaint::importer
