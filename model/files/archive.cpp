// Checked reading and reproducible writing of ZIP archives.
#include "model/files/archive.h"

#include "model/disk/atomic_file.h"
#include "model/files/zip_records.h"

#include <QFile>

#include <zip.h>
#include <zlib.h>

#include <algorithm>
#include <new>

namespace hairpaint::model {

namespace {

constexpr qsizetype kEndRecordBytes = 22;
constexpr qint64 kMostTailBytes = 1024;     ///< More than a header and the end of the directory take.
constexpr quint64 kMostDeflateRatio = 1032; // one bit of deflate stands for at most 258 bytes, twice over a code of 2

tl::unexpected<Clause> brokenArchive()
{
    return refuse(say(QT_TRANSLATE_NOOP("Files", "its archive is cut short or broken")));
}

/// Want of memory, libzip's own or zlib's, is no damage.
bool lacksMemory(zip_error_t* error)
{
    constexpr int kZlibMemory = -4; // Z_MEM_ERROR
    return error != nullptr &&
           (zip_error_code_zip(error) == ZIP_ER_MEMORY ||
            (zip_error_code_zip(error) == ZIP_ER_ZLIB && zip_error_code_system(error) == kZlibMemory));
}

void throwIfMemoryLacks(zip_error_t* error)
{
    if (lacksMemory(error))
        throw std::bad_alloc();
}

struct ErrorHolder
{
    ErrorHolder() { zip_error_init(&error); }
    ~ErrorHolder() { zip_error_fini(&error); }
    ErrorHolder(const ErrorHolder&) = delete;
    ErrorHolder& operator=(const ErrorHolder&) = delete;
    zip_error_t error{};
};

/// What libzip's source callback reads from.
struct FileSource
{
    QFile file;
};

zip_int64_t readFile(void* user, void* data, zip_uint64_t length, zip_source_cmd_t command)
{
    auto& source = *static_cast<FileSource*>(user);
    switch (command) {
    case ZIP_SOURCE_OPEN:
        return source.file.seek(0) ? 0 : -1;
    case ZIP_SOURCE_READ:
        return source.file.read(static_cast<char*>(data),
                                static_cast<qint64>(std::min<zip_uint64_t>(length, 1U << 30U)));
    case ZIP_SOURCE_CLOSE:
    case ZIP_SOURCE_FREE:
        return 0;
    case ZIP_SOURCE_STAT: {
        auto* stat = static_cast<zip_stat_t*>(data);
        zip_stat_init(stat);
        stat->valid = ZIP_STAT_SIZE;
        stat->size = static_cast<zip_uint64_t>(source.file.size());
        return sizeof(*stat);
    }
    case ZIP_SOURCE_ERROR: {
        auto* codes = static_cast<int*>(data);
        codes[0] = ZIP_ER_READ;
        codes[1] = 0;
        return 2 * sizeof(int);
    }
    case ZIP_SOURCE_SEEK: {
        ErrorHolder error;
        const zip_int64_t offset =
            zip_source_seek_compute_offset(static_cast<zip_uint64_t>(source.file.pos()),
                                           static_cast<zip_uint64_t>(source.file.size()), data, length, &error.error);
        return offset >= 0 && source.file.seek(offset) ? 0 : -1;
    }
    case ZIP_SOURCE_TELL:
        return source.file.pos();
    case ZIP_SOURCE_SUPPORTS:
        return zip_source_make_command_bitmap(ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE, ZIP_SOURCE_STAT,
                                              ZIP_SOURCE_ERROR, ZIP_SOURCE_FREE, ZIP_SOURCE_SEEK, ZIP_SOURCE_TELL,
                                              ZIP_SOURCE_SUPPORTS, -1);
    default:
        return -1;
    }
}

/// libzip believes the entry count of ZIP64 records and allocates for it, so those never reach it.
Checked<void> checkTail(QFile& file)
{
    const qint64 tailBytes = std::min<qint64>(file.size(), 65'535 + 2 * kEndRecordBytes);
    if (tailBytes < kEndRecordBytes || !file.seek(file.size() - tailBytes))
        return brokenArchive();
    const QByteArray tail = file.read(tailBytes);
    if (tail.size() != tailBytes)
        return brokenArchive();
    const QByteArray endMark("PK\x05\x06", 4);
    const QByteArray zip64Mark("PK\x06\x07", 4);
    const QByteArray end = tail.last(kEndRecordBytes);
    if (!end.startsWith(endMark) || end[20] != 0 || end[21] != 0)
        return brokenArchive();
    for (qsizetype at = tail.indexOf(endMark); at >= 0; at = tail.indexOf(endMark, at + 1))
        if (at >= 20 && tail.sliced(at - 20, 4) == zip64Mark)
            return brokenArchive();
    return {};
}

bool acceptableName(const QString& name)
{
    if (name.isEmpty() || name.toUtf8().size() > 200 || name.startsWith(QLatin1Char('/')))
        return false;
    for (const QChar c : name)
        if (c == QLatin1Char('\\') || c == QLatin1Char(':') || c.category() == QChar::Other_Control ||
            c == QChar::ReplacementCharacter)
            return false;
    const QStringList segments = name.split(QLatin1Char('/'));
    return std::ranges::none_of(segments,
                                [](const QString& s) { return s == QLatin1String(".") || s == QLatin1String(".."); });
}

} // namespace

struct ArchiveReader::Handle
{
    Handle() = default;
    ~Handle()
    {
        if (zip != nullptr)
            zip_discard(zip);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    FileSource source;
    zip_t* zip = nullptr;
};

ArchiveReader::ArchiveReader() : m_handle(std::make_unique<Handle>()) {}
ArchiveReader::ArchiveReader(ArchiveReader&& other) noexcept = default;
ArchiveReader& ArchiveReader::operator=(ArchiveReader&& other) noexcept = default;
ArchiveReader::~ArchiveReader() = default;

Checked<ArchiveReader> ArchiveReader::open(const QString& path)
{
    ArchiveReader reader;
    QFile& file = reader.m_handle->source.file;
    file.setFileName(path);
    if (!file.open(QIODevice::ReadOnly))
        return refuse(readRefusal(file.errorString()), Clause::Cure::OtherFile);
    if (!file.peek(2).startsWith("PK"))
        return refuse(say(QT_TRANSLATE_NOOP("Files", "it is not a file of Hair Paint; choose another")),
                      Clause::Cure::OtherFile);
    if (Checked<void> tail = checkTail(file); !tail)
        return tl::unexpected(tail.error());

    ErrorHolder error;
    zip_source_t* source = zip_source_function_create(readFile, &reader.m_handle->source, &error.error);
    throwIfMemoryLacks(&error.error);
    if (source == nullptr)
        return brokenArchive();
    reader.m_handle->zip = zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error.error);
    if (reader.m_handle->zip == nullptr) {
        zip_source_free(source);
        throwIfMemoryLacks(&error.error);
        return brokenArchive();
    }
    if (Checked<void> directory = reader.readDirectory(); !directory)
        return tl::unexpected(directory.error());
    return reader;
}

Checked<void> ArchiveReader::readDirectory()
{
    const zip_int64_t count = zip_get_num_entries(m_handle->zip, 0);
    if (count < 0 || count > kMostArchiveEntries)
        return refuse(say(QT_TRANSLATE_NOOP("Files", "it holds more than %1 entries")).arg(kMostArchiveEntries));
    for (zip_uint64_t index = 0; index < static_cast<zip_uint64_t>(count); ++index) {
        zip_stat_t stat;
        constexpr zip_uint64_t kNeeded = ZIP_STAT_NAME | ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_CRC |
                                         ZIP_STAT_COMP_METHOD | ZIP_STAT_ENCRYPTION_METHOD;
        if (zip_stat_index(m_handle->zip, index, 0, &stat) != 0 || (stat.valid & kNeeded) != kNeeded)
            return brokenArchive();
        const QString name = QString::fromUtf8(stat.name);
        if (!acceptableName(name))
            return refuse(say(QT_TRANSLATE_NOOP("Files", "one of its entries has an unacceptable name")));
        if (m_entries.contains(name))
            return refuse(say(QT_TRANSLATE_NOOP("Files", "it holds two entries named '%1'")).arg(name));
        const bool stored = stat.comp_method == ZIP_CM_STORE;
        const quint64 plausible = stored ? stat.comp_size : stat.comp_size * kMostDeflateRatio + 64;
        if ((!stored && stat.comp_method != ZIP_CM_DEFLATE) || stat.encryption_method != ZIP_EM_NONE ||
            stat.comp_size > (1ULL << 32U) || stat.size > plausible)
            return refuse(say(QT_TRANSLATE_NOOP("Files", "its entry '%1' is packed in an unacceptable way")).arg(name));
        m_entries.emplace(name, ListedEntry{.index = index, .size = stat.size, .crc = stat.crc, .isStored = stored});
    }
    return {};
}

tl::unexpected<Clause> brokenEntry(const QString& name)
{
    return refuse(say(QT_TRANSLATE_NOOP("Files", "its entry '%1' is broken")).arg(name));
}

QStringList ArchiveReader::names() const
{
    std::map<quint64, QString> byOffset;
    for (const auto& [name, entry] : m_entries)
        byOffset.emplace(entry.index, name);
    QStringList names;
    for (const auto& [offset, name] : byOffset)
        names += name;
    return names;
}

Checked<QByteArray> ArchiveReader::read(const QString& name, qint64 mostBytes, Check check) const
{
    const auto entry = m_entries.find(name);
    if (entry == m_entries.end())
        return refuse(say(QT_TRANSLATE_NOOP("Files", "its entry '%1' is missing")).arg(name));
    const ListedEntry& found = entry->second;
    if (found.size > static_cast<quint64>(mostBytes))
        return refuse(say(QT_TRANSLATE_NOOP("Files", "its entry '%1' is too large")).arg(name));
    const auto broken = [&name] { return brokenEntry(name); };
    const bool isRaw = check == Check::ByCaller && found.isStored; // libzip compares what it unpacks.
    zip_file_t* file = zip_fopen_index(m_handle->zip, found.index, isRaw ? ZIP_FL_COMPRESSED : 0);
    if (file == nullptr) {
        throwIfMemoryLacks(zip_get_error(m_handle->zip));
        return broken();
    }
    QByteArray bytes(static_cast<qsizetype>(found.size), Qt::Uninitialized);
    quint64 done = 0;
    while (done < found.size) {
        const zip_int64_t got = zip_fread(file, bytes.data() + done, found.size - done);
        if (got <= 0)
            break;
        done += static_cast<quint64>(got);
    }
    // One more read runs into the end, where libzip compares the checksum.
    char more = 0;
    const bool ended = done == found.size && zip_fread(file, &more, 1) == 0;
    const bool isStarved = lacksMemory(zip_file_get_error(file));
    if (zip_fclose(file) != 0 || !ended) {
        if (isStarved)
            throw std::bad_alloc();
        return broken();
    }
    return bytes;
}

void ArchiveWriter::add(const QByteArray& name, const QByteArray& bytes, Method method, std::optional<quint32> checksum)
{
    m_entries.push_back({.name = name, .bytes = bytes, .method = method, .checksum = checksum});
}

namespace {

/// A deflate stream, as small as zlib makes it.
QByteArray deflated(const QByteArray& bytes)
{
    constexpr int kSmallest = 9;
    constexpr qsizetype kZlibHeader = 2;
    constexpr qsizetype kZlibEnd = 4;
    auto packedBytes = compressBound(static_cast<uLong>(bytes.size()));
    QByteArray packed(static_cast<qsizetype>(packedBytes), Qt::Uninitialized);
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &packedBytes,
                  reinterpret_cast<const Bytef*>(bytes.constData()), static_cast<uLong>(bytes.size()),
                  kSmallest) != Z_OK)
        throw std::bad_alloc(); // Nothing else can fail.
    return packed.sliced(kZlibHeader, static_cast<qsizetype>(packedBytes) - kZlibHeader - kZlibEnd);
}

} // namespace

