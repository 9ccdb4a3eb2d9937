// One entry: its head, its bytes, and a directory of one.
#include "model/exporting/stored_entry.h"

#include "model/exporting/piece_writer.h"

#include <QtEndian>

namespace hairpaint::model {

namespace {

constexpr qsizetype kLocalHeaderBytes = 30;
constexpr qsizetype kAlignment = 64;
constexpr qsizetype kExtraHeadBytes = 4;
constexpr quint16 kPaddingId = 0x1986; ///< That pxr's own archives use.

/// An extra field that moves the bytes to a multiple of 64.
QByteArray paddingAfter(const QByteArray& name)
{
    const qsizetype before = kLocalHeaderBytes + name.size() + kExtraHeadBytes;
    const qsizetype zeros = (kAlignment - before % kAlignment) % kAlignment;
    QByteArray padding(kExtraHeadBytes + zeros, '\0');
    qToLittleEndian(kPaddingId, padding.data());
    qToLittleEndian(static_cast<quint16>(zeros), padding.data() + 2);
    return padding;
}

} // namespace

StoredEntry::StoredEntry(AtomicFile& file, const QByteArray& name) : m_file(file)
{
    m_record.name = name;
    m_record.padding = paddingAfter(name);
    m_file.write(localHeader(m_record)); // Room for it: its numbers are known at the end.
}

void StoredEntry::write(std::string_view bytes)
{
    const QByteArrayView view(bytes.data(), static_cast<qsizetype>(bytes.size()));
    m_file.write(view);
    m_bytes += view.size();
    m_record.checksum = checksumOf(view, m_record.checksum);
}

Checked<void> StoredEntry::finish()
{
    const QByteArray header = localHeader(m_record);
    constexpr qint64 kDirectoryBytes = 1024; // More than one entry and the end take.
    if (m_bytes + header.size() + kDirectoryBytes > kMostZipBytes)
        return tooManyPoints();
    m_record.bytes = m_record.packedBytes = static_cast<quint32>(m_bytes);
    m_file.rewrite(0, localHeader(m_record));
    const QByteArray directory = directoryHeader(m_record);
    m_file.write(directory + endOfDirectory(1, directory.size(), header.size() + m_bytes));
    return {};
}

} // namespace hairpaint::model
