// The messages between the editor and hairpaint-import: see "Wire format" in model/files/hairpaint_format.md.
// Errors: every length is checked against a limit and against the body before anything is allocated; a message that
// breaks a rule decodes to nothing.
#pragma once

#include "model/heads/rigged_mesh.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hairpaint::wire {

using Bytes = std::vector<std::byte>;

enum class Kind : std::uint32_t
{
    ReadImage = 1,
    ReadMesh = 2,
    EncodeImage = 3,
    TellSandbox = 4,
    ReadColours = 20,   ///< As ReadImage, in sRGB.
    EncodeColours = 21, ///< As EncodeImage, of sRGB.
    ReadBody = 22,      ///< As ReadMesh, of what nobody paints on: uvs are not asked for.
    Image = 101,
    Mesh = 102,
    Encoded = 103,
    Sandbox = 104,
    Refusal = 199
};

enum class Reason : std::uint32_t
{
    CannotOpen = 1,
    UnknownFormat = 2,
    Damaged = 3,
    TooLarge = 4,
    NoTriangles = 5,
    NoUvs = 6,
    CannotWriteEnding = 7,
    OutOfMemory = 8,
    UnknownCompression = 9,
    MissingFile = 10,          ///< A file that the model refers to is missing;
    OutsideFolder = 11,        ///< or lies outside of the model's folder.
    UnknownExtension = 12,     ///< An extension that the model can't be read without is not known;
    UndecodedCompression = 13, ///< or the compression that it names can't be decoded.
    Malformed = 14,            ///< It breaks its format's rules, and how is told in English.
    LayersOnly = 30,           ///< The file has layers, but not the picture that they make together.
    InkColours = 31,           ///< Its colours are inks, in a format of which inks are not read.
    UnreadFormat = 32          ///< A format that is known, and not read.
};

/// Why there is no other answer.
struct Refusal
{
    Reason reason;
    /// UTF-8, as part of a sentence: the file that `reason` is about (without folders), the extension, the compression,
    /// how the rules are broken, or the format's name; empty for all other reasons.
    std::string detail;
    Refusal(Reason why, std::string told = {}) : reason(why), detail(std::move(told)) {}
    friend bool operator==(const Refusal&, const Refusal&) = default;
};

inline constexpr std::size_t kHeaderBytes = 20;
/// On the helper's standard error: the request is served, and nothing that served it is left.
inline constexpr std::string_view kServed = "HPSERVED";
inline constexpr std::uint64_t kLongestPath = 32'768;
inline constexpr std::uint64_t kLongestName = 1024;
inline constexpr std::uint32_t kLongestEnding = 16;
inline constexpr std::uint32_t kLargestSide = 32'768;
inline constexpr std::uint64_t kMostPixels = 1ULL << 26U;
inline constexpr std::uint64_t kMostEncodedBytes = 1ULL << 30U;

/// 16-bit samples, row 0 on top, unassociated; 1 to 4 channels.
struct Image
{
    std::uint32_t width = 0, height = 0, channels = 0;
    std::vector<std::uint16_t> samples;
};

/// What holds the helper while it decodes.
struct Sandbox
{
    std::uint32_t landlockVersion = 0; ///< Version of Landlock in use; 0: files are not restricted.
    std::uint32_t filtersCalls = 0;    ///< 0 or 1.
    std::uint32_t mostMegabytes = 0;   ///< Limit on memory, MB; 0: it has none of its own.
    friend bool operator==(const Sandbox&, const Sandbox&) = default;
};

struct Header
{
    Kind kind = Kind::Refusal;
    std::uint64_t bodyBytes = 0;
};

struct EncodeRequest
{
    std::uint32_t bits = 16;
    std::string ending;
    Image image;
};

/// The first kHeaderBytes of a message; none where magic, kind or length are not ours.
[[nodiscard]] std::optional<Header> decodeHeader(std::span<const std::byte> bytes);

/// Whole messages, header included.
[[nodiscard]] Bytes encodeText(Kind kind, const std::string& text);
[[nodiscard]] Bytes encodeImage(const Image& image);
[[nodiscard]] Bytes encodeRequest(const EncodeRequest& request, Kind kind = Kind::EncodeImage);
[[nodiscard]] Bytes encodeMesh(const model::RiggedMesh& mesh);
[[nodiscard]] Bytes encodeFile(std::span<const std::byte> file);
[[nodiscard]] Bytes encodeSandbox(const Sandbox& sandbox);
[[nodiscard]] Bytes encodeRefusal(const Refusal& refusal);

/// Bodies, without the header.
[[nodiscard]] std::optional<std::string> decodePath(std::span<const std::byte> body);
[[nodiscard]] std::optional<Image> decodeImage(std::span<const std::byte> body);
[[nodiscard]] std::optional<EncodeRequest> decodeRequest(std::span<const std::byte> body);
[[nodiscard]] std::optional<model::RiggedMesh> decodeMesh(std::span<const std::byte> body);
[[nodiscard]] std::optional<Sandbox> decodeSandbox(std::span<const std::byte> body);
[[nodiscard]] std::optional<Refusal> decodeRefusal(std::span<const std::byte> body);

[[nodiscard]] bool imageFits(std::uint64_t width, std::uint64_t height, std::uint64_t channels);

/// Whether a mesh keeps to the limits of a head's (sim/skin/head_limits.h), with uvs in 0..1 and unit normals.
[[nodiscard]] bool meshFits(const sim::HeadMesh& mesh);

} // namespace hairpaint::wire
