// Asking for files: see the header.
#include "app/settings/file_dialogs.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QRegularExpression>
#include <QStandardPaths>

namespace hairpaint::app {

namespace {

struct SaveDialog
{
    Q_DECLARE_TR_FUNCTIONS(SaveDialog)
};

/// "png", "exr" of "PNG images (*.png);;OpenEXR images (*.exr)".
QStringList suffixesOf(const QString& filter)
{
    static const QRegularExpression ending(QStringLiteral("\\*\\.(\\w+)"));
    QStringList suffixes;
    for (auto match = ending.globalMatch(filter); match.hasNext();)
        suffixes += match.next().captured(1);
    return suffixes;
}

/// Some systems have no names that end in dots, and nobody wants two of them.
QString withSuffix(QString name, const QString& suffix)
{
    while (name.endsWith(QLatin1Char('.')))
        name.chop(1);
    return name + QLatin1Char('.') + suffix;
}

bool mayReplace(QWidget& window, const SaveQuestion& question, const QString& path)
{
    return !QFileInfo(path).isFile() ||
           QMessageBox::warning(
               &window, question.title,
               SaveDialog::tr("There is a file '%1' already. Replace it?").arg(QFileInfo(path).fileName()),
               QMessageBox::Yes | QMessageBox::No, QMessageBox::No) == QMessageBox::Yes;
}

QString usualFolder()
{
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

} // namespace

QString nearestFolder(const QString& wanted)
{
    if (wanted.isEmpty())
        return usualFolder();
    if (QFileInfo(wanted).isDir())
        return wanted;
    for (QString inner = QDir::cleanPath(wanted);;) {
        const QString around = QFileInfo(inner).path();
        if (around == inner || around == QLatin1String("."))
            return usualFolder();
        // Where a disk was that is gone, there is nothing of the user's: not to be written to.
        if (const QFileInfo folder(around); folder.isDir())
            return folder.isWritable() && !folder.isRoot() ? around : usualFolder();
        inner = around;
    }
}

QString FileDialogs::begin(const QString& folder)
{
    const Awaited<QString> found = m_jobs.awaitOrLeave<QString>(
        {.text = SaveDialog::tr("Looking for the folder"),
         .whenCancelled = SaveDialog::tr("The folder used last was not looked for: cancelled")},
        [folder](const model::Progress&) -> model::Result<QString> { return nearestFolder(folder); });
    return found.end == WorkEnd::Done && *found.result ? **found.result : usualFolder();
}

QString FileDialogs::askOpenPath(const QString& title, const QString& folder, const QString& filter)
{
    return QFileDialog::getOpenFileName(&m_window, title, begin(folder), filter);
}

QStringList FileDialogs::askOpenPaths(const QString& title, const QString& folder, const QString& filter)
{
    return QFileDialog::getOpenFileNames(&m_window, title, begin(folder), filter);
}

QString FileDialogs::askFolder(const QString& title, const QString& folder)
{
    return QFileDialog::getExistingDirectory(&m_window, title, begin(folder));
}

QString FileDialogs::askSavePath(const SaveQuestion& question, QString* filter)
{
    // What stands behind a dot may be part of a name: "take 1.2".
    const QStringList known = suffixesOf(question.filter) + question.otherSuffixes;
    const QFileInfo wanted(question.suggestedPath);
    QString suggested = QDir(begin(wanted.path())).filePath(wanted.fileName());
    QString chosenFilter = filter != nullptr ? *filter : QString();
    for (;;) {
        // Dialogs of some systems ask before they add the suffix, so they are told not to ask at all.
        const QString chosen = QFileDialog::getSaveFileName(&m_window, question.title, suggested, question.filter,
                                                            &chosenFilter, QFileDialog::DontConfirmOverwrite);
        if (chosen.isEmpty())
            return {};
        if (filter != nullptr)
            *filter = chosenFilter;
        const QStringList offered = suffixesOf(chosenFilter);
        const QString suffix = offered.size() == 1 ? offered.front() : question.suffix;
        const bool isKnown = known.contains(QFileInfo(chosen).suffix(), Qt::CaseInsensitive);
        const QString path = isKnown ? chosen : withSuffix(chosen, suffix);
        if (mayReplace(m_window, question, path))
            return path;
        suggested = path;
    }
}

} // namespace hairpaint::app
