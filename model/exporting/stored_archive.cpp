// Heads are written twice: first as room for the numbers that are known at the end.
#include "model/exporting/stored_archive.h"

#include "model/exporting/piece_writer.h"

#include <QtEndian>

namespace hairpaint::model {

namespace {

constexpr qsizetype kLocalHeaderBytes = 30;
constexpr qsizetype kAlignment = 64;
constexpr qsizetype kExtraHeadBytes = 4;
constexpr quint16 kPaddingId = 0x1986; ///< That pxr's own archives use.

/// An extra field that moves the bytes to a multiple of 64.
QByteArray paddingAfter(qint64 at, const QByteArray& name)
{
    const qint64 before = at + kLocalHeaderBytes + name.size() + kExtraHeadBytes;
    const qint64 zeros = (kAlignment - before % kAlignment) % kAlignment;
    QByteArray padding(kExtraHeadBytes + zeros, '\0');
    qToLittleEndian(kPaddingId, padding.data());
    qToLittleEndian(static_cast<quint16>(zeros), padding.data() + 2);
    return padding;
}

} // namespace

void StoredArchive::begin(const QByteArray& name)
{
    ZipRecord& record = m_records.emplace_back();
    record.name = name;
    record.padding = paddingAfter(m_end, name);
    m_sizes.push_back(0);
    m_at.push_back(m_end);
    const QByteArray header = localHeader(record);
    m_file.write(header);
    m_end += header.size();
}

void StoredArchive::write(std::string_view bytes)
{
    const QByteArrayView view(bytes.data(), static_cast<qsizetype>(bytes.size()));
    m_file.write(view);
    m_end += view.size();
    m_sizes.back() += view.size();
    m_records.back().checksum = checksumOf(view, m_records.back().checksum);
}

Checked<void> StoredArchive::finish()
{
    constexpr qint64 kDirectoryBytes = 1024; // More than an entry and the end take.
    if (m_end + kDirectoryBytes * static_cast<qint64>(m_records.size()) > kMostZipBytes)
        return tooManyPoints();
    QByteArray directory;
    for (std::size_t i = 0; i < m_records.size(); ++i) {
        ZipRecord& record = m_records[i];
        record.bytes = record.packedBytes = static_cast<quint32>(m_sizes[i]);
        record.at = static_cast<quint32>(m_at[i]);
        m_file.rewrite(m_at[i], localHeader(record));
        directory += directoryHeader(record);
    }
    m_file.write(directory + endOfDirectory(static_cast<int>(m_records.size()), directory.size(), m_end));
    return {};
}

} // namespace hairpaint::model
