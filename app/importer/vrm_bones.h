// What a VRM file tells of its body: which nodes are its bones, and where it faces.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <unordered_map>

namespace hairpaint::importer {

/// The bones' ids of VRM, "leftUpperArm", by the numbers of their nodes. VRM 1.0 (VRM Consortium, VRMC_vrm-1.0) and 0.x
/// ("VRM"). Empty where a glTF's JSON names none; the nodes need not exist.
using BoneNames = std::unordered_map<int, std::string>;
[[nodiscard]] BoneNames vrmBones(const nlohmann::json& gltf);
/// VRM 0.x looks along -z, where glTF and VRM 1.0 look along z.
[[nodiscard]] bool facesBack(const nlohmann::json& gltf);

} // namespace hairpaint::importer
