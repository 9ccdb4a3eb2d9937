// Inflates an image of our own band by band: each chunk of its pixels is a piece of the stream that refers to no other,
// and a piece at once takes less time than a stream.
#pragma once

#include <QByteArray>
#include <QByteArrayView>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

struct libdeflate_decompressor;

namespace hairpaint::model {

/// Takes the next chunk off `chunks` (length, type, content, checksum); its content where it is of pixels, cut off
/// where they are. None where there is no more chunk.
[[nodiscard]] std::optional<QByteArrayView> takePixelChunk(QByteArrayView& chunks);

/// Holds one band. Throws std::bad_alloc.
class PngBands
{
public:
    /// What `chunks` shows must outlive this.
    PngBands(QByteArrayView chunks, std::size_t rowBytes);
    ~PngBands();
    PngBands(const PngBands&) = delete;
    PngBands& operator=(const PngBands&) = delete;

    /// The next band: whole rows, each with its filter's number before it; may be changed by the caller, valid until
    /// the next call. Empty after the last one, and where what follows is no such band: then the image must be read as
    /// a stream.
    [[nodiscard]] std::span<std::uint8_t> next();
    /// Whether the last band was taken and all of them had the stream's checksum.
    [[nodiscard]] bool atEnd() const { return m_atEnd; }

private:
    std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> m_decompressor;
    QByteArrayView m_chunks;
    std::size_t m_rowBytes; ///< With the filter's number.
    std::vector<std::uint8_t> m_rows;
    QByteArray m_packed;
    std::uint32_t m_checksum = 1; ///< Adler-32 so far.
    bool m_begun = false;
    bool m_atEnd = false;
};

} // namespace hairpaint::model
