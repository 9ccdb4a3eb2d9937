// FlushFileBuffers, and MoveFileEx, which waits for the disk itself.
#include "model/disk/disk_sync.h"

#ifdef Q_OS_WIN

#include "model/disk/atomic_file.h"
#include "model/disk/windows_names.h"

#include <QDir>
#include <QFileInfo>
#include <QThread>

#include <windows.h>

#include <string>

namespace hairpaint::model {

namespace {

/// As the system's own calls take it, long ones too.
std::wstring nativePath(const QString& path)
{
    return windowsPath(QDir::toNativeSeparators(QDir::cleanPath(QFileInfo(path).absoluteFilePath()))).toStdWString();
}

/// Virus scanners and search look into what has just been written.
bool isPassing(DWORD error)
{
    return error == ERROR_SHARING_VIOLATION || error == ERROR_ACCESS_DENIED || error == ERROR_LOCK_VIOLATION;
}

/// Does it, once more for half a second while the file is in use and its attributes do not forbid it. The system's
/// error is kept for whoever asks why.
template<class Change>
bool doneInTime(const std::wstring& target, const Change& change)
{
    constexpr int kTries = 20;
    constexpr unsigned long kPauseMs = 25;
    DWORD error = ERROR_SUCCESS;
    for (int tries = 0; tries < kTries; ++tries) {
        if (change())
            return true;
        error = GetLastError();
        const DWORD attributes = GetFileAttributesW(target.c_str());
        const bool isKept = attributes != INVALID_FILE_ATTRIBUTES &&
                            (attributes & (FILE_ATTRIBUTE_READONLY | FILE_ATTRIBUTE_DIRECTORY)) != 0;
        if (isKept || !isPassing(error))
            break;
        QThread::msleep(kPauseMs);
    }
    SetLastError(error);
    return false;
}

} // namespace

QString syncProblem(const QFileDevice& file)
{
    // Opened once more: a QFile's handle() would leave a descriptor behind at every call, and what is flushed is the
    // file.
    constexpr DWORD kShared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
    HANDLE const handle = CreateFileW(nativePath(file.fileName()).c_str(), GENERIC_WRITE, kShared, nullptr,
                                      OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr);
    if (handle == INVALID_HANDLE_VALUE)
        return {}; // Another has it; the system writes it when it can.
    const bool isFlushed = FlushFileBuffers(handle) != FALSE;
    const DWORD error = isFlushed ? ERROR_SUCCESS : GetLastError();
    CloseHandle(handle);
    if (isFlushed)
        return {};
    return error == ERROR_DISK_FULL || error == ERROR_HANDLE_DISK_FULL
               ? noSpace()
               : writeRefusal(qt_error_string(static_cast<int>(error)));
}

void beginFlush(const QFileDevice& /*file*/, qint64 /*at*/, qint64 /*count*/) {}

void flushFolder(const QString& /*folder*/) {} // The move waited for it.

bool replaceFile(const QString& from, const QString& to)
{
    const std::wstring source = nativePath(from);
    const std::wstring target = nativePath(to);
    return doneInTime(target, [&source, &target] {
        return MoveFileExW(source.c_str(), target.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) != FALSE;
    });
}

bool deleteFile(const QString& path)
{
    const std::wstring target = nativePath(path);
    return doneInTime(target, [&target] { return DeleteFileW(target.c_str()) != FALSE; });
}

} // namespace hairpaint::model

#endif
