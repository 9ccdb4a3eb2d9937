// Failure sentences of file reading and writing.
#include "model/values/sentences.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>

namespace hairpaint::model {

QString say(const char* text)
{
    return QCoreApplication::translate("Files", text);
}

QString shownPath(const QString& path)
{
    return onOneLine(QDir::toNativeSeparators(path));
}

QString onOneLine(QString text)
{
    for (QChar& c : text)
        if (c.category() == QChar::Other_Control || c == QChar::LineSeparator || c == QChar::ParagraphSeparator)
            c = QLatin1Char('?');
    return text;
}

tl::unexpected<Clause> refuse(QString clause, Clause::Cure cure)
{
    return tl::unexpected<Clause>(Clause{.text = std::move(clause), .cure = cure});
}

tl::unexpected<Error> cannotOpen(const QString& path, const Clause& clause)
{
    const auto sentence = [&clause] {
        switch (clause.cure) {
        case Clause::Cure::NewerProgram:
            return say(QT_TRANSLATE_NOOP("Files", "'%1' can't be opened: %2; open it with a newer Hair Paint."));
        case Clause::Cure::OtherFile:
            return say(QT_TRANSLATE_NOOP("Files", "'%1' can't be opened: %2."));
        case Clause::Cure::EarlierCopy:
            break;
        }
        return say(QT_TRANSLATE_NOOP("Files", "'%1' is damaged: %2; try an earlier copy of it."));
    };
    return tl::unexpected<Error>(Error{.message = sentence().arg(shownPath(path), clause.text),
                                       .isDamage = clause.cure == Clause::Cure::EarlierCopy});
}

tl::unexpected<Error> cannotWrite(const QString& path, const Clause& clause)
{
    return failure(say(QT_TRANSLATE_NOOP("Files", "'%1' can't be written: %2.")).arg(shownPath(path), clause.text));
}

tl::unexpected<Error> cancelled(const QString& path)
{
    return failure(
        say(QT_TRANSLATE_NOOP("Files", "Working on '%1' was cancelled; nothing has changed.")).arg(shownPath(path)));
}

QString readRefusal(const QString& reason)
{
    return say(QT_TRANSLATE_NOOP("Files", "%1; check that you may read it")).arg(reason);
}

QString writeRefusal(const QString& reason)
{
    return say(QT_TRANSLATE_NOOP("Files", "%1; check that you may write there, or choose another place")).arg(reason);
}

Clause notEnoughMemory()
{
    return {.text = say(QT_TRANSLATE_NOOP("Files", "there is not enough memory for it; close other programs and try "
                                                   "again")),
            .cure = Clause::Cure::OtherFile};
}

Clause silentDisk()
{
    return {.text = say(QT_TRANSLATE_NOOP("Files", "its disk or network folder does not answer; try again when it "
                                                   "does, or use another place")),
            .cure = Clause::Cure::OtherFile};
}

Result<void> checkReadable(const QString& path, qint64 mostBytes)
{
    const auto refused = [&path](const QString& text) {
        return cannotOpen(path, Clause{.text = text, .cure = Clause::Cure::OtherFile});
    };
    const QFileInfo info(path);
    if (path.isEmpty() || !info.exists())
        return refused(say(QT_TRANSLATE_NOOP("Files", "there is no such file; check the name and the folder")));
    if (info.isDir())
        return refused(say(QT_TRANSLATE_NOOP("Files", "it is a folder; choose a file inside it")));
    if (!info.isFile())
        return refused(say(QT_TRANSLATE_NOOP("Files", "it is not an ordinary file; choose another")));
    if (info.size() == 0)
        return refused(say(QT_TRANSLATE_NOOP("Files", "it is empty; choose another file")));
    if (info.size() > mostBytes)
        return refused(
            say(QT_TRANSLATE_NOOP("Files", "it is larger than %1, the most that is read; choose a smaller file"))
                .arg(QLocale().formattedDataSize(mostBytes)));
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return refused(readRefusal(file.errorString()));
    return {};
}

} // namespace hairpaint::model
