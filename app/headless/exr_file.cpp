// OpenEXR writes into memory, so that the file is written as every other is.
#include "app/headless/exr_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>

#include <algorithm>
#include <array>
#include <utility>

namespace hairpaint::app {
namespace {

class ByteStream final : public Imf::OStream
{
public:
    ByteStream() : Imf::OStream("") {}

    void write(const char bytes[], int count) override
    {
        const qsizetype over = std::min<qsizetype>(count, m_bytes.size() - m_at);
        std::copy_n(bytes, over, m_bytes.data() + m_at);
        m_bytes.append(bytes + over, count - over);
        m_at += count;
    }
    std::uint64_t tellp() override { return static_cast<std::uint64_t>(m_at); }
    void seekp(std::uint64_t at) override { m_at = static_cast<qsizetype>(at); } // Always back into what is written.

    [[nodiscard]] QByteArray take() { return std::move(m_bytes); }

private:
    QByteArray m_bytes;
    qsizetype m_at = 0;
};

} // namespace

QByteArray exrBytes(std::span<const float> rgba, QSize size)
{
    constexpr std::array kNames{"R", "G", "B", "A"};
    constexpr std::size_t kPixelBytes = kNames.size() * sizeof(float);
    Imf::Header header(size.width(), size.height());
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer pixels;
    for (std::size_t c = 0; c < kNames.size(); ++c) {
        header.channels().insert(kNames[c], Imf::Channel(Imf::FLOAT));
        // OpenEXR's slices are of what is read as well as of what is written.
        char* const first = const_cast<char*>(reinterpret_cast<const char*>(rgba.data() + c));
        pixels.insert(kNames[c],
                      Imf::Slice(Imf::FLOAT, first, kPixelBytes, kPixelBytes * static_cast<std::size_t>(size.width())));
    }
    ByteStream stream;
    {
        Imf::OutputFile file(stream, header, 0);
        file.setFrameBuffer(pixels);
        file.writePixels(size.height());
    }
    return stream.take();
}

} // namespace hairpaint::app
