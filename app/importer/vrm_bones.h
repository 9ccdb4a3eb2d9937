// Which nodes a VRM file itself says are the bones of its body.
#pragma once

#include <string>
#include <unordered_map>

namespace hairpaint::importer {

/// The bones' ids of VRM, "leftUpperArm", by their nodes' names. VRM 1.0 (VRM Consortium, VRMC_vrm-1.0) and 0.x ("VRM")
/// in a binary or text glTF. Empty where the file names none or can't be read; names that several nodes bear are left
/// out.
using BoneNames = std::unordered_map<std::string, std::string>;
[[nodiscard]] BoneNames vrmBones(const std::string& path);

} // namespace hairpaint::importer
