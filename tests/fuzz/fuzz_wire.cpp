// The wire format: what decodes keeps to its limits and encodes to the very same bytes.
#include "model/files/wire_format.h"
#include "tests/fuzz/fuzz_input.h"

#include <span>

using namespace hairpaint;

namespace {

bool sameBody(std::span<const std::byte> body, const wire::Bytes& message)
{
    return std::ranges::equal(body, std::span(message).subspan(wire::kHeaderBytes));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::span bytes(reinterpret_cast<const std::byte*>(data), size);
    (void)wire::decodeHeader(bytes.first(std::min(size, wire::kHeaderBytes)));
    if (size < 1)
        return 0;
    const std::span<const std::byte> body = bytes.subspan(1);
    switch (data[0] % 6) {
    case 0:
        if (const std::optional<std::string> path = wire::decodePath(body))
            fuzz::require(sameBody(body, wire::encodeText(wire::Kind::ReadImage, *path)));
        break;
    case 1:
        if (const std::optional<wire::Image> image = wire::decodeImage(body))
            fuzz::require(wire::imageFits(image->width, image->height, image->channels) &&
                          sameBody(body, wire::encodeImage(*image)));
        break;
    case 2:
        if (const std::optional<wire::EncodeRequest> request = wire::decodeRequest(body))
            fuzz::require(sameBody(body, wire::encodeRequest(*request)));
        break;
    case 3:
        if (const std::optional<model::RiggedMesh> mesh = wire::decodeMesh(body))
            fuzz::require(sameBody(body, wire::encodeMesh(*mesh)));
        break;
    case 5:
        if (const std::optional<wire::Sandbox> sandbox = wire::decodeSandbox(body))
            fuzz::require(sameBody(body, wire::encodeSandbox(*sandbox)));
        break;
    default:
        if (const std::optional<wire::Refusal> refusal = wire::decodeRefusal(body))
            fuzz::require(sameBody(body, wire::encodeRefusal(*refusal)));
    }
    return 0;
}
