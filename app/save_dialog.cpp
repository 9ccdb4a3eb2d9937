// Asking where to save: see the header.
#include "app/save_dialog.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QRegularExpression>

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

bool mayReplace(QWidget& window, const SaveQuestion& question, const QString& path)
{
    return !QFileInfo(path).isFile() ||
           QMessageBox::warning(
               &window, question.title,
               SaveDialog::tr("There is a file '%1' already. Replace it?").arg(QFileInfo(path).fileName()),
               QMessageBox::Yes | QMessageBox::No, QMessageBox::No) == QMessageBox::Yes;
}

} // namespace

QString askSavePath(QWidget& window, const SaveQuestion& question, QString* filter)
{
    // What stands behind a dot may be part of a name: "take 1.2".
    const QStringList known = suffixesOf(question.filter) + question.otherSuffixes;
    QString suggested = question.suggestedPath;
    QString chosenFilter = filter != nullptr ? *filter : QString();
    for (;;) {
        // Dialogs of some systems ask before they add the suffix, so they are told not to ask at all.
        const QString chosen = QFileDialog::getSaveFileName(&window, question.title, suggested, question.filter,
                                                            &chosenFilter, QFileDialog::DontConfirmOverwrite);
        if (chosen.isEmpty())
            return {};
        if (filter != nullptr)
            *filter = chosenFilter;
        const QStringList offered = suffixesOf(chosenFilter);
        const QString suffix = offered.size() == 1 ? offered.front() : question.suffix;
        const bool isKnown = known.contains(QFileInfo(chosen).suffix(), Qt::CaseInsensitive);
        const QString path = isKnown ? chosen : chosen + QLatin1Char('.') + suffix;
        if (mayReplace(window, question, path))
            return path;
        suggested = path;
    }
}

} // namespace hairpaint::app
