// Maps for other programs: as images, as a sheet to draw on, and opened in a program of the user's.
#pragma once

#include "app/background/jobs.h"
#include "app/outside_edit.h"
#include "app/session.h"
#include "app/settings.h"
#include "view/dialogs/export_maps_dialog.h"
#include "view/dialogs/help_dialog.h"

#include <QObject>

namespace hairpaint::app {

/// Shows dialogs, progress and message boxes over `window`. GUI thread.
class MapExchange : public QObject
{
    Q_OBJECT
public:
    MapExchange(Session& session, Settings& settings, Jobs& jobs, QWidget& window);

    void saveMaps();  ///< Asks which and how, and for a folder.
    void saveSheet(); ///< The head's UV layout; asks for the file.
    /// The active layer, in the program that opens images.
    void editOutside();

Q_SIGNALS:
    void done(const QString& message); ///< For the status bar.
    /// About to be shown; the help has a page on it.
    void dialogMade(QDialog& dialog, hairpaint::view::HelpDialog::Topic topic);

private:
    [[nodiscard]] std::vector<model::WantedMap> wantedMaps(view::MapRange range);
    void complain(const QString& message);

    Session& m_session;
    Settings& m_settings;
    Jobs& m_jobs;
    QWidget& m_window;
    OutsideEdit m_outside;
    view::MapsExportChoice m_choice; ///< That was last made.
};

} // namespace hairpaint::app
