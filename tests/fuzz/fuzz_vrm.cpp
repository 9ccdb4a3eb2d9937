// The JSON of a glTF, which may name the bones of a body.
#include "app/importer/vrm_bones.h"
#include "tests/fuzz/fuzz_input.h"

using namespace hairpaint;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string json(reinterpret_cast<const char*>(data), size);
    for (const auto& [node, bone] : importer::bonesInJson(json))
        fuzz::require(!node.empty() && json.size() >= node.size() + bone.size());
    return 0;
}
