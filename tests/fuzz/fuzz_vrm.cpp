// The JSON of a glTF, which may name the bones of a body.
#include "app/importer/vrm_bones.h"
#include "tests/fuzz/fuzz_input.h"

#include <nlohmann/json.hpp>

using namespace hairpaint;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    constexpr bool kThrows = false;
    const nlohmann::json gltf = nlohmann::json::parse(data, data + size, nullptr, kThrows);
    for (const auto& [node, bone] : importer::vrmBones(gltf))
        fuzz::require(node >= 0 && !bone.empty());
    return 0;
}
