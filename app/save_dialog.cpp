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
    QString suggested = question.suggestedPath;
    for (;;) {
        // Dialogs of some systems ask before they add the suffix, so they are told not to ask at all.
        const QString chosen = QFileDialog::getSaveFileName(&window, question.title, suggested, question.filter, filter,
                                                            QFileDialog::DontConfirmOverwrite);
        if (chosen.isEmpty())
            return {};
        const auto wanted =
            QRegularExpression(QStringLiteral("\\(\\*\\.(\\w+)\\)")).match(filter ? *filter : QString());
        const QString suffix = wanted.hasMatch() ? wanted.captured(1) : question.suffix;
        const QString path = QFileInfo(chosen).suffix().isEmpty() ? chosen + QLatin1Char('.') + suffix : chosen;
        if (mayReplace(window, question, path))
            return path;
        suggested = path;
    }
}

} // namespace hairpaint::app
