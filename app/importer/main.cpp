// hairpaint-import: decodes and encodes foreign images and meshes for Hair Paint, over standard input and output (see
// "Wire format" in model/files/hairpaint_format.md). Exit code 0 where each request was answered.
#include "app/importer/image_io.h"
#include "app/importer/mesh_import.h"
#include "app/importer/request_service.h"
#include "app/importer/resource_limits.h"
#include "app/importer/sandbox.h"

#include <cstdio>
#include <exception>
#include <new>
#include <string>

#ifdef _WIN32
#include <windows.h>

#include <csignal>
#include <fcntl.h>
#include <io.h>
#else
#include <unistd.h>
#endif

namespace {

using namespace hairpaint;

/// Where answers go: what was standard output. What decoders print there goes where their errors go, and can't get
/// between.
std::FILE* takeWire()
{
#ifdef _WIN32
    const int wire = _dup(_fileno(stdout));
    _dup2(_fileno(stderr), _fileno(stdout));
    _setmode(_fileno(stdin), _O_BINARY);
    _setmode(wire, _O_BINARY);
    return _fdopen(wire, "wb");
#else
    const int wire = dup(STDOUT_FILENO);
    dup2(STDERR_FILENO, STDOUT_FILENO);
    return fdopen(wire, "wb");
#endif
}

/// A decoder that crashes ends the helper; no box asks a person about it.
void crashQuietly()
{
#ifdef _WIN32
    SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX | SEM_NOOPENFILEERRORBOX);
    // abort() of msvcrt.dll opens one, and has no switch for that.
    (void)std::signal(SIGABRT, [](int) { TerminateProcess(GetCurrentProcess(), 3); });
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

wire::Sandbox sandboxFor(const std::string& file)
{
    const importer::Confinement layers = importer::enterSandbox(file);
    return {.landlockVersion = static_cast<std::uint32_t>(layers.landlockVersion),
            .filtersCalls = layers.filtersCalls ? 1U : 0U,
            .mostMegabytes = importer::mostMegabytes()};
}

std::optional<wire::Bytes> answerTo(Request request)
{
    const bool isColour = request.kind == wire::Kind::ReadColours || request.kind == wire::Kind::EncodeColours;
    if (request.kind == wire::Kind::EncodeImage || request.kind == wire::Kind::EncodeColours) {
        const std::optional<wire::EncodeRequest> encode = wire::decodeRequest(request.body);
        if (!encode)
            return std::nullopt;
        request.body = {};
        (void)importer::enterSandbox({});
        const auto file = importer::encodeImageFile(*encode, isColour);
        return file ? *file : wire::encodeRefusal(file.error());
    }
    const std::optional<std::string> path = wire::decodePath(request.body);
    if (!path)
        return std::nullopt;
    if (request.kind == wire::Kind::TellSandbox)
        return wire::encodeSandbox(sandboxFor(*path));
    (void)importer::enterSandbox(*path);
    if (request.kind == wire::Kind::ReadImage || request.kind == wire::Kind::ReadColours) {
        const auto image = importer::readImage(*path, isColour);
        return image ? wire::encodeImage(*image) : wire::encodeRefusal(image.error());
    }
    const auto mesh = importer::readMesh(*path, request.kind != wire::Kind::ReadBody);
    return mesh ? wire::encodeMesh(*mesh) : wire::encodeRefusal(mesh.error());
}

bool send(std::FILE* channel, const wire::Bytes& message)
{
    return channel != nullptr && std::fwrite(message.data(), 1, message.size(), channel) == message.size() &&
           std::fflush(channel) == 0;
}

int serve(std::FILE* channel)
{
    try {
        std::optional<Request> request = receive();
        if (!request)
            return 2;
        const std::optional<wire::Bytes> answer = answerTo(std::move(*request));
        return answer && send(channel, *answer) ? 0 : 2;
    } catch (const std::bad_alloc&) {
        return send(channel, wire::encodeRefusal(wire::Reason::OutOfMemory)) ? 0 : 2;
    } catch (const std::exception&) {
        return send(channel, wire::encodeRefusal(wire::Reason::Damaged)) ? 0 : 2;
    }
}

} // namespace

int main()
{
    crashQuietly();
    importer::closeInherited();
    importer::limitResources();
    std::FILE* const channel = takeWire();
    const int code = importer::serveEach([channel] { return serve(channel); });
    // Decoders' own clean-up at exit has nothing left to say.
    std::_Exit(code);
}
