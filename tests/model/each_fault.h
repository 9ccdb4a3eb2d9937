// Does something with a fault at the first call that can fail, the second, and so on until none is left to fail.
#pragma once

#include "model/values/error.h"
#include "tests/model/archive_maker.h"
#include "tests/model/sample_project.h"

#include <QDir>
#include <QMap>
#include <QString>
#include <QTemporaryDir>

#include <functional>

namespace hairpaint::test {

inline constexpr int kMostFaults = 2000; ///< More than anything that is tried asks for.

inline constexpr int kFewestFaults = 2; ///< Else nothing was tried.

/// The bytes of files by name; a folder's name ends with '/' and has no bytes.
using FolderContent = QMap<QString, QByteArray>;

/// The files of a folder, and the names of its subfolders.
inline FolderContent contentOf(const QString& folder)
{
    FolderContent content;
    for (const QString& name : QDir(folder).entryList(QDir::Files | QDir::Hidden))
        content.insert(name, readBytes(folder + QLatin1Char('/') + name));
    for (const QString& name : QDir(folder).entryList(QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot))
        content.insert(name + QLatin1Char('/'), {});
    return content;
}

/// Makes the folder hold `content` and nothing else.
inline void putBack(const QString& folder, const FolderContent& content)
{
    for (const QString& name : QDir(folder).entryList(QDir::Files | QDir::Hidden))
        QFile::remove(folder + QLatin1Char('/') + name);
    for (const QString& name : QDir(folder).entryList(QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot))
        QDir(folder + QLatin1Char('/') + name).removeRecursively();
    for (const auto& [name, bytes] : content.asKeyValueRange())
        writeBytes(folder + QLatin1Char('/') + name, bytes);
}

/// `judge` returns what is wrong after each run. Empty where nothing was wrong and faults did happen.
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

/// Where files are written under each fault: all that belong together are there and whole, or the folder is as it was
/// and a sentence tells why.
class FaultyFolder
{
public:
    [[nodiscard]] QString filePath(const QString& name) const { return m_folder.filePath(name); }
    [[nodiscard]] QString path() const { return m_folder.path(); }

    /// `old`: files that are there before. Empty where all was well.
    template<typename Fault, typename... Options>
    QString underEach(const QStringList& old, const std::function<model::Result<void>()>& work, Options... options)
    {
        for (const QString& file : old)
            writeBytes(file, "old");
        const FolderContent before = contentOf(path());
        QString message;
        const auto isDone = [&] {
            const model::Result<void> done = work();
            message = done ? QString() : done.error().message;
            return done.has_value();
        };
        if (!isDone())
            return QStringLiteral("it fails without a fault: ") + message;
        const FolderContent after = contentOf(path());
        putBack(path(), before);
        const auto judge = [&](bool done) {
            const FolderContent now = contentOf(path());
            putBack(path(), before);
            if (now != (done ? after : before))
                return QStringLiteral("done %1, and the folder holds %2")
                    .arg(done)
                    .arg(QStringList(now.keys()).join(QLatin1Char(' ')));
            // Where there are several files, the sentence names the one that failed.
            return done || isOneSentenceNaming(message, path()) ? QString() : message;
        };
        return underEachFault<Fault>(isDone, judge, options...);
    }

private:
    QTemporaryDir m_folder;
};

} // namespace hairpaint::test
