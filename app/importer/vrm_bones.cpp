// Looks at nothing but a VRM's extension.
#include "app/importer/vrm_bones.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <limits>

namespace hairpaint::importer {

namespace {

using Json = nlohmann::json;

/// A null where it is no object or has no such member.
const Json& member(const Json& object, const char* name)
{
    static const Json none;
    const auto found = object.find(name);
    return found == object.end() ? none : *found;
}

} // namespace

BoneNames vrmBones(const Json& gltf)
{
    BoneNames bones;
    const auto add = [&bones](const std::string& bone, const Json& node) {
        constexpr std::uint64_t kMost = std::numeric_limits<int>::max();
        if (!bone.empty() && node.is_number_unsigned() && node.get<std::uint64_t>() <= kMost)
            bones.try_emplace(node.get<int>(), bone);
    };
    const Json& extensions = member(gltf, "extensions");
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

bool facesBack(const Json& gltf)
{
    const Json& extensions = member(gltf, "extensions");
    return member(extensions, "VRM").is_object() && !member(extensions, "VRMC_vrm").is_object();
}

} // namespace hairpaint::importer
