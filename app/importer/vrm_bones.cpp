// Reads no more than a glTF's JSON, with limits.
#include "app/importer/vrm_bones.h"

#include <nlohmann/json.hpp>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace hairpaint::importer {

namespace {

using Json = nlohmann::json;

constexpr std::uintmax_t kMostBytes = 16U << 20U;
constexpr std::size_t kHeaderBytes = 20; ///< Of a binary glTF, with that of its first chunk.

static_assert(std::endian::native == std::endian::little);

/// Empty where there is none.
std::string jsonOf(const std::string& path)
{
    std::error_code problem;
    const std::uintmax_t size = std::filesystem::file_size(path, problem);
    std::ifstream file(path, std::ios::binary);
    std::array<char, kHeaderBytes> header{};
    if (problem || !file.read(header.data(), header.size()))
        return {};
    std::uintmax_t bytes = size;
    if (std::memcmp(header.data(), "glTF", 4) == 0) {
        std::uint32_t chunk = 0;
        std::memcpy(&chunk, header.data() + 12, sizeof chunk);
        if (chunk > size - kHeaderBytes)
            return {};
        bytes = chunk;
    } else {
        file.seekg(0);
    }
    if (bytes > kMostBytes)
        return {};
    std::string json(static_cast<std::size_t>(bytes), '\0');
    file.read(json.data(), static_cast<std::streamsize>(bytes));
    return file ? json : std::string();
}

/// A null where it is no object or has no such member.
const Json& member(const Json& object, const char* name)
{
    static const Json none;
    const auto found = object.find(name);
    return found == object.end() ? none : *found;
}

class NodeNames
{
public:
    explicit NodeNames(const Json& nodes) : m_nodes(nodes)
    {
        for (const Json& node : nodes)
            ++m_bearers[nameOf(node)];
    }
    /// Empty where there is no such node, or others bear its name.
    [[nodiscard]] std::string own(const Json& node) const
    {
        if (!node.is_number_unsigned() || !m_nodes.is_array() || node.get<std::uint64_t>() >= m_nodes.size())
            return {};
        std::string name = nameOf(m_nodes[node.get<std::size_t>()]);
        return m_bearers.at(name) == 1 ? name : std::string();
    }

private:
    [[nodiscard]] static std::string nameOf(const Json& node)
    {
        const Json& name = member(node, "name");
        return name.is_string() ? name.get<std::string>() : std::string();
    }

    const Json& m_nodes;
    std::unordered_map<std::string, int> m_bearers;
};

} // namespace

BoneNames vrmBones(const std::string& path)
{
    return bonesInJson(jsonOf(path));
}

BoneNames bonesInJson(const std::string& json)
{
    constexpr bool kThrows = false;
    const Json root = Json::parse(json, nullptr, kThrows);
    if (!root.is_object())
        return {};
    const NodeNames names(member(root, "nodes"));
    BoneNames bones;
    const auto add = [&](const std::string& bone, const Json& node) {
        if (std::string name = names.own(node); !name.empty())
            bones.try_emplace(std::move(name), bone);
    };
    const Json& extensions = member(root, "extensions");
    const Json& now = member(member(member(extensions, "VRMC_vrm"), "humanoid"), "humanBones");
    if (now.is_object())
        for (const auto& [bone, value] : now.items())
            add(bone, member(value, "node"));
    const Json& before = member(member(member(extensions, "VRM"), "humanoid"), "humanBones");
    if (before.is_array())
        for (const Json& bone : before)
            if (const Json& id = member(bone, "bone"); id.is_string())
                add(id.get<std::string>(), member(bone, "node"));
    return bones;
}

} // namespace hairpaint::importer
