// Maps for other programs: as images, as a sheet to draw on, and opened in a program of the user's.
#pragma once

#include "app/exchange/file_work.h"
#include "app/exchange/outside_edit.h"
#include "app/session/session.h"
#include "view/dialogs/export_maps_dialog.h"

namespace hairpaint::app {

/// GUI thread.
class MapExchange : public QObject
{
    Q_OBJECT
public:
    MapExchange(Session& session, FileWork& files);

    /// Into the active map; `grey`: brightness is the value, else the image's colours are read by the map's scale.
    void importImage(bool grey); ///< Asks for the file.
    void importImageFrom(const QString& path, bool grey);
    void exportMap(); ///< The active map in its scale.

    void saveMaps();  ///< Asks which and how, and for a folder.
    void saveSheet(); ///< The head's UV layout; asks for the file.
    /// The active layer, in the program that opens images.
    void editOutside();

private:
    [[nodiscard]] std::vector<model::WantedMap> wantedMaps(view::MapRange range);
    [[nodiscard]] static QString noGroupText();

    Session& m_session;
    FileWork& m_files;
    OutsideEdit m_outside;
    view::MapsExportChoice m_choice; ///< The last choice made in the dialog.
};

} // namespace hairpaint::app
