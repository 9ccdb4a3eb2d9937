// A helper that misbehaves as the variable HAIRPAINT_FAKE_HELPER says.
#include "model/files/wire_format.h"
#include "tests/support/test_heads.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string>

#ifdef _WIN32
#include <csignal>
#include <fcntl.h>
#include <io.h>
#endif

using namespace hairpaint;

namespace {

void send(const wire::Bytes& bytes)
{
    std::fwrite(bytes.data(), 1, bytes.size(), stdout);
    std::fflush(stdout);
}

void tellServed()
{
    std::fwrite(wire::kServed.data(), 1, wire::kServed.size(), stderr);
}

[[noreturn]] void sleepForEver()
{
    const std::atomic<bool> isOver = false;
    for (;;)
        isOver.wait(false);
}

[[noreturn]] void workForEver()
{
    for (std::atomic<unsigned> count = 0;; ++count) {
    }
}

[[noreturn]] void writeForEver()
{
    const wire::Bytes zeros(1U << 16U);
    for (;;)
        std::fwrite(zeros.data(), 1, zeros.size(), stdout);
}

[[noreturn]] void allocateForEver()
{
    for (;;) {
        constexpr std::size_t kPiece = 64U << 20U;
        void* piece = std::malloc(kPiece); // kept on purpose
        if (piece == nullptr)
            std::abort();
        std::memset(piece, 1, kPiece);
    }
}

wire::Bytes goodImage()
{
    return wire::encodeImage({.width = 2, .height = 1, .channels = 1, .samples = {1, 65535}});
}

wire::Bytes headerClaiming(wire::Kind kind, std::uint64_t length)
{
    wire::Bytes bytes = goodImage();
    std::memcpy(bytes.data() + 8, &kind, sizeof(kind));
    std::memcpy(bytes.data() + 12, &length, sizeof(length));
    return bytes;
}

wire::Bytes meshSpoilt(bool wrongIndex)
{
    sim::HeadMesh mesh = test::makeBallHead(6);
    if (wrongIndex)
        mesh.triangles[0].x = 1U << 30U;
    else
        mesh.positionsHd[0].x = std::numeric_limits<float>::quiet_NaN();
    return wire::encodeMesh(mesh);
}

wire::Bytes received(std::size_t count)
{
    wire::Bytes bytes(count);
    bytes.resize(std::fread(bytes.data(), 1, count, stdin));
    return bytes;
}

/// What it is asked to encode, as it stands.
wire::Bytes unencoded()
{
    const auto header = wire::decodeHeader(received(wire::kHeaderBytes));
    const auto request = header ? wire::decodeRequest(received(header->bodyBytes)) : std::nullopt;
    return request ? wire::encodeFile(std::as_bytes(std::span(request->image.samples))) : wire::Bytes();
}

/// As the one that behaves: bytes as they are, and no box that asks what is to be done.
void behaveOnWindows()
{
#ifdef _WIN32
    for (const int stream : {0, 1, 2})
        (void)_setmode(stream, _O_BINARY);
    (void)std::signal(SIGABRT, [](int) { std::_Exit(3); });
#endif
}

} // namespace

int main()
{
    behaveOnWindows();
    const char* variable = std::getenv("HAIRPAINT_FAKE_HELPER");
    const std::string mode = variable == nullptr ? "" : variable;
    std::fputs("a decoder's own complaint\n", stderr);
    if (mode == "abort")
        std::abort();
    if (mode == "silent")
        return 0;
    if (mode == "exit 3")
        return 3;
    if (mode == "hang")
        sleepForEver();
    if (mode == "spin")
        workForEver();
    if (mode == "allocate")
        allocateForEver();
    if (mode == "garbage")
        send(wire::Bytes(5000, std::byte{0x5A}));
    if (mode == "endless garbage")
        writeForEver();
    if (mode == "half a header")
        send(wire::Bytes(goodImage().begin(), goodImage().begin() + 1));
    if (mode == "huge length")
        send(headerClaiming(wire::Kind::Image, ~0ULL));
    if (mode == "long body never sent")
        send(headerClaiming(wire::Kind::Image, 400'000'000));
    if (mode == "long body never sent, then hang") {
        send(headerClaiming(wire::Kind::Image, 400'000'000));
        sleepForEver();
    }
    if (mode == "endless body") {
        send(headerClaiming(wire::Kind::Refusal, 4));
        writeForEver();
    }
    if (mode == "bytes after the end") {
        send(goodImage());
        send(goodImage());
    }
    if (mode == "a request for an answer")
        send(wire::encodeText(wire::Kind::ReadImage, "/etc/passwd"));
    if (mode == "unknown refusal")
        send(wire::encodeRefusal(static_cast<wire::Reason>(99)));
    if (mode == "another answer")
        send(wire::encodeFile(goodImage()));
    if (mode == "image of wrong size")
        send(wire::encodeImage({.width = 200, .height = 100, .channels = 3, .samples = {1, 2, 3}}));
    if (mode == "mesh with a wrong index")
        send(meshSpoilt(true));
    if (mode == "mesh with NaN")
        send(meshSpoilt(false));
    if (mode == "good, then abort") {
        send(goodImage());
        std::abort();
    }
    if (mode == "two answers, then served") {
        send(goodImage());
        send(goodImage());
        tellServed();
        sleepForEver();
    }
    if (mode == "one served, then abort") {
        (void)unencoded();
        send(wire::encodeFile(goodImage()));
        tellServed();
        (void)unencoded();
        std::abort();
    }
    if (mode == "good, then hang") {
        send(goodImage());
        sleepForEver();
    }
    if (mode == "good")
        send(goodImage());
    if (mode == "unencoded")
        send(unencoded());
    return 0;
}
