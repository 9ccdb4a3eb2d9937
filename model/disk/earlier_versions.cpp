// Names with numbers, moved up by one.
#include "model/disk/earlier_versions.h"

#include "model/disk/atomic_file.h"
#include "model/disk/own_folder.h"

#include <QFile>
#include <QFileInfo>

#include <utility>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr qint64 kCopiedBytes = 1 << 20;

/// Renames that are taken back where not all of them could be done.
class Renames
{
public:
    ~Renames()
    {
        while (!m_done.empty()) {
            const auto& [from, to] = m_done.back();
            (void)replaceFile(to, from);
            m_done.pop_back();
        }
    }
    Renames() = default;
    Renames(const Renames&) = delete;
    Renames& operator=(const Renames&) = delete;

    [[nodiscard]] bool rename(const QString& from, const QString& to)
    {
        if (!replaceFile(from, to))
            return false;
        m_done.emplace_back(from, to);
        return true;
    }
    void keep() { m_done.clear(); }

private:
    std::vector<std::pair<QString, QString>> m_done;
};

bool haveSameBytes(QFile& one, const QString& path)
{
    const QFileInfo named(path);
    const std::optional<OwnFolder> folder = OwnFolder::open(named.path());
    QFile other;
    if (!folder || !folder->openToRead(other, named.fileName()) || one.size() != other.size())
        return false;
    bool same = true;
    while (same && !one.atEnd())
        same = one.read(kCopiedBytes) == other.read(kCopiedBytes);
    return one.seek(0) && same;
}

/// A link of that name would lead the copy over what it points to.
void removeLink(const QString& path)
{
    const QFileInfo named(path);
    if (const std::optional<OwnFolder> folder = OwnFolder::open(named.path())) {
        const std::optional<OwnEntry> before = folder->entry(named.fileName());
        if (before && before->kind == OwnEntry::Kind::Other)
            folder->remove(named.fileName());
    }
}

} // namespace

QString earlierVersion(const QString& path, int number)
{
    const QFileInfo file(path);
    const QString suffix = file.suffix().isEmpty() ? QString() : QLatin1Char('.') + file.suffix();
    return QStringLiteral("%1/%2~%3%4").arg(file.path(), file.completeBaseName()).arg(number).arg(suffix);
}

Checked<void> keepEarlierVersions(const QString& path)
{
    QFile now(path);
    if (!now.exists())
        return {};
    if (!now.open(QIODevice::ReadOnly))
        return refuse(readRefusal(now.errorString()));
    // Where saving failed after this and is tried again, it is there already.
    if (haveSameBytes(now, earlierVersion(path, 1)))
        return {};
    // A copy, so that the file is never missing; the renames wait until it is whole.
    const QString newest = earlierVersion(path, 0);
    const QString oldest = earlierVersion(path, kEarlierVersions + 1);
    removeLink(newest);
    if (Checked<void> copied = copyFile(now, newest); !copied)
        return copied;
    Renames renames;
    for (int number = kEarlierVersions; number >= 0; --number) {
        const QString from = earlierVersion(path, number);
        if (QFileInfo::exists(from) && !renames.rename(from, earlierVersion(path, number + 1))) {
            QFile::remove(newest);
            return refuse(say(QT_TRANSLATE_NOOP(
                "Files", "it can't take the place of the one before; close what has that open and try again")));
        }
    }
    renames.keep();
    QFile::remove(oldest);
    return {};
}

} // namespace hairpaint::model
