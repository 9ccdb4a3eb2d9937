// Names with numbers, moved up by one.
#include "model/files/earlier_versions.h"

#include "model/files/atomic_file.h"

#include <QFile>
#include <QFileInfo>

namespace hairpaint::model {

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
    for (int number = kEarlierVersions - 1; number >= 1; --number) {
        const QString from = earlierVersion(path, number);
        if (QFileInfo::exists(from) && !replaceFile(from, earlierVersion(path, number + 1)))
            return refuse(say(QT_TRANSLATE_NOOP("Files", "it can't take the place of the one before")));
    }
    // A copy, so that the file is never missing.
    const QString first = earlierVersion(path, 1);
    if (!now.open(QIODevice::ReadOnly))
        return refuse(now.errorString());
    AtomicFile copy(first);
    if (Checked<void> opened = copy.open(); !opened)
        return opened;
    constexpr qint64 kPiece = 1 << 20;
    for (QByteArray piece = now.read(kPiece); !piece.isEmpty(); piece = now.read(kPiece))
        copy.write(piece);
    if (now.error() != QFileDevice::NoError)
        return refuse(now.errorString());
    return copy.commit();
}

} // namespace hairpaint::model
