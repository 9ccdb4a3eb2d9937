// hairpaint-import: decodes and encodes foreign images and meshes for Hair Paint, one request a run, over standard
// input and output (see "Wire format" in model/files/hairpaint_format.md). Exit code 0 where an answer was written.
#include "app/importer/image_io.h"
#include "app/importer/mesh_import.h"
#include "app/importer/resource_limits.h"

#include <cstdio>
#include <exception>
#include <new>

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#endif

namespace {

using namespace hairpaint;

void makeStreamsBinary()
{
#ifdef _WIN32
    _setmode(_fileno(stdin), _O_BINARY);
    _setmode(_fileno(stdout), _O_BINARY);
#endif
}

struct Request
{
    wire::Kind kind = wire::Kind::Refusal;
    wire::Bytes body;
};

std::optional<Request> receive()
{
    wire::Bytes start(wire::kHeaderBytes);
    if (std::fread(start.data(), 1, start.size(), stdin) != start.size())
        return std::nullopt;
    const std::optional<wire::Header> header = wire::decodeHeader(start);
    if (!header || header->kind >= wire::Kind::Image)
        return std::nullopt;
    Request request{.kind = header->kind, .body = wire::Bytes(static_cast<std::size_t>(header->bodyBytes))};
    if (std::fread(request.body.data(), 1, request.body.size(), stdin) != request.body.size())
        return std::nullopt;
    return request;
}

std::optional<wire::Bytes> answerTo(Request request)
{
    if (request.kind == wire::Kind::EncodeImage) {
        const std::optional<wire::EncodeRequest> encode = wire::decodeRequest(request.body);
        if (!encode)
            return std::nullopt;
        request.body = {};
        const auto file = importer::encodeImage(*encode);
        return file ? *file : wire::encodeRefusal(file.error());
    }
    const std::optional<std::string> path = wire::decodePath(request.body);
    if (!path)
        return std::nullopt;
    if (request.kind == wire::Kind::ReadImage) {
        const auto image = importer::readImage(*path);
        return image ? wire::encodeImage(*image) : wire::encodeRefusal(image.error());
    }
    const auto mesh = importer::readMesh(*path);
    return mesh ? wire::encodeMesh(*mesh) : wire::encodeRefusal(mesh.error());
}

bool send(const wire::Bytes& message)
{
    return std::fwrite(message.data(), 1, message.size(), stdout) == message.size() && std::fflush(stdout) == 0;
}

int run()
{
    try {
        std::optional<Request> request = receive();
        if (!request)
            return 2;
        const std::optional<wire::Bytes> answer = answerTo(std::move(*request));
        return answer && send(*answer) ? 0 : 2;
    } catch (const std::bad_alloc&) {
        return send(wire::encodeRefusal(wire::Reason::OutOfMemory)) ? 0 : 2;
    } catch (const std::exception&) {
        return send(wire::encodeRefusal(wire::Reason::Damaged)) ? 0 : 2;
    }
}

} // namespace

int main()
{
    importer::limitResources();
    makeStreamsBinary();
    const int code = run();
    // Decoders' own clean-up at exit has nothing left to say.
    std::_Exit(code);
}
