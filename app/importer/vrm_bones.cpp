// Reads no more than a glTF's JSON, with limits.
#include "app/importer/vrm_bones.h"

#include <rapidjson/document.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace hairpaint::importer {

namespace {

using Json = rapidjson::Value;

constexpr std::uintmax_t kMostBytes = 64U << 20U;
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

/// Null where it is no object or has no such member.
const Json* member(const Json* object, const char* name)
{
    if (object == nullptr || !object->IsObject())
        return nullptr;
    const auto found = object->FindMember(name);
    return found == object->MemberEnd() ? nullptr : &found->value;
}

class NodeNames
{
public:
    explicit NodeNames(const Json* nodes) : m_nodes(nodes != nullptr && nodes->IsArray() ? nodes : nullptr)
    {
        for (rapidjson::SizeType i = 0; m_nodes != nullptr && i < m_nodes->Size(); ++i)
            ++m_bearers[nameOf(i)];
    }
    /// Empty where no other bears it.
    [[nodiscard]] std::string own(const Json* node) const
    {
        if (m_nodes == nullptr || node == nullptr || !node->IsUint() || node->GetUint() >= m_nodes->Size())
            return {};
        std::string name = nameOf(node->GetUint());
        return m_bearers.at(name) == 1 ? name : std::string();
    }

private:
    [[nodiscard]] std::string nameOf(rapidjson::SizeType i) const
    {
        const Json* name = member(&(*m_nodes)[i], "name");
        return name != nullptr && name->IsString() ? std::string(name->GetString(), name->GetStringLength())
                                                   : std::string();
    }

    const Json* m_nodes;
    std::unordered_map<std::string, int> m_bearers;
};

} // namespace

BoneNames vrmBones(const std::string& path)
{
    return bonesInJson(jsonOf(path));
}

BoneNames bonesInJson(const std::string& json)
{
    rapidjson::Document document;
    // Iteratively: however deep it is, the stack is not.
    document.Parse<rapidjson::kParseIterativeFlag>(json.data(), json.size());
    if (json.empty() || document.HasParseError())
        return {};
    const NodeNames names(member(&document, "nodes"));
    BoneNames bones;
    const auto add = [&](const std::string& bone, const Json* node) {
        if (std::string name = names.own(node); !name.empty())
            bones.try_emplace(std::move(name), bone);
    };
    const Json* extensions = member(&document, "extensions");
    const Json* now = member(member(member(extensions, "VRMC_vrm"), "humanoid"), "humanBones");
    if (now != nullptr && now->IsObject())
        for (const auto& bone : now->GetObject())
            add(bone.name.GetString(), member(&bone.value, "node"));
    const Json* before = member(member(member(extensions, "VRM"), "humanoid"), "humanBones");
    if (before != nullptr && before->IsArray())
        for (const Json& bone : before->GetArray())
            if (const Json* id = member(&bone, "bone"); id != nullptr && id->IsString())
                add(id->GetString(), member(&bone, "node"));
    return bones;
}

} // namespace hairpaint::importer
