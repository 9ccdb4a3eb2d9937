// Small glTF files of any kind of numbers, made by tests.
#pragma once

#include "sim/skin/head_mesh.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace hairpaint::test {

enum ComponentType : int
{
    kByte = 5120,
    kUnsignedByte = 5121,
    kShort = 5122,
    kUnsignedShort = 5123,
    kUnsignedInt = 5125,
    kFloat = 5126
};

using Numbers = std::vector<float>;

/// A scene of one node, to which a mesh is added.
struct GltfMaker
{
    nlohmann::json json = {{"asset", {{"version", "2.0"}}},
                           {"scenes", {{{"nodes", {0}}}}},
                           {"nodes", {{{"mesh", 0}}}},
                           {"meshes", {{{"primitives", {nlohmann::json::object()}}}}},
                           {"accessors", nlohmann::json::array()},
                           {"bufferViews", nlohmann::json::array()}};
    std::vector<std::byte> bin;

    nlohmann::json& primitive() { return json["meshes"][0]["primitives"][0]; }

    /// The view's number.
    int addView(const std::vector<std::byte>& bytes, std::size_t stride = 0)
    {
        bin.resize((bin.size() + 3) / 4 * 4);
        nlohmann::json view = {{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", bytes.size()}};
        if (stride != 0)
            view["byteStride"] = stride;
        bin.insert(bin.end(), bytes.begin(), bytes.end());
        json["bufferViews"].push_back(view);
        return static_cast<int>(json["bufferViews"].size()) - 1;
    }
    /// The accessor's number. `stride`: bytes between two elements, at least as many as one has.
    int add(const Numbers& numbers, int components, ComponentType type, bool normalized = false, std::size_t stride = 0)
    {
        const std::size_t count = numbers.size() / static_cast<std::size_t>(components);
        json["accessors"].push_back(
            {{"bufferView", addView(encoded(numbers, components, type, normalized, stride), stride)},
             {"componentType", static_cast<int>(type)},
             {"count", count},
             {"type", typeOf(components)}});
        if (normalized)
            json["accessors"].back()["normalized"] = true;
        return static_cast<int>(json["accessors"].size()) - 1;
    }
    static const char* typeOf(int components)
    {
        return components == 1   ? "SCALAR"
               : components == 2 ? "VEC2"
               : components == 3 ? "VEC3"
               : components == 4 ? "VEC4"
                                 : "MAT4";
    }
    static std::vector<std::byte> encoded(const Numbers& numbers, int components, ComponentType type,
                                          bool normalized = false, std::size_t stride = 0)
    {
        std::vector<std::byte> bytes;
        const auto append = [&bytes](auto number) {
            const auto* from = reinterpret_cast<const std::byte*>(&number);
            bytes.insert(bytes.end(), from, from + sizeof number);
        };
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (stride != 0 && i % static_cast<std::size_t>(components) == 0)
                bytes.resize(i / static_cast<std::size_t>(components) * stride);
            const auto whole = [&](float greatest) {
                return static_cast<std::int64_t>(std::lround(numbers[i] * (normalized ? greatest : 1.0F)));
            };
            switch (type) {
            case kByte:
                append(static_cast<std::int8_t>(whole(127.0F)));
                break;
            case kUnsignedByte:
                append(static_cast<std::uint8_t>(whole(255.0F)));
                break;
            case kShort:
                append(static_cast<std::int16_t>(whole(32767.0F)));
                break;
            case kUnsignedShort:
                append(static_cast<std::uint16_t>(whole(65535.0F)));
                break;
            case kUnsignedInt:
                append(static_cast<std::uint32_t>(whole(1.0F)));
                break;
            case kFloat:
                append(numbers[i]);
                break;
            }
        }
        if (stride != 0)
            bytes.resize(numbers.size() / static_cast<std::size_t>(components) * stride);
        return bytes;
    }
    /// A binary glTF.
    [[nodiscard]] std::vector<std::byte> glb()
    {
        json["buffers"] = {{{"byteLength", bin.size()}}};
        std::string text = json.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        bin.resize((bin.size() + 3) / 4 * 4);
        std::vector<std::byte> bytes;
        const auto word = [&bytes](std::size_t value) {
            const auto own = static_cast<std::uint32_t>(value);
            const auto* from = reinterpret_cast<const std::byte*>(&own);
            bytes.insert(bytes.end(), from, from + 4);
        };
        const auto piece = [&](std::size_t kind, const std::byte* from, std::size_t size) {
            word(size);
            word(kind);
            bytes.insert(bytes.end(), from, from + size);
        };
        word(0x46546C67);
        word(2);
        word(12 + 8 + text.size() + 8 + bin.size());
        piece(0x4E4F534A, reinterpret_cast<const std::byte*>(text.data()), text.size());
        piece(0x004E4942, bin.data(), bin.size());
        return bytes;
    }
};

inline Numbers positionsOf(const sim::HeadMesh& mesh, float scale = 1.0F)
{
    Numbers numbers;
    for (const glm::vec3& p : mesh.positionsHd)
        numbers.insert(numbers.end(), {p.x * scale, p.y * scale, p.z * scale});
    return numbers;
}

inline Numbers normalsOf(const sim::HeadMesh& mesh)
{
    Numbers numbers;
    for (const glm::vec3& n : mesh.normalsHd)
        numbers.insert(numbers.end(), {n.x, n.y, n.z});
    return numbers;
}

/// v down, as glTF has it.
inline Numbers uvsOf(const sim::HeadMesh& mesh)
{
    Numbers numbers;
    for (const glm::vec2& uv : mesh.uvs)
        numbers.insert(numbers.end(), {uv.x, 1.0F - uv.y});
    return numbers;
}

inline Numbers indicesOf(const sim::HeadMesh& mesh)
{
    Numbers numbers;
    for (const glm::uvec3& t : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner)
            numbers.push_back(static_cast<float>(t[corner]));
    return numbers;
}

} // namespace hairpaint::test
