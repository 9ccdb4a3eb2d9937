// What comes from foreign files, once they are decoded: meshes become ones that the wire carries, images become layers.
#include "app/importer/mesh_builder.h"
#include "model/files/image_map.h"
#include "model/files/wire_format.h"
#include "tests/fuzz/fuzz_input.h"

#include <span>

using namespace hairpaint;

namespace {

void buildMesh(fuzz::Input& input)
{
    importer::MeshBuilder builder;
    while (!input.atEnd()) {
        std::array<importer::Corner, 3> triangle;
        for (importer::Corner& corner : triangle) {
            // Any number, or the same few again, so that corners are shared.
            const bool isSmall = input.byte() % 4 != 0;
            const auto next = [&] {
                return isSmall ? static_cast<float>(input.number<std::int8_t>()) / 16.0F : input.number<float>();
            };
            corner.position = {next(), next(), next()};
            corner.normal = {next(), next(), next()};
            corner.uv = {next(), next()};
        }
        builder.add(triangle);
    }
    const sim::HeadMesh mesh = builder.take();
    if (!wire::meshFits(mesh))
        return; // Refused before it is sent.
    const wire::Bytes message = wire::encodeMesh(mesh);
    fuzz::require(wire::decodeMesh(std::span(message).subspan(wire::kHeaderBytes)).has_value());
}

void buildLayer(fuzz::Input& input)
{
    model::ForeignImage image{.width = 1 + input.byte() % 32,
                              .height = 1 + input.byte() % 32,
                              .channels = 1 + input.byte() % 4,
                              .pixels = {}};
    const model::MapSpec& spec = model::mapSpecs()[static_cast<std::size_t>(input.byte() % model::kMapKindCount)];
    const bool grey = input.byte() % 2 != 0;
    image.pixels.resize(static_cast<std::size_t>(image.width * image.height * image.channels));
    for (std::uint16_t& value : image.pixels)
        value = input.number<std::uint16_t>();
    const model::Result<sim::TiledRaster> layer = model::layerFromImage(image, spec, grey, 256);
    fuzz::require(!layer || (layer->size() == 256 && layer->channels() == spec.layerChannels()));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    if (input.byte() % 2 == 0)
        buildMesh(input);
    else
        buildLayer(input);
    return 0;
}
