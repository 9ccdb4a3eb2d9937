// Does something with a fault at the first call that can fail, the second, and so on until none is left to fail.
#pragma once

#include "tests/model/archive_maker.h"

#include <QDir>
#include <QMap>
#include <QString>

#include <functional>

namespace hairpaint::test {

inline constexpr int kMostFaults = 2000; ///< More than anything that is tried asks for.

/// Else nothing was tried. The address sanitizer keeps malloc to itself, and what is left allocates little.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr int kFewestFaults = 0;
#else
inline constexpr int kFewestFaults = 2;
#endif

/// Names and bytes.
using FolderContent = QMap<QString, QByteArray>;

/// Of its files, and the names of its folders.
inline FolderContent contentOf(const QString& folder)
{
    FolderContent content;
    for (const QString& name : QDir(folder).entryList(QDir::Files | QDir::Hidden))
        content.insert(name, readBytes(folder + QLatin1Char('/') + name));
    for (const QString& name : QDir(folder).entryList(QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot))
        content.insert(name + QLatin1Char('/'), {});
    return content;
}

/// The folder holds that and nothing else.
inline void putBack(const QString& folder, const FolderContent& content)
{
    for (const QString& name : QDir(folder).entryList(QDir::Files | QDir::Hidden))
        QFile::remove(folder + QLatin1Char('/') + name);
    for (const QString& name : QDir(folder).entryList(QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot))
        QDir(folder + QLatin1Char('/') + name).removeRecursively();
    for (const auto& [name, bytes] : content.asKeyValueRange())
        writeBytes(folder + QLatin1Char('/') + name, bytes);
}

/// `judge` says each time what is wrong. Empty where nothing was, and where there were faults.
template<typename Fault, typename... Options>
QString underEachFault(const std::function<bool()>& work, const std::function<QString(bool done)>& judge,
                       Options... options)
{
    for (int nth = 1; nth < kMostFaults; ++nth) {
        bool happened = false;
        const bool done = [&] {
            const Fault fault(nth, options...);
            const bool came = work();
            happened = Fault::happened();
            return came;
        }();
        if (const QString wrong = judge(done); !wrong.isEmpty())
            return QStringLiteral("fault %1: %2").arg(nth).arg(wrong);
        if (!happened)
            return done && nth > kFewestFaults ? QString()
                                               : QStringLiteral("without a fault: done %1, %2").arg(done).arg(nth);
    }
    return QStringLiteral("there is no end of faults");
}

} // namespace hairpaint::test
