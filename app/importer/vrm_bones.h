// Which nodes a VRM file itself says are the bones of its body.
#pragma once

#include <string>
#include <unordered_map>

namespace hairpaint::importer {

/// The bones' ids of VRM, "leftUpperArm", by their nodes' names. VRM 1.0 (VRM Consortium, VRMC_vrm-1.0) and 0.x ("VRM")
/// in a glTF's JSON. Empty where it names none or is none; names that several nodes bear are left out.
using BoneNames = std::unordered_map<std::string, std::string>;
[[nodiscard]] BoneNames bonesInJson(const std::string& json);
/// Of a file, binary or text; empty where it can't be read.
[[nodiscard]] BoneNames vrmBones(const std::string& path);

} // namespace hairpaint::importer
