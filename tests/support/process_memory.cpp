// From /proc, or from the system's counters.
#include "tests/support/process_memory.h"

#ifdef Q_OS_WIN

#include <windows.h>

#include <psapi.h>

namespace hairpaint::test {

qint64 residentBytes(qint64 process)
{
    HANDLE const handle = OpenProcess(PROCESS_QUERY_INFORMATION | PROCESS_VM_READ, FALSE, static_cast<DWORD>(process));
    if (handle == nullptr)
        return 0;
    PROCESS_MEMORY_COUNTERS counters{};
    const bool isKnown = K32GetProcessMemoryInfo(handle, &counters, sizeof(counters)) != FALSE;
    CloseHandle(handle);
    return isKnown ? static_cast<qint64>(counters.WorkingSetSize) : 0;
}

} // namespace hairpaint::test

#else

#include <QByteArray>
#include <QFile>
#include <QList>
#include <QString>

namespace hairpaint::test {

qint64 residentBytes(qint64 process)
{
    const auto read = [process](const char* name) {
        QFile file(QStringLiteral("/proc/%1/%2").arg(process).arg(QLatin1String(name)));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    qint64 bytes = read("statm").split(' ').value(1).toLongLong() * 4096;
    const QByteArray children = read(QByteArray("task/" + QByteArray::number(process) + "/children").constData());
    for (const QByteArray& child : children.split(' '))
        if (child.toLongLong() > 0)
            bytes += residentBytes(child.toLongLong());
    return bytes;
}

} // namespace hairpaint::test

#endif
