// Failure sentences of file reading and writing.
#include "model/files/sentences.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>

namespace hairpaint::model {

namespace {

QString say(const char* text)
{
    return QCoreApplication::translate("Files", text);
}

} // namespace

QString shownPath(const QString& path)
{
    QString shown = QDir::toNativeSeparators(path);
    for (QChar& c : shown)
        if (c.category() == QChar::Other_Control || c == QChar::LineSeparator || c == QChar::ParagraphSeparator)
            c = QLatin1Char('?');
    return shown;
}

tl::unexpected<Error> damaged(const QString& path, const QString& clause)
{
    return failure(say(QT_TRANSLATE_NOOP("Files", "'%1' is damaged: %2; try an earlier copy of it."))
                       .arg(shownPath(path), clause));
}

tl::unexpected<Error> cannotOpen(const QString& path, const QString& clause)
{
    return failure(say(QT_TRANSLATE_NOOP("Files", "'%1' can't be opened: %2.")).arg(shownPath(path), clause));
}

tl::unexpected<Error> cannotWrite(const QString& path, const QString& clause)
{
    return failure(say(QT_TRANSLATE_NOOP("Files", "'%1' can't be written: %2.")).arg(shownPath(path), clause));
}

tl::unexpected<Error> cancelled(const QString& path)
{
    return failure(
        say(QT_TRANSLATE_NOOP("Files", "Working on '%1' was cancelled; nothing has changed.")).arg(shownPath(path)));
}

Result<void> checkReadable(const QString& path, qint64 mostBytes)
{
    const QFileInfo info(path);
    if (path.isEmpty() || !info.exists())
        return cannotOpen(path, say(QT_TRANSLATE_NOOP("Files", "there is no such file; check the name and the folder")));
    if (info.isDir())
        return cannotOpen(path, say(QT_TRANSLATE_NOOP("Files", "it is a folder; choose a file inside it")));
    if (!info.isFile())
        return cannotOpen(path, say(QT_TRANSLATE_NOOP("Files", "it is not an ordinary file; choose another")));
    if (info.size() == 0)
        return cannotOpen(path, say(QT_TRANSLATE_NOOP("Files", "it is empty; choose another file")));
    if (info.size() > mostBytes)
        return cannotOpen(path, say(QT_TRANSLATE_NOOP("Files", "it is larger than %1, the most that is read; choose a smaller file"))
                                    .arg(QLocale().formattedDataSize(mostBytes)));
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return cannotOpen(path, say(QT_TRANSLATE_NOOP("Files", "%1; check that you may read it")).arg(file.errorString()));
    return {};
}

} // namespace hairpaint::model