Checked<bool> ArchiveWriter::writeTo(const QString& path, const std::function<bool()>& isWanted) const
{
    AtomicFile file(path);
    if (Checked<void> opened = file.open(); !opened)
        return tl::unexpected(opened.error());
    qint64 at = 0;
    QByteArray directory;
    for (const AddedEntry& entry : m_entries) {
        const bool isDeflated = entry.method == Method::Deflated;
        const QByteArray packed = isDeflated ? deflated(entry.bytes) : entry.bytes;
        const ZipRecord record{.name = entry.name,
                               .padding = {},
                               .isDeflated = isDeflated,
                               .checksum = entry.checksum ? *entry.checksum : checksumOf(entry.bytes),
                               .packedBytes = static_cast<quint32>(packed.size()),
                               .bytes = static_cast<quint32>(entry.bytes.size()),
                               .at = static_cast<quint32>(at)};
        const QByteArray header = localHeader(record);
        directory += directoryHeader(record);
        at += header.size() + packed.size();
        if (at + directory.size() + kMostTailBytes > kMostZipBytes)
            return refuse(say(QT_TRANSLATE_NOOP("Files", "it would be larger than 4 GB; use fewer layers or smaller "
                                                         "maps")));
        file.write(header);
        file.write(packed);
    }
    file.write(directory);
    file.write(endOfDirectory(static_cast<int>(m_entries.size()), directory.size(), at));
    if (Checked<void> flushed = file.flush(); !flushed)
        return tl::unexpected(flushed.error());
    if (isWanted && !isWanted())
        return false;
    if (Checked<void> written = file.commit(); !written)
        return tl::unexpected(written.error());
    return true;
}

} // namespace hairpaint::model
