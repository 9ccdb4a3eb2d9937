// PKWARE's APPNOTE, sections 4.3.7 (local header), 4.3.12 (directory) and 4.3.16 (end).
#include "model/exporting/stored_entry.h"

#include "model/exporting/piece_writer.h"

#include <QtEndian>

#include <zlib.h>

#include <algorithm>
#include <limits>

namespace hairpaint::model {

namespace {

constexpr std::size_t kLocalHeaderBytes = 30;
constexpr std::size_t kAlignment = 64;
constexpr std::size_t kExtraHeadBytes = 4;
constexpr quint16 kPaddingId = 0x1986; ///< That pxr's own archives use.
constexpr quint16 kVersion = 10;
constexpr quint16 kDate1980 = (1U << 5U) | 1U;

template<typename Number>
void append(std::string& out, Number value)
{
    const Number little = qToLittleEndian(value);
    out.append(reinterpret_cast<const char*>(&little), sizeof(little));
}

QByteArrayView viewOf(std::string_view text)
{
    return {text.data(), static_cast<qsizetype>(text.size())};
}

} // namespace

StoredEntry::StoredEntry(AtomicFile& file, std::string name) : m_file(file), m_name(std::move(name))
{
    const std::size_t before = kLocalHeaderBytes + m_name.size() + kExtraHeadBytes;
    const std::size_t zeros = (kAlignment - before % kAlignment) % kAlignment;
    append(m_padding, kPaddingId);
    append(m_padding, static_cast<quint16>(zeros));
    m_padding.append(zeros, '\0');
    // The place of the head, whose numbers are known at the end.
    m_file.write(viewOf(std::string(kLocalHeaderBytes, '\0') + m_name + m_padding));
}

void StoredEntry::write(std::string_view bytes)
{
    m_file.write(viewOf(bytes));
    m_size += bytes.size();
    while (!bytes.empty()) {
        const std::size_t some = std::min<std::size_t>(bytes.size(), 1U << 30U);
        m_checksum = static_cast<quint32>(
            ::crc32(m_checksum, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(some)));
        bytes.remove_prefix(some);
    }
}

std::string StoredEntry::commonFields() const
{
    std::string fields;
    append(fields, kVersion);
    append(fields, quint16{0}); // No flags.
    append(fields, quint16{0}); // Stored.
    append(fields, quint16{0}); // Midnight.
    append(fields, kDate1980);
    append(fields, m_checksum);
    append(fields, static_cast<quint32>(m_size));
    append(fields, static_cast<quint32>(m_size));
    append(fields, static_cast<quint16>(m_name.size()));
    return fields;
}

Checked<void> StoredEntry::finish()
{
    const std::size_t head = kLocalHeaderBytes + m_name.size() + m_padding.size();
    constexpr std::size_t kDirectoryBytes = 1024; // More than one entry and the end take.
    if (m_size + head + kDirectoryBytes > std::numeric_limits<quint32>::max())
        return tooManyPoints();
    std::string local = "PK\x03\x04";
    local += commonFields();
    append(local, static_cast<quint16>(m_padding.size()));
    m_file.rewrite(0, viewOf(local));

    std::string directory = "PK\x01\x02";
    append(directory, kVersion);
    directory += commonFields();
    append(directory, quint16{0}); // No extra field here,
    append(directory, quint16{0}); // no remark,
    append(directory, quint16{0}); // on the first disk,
    append(directory, quint16{0}); // and with attributes
    append(directory, quint32{0}); // of no system.
    append(directory, quint32{0}); // The entry stands at the beginning.
    directory += m_name;
    std::string end("PK\x05\x06", 4);
    append(end, quint32{0}); // One disk.
    append(end, quint16{1});
    append(end, quint16{1});
    append(end, static_cast<quint32>(directory.size()));
    append(end, static_cast<quint32>(head + m_size));
    append(end, quint16{0});
    m_file.write(viewOf(directory + end));
    return {};
}

} // namespace hairpaint::model
