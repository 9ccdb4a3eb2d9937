// Where folders can't be held by descriptors: by path, each name looked at just before it is used.
#include "model/disk/own_folder.h"

#ifndef Q_OS_UNIX

#include "model/disk/atomic_file.h"
#include "model/values/sentences.h"

#include <QDir>
#include <QFileInfo>

#include <filesystem>
#include <system_error>
#include <utility>

#ifdef Q_OS_WIN
#include <windows.h>
#endif

namespace hairpaint::model {

namespace {

bool isLink(const QFileInfo& info)
{
    return info.isSymbolicLink() || info.isJunction() || info.isShortcut();
}

bool isOrdinaryFile(const QFileInfo& info)
{
    return !isLink(info) && info.isFile();
}

bool hasOtherNames(const QFileInfo& info)
{
#ifdef Q_OS_WIN
    // GCC's library does not count them there.
    constexpr DWORD kShared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
    HANDLE const handle = CreateFileW(info.filesystemFilePath().c_str(), FILE_READ_ATTRIBUTES, kShared, nullptr,
                                      OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
    if (handle == INVALID_HANDLE_VALUE)
        return false;
    BY_HANDLE_FILE_INFORMATION told{};
    const bool isTold = GetFileInformationByHandle(handle, &told) != FALSE;
    CloseHandle(handle);
    return isTold && told.nNumberOfLinks > 1;
#else
    std::error_code problem;
    const auto names = std::filesystem::hard_link_count(info.filesystemFilePath(), problem);
    return !problem && names > 1;
#endif
}

} // namespace

OwnFolder::OwnFolder(QString path, int descriptor) : m_path(std::move(path)), m_descriptor(descriptor) {}
OwnFolder::OwnFolder(OwnFolder&& other) noexcept = default;
OwnFolder& OwnFolder::operator=(OwnFolder&& other) noexcept = default;
OwnFolder::~OwnFolder() = default;

std::optional<OwnFolder> OwnFolder::open(const QString& path)
{
    if (!QFileInfo(path).isDir())
        return std::nullopt;
    return OwnFolder(path, -1);
}

std::optional<OwnFolder> OwnFolder::child(const QString& name) const
{
    const QFileInfo info(pathOf(name));
    if (isLink(info) || !info.isDir())
        return std::nullopt;
    return OwnFolder(pathOf(name), -1);
}

bool OwnFolder::isAtPath() const
{
    return QFileInfo(m_path).isDir();
}

QStringList OwnFolder::names() const
{
    return QDir(m_path).entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
}

std::optional<OwnEntry> OwnFolder::entry(const QString& name) const
{
    const QFileInfo info(pathOf(name));
    if (!info.exists() && !isLink(info))
        return std::nullopt;
    return OwnEntry{.kind = isLink(info)    ? OwnEntry::Kind::Other
                            : info.isFile() ? OwnEntry::Kind::File
                            : info.isDir()  ? OwnEntry::Kind::Folder
                                            : OwnEntry::Kind::Other,
                    .size = info.size(),
                    .modifiedMs = info.lastModified().toMSecsSinceEpoch(),
                    .hasOtherNames = model::hasOtherNames(info)};
}

bool OwnFolder::isNamed(const QFile& /*file*/, const QString& name) const
{
    return isOrdinaryFile(QFileInfo(pathOf(name))); // A file that is open keeps its name there.
}

bool OwnFolder::openToRead(QFile& file, const QString& name) const
{
    file.setFileName(pathOf(name));
    m_problem.clear();
    const bool isOrdinary = isOrdinaryFile(QFileInfo(pathOf(name)));
    if (isOrdinary && file.open(QIODevice::ReadOnly))
        return true;
    m_problem = isOrdinary ? readRefusal(file.errorString())
                           : say(QT_TRANSLATE_NOOP("Files", "it is not an ordinary file; choose another"));
    return false;
}

bool OwnFolder::openNew(QFile& file, const QString& name) const
{
    file.setFileName(pathOf(name));
    m_problem.clear();
    constexpr QIODevice::OpenMode kNew = QIODevice::WriteOnly | QIODevice::NewOnly | QIODevice::Unbuffered;
    if (file.open(kNew) || (remove(name) && file.open(kNew)))
        return true;
    m_problem = writeRefusal(file.errorString());
    return false;
}

bool OwnFolder::makeFolder(const QString& name) const
{
    return QDir(m_path).mkdir(name);
}

bool OwnFolder::rename(const QString& from, const QString& to) const
{
    return replaceFile(pathOf(from), pathOf(to));
}

bool OwnFolder::remove(const QString& name) const
{
    return QFile::remove(pathOf(name));
}

bool OwnFolder::removeFolder(const QString& name) const
{
    return !isLink(QFileInfo(pathOf(name))) && QDir(m_path).rmdir(name);
}

void OwnFolder::flush() const {}

bool OwnFolder::isHeld(const QString& /*name*/) const
{
    return false; // There the system itself keeps a file that is open.
}

std::optional<QByteArray> contentOfOrdinaryFile(const QString& path, qint64 mostBytes)
{
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly))
        return std::nullopt;
    const QByteArray bytes = file.read(mostBytes + 1);
    return bytes.size() > mostBytes ? std::nullopt : std::optional(bytes);
}

} // namespace hairpaint::model

#endif
