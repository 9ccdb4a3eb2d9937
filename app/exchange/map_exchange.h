// Maps for other programs: as images, as a sheet to draw on, and opened in a program of the user's.
#pragma once

#include "app/exchange/file_work.h"
#include "app/exchange/outside_edit.h"
#include "app/session/session.h"
#include "model/files/image_map.h"
#include "model/tools/selecting/clipboard.h"
#include "view/dialogs/export_maps_dialog.h"
#include "view/dialogs/image_reading_dialog.h"

#include <functional>
#include <optional>

namespace hairpaint::app {

/// GUI thread.
class MapExchange : public QObject
{
    Q_OBJECT
public:
    MapExchange(Session& session, FileWork& files);

    /// Into the active map; `grey`: brightness is the value. None: as its pixels tell, or as the user says where they
    /// allow both.
    void importImage(std::optional<bool> grey); ///< Asks for the file.
    void importImageFrom(const QString& path, std::optional<bool> grey);
    /// Each to the map that its name tells, after a table to correct that; a step to be undone each.
    void importImages(const QStringList& paths);
    void importFolder(); ///< The same of the images of a folder; asks for it.
    /// A picture of another program's clipboard as a clip for the active map; none where that was cancelled.
    [[nodiscard]] std::optional<model::Clip> clipFrom(const QImage& image);
    void exportMap(); ///< The active map in its scale.

    void saveMaps();  ///< Asks which and how, and for a folder.
    void saveSheet(); ///< The head's UV layout; asks for the file.
    /// The active layer, in the program that opens images.
    void editOutside();

private:
    /// As a layer on top of the map of `target`, whose layer is not looked at; where `told` is an image of one of the
    /// head's uv tiles, those of the others come with it.
    void importImageInto(const QString& told, std::optional<bool> grey, const model::LayerAddress& target);
    /// Whether brightness is the value; none where the user cancels.
    [[nodiscard]] std::optional<bool> askReading(const QString& name, const model::MapSpec& spec,
                                                 const view::ReadingPreview& preview);
    [[nodiscard]] std::vector<model::WantedMap> wantedMaps(view::MapRange range);
    [[nodiscard]] static QString noGroupText();

    Session& m_session;
    FileWork& m_files;
    OutsideEdit m_outside;
    view::MapsExportChoice m_choice; ///< The last choice made in the dialog.
};

} // namespace hairpaint::app
