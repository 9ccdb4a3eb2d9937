// A glTF as a whole, binary or text, as the helper reads it; the buffers beside it are made up, too.
#include "app/importer/gltf_scene.h"
#include "app/importer/scene_flattener.h"
#include "tests/fuzz/fuzz_input.h"

using namespace hairpaint;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    constexpr std::size_t kBuffer = 512;
    const auto* bytes = reinterpret_cast<const std::byte*>(data);
    const auto file = importer::parsedGltf({bytes, bytes + size});
    if (!file)
        return 0;
    const auto scene = importer::gltfScene(
        *file, [&](const std::string&) { return importer::BufferBytes(bytes, bytes + std::min(size, kBuffer)); });
    if (!scene)
        return 0;
    const auto mesh = importer::flattened(*scene);
    if (!mesh)
        return 0;
    const wire::Bytes message = wire::encodeMesh(*mesh);
    fuzz::require(wire::decodeMesh(std::span(message).subspan(wire::kHeaderBytes)).has_value());
    return 0;
}
