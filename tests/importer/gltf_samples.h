// Meshes as glTF files, plain, compressed and skinned.
#pragma once

#include "tests/importer/gltf_maker.h"
#include "tests/support/test_heads.h"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include <QtGlobal>

#include <array>

namespace hairpaint::test {

/// A ball of 6 cm, whose normals and uvs are those of its vertices.
inline const sim::HeadMesh& ball()
{
    static const sim::HeadMesh mesh = [] {
        sim::HeadMesh made = makeBallHead(10, 0.06F);
        std::erase_if(made.triangles, [&made](const glm::uvec3& t) { // Those of its poles have no area.
            const glm::vec3& a = made.positionsHd[t.x];
            return glm::length(glm::cross(made.positionsHd[t.y] - a, made.positionsHd[t.z] - a)) < 1e-6F;
        });
        return made;
    }();
    return mesh;
}

/// With 32-bit numbers everywhere.
inline GltfMaker plain()
{
    GltfMaker maker;
    maker.primitive()["attributes"] = {{"POSITION", maker.add(positionsOf(ball()), 3, kFloat)},
                                       {"NORMAL", maker.add(normalsOf(ball()), 3, kFloat)},
                                       {"TEXCOORD_0", maker.add(uvsOf(ball()), 2, kFloat)}};
    maker.primitive()["indices"] = maker.add(indicesOf(ball()), 1, kUnsignedInt);
    return maker;
}

/// A view's bytes instead of it, compressed by meshoptimizer.
inline void compressView(GltfMaker& maker, int view, bool isOfIndices, std::size_t stride)
{
    nlohmann::json& own = maker.json["bufferViews"][static_cast<std::size_t>(view)];
    const std::size_t count = own["byteLength"].get<std::size_t>() / stride;
    const std::byte* from = maker.bin.data() + own["byteOffset"].get<std::size_t>();
    std::vector<std::byte> coded;
    std::size_t size = 0;
    auto* const to =
        [&](std::size_t bound) {
            coded.resize(bound);
            return reinterpret_cast<unsigned char*>(coded.data());
        }(isOfIndices ? meshopt_encodeIndexBufferBound(count, ball().positionsHd.size())
                      : meshopt_encodeVertexBufferBound(count, stride));
    if (isOfIndices) {
        std::vector<unsigned> indices(count);
        std::memcpy(indices.data(), from, count * stride);
        size = meshopt_encodeIndexBuffer(to, coded.size(), indices.data(), count);
    } else {
        size = meshopt_encodeVertexBuffer(to, coded.size(), from, count, stride);
    }
    coded.resize(size);
    const int packed = maker.addView(coded);
    const nlohmann::json lies = maker.json["bufferViews"][static_cast<std::size_t>(packed)];
    maker.json["bufferViews"][static_cast<std::size_t>(view)] = {
        {"buffer", 1},
        {"byteLength", count * stride},
        {"extensions",
         {{"EXT_meshopt_compression",
           {{"buffer", 0},
            {"byteOffset", lies["byteOffset"]},
            {"byteLength", size},
            {"byteStride", stride},
            {"count", count},
            {"mode", isOfIndices ? "TRIANGLES" : "ATTRIBUTES"}}}}}};
}

inline GltfMaker packedByMeshopt()
{
    GltfMaker maker = plain();
    compressView(maker, 0, false, 12);
    compressView(maker, 2, false, 8);
    compressView(maker, 3, true, 4);
    maker.json["extensionsRequired"] = {"EXT_meshopt_compression"};
    return maker;
}

inline GltfMaker packedByDraco()
{
    const sim::HeadMesh& mesh = ball();
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(static_cast<int>(mesh.triangles.size()));
    const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int uv = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        std::array<glm::vec3, 3> p{};
        std::array<glm::vec2, 3> q{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = mesh.triangles[t][static_cast<int>(corner)];
            p.at(corner) = mesh.positionsHd[vertex];
            q.at(corner) = {mesh.uvs[vertex].x, 1.0F - mesh.uvs[vertex].y};
        }
        const draco::FaceIndex face(static_cast<std::uint32_t>(t));
        builder.SetAttributeValuesForFace(position, face, &p[0], &p[1], &p[2]);
        builder.SetAttributeValuesForFace(uv, face, &q[0], &q[1], &q[2]);
    }
    const std::unique_ptr<draco::Mesh> packed = builder.Finalize();
    draco::Encoder encoder;
    encoder.SetEncodingMethod(draco::MESH_SEQUENTIAL_ENCODING); // Keeps the order of triangles.
    draco::EncoderBuffer buffer;
    if (!encoder.EncodeMeshToBuffer(*packed, &buffer).ok())
        qFatal("Draco does not encode.");
    std::vector<std::byte> coded(buffer.size());
    std::memcpy(coded.data(), buffer.data(), coded.size());
    GltfMaker maker;
    for (const char* type : {"VEC3", "VEC2", "SCALAR"})
        maker.json["accessors"].push_back({{"componentType", type[0] == 'S' ? 5125 : 5126},
                                           {"count", type[0] == 'S' ? 3 * packed->num_faces() : packed->num_points()},
                                           {"type", type}});
    maker.primitive() = {{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}},
                         {"indices", 2},
                         {"extensions",
                          {{"KHR_draco_mesh_compression",
                            {{"bufferView", maker.addView(coded)},
                             {"attributes",
                              {{"POSITION", packed->attribute(position)->unique_id()},
                               {"TEXCOORD_0", packed->attribute(uv)->unique_id()}}}}}}}};
    maker.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    return maker;
}

/// The ball under two joints, a above b, each vertex held by both, half and half.
inline GltfMaker skinned(ComponentType weights, bool normalized)
{
    GltfMaker maker = plain();
    Numbers joints;
    Numbers held;
    for (std::size_t i = 0; i < ball().positionsHd.size(); ++i) {
        joints.insert(joints.end(), {0, 1, 0, 0});
        held.insert(held.end(), {0.5F, 0.5F, 0, 0});
    }
    maker.primitive()["attributes"]["JOINTS_0"] = maker.add(joints, 4, kUnsignedByte);
    maker.primitive()["attributes"]["WEIGHTS_0"] = maker.add(held, 4, weights, normalized);
    maker.json["nodes"] = {
        {{"mesh", 0}, {"skin", 0}}, {{"name", "a"}, {"children", {2}}}, {{"name", "b"}, {"translation", {0, 0.1, 0}}}};
    maker.json["scenes"][0]["nodes"] = {0, 1};
    maker.json["skins"] = {{{"joints", {1, 2}}}};
    return maker;
}

} // namespace hairpaint::test
