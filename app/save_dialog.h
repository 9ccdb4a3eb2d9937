// The one file dialog for everything that is saved.
#pragma once

#include <QString>

class QWidget;

namespace hairpaint::app {

struct SaveQuestion
{
    QString title;
    QString suggestedPath;
    QString filter;
    QString suffix; ///< "png"; added where neither the name that is given nor the filter that is chosen has one.
};

/// The chosen path; empty where cancelled. Before a file that is there is replaced, asks, and for the name with which
/// it will be written. `filter`, where given, becomes the part of question.filter that is chosen. GUI thread, blocking.
[[nodiscard]] QString askSavePath(QWidget& window, const SaveQuestion& question, QString* filter = nullptr);

} // namespace hairpaint::app
