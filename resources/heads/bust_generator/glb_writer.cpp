// Two chunks: JSON padded with spaces, then the binary one.
#include "glb_writer.h"

#include <bit>
#include <cstring>
#include <fstream>
#include <locale>
#include <span>
#include <sstream>
#include <string>

#include "sim/skin/mesh_bounds.h"

namespace hairpaint::heads {

namespace {

static_assert(std::endian::native == std::endian::little, "the arrays are written as they lie in memory");

std::string text(const glm::vec3& v)
{
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(9); // enough to bring a float back exactly
    out << '[' << v.x << ',' << v.y << ',' << v.z << ']';
    return out.str();
}

template<typename T>
std::string bytes(const std::vector<T>& values)
{
    std::string out(values.size() * sizeof(T), '\0');
    std::memcpy(out.data(), values.data(), out.size());
    return out;
}

std::string word(std::size_t value)
{
    return bytes(std::vector<std::uint32_t>{static_cast<std::uint32_t>(value)});
}

struct Block
{
    std::string bytes;
    std::string accessor; // its JSON members after bufferView and count
    std::size_t count;
    int target;
};

std::string description(std::span<const Block> blocks, std::size_t size)
{
    std::string views;
    std::string accessors;
    std::size_t offset = 0;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const std::string comma = i == 0 ? "" : ",";
        views += comma + R"({"buffer":0,"byteOffset":)" + std::to_string(offset) + R"(,"byteLength":)" +
                 std::to_string(blocks[i].bytes.size()) + R"(,"target":)" + std::to_string(blocks[i].target) + "}";
        accessors += comma + R"({"bufferView":)" + std::to_string(i) + R"(,"count":)" +
                     std::to_string(blocks[i].count) + "," + blocks[i].accessor + "}";
        offset += blocks[i].bytes.size();
    }
    return R"({"asset":{"version":"2.0","generator":"hairpaint_bust_generator"},"scene":0,"scenes":[{)"
           R"("nodes":[0]}],)"
           R"("nodes":[{"mesh":0,"name":"bust-2"}],"meshes":[{"name":"bust-2","primitives":[{)"
           R"("attributes":{)"
           R"("POSITION":1,"NORMAL":2,"TEXCOORD_0":3,"_UV":4},"indices":0,"mode":4}]}],"buffers":[{)"
           R"("byteLength":)" +
           std::to_string(size) + R"(}],"bufferViews":[)" + views + R"(],"accessors":[)" + accessors + "]}";
}

} // namespace

bool writeGlb(const sim::HeadMesh& mesh, const std::filesystem::path& path)
{
    const sim::MeshBounds bounds = sim::boundsOf(mesh);
    std::vector<glm::vec2> flipped;
    for (const glm::vec2& uv : mesh.uvs)
        flipped.emplace_back(uv.x, 1.0F - uv.y);

    constexpr int vertexTarget = 34962;
    constexpr int indexTarget = 34963;
    const std::size_t count = mesh.positionsHd.size();
    const std::string vec3 = R"("componentType":5126,"type":"VEC3")";
    const std::string vec2 = R"("componentType":5126,"type":"VEC2")";
    const std::vector<Block> blocks = {
        {bytes(mesh.triangles), R"("componentType":5125,"type":"SCALAR")", mesh.triangles.size() * 3, indexTarget},
        {bytes(mesh.positionsHd), vec3 + R"(,"min":)" + text(bounds.least) + R"(,"max":)" + text(bounds.greatest),
         count, vertexTarget},
        {bytes(mesh.normalsHd), vec3, count, vertexTarget},
        {bytes(flipped), vec2, count, vertexTarget},
        {bytes(mesh.uvs), vec2, count, vertexTarget}};
    std::string binary;
    for (const Block& block : blocks)
        binary += block.bytes; // each a multiple of four bytes long
    std::string json = description(blocks, binary.size());
    json.resize((json.size() + 3) / 4 * 4, ' ');

    const std::size_t total = 12 + 8 + json.size() + 8 + binary.size();
    std::ofstream file(path, std::ios::binary);
    file << "glTF" << word(2) << word(total) << word(json.size()) << "JSON" << json << word(binary.size())
         << std::string("BIN\0", 4) << binary;
    return static_cast<bool>(file.flush());
}

} // namespace hairpaint::heads
