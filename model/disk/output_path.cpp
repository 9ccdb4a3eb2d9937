// Following links by hand: the system follows none to what is not there.
#include "model/disk/output_path.h"

#include "model/disk/windows_names.h"

#include <QFile>
#include <QFileInfo>

#include <filesystem>
#include <system_error>

namespace hairpaint::model {

namespace {

/// What a file is that is no ordinary one, as a clause; empty for ordinary ones and where there is none.
QString kindOf(const QString& path)
{
    std::error_code unknown;
    switch (std::filesystem::status(QFileInfo(path).filesystemFilePath(), unknown).type()) {
    case std::filesystem::file_type::directory:
        return say(QT_TRANSLATE_NOOP("Files", "it is a folder; give the name of a file"));
    case std::filesystem::file_type::block:
    case std::filesystem::file_type::character:
        return say(QT_TRANSLATE_NOOP("Files", "it is a device, and no file can take its place; choose another name"));
    case std::filesystem::file_type::fifo:
        return say(QT_TRANSLATE_NOOP("Files", "it is a pipe, and no file can take its place; choose another name"));
    case std::filesystem::file_type::socket:
        return say(QT_TRANSLATE_NOOP("Files", "it is a socket, and no file can take its place; choose another name"));
    case std::filesystem::file_type::unknown:
        return say(QT_TRANSLATE_NOOP("Files", "it is not an ordinary file; choose another name"));
    default:
        return {};
    }
}

/// What a link says, from the folder on that it lies in; "..", left as it is, means what it means to the system.
Checked<QString> targetOf(const QString& link)
{
    std::error_code problem;
    const std::filesystem::path target = std::filesystem::read_symlink(QFileInfo(link).filesystemFilePath(), problem);
    if (problem)
        return refuse(writeRefusal(QString::fromLocal8Bit(problem.message())));
#ifdef Q_OS_UNIX
    const QByteArray bytes = QByteArray::fromStdString(target.native());
    const QString text = QFile::decodeName(bytes);
    if (QFile::encodeName(text) != bytes)
        return refuse(say(QT_TRANSLATE_NOOP("Files", "it is a link to a name that is not UTF-8; choose another name")));
#else
    const QString text = QString::fromStdU16String(target.u16string());
#endif
    return target.is_absolute() ? text : QFileInfo(link).path() + QLatin1Char('/') + text;
}

/// Behind the link at `path`.
Checked<QString> followed(const QString& path)
{
    constexpr int kMostLinks = 40; // As Linux has it.
    QString file = path;
    for (int links = 0; QFileInfo(file).isSymbolicLink(); ++links) {
        if (links == kMostLinks)
            return refuse(
                say(QT_TRANSLATE_NOOP("Files", "it is a link that leads round in a circle; choose another name")));
        Checked<QString> target = targetOf(file);
        if (!target)
            return target;
        // One of those in /proc that show what a process has open.
        if (QFileInfo::exists(file) && !QFileInfo::exists(*target))
            return refuse(
                say(QT_TRANSLATE_NOOP("Files", "it leads to a file without a name, which nothing can take the "
                                               "place of; choose another name")));
        file = *target;
    }
    return file;
}

} // namespace

Checked<QString> outputPath(const QString& path)
{
#ifdef Q_OS_WIN
    if (const QString problem = windowsNameProblem(QFileInfo(path).fileName()); !problem.isEmpty())
        return refuse(problem);
#endif
    if (const QString kind = kindOf(path); !kind.isEmpty())
        return refuse(kind);
    Checked<QString> file = followed(path);
    if (!file)
        return file;
    if (const QString folder = QFileInfo(*file).path(); !QFileInfo(folder).isDir())
        return refuse(say(QT_TRANSLATE_NOOP("Files", "there is no folder '%1'; make it first")).arg(shownPath(folder)));
    return file;
}

Checked<void> checkWritable(const QString& path)
{
    const Checked<QString> file = outputPath(path);
    return file ? Checked<void>() : tl::unexpected(file.error());
}

} // namespace hairpaint::model
