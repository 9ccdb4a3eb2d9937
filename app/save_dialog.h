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
    QString suffix; ///< "png"; added where the name that is given has none.
};

/// The chosen path; empty where cancelled. Before a file that is there is replaced, asks, and for the name with which
/// it will be written. GUI thread, blocking.
[[nodiscard]] QString askSavePath(QWidget& window, const SaveQuestion& question);

} // namespace hairpaint::app
