// The one file dialog for everything that is saved.
#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace hairpaint::app {

struct SaveQuestion
{
    QString title;
    QString suggestedPath;
    QString filter;
    QString suffix; ///< "png"; added, or the chosen filter's, where the name ends in none of those that are known.
    QStringList otherSuffixes = {}; ///< Known besides those of the filters.
};

/// The chosen path; empty where cancelled. Before a file that is there is replaced, asks, and for the name with which
/// it will be written. `filter`, where given, becomes the part of question.filter that is chosen. GUI thread, blocking.
[[nodiscard]] QString askSavePath(QWidget& window, const SaveQuestion& question, QString* filter = nullptr);

} // namespace hairpaint::app
