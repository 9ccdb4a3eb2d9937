// Each band gets an end of its own, so that it is a deflate stream by itself.
#include "model/files/png_bands.h"

#include <QtEndian>

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <new>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr qsizetype kChunkStart = 8; // Length and type.
constexpr qsizetype kChunkEnd = 4;   // Checksum.
constexpr std::size_t kMostRows = 64;
constexpr qsizetype kZlibHeader = 2;
constexpr qsizetype kZlibChecksum = 4;
/// The last block, of no bytes.
constexpr std::array<char, 5> kEnd = {'\x01', '\0', '\0', '\xFF', '\xFF'};

/// RFC 1950, 2.2: deflate, no dictionary.
bool isZlibHeader(QByteArrayView stream)
{
    const auto first = static_cast<unsigned char>(stream[0]);
    const auto second = static_cast<unsigned char>(stream[1]);
    return (first & 0x0FU) == 8 && (second & 0x20U) == 0 && (first * 256U + second) % 31U == 0;
}

} // namespace

std::optional<QByteArrayView> takePixelChunk(QByteArrayView& chunks)
{
    while (chunks.size() >= kChunkStart) {
        const auto length = qFromBigEndian<quint32>(chunks.data());
        const bool isPixels = chunks.sliced(4, 4) == QByteArrayView("IDAT");
        const QByteArrayView content =
            chunks.sliced(kChunkStart, std::min<qsizetype>(length, chunks.size() - kChunkStart));
        chunks = chunks.sliced(std::min<qsizetype>(kChunkStart + qsizetype{length} + kChunkEnd, chunks.size()));
        if (isPixels && !content.isEmpty())
            return content;
    }
    return std::nullopt;
}

PngBands::PngBands(QByteArrayView chunks, std::size_t rowBytes)
    : m_decompressor(libdeflate_alloc_decompressor(), &libdeflate_free_decompressor), m_chunks(chunks),
      m_rowBytes(rowBytes + 1), m_rows(kMostRows * m_rowBytes)
{
    if (!m_decompressor)
        throw std::bad_alloc();
}

PngBands::~PngBands() = default;

std::span<std::uint8_t> PngBands::next()
{
    std::optional<QByteArrayView> content = takePixelChunk(m_chunks);
    if (!content || m_atEnd)
        return {};
    if (!std::exchange(m_begun, true)) {
        if (content->size() < kZlibHeader || !isZlibHeader(*content))
            return {};
        content = content->sliced(kZlibHeader);
    }
    QByteArrayView rest = m_chunks;
    const bool isLast = !takePixelChunk(rest);
    m_packed.resize(0);
    m_packed.append(*content);
    if (!isLast)
        m_packed.append(kEnd.data(), kEnd.size());
    std::size_t read = 0;
    std::size_t made = 0;
    if (libdeflate_deflate_decompress_ex(m_decompressor.get(), m_packed.constData(),
                                         static_cast<std::size_t>(m_packed.size()), m_rows.data(), m_rows.size(), &read,
                                         &made) != LIBDEFLATE_SUCCESS ||
        made == 0 || made % m_rowBytes != 0)
        return {};
    m_checksum = libdeflate_adler32(m_checksum, m_rows.data(), made);
    const qsizetype left = m_packed.size() - static_cast<qsizetype>(read);
    if (!isLast && left != 0)
        return {}; // It ended before.
    if (isLast) {
        const char* const checksum = m_packed.constData() + read;
        if (left < kZlibChecksum || qFromBigEndian<quint32>(checksum) != m_checksum)
            return {};
        m_atEnd = true;
    }
    return {m_rows.data(), made};
}

} // namespace hairpaint::model
